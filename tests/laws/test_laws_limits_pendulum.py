"""Limits of problem 1 that physics knows: stiff springs, none, a light pendulum, a short one.

(M + m) x'' + M L/2 (theta'' cos theta - theta'^2 sin theta) = -2 k x
"""

import math
from collections.abc import Callable

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from mechanics import compile, derive, simulate
from mechanics.checks.solution import solve
from mechanics.compiled import Model
from mechanics.compiled.outputs import momenta
from mechanics.kernel import Verdict
from mechanics.routes.textbook import Printer
from mechanics.scene.rates import rate, rate_table
from mechanics.symbolic import Arithmetic, decide
from systems import elastic_pendulum
from systems.elastic_pendulum import k

FINE = {"rtol": 1e-12, "atol": 1e-14}
TYPICAL = {"M": 1.0, "m": 1.0, "L": 1.0, "g": 9.81}


@pytest.fixture(scope="module")
def model() -> Model:
    return compile(derive(elastic_pendulum.scene(), "kane"))


def order(errors: list[float], step: float) -> float:
    """p where errors fall as step^-p from one to the next, the last two counting."""
    return math.log(errors[-2] / errors[-1], step)


def fixed_pivot(theta: float, t: float, extra: Callable[[float], float] = lambda _: 0.0) -> float:
    """theta(t) of a uniform rod on a fixed pivot, from rest: theta'' = -3 g/(2 L) sin theta."""

    def flow(_: float, y: np.ndarray) -> list[float]:
        return [y[1], -1.5 * TYPICAL["g"] * math.sin(y[0]) + extra(y[0])]

    found = solve_ivp(flow, (0.0, t), [theta, 0.0], method="DOP853", rtol=1e-13, atol=1e-15)
    return float(found.y[0, -1])


@pytest.mark.parametrize("route", ["free_body", "moving_point", "kane", "lagrange"])
def test_without_springs_the_momentum_along_x_stays(route: str) -> None:
    equations = derive(elastic_pendulum.scene(), route)
    scene = equations.scene
    mechanism, _ = equations.program
    linear = Printer(scene, mechanism)(momenta(mechanism)["linear"])
    growth = rate(linear[0], rate_table(scene))

    def without(a: Arithmetic) -> list[tuple[object, object]]:
        a.assign(k, a.rational(0))
        for symbol, value in zip(equations.unknowns, solve(a, equations), strict=True):
            a.assign(symbol, value)
        return [(a.value(growth), a.rational(0))]

    def with_springs(a: Arithmetic) -> list[tuple[object, object]]:
        for symbol, value in zip(equations.unknowns, solve(a, equations), strict=True):
            a.assign(symbol, value)
        return [(a.value(growth), a.value(-2 * k * scene.q[0]))]

    assert decide("dP_x/dt = 0 for k = 0", without).verdict is Verdict.PROVED
    assert decide("dP_x/dt = -2 k x", with_springs).verdict is Verdict.PROVED


@pytest.mark.campaign
def test_stiff_springs_tend_to_a_fixed_pivot(model: Model) -> None:
    """Where the energy of the springs vanishes too, theta tends to the fixed pivot's as 1/k."""
    limit = fixed_pivot(2.0, 1.0)
    errors = []
    for stiffness in (1e3, 1e4, 1e5):
        found = simulate(
            model, 1.0, initial={"x": 0.0, "theta": 2.0}, parameters={"k": stiffness},
            samples=2, **FINE,
        )  # fmt: skip
        errors.append(abs(found.coordinates["theta"][-1] - limit))
    assert order(errors, 10.0) == pytest.approx(1.0, abs=0.1)
    assert errors[-1] < 1e-3


@pytest.mark.campaign
def test_energy_that_stays_in_stiff_springs_acts_on_the_pendulum(model: Model) -> None:
    """x = sqrt(e/k): bounded energy that does not vanish, and so another limit.

    The action J = E/omega of the quick motion stays, omega(theta)^2 = 2 k / (M + m - 3/4 M cos^2
    theta), and J omega(theta) adds to the potential of the slow one (Rubin and Ungar, 1957).
    """
    energy, start, t = 2.0, 1.0, 1.0

    def heavy(theta: float) -> float:
        return 2.0 - 0.75 * math.cos(theta) ** 2

    def extra(theta: float) -> float:
        # -d/dtheta E omega(theta)/omega(start) over the inertia M L^2/3.
        slope = 1.5 * math.cos(theta) * math.sin(theta)
        return 3.0 * energy * math.sqrt(heavy(start)) * 0.5 * heavy(theta) ** -1.5 * slope

    limit, other = fixed_pivot(start, t, extra), fixed_pivot(start, t)
    errors = []
    for stiffness in (1e4, 1e5, 1e6):
        initial = {"x": math.sqrt(energy / stiffness), "theta": start}
        found = simulate(model, t, initial=initial, parameters={"k": stiffness}, samples=2, **FINE)
        x, angle = found.coordinates["x"][-1], found.coordinates["theta"][-1]
        # The quick motion takes theta along; this sum it leaves where it is.
        errors.append(abs(angle + 1.5 * math.cos(angle) * x - limit))
    assert order(errors, 10.0) == pytest.approx(0.5, abs=0.2), errors
    assert errors[-1] < 0.02 * abs(other - limit)


def test_a_light_pendulum_leaves_a_mass_on_two_springs(model: Model) -> None:
    t, errors = 2.0, []
    for mass in (1e-2, 1e-3, 1e-4):
        found = simulate(
            model, t, initial={"x": 0.1, "theta": 2.5}, parameters={"M": mass}, samples=2, **FINE
        )
        limit = 0.1 * math.cos(math.sqrt(2 * 10.0) * t)
        errors.append(abs(found.coordinates["x"][-1] - limit))
    assert order(errors, 10.0) == pytest.approx(1.0, abs=0.1)


@pytest.mark.campaign
def test_a_short_pendulum_leaves_a_sliding_mass(model: Model) -> None:
    """(M + m) x + M L/2 sin theta is driven by -2 k x alone, so that x is off by O(L)."""
    t, errors = 2.0, []
    for length in (1e-1, 1e-2, 1e-3):
        found = simulate(
            model, t, initial={"x": 0.1, "theta": 1.0}, parameters={"L": length},
            samples=201, **FINE,
        )  # fmt: skip
        limit = 0.1 * np.cos(math.sqrt(10.0) * found.times)
        errors.append(float(np.max(np.abs(found.coordinates["x"] - limit))))
        assert errors[-1] < length
    assert order(errors, 10.0) == pytest.approx(1.0, abs=0.15)


def test_a_carriage_without_mass_is_the_limit_of_a_light_one(model: Model) -> None:
    without = compile(derive(elastic_pendulum.massless(), "kane"))
    state = {"q": np.array([0.1, 2.5]), "u": np.array([0.3, -1.2])}
    limit = without.forward_dynamics(**state)
    errors = [
        float(np.max(np.abs(model.forward_dynamics(**state, p={"m": mass}) - limit)))
        for mass in (1e-2, 1e-3, 1e-4)
    ]
    assert order(errors, 10.0) == pytest.approx(1.0, abs=0.02)
    assert np.linalg.cond(without.mass_matrix(**state)) < 1e3
