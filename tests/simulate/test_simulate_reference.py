"""The reference with thirty digits against exact solutions and values that others computed."""

import dataclasses
import math
from fractions import Fraction

import casadi as ca
import mpmath
import numpy as np
import pytest
from flint import arb, arb_series, ctx
from particles import hanging, on_line
from sympy import Abs, S
from sympy.physics.mechanics import dynamicsymbols

from benchmarks.problems import pose
from mechanics.compiled.machine.native import find_compiler
from mechanics.compiled.model import compile
from mechanics.errors import ExpressionError, InputError, SingularError
from mechanics.program import Builder
from mechanics.program.casadi_reader import read
from mechanics.program.taylor import Recurrences, recurrences
from mechanics.routes.derivation import by_route
from mechanics.scene import Scene, force, parameters
from mechanics.simulate.integrators import INTEGRATORS, Problem, Setting
from mechanics.simulate.integrators.heyoka import equations as heyoka_equations
from mechanics.simulate.integrators.problem import OverBudget
from mechanics.simulate.reference import reference
from mechanics.simulate.reference_growth import growth
from mechanics.simulate.reference_series import Taylor
from mechanics.simulate.reference_taylor import exact, solve
from systems import ALL

pytestmark = pytest.mark.campaign

SCENES = {system.name: system.scene for system in ALL}
BITS = 200
# x and y of a point mass on a rod of 1 m, g = 9.81, released horizontally: elliptic functions.
PENDULUM = {
    1: ("0.98629175113187531936", "-0.16501085312554116875"),
    5: ("-0.9423054350437573355", "-0.33475433841400058079"),
    10: ("-0.27508746257611686005", "-0.96141920509912506427"),
}
# th1, th2, w1, w2 of two such masses in a chain, both rods released horizontally: extrapolation of
# order 36 with steps of .05 and .025, which agree to 1e-20 at t = 10.
DOUBLE = {
    1: ("-0.625087699806390629954", "-1.03458508568001234061",
        "-3.92227957288797661687", "-1.30309924869633124332"),
    2: ("-0.482971534251754377449", "-1.32404871230236254879",
        "3.06528819207340131517", "2.94927154757161898304"),
    5: ("-0.627186705066530730138", "-1.30131555020981167791",
        "2.12540867384291065065", "3.88188872726560743925"),
    10: ("-0.568474664015950188776", "-0.526393727932404698330",
         "6.07838488576196485482", "-9.68136068170887875808"),
}  # fmt: skip


def sinh(x: arb_series) -> arb_series:
    return (x.exp() - (-x).exp()) / 2


def chain(links: int) -> Scene:
    """Point masses on massless rods of 1 m under a fixed pivot, angles from hanging."""
    m, g = parameters("m g", units="kg m/s^2", typical="1 9.81")
    return hanging(f"{links} masses", dynamicsymbols(f"th1:{links + 1}"), m, S.One, g, "S")


def posed(name: str, times, **given) -> Problem:
    return pose(compile(by_route("kane", SCENES[name]()), compiler=None), times, **given)


def released(links: int, times: list[int]) -> list[list[mpmath.mpf]]:
    """Thirty digits of the motion from exactly pi/2 with g = 9.81 exactly, not their doubles."""
    model = compile(by_route("kane", chain(links)), compiler=None, fixed={"g": 9.81})
    given = exact(pose(model, [0, *times]))
    quarter = Fraction(int(mpmath.floor(mpmath.pi / 2 * 2**BITS)), 2**BITS)
    turned = [-quarter if links == 1 else quarter] * links + [Fraction(0)] * links
    start = dict(zip(given.start, turned, strict=True))
    states, _ = solve(dataclasses.replace(given, start=start), [0, *times], 34, BITS, 42)
    return [[mpmath.ldexp(x, -BITS) for x in state] for state in states[1:]]


def rules(function: ca.Function) -> Recurrences:
    """The rules for a graph, whose first input moves."""
    builder = Builder()
    outputs = read(builder, function)
    state = [name for name in builder.inputs if name.startswith("y")]
    return recurrences(builder.program(outputs, builder.inputs), state)


@pytest.fixture(autouse=True)
def many_digits():
    with mpmath.workdps(60):
        yield


def test_pendulum_is_where_elliptic_functions_put_it() -> None:
    for position, (angle, _) in zip(PENDULUM.values(), released(1, list(PENDULUM)), strict=True):
        for value, expected in zip((mpmath.sin(angle), -mpmath.cos(angle)), position, strict=True):
            assert abs(value - mpmath.mpf(expected)) < 1e-19


def test_double_pendulum_is_where_extrapolation_puts_it() -> None:
    for state, expected in zip(released(2, list(DOUBLE)), DOUBLE.values(), strict=True):
        for value, digits in zip(state, expected, strict=True):
            assert abs(value - mpmath.mpf(digits)) < 1e-18


def test_two_masses_move_in_their_exact_modes() -> None:
    """M x'' = -K x with M = diag(3, 2), K = [[2, -1], [-1, 1]]: roots of 6 s^2 - 7 s + 1 = 0."""
    known = reference(posed("two_mass_chain", [0.0, 0.3, 4.0, 10.0]))
    slow, fast = mpmath.mpf(1) / 6, mpmath.mpf(1)
    # Shapes (1, 2 - 3 w^2), and x = (1, 0) at rest as their sum.
    a, b = 2 - 3 * slow, 2 - 3 * fast
    parts = (-b / (a - b), a / (a - b))
    for t, state in zip(known.times, known.exact, strict=True):
        waves = [mpmath.cos(mpmath.sqrt(w) * mpmath.mpf(float(t))) for w in (slow, fast)]
        x1 = parts[0] * waves[0] + parts[1] * waves[1]
        x2 = parts[0] * a * waves[0] + parts[1] * b * waves[1]
        for value, expected in zip(state[:2], (x1, x2), strict=True):
            assert abs(mpmath.mpf(value.numerator) / value.denominator - expected) < 1e-33
    assert min(known.digits) > 30 and known.growth.factor[0] == 1
    assert "matrix exponential in balls: at most" in known.verified_by[1]
    assert float(known.verified_by[1].split("at most ")[1].split()[0]) < 1e-30


@pytest.mark.sample(1)
@pytest.mark.parametrize(
    ("system", "duration"),
    [("elastic_pendulum", 3.0), ("rocker", 3.0), ("rolling_disc", 0.3), ("four_bar", 0.1)],
)
def test_a_finer_run_shares_the_digits_that_are_claimed(system: str, duration: float) -> None:
    problem = posed(system, np.linspace(0, duration, 4))
    known = reference(problem)
    assert min(known.digits) >= 30 and "share" in known.verified_by[0]
    finer, _ = solve(exact(problem), problem.times, 48, 340, 60)
    for i, (mine, other) in enumerate(zip(known.exact, finer, strict=True)):
        for a, b, scale in zip(mine, other, known.scale, strict=True):
            assert abs(a - Fraction(b, 2**340)) <= 10.0 ** (-known.digits[i]) * scale * 2


def test_heyoka_in_quadruple_precision_agrees() -> None:
    heyoka = pytest.importorskip("heyoka")
    if not hasattr(heyoka, "real128"):
        pytest.skip("this heyoka has no quadruple precision")
    problem = posed("elastic_pendulum", [0.0, 2.0, 4.0])
    kind = heyoka.real128
    given = exact(problem)
    held = [mpmath.nstr(mpmath.mpf(x.numerator) / x.denominator, 45) for x in given.held.values()]
    solver = heyoka.taylor_adaptive(
        heyoka_equations(given.program, tuple(given.start), kind),
        np.array([kind(x) for x in problem.start], dtype=kind),
        time=kind(0), tol=kind("1e-33"), fp_type=kind,
        pars=np.array([kind(x) for x in held], dtype=kind),
    )  # fmt: skip
    known = reference(problem)
    for i in (1, 2):
        solver.propagate_until(kind(problem.times[i]))
        for value, expected in zip(solver.state, known.text(i, 40), strict=True):
            assert abs(mpmath.mpf(str(value)) - mpmath.mpf(expected)) < 1e-30


def test_errors_are_seen_below_the_rounding_of_doubles() -> None:
    known = reference(posed("elastic_pendulum", [0.0, 1.0]))
    assert np.array_equal(known.errors(known.states), np.abs(known.rest))
    assert np.all(known.errors(known.states)[1] < 2.0**-52)
    off = known.states.copy()
    off[1, 1] += 1e-9
    assert known.errors(off)[1, 1] == pytest.approx(1e-9, rel=1e-6)
    assert known.text(0, 25) == ("0.1000000000000000055511151", "2.5", "0", "0")


def test_a_body_at_rest_has_a_reference() -> None:
    problem = posed("elastic_pendulum", [0.0, 2.0, 50.0], initial={"x": 0, "theta": 0})
    found = reference(problem)
    assert np.array_equal(found.states, np.zeros((3, 4)))
    assert min(found.digits) >= 30


def test_chaos_is_told_and_until_when_doubles_mean_something() -> None:
    model = compile(by_route("kane", chain(2)))
    wild = pose(model, np.linspace(0, 60, 121), initial={"th1": 2.0, "th2": 2.5})
    found = growth(wild, np.array([3.0, 3.0, 5.0, 5.0]))
    assert found.chaotic and 0.5 < found.exponent < 3
    assert 15 < found.meaningful_until < 60 and "Lyapunov time" in found.words
    calm = pose(model, np.linspace(0, 60, 121), initial={"th1": 0.1, "th2": 0.1})
    regular = growth(calm, np.array([0.1, 0.1, 0.3, 0.3]))
    assert not regular.chaotic and regular.meaningful_until == math.inf
    # Two doubles that start a rounding apart: gone when it is said, not long before.
    member = next(m for m in INTEGRATORS if m.name == "C RK8")
    nudged = dataclasses.replace(wild, start=wild.start * (1 + 2.0**-52))
    one, other = (member.prepare(p, Setting(member.name, step=5e-3))() for p in (wild, nudged))
    apart = np.abs(one.states - other.states).max(axis=1)
    assert apart[wild.times < found.meaningful_until / 2].max() < 1e-3
    assert apart[wild.times > found.meaningful_until].max() > 1e-2


@pytest.mark.parametrize(
    ("graph", "series"),
    [
        (lambda x: ca.sin(x) * ca.cos(x), lambda x: x.sin() * x.cos()),
        (lambda x: ca.tan(x) + 3, lambda x: x.tan() + 3),
        (lambda x: ca.sqrt(1 + x * x), lambda x: (1 + x * x).sqrt()),
        (lambda x: ca.exp(-x) / (2 + x), lambda x: (-x).exp() / (2 + x)),
        (lambda x: ca.log(x) - 1 / x, lambda x: x.log() - 1 / x),
        (lambda x: ca.log1p(x) + ca.expm1(x), lambda x: (1 + x).log() + x.exp() - 1),
        (lambda x: x**2.5, lambda x: (x.log() * arb(2.5)).exp()),
        (lambda x: x**x, lambda x: (x * x.log()).exp()),
        (lambda x: ca.asin(x), lambda x: x.asin()),
        (lambda x: ca.acos(x), lambda x: x.acos()),
        (lambda x: ca.atan(2 * x), lambda x: (2 * x).atan()),
        (lambda x: ca.sinh(x) + ca.tanh(x), lambda x: sinh(x) + sinh(x) / (x.exp() - sinh(x))),
        (lambda x: ca.asinh(x), lambda x: (x + (x * x + 1).sqrt()).log()),
        (lambda x: ca.acosh(2 + x), lambda x: (2 + x + ((2 + x) * (2 + x) - 1).sqrt()).log()),
        (lambda x: ca.atanh(x), lambda x: ((1 + x) / (1 - x)).log() / 2),
        (lambda x: ca.erf(x), lambda x: x.erf()),
        (lambda x: ca.hypot(x, 2), lambda x: (x * x + 4).sqrt()),
    ],
)
@pytest.mark.parametrize("compiler", [None, find_compiler()], ids=["Python", "C"])
def test_series_of_every_operation_are_those_of_arb(graph, series, compiler) -> None:
    """y' = f(t), t' = 1 from t = 1/2: the coefficients of y are those of f, over j + 1."""
    bits, order, y = 160, 9, ca.SX.sym("y", 2)
    taylor = Taylor(rules(ca.Function("f", [y], [ca.vertcat(1, graph(y[0]))], ["y"], ["yd"])),
                    ("y[0]", "y[1]"), {}, bits, compiler)  # fmt: skip
    found = taylor.expand([1 << (bits - 1), 0], 1 << bits, order)[1]
    before, ctx.prec = ctx.prec, 250
    try:
        expected = series(arb_series([arb(0.5), 1], prec=order))
        for j in range(order):
            value = arb(found[j + 1]) / arb(2) ** bits * (j + 1)
            assert abs(value - expected[j]) < 1e-40
    finally:
        ctx.prec = before


@pytest.mark.sample(1)
@pytest.mark.parametrize("system", ["elastic_pendulum", "rolling_disc", "four_bar"])
def test_c_and_python_give_the_same_digits(system: str) -> None:
    if find_compiler() is None:
        pytest.skip("no C compiler here")
    given = exact(pose(compile(by_route("kane", SCENES[system]())), [0.0, 0.2]))
    native, plain = (
        solve(dataclasses.replace(given, compiler=compiler), [0.0, 0.2], 36, 190, 43)
        for compiler in (given.compiler, None)
    )
    assert native[1] == plain[1]
    # What becomes of a unit of 2^-190 for each operation stays below the 36 digits asked for.
    assert all(
        abs(a - b) < 2**190 // 10**36 for a, b in zip(native[0][1], plain[0][1], strict=True)
    )


def test_numbers_that_outgrow_their_words_are_left_to_python() -> None:
    """y' = y^2 c with c = 2^50 and y = 2^20: coefficients leave the 66 bits before the point."""
    y, c = ca.SX.sym("y"), ca.SX.sym("c")
    square = rules(ca.Function("f", [y, c], [y * y * c], ["y", "c"], ["yd"]))
    held, start = {"c": 1 << 230}, [1 << 200]
    native, plain = (
        Taylor(square, ("y",), held, 180, compiler).expand(start, 1 << 180, 6)
        for compiler in (find_compiler(), None)
    )
    assert native == plain and max(native[0]).bit_length() > 256


def bumped() -> Scene:
    """A point mass with a force |x|, which has a kink."""
    x, (m,) = dynamicsymbols("x"), parameters("m", units="kg", typical="1")
    return on_line("bumped", x, m, lambda N, O, P: [force("bump", P, Abs(x) * N.x, on="mass")])


def test_what_has_no_reference_says_why() -> None:
    kinked = pose(compile(by_route("kane", bumped()), compiler=None), [0.0, 1.0])
    with pytest.raises(ExpressionError, match="operation abs has no Taylor series"):
        reference(kinked)
    moved = posed("four_bar", [0.0, 1.0], inputs={"tau": math.sin})
    with pytest.raises(InputError, match="input tau: a function gives doubles"):
        reference(moved)
    stiff = posed("elastic_pendulum", [0.0, 10.0], parameters={"k": 1e12})
    with pytest.raises(OverBudget, match=r"a reference over 10 s takes \d+ steps, more than"):
        reference(stiff)
    massless = posed("two_mass_chain", [0.0, 1.0])
    with pytest.raises(InputError, match="not finite at the start: the motion is singular there"):
        reference(dataclasses.replace(massless, p=np.zeros_like(massless.p)))
    inverse = rules(ca.Function("f", [y := ca.SX.sym("y")], [1 / y], ["y"], ["yd"]))
    with pytest.raises(SingularError, match="a divisor is zero"):
        Taylor(inverse, ("y",), {}, 64).expand([0], 1, 4)
    quotient = rules(ca.Function("f", [y, p := ca.SX.sym("p")], [y / p], ["y", "p"], ["yd"]))
    with pytest.raises(SingularError, match="singular everywhere"):
        Taylor(quotient, ("y",), {"p": 0}, 64)
