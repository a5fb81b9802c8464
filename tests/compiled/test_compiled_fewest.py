"""The form with the fewest operations: exact, no dearer than elimination, accurate, repeatable."""

from fractions import Fraction
from random import Random
from typing import Any

import numpy as np
import pytest
import sympy
from sympy import Expr, Matrix, Rational, cos, pi, sin, sqrt, symbols

from mechanics.compiled import compile, prove_compiled
from mechanics.compiled.forms import system
from mechanics.compiled.forms.closed import quotients
from mechanics.compiled.forms.coefficient import Coefficient, coefficient
from mechanics.compiled.forms.entries import nested_entries
from mechanics.compiled.forms.fewest import nested_quotients
from mechanics.compiled.forms.graph import Written
from mechanics.compiled.forms.members import FEWEST, preferred
from mechanics.compiled.sampling import sample
from mechanics.kernel.ring import TooLarge
from mechanics.symbolic import is_zero

a, b = symbols("a b", positive=True)
x, y, th = symbols("x y theta", real=True)
U, V, W = symbols("U V W", real=True)

SYSTEMS = {
    "one": (Matrix([[a + b * cos(th)]]), Matrix([a * x**2 - b * y * x])),
    "shared difference": (sympy.diag(3 * a, 2 * a), Matrix([b * (y - 2 * x), b * (x - y)])),
    "coupled": (
        Matrix([[a + b, b * cos(th)], [b * cos(th), 2 * b]]),
        Matrix([b * sin(th) * x**2 - y, -b * sin(th)]),
    ),
    "numbers": (
        Matrix([[(2 + pi) * a, a], [a, 3 * a]]),
        Matrix([pi * x + (2 + pi) * y, x / 3]),
    ),
    "three": (
        Matrix([[a + 2, 1, x], [1, b + 2, 0], [x, 0, 3 + x**2]]),
        Matrix([y, x, x * y + 1]),
    ),
    "zero right side": (sympy.diag(a, b), Matrix([0, x])),
    "negative": (Matrix([[-a]]), Matrix([-x - b * y])),
}


def expressions(found: Written) -> dict[Any, Expr]:
    """Nodes back into SymPy, unknowns put in."""
    values: list[Expr] = []
    for operation, one, two in found.nest.nodes:
        if operation == "leaf":
            key = found.nest.table.keys[one]
            values.append(key.expr if isinstance(key, Coefficient) else key)
        elif operation == "-":
            values.append(-values[one] if one == two else values[one] - values[two])
        else:
            combine = {"+": lambda p, q: p + q, "*": lambda p, q: p * q, "/": lambda p, q: p / q}
            values.append(combine[operation](values[one], values[two]))
    roots = {name: values[place] for name, place in found.roots.items()}
    named = {name: value for name, value in roots.items() if isinstance(name, sympy.Symbol)}
    for _ in named:
        roots = {name: value.subs(named) for name, value in roots.items()}
        named = {name: roots[name] for name in named}
    return roots


@pytest.mark.sample(6)
@pytest.mark.parametrize("name", SYSTEMS)
@pytest.mark.parametrize("definite", [True, False])
def test_every_way_solves_the_system(name: str, definite: bool) -> None:
    left, right = SYSTEMS[name]
    unknowns = (U, V, W)[: left.rows]
    ways = nested_quotients(left, right, unknowns, definite)
    assert ways
    for way in ways:
        solution = Matrix([expressions(way)[unknown] for unknown in unknowns])
        assert all(is_zero(entry) for entry in left * solution - right)


def test_the_cheapest_comes_first() -> None:
    costs = [way.cost for way in nested_quotients(*SYSTEMS["coupled"], (U, V), True)]
    assert costs == sorted(costs)
    # d = x - y, r = b / a, and (d + x) r / 3, d r / 2: a division counts twice.
    (least, *_) = nested_quotients(*SYSTEMS["shared difference"], (U, V), True)
    assert least.cost[0] == 8


@pytest.mark.campaign
@pytest.mark.sample(2)
@pytest.mark.parametrize("seed", range(6))
def test_random_systems(seed: int) -> None:
    random = Random(seed)
    gens = [a, b, x, y, sin(th), cos(th)]

    def polynomial(terms: int) -> Expr:
        return sympy.Add(*(
            Rational(random.randint(-4, 4), random.randint(1, 3))
            * sympy.Mul(*random.choices(gens, k=random.randint(0, 3)))
            for _ in range(terms)
        ))  # fmt: skip

    off = polynomial(1)
    left = Matrix([[a + b, off], [off, 7 + off**2]])
    right = Matrix([polynomial(3), polynomial(3)])
    for way in nested_quotients(left, right, (U, V), True):
        solution = Matrix([expressions(way)[unknown] for unknown in (U, V)])
        assert all(is_zero(entry) for entry in left * solution - right)


def test_the_same_system_is_written_the_same_way() -> None:
    from mechanics.compiled.forms import fewest

    one = nested_quotients(*SYSTEMS["coupled"], (U, V), True)[0]
    fewest._searched.cache_clear()
    two = nested_quotients(*SYSTEMS["coupled"], (U, V), True)[0]
    assert one is not two
    assert one.nest.nodes == two.nest.nodes and one.roots == two.roots


def test_no_order_divides_by_what_may_vanish() -> None:
    # det K[1:, 1:] = cos(theta): only the other order is left, unless K is positive definite.
    left, right = Matrix([[a, x], [x, cos(th)]]), Matrix([1, y])
    (only,) = quotients(left, right, (U, V), definite=False)
    assert [quotient.unknown for quotient in only] == [V, U]
    assert len(quotients(left, right, (U, V), definite=True)) == 2


@pytest.mark.parametrize(
    ("left", "right", "why"),
    [
        (sympy.eye(4), Matrix([x, y, a, b]), "4 unknowns"),
        (Matrix([[1 + sqrt(1 + x**2)]]), Matrix([1]), "roots or quotients inside"),
        (Matrix([[1]]), Matrix([1 / (1 + x**2)]), "roots or quotients inside"),
        (Matrix([[1]]), Matrix([sum(x**i * y**j for i in range(7) for j in range(7))]), "32 terms"),
        (Matrix([[x, y], [y, x * y]]), Matrix([1, 1]), "may vanish"),
        (Matrix([[x, x], [x, x]]), Matrix([1, 1]), "may vanish"),
    ],
    ids=str,
)
def test_what_is_left_to_elimination(left: Matrix, right: Matrix, why: str) -> None:
    with pytest.raises(TooLarge, match=why):
        nested_quotients(left, right, (U, V, W, x)[: left.rows], False)


SEEDS = ("elastic_pendulum", "rocker", "two_mass_chain")


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", SEEDS)
@pytest.mark.parametrize("route", ["free_body", "moving_point", "kane", "lagrange"])
def test_the_form_is_proved_and_no_dearer(derived, system: str, route: str) -> None:
    equations = derived(system, route)
    assert preferred(equations) is FEWEST
    fewest, other = (
        compile(equations, form=form, outputs=("forward_dynamics",))
        for form in ("fewest", "elimination")
    )
    counts = [m.program("forward_dynamics").operations for m in (fewest, other)]
    assert counts[0] < counts[1]
    (finding,) = prove_compiled(fewest)
    assert finding.verdict.name == "PROVED"


LARGE = [("pendulum_chain", route) for route in ("free_body", "moving_point", "kane", "lagrange")]
LARGE += [("rolling_disc", "kane")]


@pytest.mark.sample(2)
@pytest.mark.parametrize(("system", "route"), LARGE)
def test_entries_of_large_systems_are_nested(derived, system: str, route: str) -> None:
    equations = derived(system, route)
    left, right = equations.system
    found = expressions(nested_entries(left.as_immutable(), right.as_immutable()))
    for i in range(left.rows):
        for j, entry in enumerate([*left[i, :], right[i]]):
            assert is_zero(found.get((i, j), 0) - entry)
    assert preferred(equations) is FEWEST
    nested, other = (
        compile(equations, form=form).program("forward_dynamics").operations
        for form in ("fewest", "elimination")
    )
    assert nested < 0.95 * other


def test_too_many_terms_are_left_as_they_are(derived) -> None:
    equations = derived("rocker", "kane")
    theta, (f,) = equations.scene.q[0], equations.scene.input_symbols
    many = sympy.Add(*(theta**i * f**j for i in range(60) for j in range(60)))
    assert preferred(equations.with_matrices(forcing=Matrix([many]))) is not FEWEST
    with pytest.raises(TooLarge, match="terms"):
        nested_entries(equations.mass.as_immutable(), Matrix([many]).as_immutable())


def test_what_rounds_badly_is_not_taken(derived, monkeypatch: pytest.MonkeyPatch) -> None:
    equations = derived("elastic_pendulum", "kane")
    asked = []

    def worse_than_elimination(solution: Any, *_: Any) -> float:
        asked.append(solution)
        return 1.0 if solution.n_instructions() > 40 else 9.0

    monkeypatch.setattr(system, "largest_error", worse_than_elimination)
    refused, other = (
        compile(equations, form=form, reciprocals=False).program("forward_dynamics")
        for form in ("fewest", "elimination")
    )
    assert refused.operations == other.operations
    assert len(asked) > 2


def test_products_that_cancel_are_cancelled(derived) -> None:
    equations = derived("rocker", "kane")
    theta = equations.scene.q[0]
    hidden = equations.forcing + Matrix([10**6 * (sin(theta) ** 2 + cos(theta) ** 2 - 1)])
    disguised = equations.with_matrices(forcing=hidden)
    model, plain = (compile(e, compiler=None) for e in (disguised, equations))
    states = sample(model.quantities, 50, seed=7)
    q, u, inputs, p = states.groups
    found, wanted = (m.forward_dynamics(q, u, inputs=inputs, p=p) for m in (model, plain))
    np.testing.assert_array_equal(found, wanted)


def test_coefficients() -> None:
    area = coefficient(Rational(27, 25) + 27 * pi / 50)
    assert area == Coefficient(Fraction(27, 50), ((2 + pi, 1),))
    assert (area / area) == Coefficient(Fraction(1))
    assert (area * area).expr == Rational(27, 50) ** 2 * (2 + pi) ** 2
    assert coefficient(1 / (pi - 4)).ratio < 0
    assert not (-area).positive and abs(-area) == area
    assert [coefficient(Rational(*n)).awkward for n in ((1, 4), (-1, 4), (1, 3), (-1, 3))] == [
        0, 1, 2, 3
    ]  # fmt: skip
