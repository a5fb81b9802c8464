"""Linearization about steady motions, against what textbooks say of them."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from quaternions import ball_top
from steady_scenes import OMEGA, A, C, L, bead, d, foucault, g, k, m, psi, r, rotor, top
from sympy import Expr, Rational, Symbol, cos, factor, pi, sin, sqrt, symbols
from sympy.physics.mechanics import inertia
from whipple_bicycle import whipple_bicycle

from mechanics.equations import Equations
from mechanics.errors import InputError, SingularError
from mechanics.linear import (
    Linear,
    Stability,
    linearize,
    numeric_poles,
    speed_form,
    stability,
    stability_region,
    state_space,
    sweep,
)
from mechanics.mechanism import lower
from mechanics.program import Builder
from mechanics.routes.derivation import ROUTES as TABLE
from mechanics.routes.derivation import as_program
from mechanics.scene import RigidBody, Scene
from mechanics.symbolic import prove_equal
from systems import cartpole_friction, rolling_disc

ROUTES = ("free_body", "moving_point", "kane", "lagrange")
SPEED = Symbol("v", positive=True)
s = Symbol("s")


@cache
def derived(name: str, route: str = "lagrange") -> Equations:
    scenes = {
        "disc": rolling_disc.scene,
        "upright": lambda: top("xyz"),
        "euler": lambda: top("zxz"),
        "rotor": rotor,
        "table": foucault,
        "bead": lambda: bead(psi, (psi,)),
        "timed bead": lambda: bead(OMEGA * Symbol("t")),
    }
    return unwritten(route, scenes[name]())


def unwritten(route: str, scene: Scene) -> Equations:
    """Equations as a program: nothing here reads their matrices."""
    mechanism = lower(scene, Builder())
    (rows,) = (one.rows(mechanism) for one in TABLE if one.name == route)
    return as_program(scene, mechanism, rows)


def polynomial(linear: Linear) -> Expr:
    """det(s - A), factored."""
    return factor(linear.A.charpoly(s).as_expr())


def same(one: Expr, two: Expr) -> bool:
    return prove_equal("", [one], [two]).shown


@pytest.mark.sample(2)
@pytest.mark.parametrize("route", ROUTES)
def test_upright_disc_is_stable_above_its_critical_speed(route: str) -> None:
    # v^2 > g R / 3 for a thin uniform disc.
    linear = linearize(derived("disc", route), {"lean": 0}, speeds={"u2": SPEED / rolling_disc.R})
    R, weight = rolling_disc.R, rolling_disc.g
    assert [q.name for q in linear.coordinates] == ["lean", "yaw", "spin"]
    assert [q.name for q in linear.cyclic] == ["yaw", "spin"]
    assert [y.name for y in linear.states] == ["lean", "lean_dot", "yaw_dot", "spin_dot"]
    assert linear.speeds[Symbol("u4", real=True)] == SPEED
    expected = s**2 * (s**2 + Rational(12, 5) * (SPEED**2 - weight * R / 3) / R**2)
    assert same(polynomial(linear), expected)


def test_upright_ring_is_stable_above_its_critical_speed() -> None:
    # v^2 > g R / 4: all of the mass is at the rim.
    R, mass = rolling_disc.R, rolling_disc.m
    scene = rolling_disc.scene()
    (body,) = scene.bodies
    moments = (mass * R**2 / 2, mass * R**2, mass * R**2 / 2)
    ring = RigidBody("disc", body.centre, body.frame, mass, inertia(body.frame, *moments))
    equations = unwritten("lagrange", replace(scene, bodies=(ring,)))
    linear = linearize(equations, {"lean": 0}, speeds={"u2": SPEED / R})
    expected = s**2 * (s**2 + Rational(8, 3) * (SPEED**2 - rolling_disc.g * R / 4) / R**2)
    assert same(polynomial(linear), expected)


def test_disc_in_a_circle_goes_on_and_its_heading_has_no_effect() -> None:
    # Steady where 4 g sin + 6 R u2 u3 - R u3^2 tan = 0; its speeds u4, u5 turn with the heading.
    R, weight = rolling_disc.R, rolling_disc.g
    lean, turn = Rational(1, 4), Symbol("w", real=True)
    tilt = sin(lean) / cos(lean)
    roll = (R * turn**2 * tilt - 4 * weight * sin(lean)) / (6 * R * turn)
    equations = derived("disc")
    linear = linearize(equations, {"lean": lean}, speeds={"u2": roll, "u3": turn})
    values = {"w": -1.2}
    matrix, _ = state_space(linear, values)
    assert np.allclose(matrix, _by_differences(equations.scene, values["w"]), atol=1e-7)
    with pytest.raises(InputError, match=r"is no steady motion: row . of the equations leaves"):
        linearize(equations, {"lean": lean}, speeds={"u2": 2 * roll, "u3": turn})


def _by_differences(scene, turn: float) -> np.ndarray:
    """d(lean', lean'', yaw'', spin'')/d(lean, lean', yaw', spin') of the published equations."""
    R, weight = 0.5, 9.81
    lean = 0.25
    roll = (R * turn**2 * np.tan(lean) - 4 * weight * np.sin(lean)) / (6 * R * turn)

    def rates(state: np.ndarray) -> np.ndarray:
        q, u1, yaw, spin = state
        u3, tan = yaw * np.cos(q), np.tan(q)
        u2 = spin + yaw * np.sin(q)
        u1_dot = (4 * weight * np.sin(q) + 6 * R * u2 * u3 - R * u3**2 * tan) / (5 * R)
        u2_dot, u3_dot = -2 * u1 * u3 / 3, (-2 * u2 + u3 * tan) * u1
        yaw_dot = (u3_dot + u3 * tan * u1) / np.cos(q)
        return np.array([u1, u1_dot, yaw_dot, u2_dot - yaw_dot * np.sin(q) - u3 * u1])

    yaw = turn / np.cos(lean)
    start = np.array([lean, 0.0, yaw, roll - yaw * np.sin(lean)])
    step = 1e-5
    columns = [(rates(start + e) - rates(start - e)) / (2 * step) for e in step * np.eye(4)]
    return np.array(columns).T


@pytest.mark.campaign
@pytest.mark.sample(2)
@pytest.mark.parametrize("route", ROUTES)
def test_sleeping_top_needs_the_textbook_spin(route: str) -> None:
    linear = linearize(derived("upright", route), {"a": 0, "b": 0}, speeds={"c_dot": OMEGA})
    assert [q.name for q in linear.cyclic] == ["c"]
    square = (C**2 * OMEGA**2 - 2 * A * m * g * L) / A**2
    assert same(polynomial(linear), s * (s**4 + square * s**2 + (m * g * L / A) ** 2))


@pytest.mark.campaign
def test_steady_precession_nutates_with_the_textbook_frequency() -> None:
    tilt, turn = symbols("theta0 p", real=True)
    spin = (m * g * L + A * turn**2 * cos(tilt)) / (C * turn) - turn * cos(tilt)
    speeds = {"a_dot": turn, "c_dot": spin}
    linear = linearize(derived("euler"), {"b": tilt}, speeds=speeds)
    weight = m * g * L
    square = turn**2 - 2 * weight * cos(tilt) / A + (weight / (A * turn)) ** 2
    assert same(polynomial(linear), s**2 * (s**2 + square))
    with pytest.raises(InputError, match=r"the torque on b is -C\*p\*sin\(theta0\) N m, not zero"):
        linearize(derived("euler"), {"b": tilt}, speeds={**speeds, "c_dot": spin + 1})


def test_upright_euler_angles_are_refused() -> None:
    with pytest.raises(SingularError, match="singular at the operating point"):
        linearize(derived("euler"), {"b": 0}, speeds={"c_dot": OMEGA})


def test_rotor_whirls_forward_and_backward() -> None:
    linear = linearize(
        derived("rotor"), {q: 0 for q in ("x", "y", "a", "b")}, speeds={"c_dot": OMEGA}
    )
    jeffcott = (s**2 + 2 * k / m) ** 2
    tilting = (s**2 + 2 * k * L**2 / d) ** 2 + (C * OMEGA * s / d) ** 2
    assert same(polynomial(linear), s * jeffcott * tilting)
    values = {"Omega": 300.0}
    matrix, _ = state_space(linear, values)
    poles, shapes = np.linalg.eig(matrix)
    faster, slower = sorted((p.imag for p in poles if p.imag > 1), reverse=True)[::3]
    for speed, sense in ((faster, 1), (slower, -1)):
        shape = shapes[:, np.argmin(abs(poles - 1j * speed))]
        tilt_a, tilt_b = shape[[y.name for y in linear.states].index("a")], shape[3]
        # Tilts that turn with the spin: b lags a by a quarter of a turn.
        assert np.isclose(tilt_b / tilt_a, -1j * sense)


def test_bead_on_a_turned_hoop_rests_where_the_textbook_says() -> None:
    tilt = Symbol("beta", real=True)
    relation = {g: r * OMEGA**2 * cos(tilt)}
    linear = linearize(derived("bead"), {"b": tilt}, {"psi": 0}, relation, {"psi_dot": OMEGA})
    assert same(linear.stiffness[0] / linear.mass[0], (OMEGA * sin(tilt)) ** 2)
    for held in ({"b": 0}, {"b": pi}):
        above = linearize(derived("bead"), held, {"psi": 0}, speeds={"psi_dot": OMEGA})
        weight = g / r * cos(held["b"])
        assert same(above.stiffness[0] / above.mass[0], weight - OMEGA**2)
    with pytest.raises(InputError, match="b = 1/2 rad, psi = 0, psi_dot = Omega is no steady"):
        linearize(derived("bead"), {"b": 0.5}, {"psi": 0}, speeds={"psi_dot": OMEGA})


def test_mass_on_a_turning_table_has_the_frequencies_of_foucault() -> None:
    linear = linearize(derived("table"), {"x": 0, "y": 0}, {"psi": 0}, speeds={"psi_dot": OMEGA})
    expected = (s**2 + k / m - OMEGA**2) ** 2 + (2 * OMEGA * s) ** 2
    assert same(polynomial(linear), expected)


def test_what_drifts_and_has_an_effect_is_refused() -> None:
    with pytest.raises(InputError, match=r"the rate a_dot is Omega at the operating point"):
        linearize(derived("upright"), {"a": 0, "b": 0}, speeds={"a_dot": OMEGA})
    with pytest.raises(InputError, match="gives no value for coordinate b"):
        linearize(derived("upright"), {"a": 0}, speeds={"c_dot": OMEGA})


def test_friction_is_linear_where_it_slides() -> None:
    scene = cartpole_friction.scene()
    equations = unwritten("lagrange", scene)
    upright, weight = {"x": 0, "theta": 0}, cartpole_friction.m_c + cartpole_friction.m_p
    pull = {"F": cartpole_friction.mu_c * weight * cartpole_friction.g}
    linear = linearize(equations, upright, pull, speeds={"x_dot": SPEED})
    assert [q.name for q in linear.cyclic] == ["x"]
    # The cart goes on at any speed, and the pivot is viscous.
    assert same(linear.damping[1, 0], cartpole_friction.mu_p)
    with pytest.raises(InputError, match=r"sign\(x_dot\) has no slope"):
        linearize(equations, upright, pull)


def test_speeds_that_the_constraints_give_are_checked() -> None:
    R = rolling_disc.R
    fitting = {"u2": SPEED / R, "u4": SPEED}
    linear = linearize(derived("disc"), {"lean": 0, "yaw": 0}, speeds=fitting)
    assert linear.speeds[Symbol("u4", real=True)] == SPEED
    with pytest.raises(InputError, match=r"speed u\d less its given value is"):
        linearize(derived("disc"), {"lean": 0, "yaw": 0}, speeds={**fitting, "u5": 1})


def test_a_top_that_a_quaternion_turns_is_held_by_its_norm() -> None:
    equations = unwritten("lagrange", ball_top())
    hanging = dict.fromkeys(("e0", "e2", "e3"), 0) | {"e1": 1}
    linear = linearize(equations, hanging)
    assert [q.name for q in linear.coordinates] == ["e0", "e2", "e3"]
    ratio = linear.stiffness[0, 0] / linear.mass[0, 0]
    m_, g_, l_, A_ = (linear.names[name] for name in "mglA")
    assert same(ratio, m_ * g_ * l_ / (A_ + m_ * l_**2))
    with pytest.raises(InputError, match="norm of quaternion e0 e1 e2 e3, less 1, is 1 at the"):
        linearize(equations, {**hanging, "e0": 1})


def test_state_space_leaves_out_what_has_no_effect() -> None:
    linear = linearize(derived("disc"), {"lean": 0}, speeds={"u2": SPEED / rolling_disc.R})
    matrix, drive = state_space(linear, {"v": 2.0})
    numbers = {rolling_disc.R: 0.5, rolling_disc.g: 9.81, SPEED: 2.0}
    exact = np.array(linear.A.subs(numbers).tolist(), dtype=float)
    assert np.allclose(matrix, exact, rtol=1e-14)
    assert linear.B.shape == drive.shape == (4, 0)
    poles = numeric_poles(linear, {"v": 2.0})
    assert np.isclose(max(poles.imag), np.sqrt(12 / 5 * (4 / 0.25 - 9.81 / 1.5)))


def test_stability_of_steady_motions_follows_from_the_matrices() -> None:
    square = Symbol("W", positive=True)
    sleeping = {"a": 0, "b": 0}
    region = stability_region(
        linearize(derived("upright"), sleeping, speeds={"c_dot": sqrt(square)}), square
    )
    borders = [2 * A * m * g * L / C**2, 4 * A * m * g * L / C**2]
    assert len(region.lower) == 2 and not region.upper
    assert all(same(one, two) for one, two in zip(region.lower, borders, strict=True))
    numbers = {A: Rational(3, 10), C: Rational(1, 10), m: 2, L: Rational(1, 5), g: 10}
    # 4 A m g L / C^2 = 480 rad^2/s^2.
    fast = linearize(derived("upright"), sleeping, None, numbers, {"c_dot": 22})
    assert stability(fast) is Stability.BOUNDED
    slow = linearize(derived("upright"), sleeping, None, numbers, {"c_dot": 21})
    assert stability(slow) is Stability.UNSTABLE
    R, weight = rolling_disc.R, rolling_disc.g
    rolling = linearize(derived("disc"), {"lean": 0}, speeds={"u2": sqrt(square) / R})
    (border,) = stability_region(rolling, square).lower
    assert same(border, weight * R / 3)


@pytest.mark.campaign  # the package takes seconds to be imported
def test_to_control_is_the_same_state_space() -> None:
    linear = linearize(derived("table"), {"x": 0, "y": 0}, {"psi": 0}, speeds={"psi_dot": OMEGA})
    found = linear.to_control({"Omega": 3.0})
    matrix, _ = state_space(linear, {"Omega": 3.0})
    assert np.array_equal(found.A, matrix)
    assert found.state_labels == found.output_labels == ["x", "y", "x_dot", "y_dot"]
    assert np.array_equal(found.C, np.eye(4)) and not found.D.any()
    poles = np.sort(np.abs(found.poles().imag))
    assert np.allclose(poles, np.sqrt(250) + np.array([-3, -3, 3, 3]))


def test_a_disc_has_the_form_of_a_bicycle_in_its_speed() -> None:
    R, mass = rolling_disc.R, rolling_disc.m
    linear = linearize(derived("disc"), {"lean": 0}, speeds={"u2": SPEED / R})
    form = speed_form(linear, "v")
    assert form.finding.shown
    matrices = (form.M, form.C1, form.K0, form.K2)
    # Its yaw momentum is kept: 3 m v yaw' goes with it into K_2.
    expected = (5 * mass * R**2 / 4, 0, -mass * R, 3 * mass)
    assert all(same(one[0], two) for one, two in zip(matrices, expected, strict=True))
    with pytest.raises(InputError, match="not of the form M x"):
        speed_form(linearize(derived("disc"), {"lean": 0}, speeds={"u2": 1 + SPEED}), "v")
    with pytest.raises(InputError, match="rows by moving_point are no momenta"):
        there = derived("disc", "moving_point")
        speed_form(linearize(there, {"lean": 0}, speeds={"u2": SPEED / R}), "v")


@pytest.mark.campaign
@pytest.mark.parametrize("route", ["kane", "lagrange"])
def test_bicycle_has_the_published_matrices(route: str) -> None:
    # Meijaard, Papadopoulos, Ruina and Schwab 2007, equations (6.1) to (6.5) and (7.1).
    scene = whipple_bicycle()
    radius = next(p for p in scene.parameters if p.name == "rR")
    upright = {"lean": 0, "pitch": 0, "steer": 0}
    linear = linearize(unwritten(route, scene), upright, speeds={"tR_dot": -SPEED / radius})
    assert [q.name for q in linear.coordinates] == ["lean", "steer", "tF"]
    found = speed_form(linear, "v").numbers()
    published = (
        [[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]],
        [[0, 33.86641391492494], [-0.85035641456978, 1.68540397397560]],
        [[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]],
        [[0, 76.59734589573222], [0, 2.65431523794604]],
    )
    for one, two in zip(found, published, strict=True):
        assert np.allclose(one, two, rtol=0, atol=1e-13)
    weave, capsize = sweep(linear, "v", np.linspace(0.1, 10, 100).tolist()).borders
    assert abs(weave - 4.292382536341) < 1e-11
    assert abs(capsize - 6.024262015388) < 1e-10
