"""Fixed parameters over all systems: fixing commutes with passing, and zero drops the load."""

import dataclasses
from collections.abc import Mapping
from fractions import Fraction
from random import Random
from typing import Any

import numpy as np
import pytest
from sympy import Add
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

import systems
from mechanics.compiled import Model, compile, prove_compiled
from mechanics.compiled.quantities import Quantities
from mechanics.compiled.terms import read_terms, typed_terms
from mechanics.crosscheck import derive
from mechanics.equations import Equations
from mechanics.errors import SingularError
from mechanics.kernel import Finding
from mechanics.program.operations import SIN
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    damper,
    force,
    gravity,
    parameters,
    reaction,
    spring,
    torsion_spring,
)
from mechanics.scene.loads import Gravity
from mechanics.symbolic import Arithmetic, canonical, decide

pytestmark = pytest.mark.campaign

SYSTEMS = [system.name for system in systems.ALL]
ROUTES = ("free_body", "moving_point", "kane", "lagrange")
SEED = [system.name for system in systems.SEED]
EVERY = [(s, r) for s in SYSTEMS for r in (ROUTES if s in SEED else ("free_body", "kane"))]
ONLY = ("forward_dynamics",)
STATES = 20
ROUNDINGS = 16


def decimals(equations: Equations, seed: int = 0) -> dict[str, str]:
    """A short decimal for every parameter, as a person would type it."""
    random = np.random.default_rng(seed)
    names = [symbol.name for symbol in equations.scene.parameters]
    return {name: f"{value:.2f}" for name, value in zip(names, random.uniform(0.5, 3, len(names)),
                                                        strict=True)}  # fmt: skip


def same_numbers(free: Model, fixed: Model, values: Mapping[str, str]) -> None:
    """Both models solve the equations at the same numbers, up to the roundings of the solution."""
    # Away from the states at which a route divides by zero, as the disc's at a multiple of pi / 2.
    random, names = np.random.default_rng(3), free.entries["p"]
    q, u, inputs, p = (
        random.uniform(0.3, 1.2, (STATES, len(group)))
        for group in (free.entries["q"], free.entries["u"], free.entries["inputs"], names)
    )
    for name, value in values.items():
        p[:, names.index(name)] = float(Fraction(value))
    rest = p[:, [names.index(name) for name in fixed.entries["p"]]]
    for model, given in ((free, p), (fixed, rest)):
        solved = model.evaluate("forward_dynamics", q=q, u=u, inputs=inputs, p=given)
        columns = np.hstack([q, u, inputs, p, solved["ud"], solved["multipliers"]]).T
        assert largest_residual(free.equations, free.quantities, columns) < ROUNDINGS


def largest_residual(equations: Equations, known: Quantities, columns: np.ndarray) -> float:
    """Of the rows K x = k, in epsilon times the sum of the magnitudes of the terms."""
    groups = (known.q, known.u, known.inputs, known.p, known.ud, known.multipliers)
    symbols = [entry.symbol for group in groups for entry in group]
    left, right = equations.system
    rows = [
        read_terms(
            typed_terms(Add(*(canonical(entry) * x for entry, x in
                              zip(left[i, :], equations.unknowns, strict=True))),
                        canonical(right[i])),
            symbols,
        )
        for i in range(left.rows)
    ]  # fmt: skip
    epsilon = float(np.finfo(float).eps)
    return max(float(row.ratios(list(columns), epsilon).max()) for row in rows)


@pytest.mark.sample(2)
@pytest.mark.parametrize(("system", "route"), EVERY)
def test_fixing_all_parameters_is_passing_all(derived: Any, system: str, route: str) -> None:
    equations = derived(system)[route]
    values = decimals(equations)
    fixed = compile(equations, fixed=values, outputs=ONLY)
    assert fixed.entries["p"] == ()
    assert {name: str(value) for name, value in fixed.fixed.items()} == {
        name: str(Fraction(value)) for name, value in values.items()
    }
    same_numbers(compile(equations), fixed, values)
    (finding,) = prove_compiled(fixed, ONLY)
    assert finding.shown, finding


@pytest.mark.sample(1)
@pytest.mark.parametrize("system", SYSTEMS)
def test_fixing_any_parameter_is_passing_it(derived: Any, system: str) -> None:
    equations = derived(system)["kane"]
    free = compile(equations, compiler=None)
    # Masses or lengths of a chain are alike: first, middle and last of the names are enough.
    values = list(decimals(equations, seed=1).items())
    for name, value in sorted({values[0], values[len(values) // 2], values[-1]}):
        fixed = compile(equations, compiler=None, fixed={name: value}, outputs=ONLY)
        assert set(free.entries["p"]) - set(fixed.entries["p"]) == {name}
        same_numbers(free, fixed, {name: value})
        (finding,) = prove_compiled(fixed, ONLY)
        assert finding.shown, finding


@pytest.mark.sample(1)
@pytest.mark.parametrize("system", SYSTEMS)
def test_every_function_of_a_fixed_model_is_proved(derived: Any, system: str) -> None:
    equations = derived(system)["free_body"]
    values = dict(list(decimals(equations, seed=2).items())[::2])
    findings = prove_compiled(compile(equations, fixed=values))
    assert len(findings) >= 8
    assert all(finding.shown for finding in findings), findings


COUNTED = ("forward_dynamics", "mass_matrix", "forcing", "energy")


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", SYSTEMS)
@pytest.mark.parametrize("route", ("free_body", "kane"))
def test_numbers_bound_early_never_make_a_count_larger(
    derived: Any, system: str, route: str
) -> None:
    equations = derived(system)[route]
    random, names = Random(f"{system} {route}"), [p.name for p in equations.scene.parameters]
    free = compile(equations, compiler=None, outputs=COUNTED)
    for size in (len(names), *random.choices(range(1, len(names) + 1), k=2)):
        drawn = sorted(random.sample(names, size))
        values = {name: random.choice(("1", "2", "3/7", "9.81", "0.1")) for name in drawn}
        fixed = compile(equations, compiler=None, fixed=values, outputs=COUNTED)
        for name in COUNTED:
            counts = fixed.program(name).operations, free.program(name).operations
            assert counts[0] <= counts[1], (values, name)


def is_solution(model: Model, other: Equations) -> Finding:
    """Whether the graph of forward dynamics solves the equations of another scene."""
    function, constants = model.casadi.exact("forward_dynamics")
    groups = [getattr(model.quantities, group) for group in ("q", "u", "inputs", "p")]
    symbols = [[entry.symbol for entry in group] for group in groups]
    left, right = other.system

    def rows(a: Arithmetic) -> list[tuple[Any, Any]]:
        ud, multipliers = a.graph(function, symbols=[*symbols, list(constants)])
        x = [*ud, *multipliers]
        products = [
            sum((a.value(left[i, j]) * x[j] for j in range(left.cols)), a.rational(0))
            for i in range(left.rows)
        ]
        return [(product, a.value(right[i])) for i, product in enumerate(products)]

    return decide("forward dynamics of another scene", rows)


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", ["elastic_pendulum", "rocker", "pendulum_chain",
                                    "rolling_disc", "four_bar"])  # fmt: skip
@pytest.mark.parametrize("route", ["free_body", "kane"])
def test_no_gravity_is_a_scene_without_gravity(derived: Any, system: str, route: str) -> None:
    equations = derived(system)[route]
    scene = equations.scene
    loads = tuple(load for load in scene.loads if not isinstance(load, Gravity))
    assert len(loads) < len(scene.loads)
    floating = derive(dataclasses.replace(scene, loads=loads, definitions={}), route)
    model = compile(equations, fixed={"g": 0}, outputs=ONLY)
    finding = is_solution(model, floating)
    assert finding.shown, finding
    # With gravity it is another motion.
    assert not is_solution(compile(equations, fixed={"g": 1}, outputs=ONLY), floating).shown


x, theta = dynamicsymbols("x theta")
f = dynamicsymbols("f")
m, M, L, g, c, k, b, kappa = parameters("m M L g c k b kappa")


def cart(*left_out: str) -> Scene:
    """A cart with a rod, on which every kind of load acts; some can be left out."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    B = O.locatenew("B", x * N.x)
    C = B.locatenew("C", -L / 2 * A.y)
    loads = {
        "g": gravity(-g * N.y),
        "c": damper("d", O, B, c, along=N.x),
        "k": spring("s", O, B, k, along=N.x),
        "kappa": torsion_spring("t", theta, N.z, kappa, on="rod", by="cart"),
        "b": force("F", B, b * f * N.x, on="cart"),
    }
    return Scene(
        "cart", N, O, coordinates=(x, theta), inputs=(f,),
        bodies=(Particle("cart", B, m), RigidBody("rod", C, A, M, M * L**2 / 12)),
        loads=tuple(load for name, load in loads.items() if name not in left_out),
        reactions=(
            reaction("T", at=B, on="cart", by="rod", along=N.x),
            reaction("R", at=B, on="rod", by="cart", along=N.y),
            reaction("S", at=B, on="cart", by=None, along=N.y),
        ),
    )  # fmt: skip


LEFT_OUT = [("c",), ("k",), ("g",), ("kappa",), ("b",), ("c", "b"), ("g", "k", "kappa", "c", "b")]


@pytest.mark.sample(8)
@pytest.mark.parametrize("names", LEFT_OUT, ids="-".join)
@pytest.mark.parametrize("route", ROUTES)
def test_zero_drops_the_load(names: tuple[str, ...], route: str) -> None:
    whole, less = derive(cart(), route), derive(cart(*names), route)
    model = compile(whole, fixed=dict.fromkeys(names, 0), outputs=ONLY)
    assert not set(names) & set(model.entries["p"])
    finding = is_solution(model, less)
    assert finding.shown, finding
    most = compile(whole, outputs=ONLY).program("forward_dynamics").operations
    own = compile(less, outputs=ONLY).program("forward_dynamics").operations
    assert model.program("forward_dynamics").operations == own
    assert own <= most


@pytest.mark.parametrize("route", ROUTES)
def test_no_sine_is_evaluated_that_nobody_needs(route: str) -> None:
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    C = O.locatenew("C", -L * A.y)
    scene = Scene(
        "pendulum", N, O, coordinates=(theta,), bodies=(Particle("bob", C, m),),
        loads=(gravity(-g * N.y),),
        reactions=(reaction("S", at=C, on="bob", by=None, along=A.y),),
    )  # fmt: skip
    equations = derive(scene, route)
    hanging = compile(equations, outputs=ONLY).program("forward_dynamics")
    floating = compile(equations, fixed={"g": 0}, outputs=ONLY).program("forward_dynamics")
    assert [node.operation for node in hanging.nodes].count(SIN) == 1
    assert floating.operations == 0


@pytest.mark.parametrize("route", ROUTES)
def test_a_body_without_mass_may_leave_the_equations_regular_or_not(
    derived: Any, route: str
) -> None:
    equations = derived("elastic_pendulum")[route]
    massless = compile(equations, fixed={"m": 0}, outputs=ONLY)
    (finding,) = prove_compiled(massless)
    assert finding.shown, finding
    with pytest.raises(SingularError, match=r"with M = 0.* fixed, .* without mass") as caught:
        compile(equations, fixed={"M": 0})
    assert "\n" not in str(caught.value)
