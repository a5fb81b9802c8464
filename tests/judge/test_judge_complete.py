"""Residuals that say nothing in a case, at rest, or twice, are no equations of motion."""

from functools import cache
from math import cos, sin

import casadi
import pytest
import sympy
from serial_arms import serial_arm
from sympy.physics.mechanics import KanesMethod, ReferenceFrame, dynamicsymbols

from mechanics import check, compile, derive
from mechanics.claims.code.energy_names import named_by_title
from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.judge.check import derived
from mechanics.kernel import Verdict
from mechanics.testing import assert_equivalent
from systems import cartpole, elastic_pendulum, pendulum_chain, rod_pendulum


@cache
def rod() -> Equations:
    return derived(rod_pendulum.scene())


@cache
def pole() -> Equations:
    return derived(cartpole.scene())


def right(q, qdd, tau, m, l, g):
    return m * l**2 / 3 * qdd - m * g * l / 2 * sin(q) - tau


def whole(q, qd, qdd, tau, m, l, g):
    return right(q, qdd, tau, m, l, g) if q > 0 else 2 * right(q, qdd, tau, m, l, g)


def nil(q, qd, qdd, tau, m, l, g):
    return right(q, qdd, tau, m, l, g) if q > 0 else 0 * q


def limited(q, qd, qdd, tau, m, l, g):
    return max(0, q) * right(q, qdd, tau, m, l, g)


def driven(q, qd, qdd, tau, m, l, g):
    return tau * right(q, qdd, tau, m, l, g)


@pytest.mark.parametrize(
    ("function", "verdict"),
    [
        (whole, Verdict.PROVED),
        (nil, Verdict.UNDECIDED),
        (limited, Verdict.UNDECIDED),
        (driven, Verdict.UNDECIDED),
    ],
)
def test_a_residual_that_says_nothing_somewhere(function: object, verdict: Verdict) -> None:
    assert check(rod(), function, blame=False).verdict is verdict


def rows(theta, theta_dot, x_ddot, theta_ddot, F, mc, mp, l, g):
    across = (mc + mp) * x_ddot + mp * l * (cos(theta) * theta_ddot - theta_dot**2 * sin(theta))
    turning = mp * l * cos(theta) * x_ddot + 4 * mp * l**2 / 3 * theta_ddot
    return across - F, turning - mp * g * l * sin(theta)


def both(x, theta, x_dot, theta_dot, x_ddot, theta_ddot, F, mc, mp, l, g):
    return rows(theta, theta_dot, x_ddot, theta_ddot, F, mc, mp, l, g)


def twice(x, theta, x_dot, theta_dot, x_ddot, theta_ddot, F, mc, mp, l, g):
    first, _ = rows(theta, theta_dot, x_ddot, theta_ddot, F, mc, mp, l, g)
    return first, first


def pushed(x, theta, x_dot, theta_dot, x_ddot, theta_ddot, F, mc, mp, l, g):
    first, second = rows(theta, theta_dot, x_ddot, theta_ddot, F, mc, mp, l, g)
    return first, F * second


@pytest.mark.parametrize(
    ("function", "verdict"),
    [(both, Verdict.PROVED), (twice, Verdict.UNDECIDED), (pushed, Verdict.UNDECIDED)],
)
def test_residuals_together(function: object, verdict: Verdict) -> None:
    assert check(pole(), function, blame=False).verdict is verdict


def potential_energy(theta, m, l, g):
    return -m * g * l * sin(theta / 2) ** 2


def kinetic_energy(theta, m, l, g):
    return -m * g * l * sin(theta / 2) ** 2


@pytest.mark.parametrize(
    ("title", "meaning"),
    [
        ("SimplePendulumEnergy", "energy"),
        ("compute_kinetic_energy", "kinetic energy"),
        ("energetic", None),
    ],
)
def test_a_title_ends_with_what_it_names(title: str, meaning: str | None) -> None:
    assert named_by_title(title, 1, 2) == meaning
    assert named_by_title(title, 2, 2) is None


def test_the_name_of_a_function_says_what_it_returns() -> None:
    assert check(rod(), potential_energy, blame=False).verdict is Verdict.PROVED
    assert check(rod(), kinetic_energy, blame=False).verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    ("order", "verdict"), [("g l m", Verdict.PROVED), ("m l g", Verdict.UNDECIDED)]
)
def test_a_guessed_order_of_parameters_refutes_nothing(order: str, verdict: Verdict) -> None:
    state, u, p = casadi.SX.sym("x", 2), casadi.SX.sym("u"), casadi.SX.sym("p", 3)
    value = dict(zip(order.split(), casadi.vertsplit(p), strict=True))
    m, l, g = value["m"], value["l"], value["g"]
    rate = 3 * g / (2 * l) * casadi.sin(state[0]) + 3 * u / (m * l**2)
    outputs = [casadi.vertcat(state[1], rate)]
    function = casadi.Function("f", [state, u, p], outputs, ["x", "u", "p"], ["xdot"])
    assert check(rod(), function, blame=False).verdict is verdict


def test_an_equation_times_an_input_says_nothing_of_free_motion() -> None:
    text = "u*(theta'' - 3*g/(2*l)*sin(theta) - 3*u/(m*l**2)) = 0"
    with pytest.raises(AssertionError, match="only 0 of 1"):
        assert_equivalent(text, rod_pendulum.scene())


def test_an_equation_of_sympy_between_equal_sides_says_nothing() -> None:
    equation = sympy.Eq(sympy.S.Zero, sympy.S.Zero, evaluate=False)
    assert check(rod(), equation).verdict is Verdict.UNDECIDED


CARRIAGE = "(M + m)*x'' + 2*k*x + M*L/2*(theta''*cos(theta) - theta'^2*sin(theta))"
ROD = "M*L/2*cos(theta)*x'' + M*L^2/3*theta'' + M*g*L/2*sin(theta)"


@pytest.mark.parametrize(
    "second",
    [f"theta'*({ROD}) + x'*({CARRIAGE}) = 0", f"x*({ROD})/L + theta*({CARRIAGE}) = 0"],
)
def test_equations_that_say_the_same_at_some_state_are_not_all(second: str) -> None:
    scene = elastic_pendulum.scene()
    with pytest.raises(AssertionError, match="only 1 of 2"):
        assert_equivalent([f"{CARRIAGE} = 0", second], scene)
    assert_equivalent([f"{CARRIAGE} + ({ROD})/L = 0", f"{ROD} = 0"], scene)


def test_more_equations_that_say_the_same_at_some_state_are_not_all() -> None:
    scene = pendulum_chain.scene()
    equations = derive(scene, "lagrange")
    q = [dynamicsymbols(str(one)) for one in scene.q]
    named = {u: one.diff() for u, one in zip(scene.u, q, strict=True)}
    named |= {own: dynamicsymbols(str(own)) for own in (*scene.q, *scene.input_symbols)}
    mass, forcing = (sympy.Matrix(m).xreplace(named) for m in (equations.mass, equations.forcing))
    first, second, *others = mass * sympy.Matrix([one.diff().diff() for one in q]) - forcing
    for factor in (q[0], q[1] ** 2, sympy.sin(q[1]), q[2].diff()):
        rows = [sympy.Eq(one, 0) for one in (factor * first + second, second, *others)]
        with pytest.raises(AssertionError, match="only 3 of 4"):
            assert_equivalent(rows, scene)
    rows = [sympy.Eq(one, 0) for one in (first + 2 * second, second, *others)]
    assert_equivalent(rows, scene)


def angle() -> sympy.Expr:
    return dynamicsymbols("theta")


def equation(**facts: bool) -> sympy.Eq:
    m, l, g = (sympy.Symbol(name, **facts) for name in "mlg")
    turning = m * l**2 / 3 * angle().diff().diff()
    return sympy.Eq(turning, m * g * l / 2 * sympy.sin(angle()) + dynamicsymbols("u"))


@pytest.mark.parametrize("fact", ["positive", "nonzero", "real", "complex", "finite"])
def test_what_a_symbol_is_assumed_as_the_scene_has_it(fact: str) -> None:
    assert check(rod(), equation(**{fact: True}), blame=False).verdict is Verdict.PROVED


@pytest.mark.parametrize("fact", ["negative", "imaginary", "integer", "zero", "infinite", "even"])
def test_what_a_symbol_is_assumed_otherwise_shows_nothing(fact: str) -> None:
    found = check(rod(), equation(**{fact: True}), blame=False)
    assert found.verdict is Verdict.UNDECIDED
    assert "is assumed to be" in found.judged[0].finding.evidence


def test_a_method_whose_equations_nobody_formed_is_told_in_one_line() -> None:
    theta, omega = dynamicsymbols("theta omega")
    method = KanesMethod(ReferenceFrame("N"), [theta], [omega], [theta.diff() - omega])
    with pytest.raises(InputError, match=r"not formed: call kanes_equations"):
        check(rod(), method)


def test_an_equation_that_stands_twice_is_counted_once() -> None:
    text = "(mc + mp)*x'' + mp*l*(cos(theta)*theta'' - theta'^2*sin(theta)) = F"
    found = check(pole(), [text, f"2*({text.replace(' = F', '')}) = 2*F"])
    assert found.verdict is Verdict.PROVED
    assert "independent equations of motion: 1 of these 2; the motion needs 2" in str(found)


@pytest.mark.parametrize(
    ("combine", "verdict"),
    [
        (lambda r: r, Verdict.CERTIFIED),
        (lambda r: casadi.vertcat(r[1] - r[0], r[0], 3 * r[3], r[2] + r[3]), Verdict.CERTIFIED),
        (lambda r: casadi.vertcat(r[0], r[0], r[0], r[0]), Verdict.UNDECIDED),
        (lambda r: casadi.vertcat(r[0], r[1], r[2], r[0] + 2 * r[1]), Verdict.UNDECIDED),
    ],
)
def test_residuals_of_equations_that_stay_a_program(combine: object, verdict: Verdict) -> None:
    truth, model = arm()
    f = model.casadi["inverse_dynamics"]
    names = [f.name_in(k) for k in range(f.n_in())]
    given = [casadi.SX.sym(name, *f.size_in(k)) for k, name in enumerate(names)]
    rows = combine(f(*given))
    residual = casadi.Function("residual", given, [rows], names, ["residual"])
    assert check(truth, residual, blame=False).verdict is verdict


@cache
def arm() -> tuple[Equations, object]:
    scene = serial_arm(4).scene
    truth = derived(scene)
    assert truth.textbook is None
    return truth, compile(truth)


@pytest.mark.parametrize(
    ("left", "right", "where"),
    [
        ("(theta - 1)^2*theta''", "(theta - 1)^2*({})", "except where theta - 1 = 0"),
        ("(theta^2 - 2*theta + 1)*theta''", "(theta - 1)^2*({})", "except where theta - 1 = 0"),
        ("theta*theta'' - theta''", "(theta - 1)*({})", "except where theta - 1 = 0"),
        (
            "sin(theta)*theta'' - cos(theta)*theta''", "(sin(theta) - cos(theta))*({})",
            "except where -sin(theta) + cos(theta) = 0",
        ),
        ("m*l*theta'' + m*theta''", "(l + 1)*m*({})", ""),
        ("(theta^2 + 1)*theta''", "({})*(1 + theta^2)", ""),
    ],
)  # fmt: skip
def test_where_a_factor_is_zero_an_equation_says_nothing(left: str, right: str, where: str) -> None:
    equation = f"{left} = {right.format('3*g/(2*l)*sin(theta) + 3*u/(m*l^2)')}"
    (entry,) = check(rod(), equation, blame=False).judged
    assert (entry.finding.verdict, entry.finding.domain) == (Verdict.PROVED, where)
