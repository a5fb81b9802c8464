"""Enclosed accelerations: right, narrow, zero where proved so, and none where M is singular."""

import mpmath
import numpy as np
import pytest
from flint import arb

from mechanics.compiled import compile
from mechanics.compiled.programs.describe import describe
from mechanics.compiled.programs.trace import trace
from mechanics.extremes.measure import measure, spacing
from mechanics.extremes.survey import GROUPS, computed
from mechanics.extremes.truth import truth
from mechanics.kernel.balls import precision

PENDULUM = ("x", "theta", "x_dot", "theta_dot", "L", "M", "g", "k", "m")


def judge(equations):
    known = compile(equations, compiler=None).quantities
    return truth(equations, [e.symbol for group in GROUPS for e in getattr(known, group)])


@pytest.fixture(scope="module")
def pendulum(derived):
    return judge(derived("elastic_pendulum", "kane"))


def by_hand(x, theta, _, theta_dot, L, M, g, k, m):
    """x'' and theta'' of the pendulum on an elastic support, by Cramer's rule in 2000 bits."""
    with mpmath.workprec(2000):
        x, theta, w, L, M, g, k, m = map(mpmath.mpf, (x, theta, theta_dot, L, M, g, k, m))
        s, c = mpmath.sin(theta), mpmath.cos(theta)
        a, b, d = M + m, M * L * c / 2, M * L**2 / 3
        f, h = M * L * w**2 * s / 2 - 2 * k * x, -M * g * L * s / 2
        det = a * d - b**2
        return (d * f - b * h) / det, (a * h - b * f) / det


@pytest.mark.parametrize("seed", range(20))
def test_the_true_value_lies_in_a_narrow_ball(pendulum, seed: int) -> None:
    random = np.random.default_rng(seed)
    values = (10.0 ** random.uniform(-12, 12, len(PENDULUM))).tolist()
    values[1] = float(random.choice([np.pi / 2, np.pi, 1e8, 1e15, 0.3, 1e-300]))
    found = pendulum.at(values)
    for ball, true in zip(found.solution, by_hand(*values), strict=True):
        with precision(2000):
            exact = arb(mpmath.nstr(true, 500))
        assert ball.rel_accuracy_bits() >= 80
        assert abs(ball - exact) <= abs(ball) * 2.0**-80


def test_a_massless_carriage_has_accelerations_and_a_massless_pendulum_has_none(pendulum) -> None:
    usual = dict(zip(PENDULUM, (0.1, 0.5, 0.0, 1.0, 1.0, 1.0, 9.81, 10.0, 1.0), strict=True))
    assert pendulum.at(list((usual | {"m": 0.0}).values())).solution is not None
    for nothing in ("M", "L"):
        assert pendulum.at(list((usual | {nothing: 0.0}).values())).solution is None


def test_the_scene_without_mass_is_the_model_with_mass_zero(derived) -> None:
    without = compile(derived("massless_carriage", "kane"))
    zero = compile(derived("elastic_pendulum", "kane"))
    random = np.random.default_rng(1)
    q, u = random.uniform(-3, 3, (2, 50, 2))
    p = {"M": 1.3, "L": 0.7, "k": 11.0, "g": 9.81}
    assert np.allclose(
        without.forward_dynamics(q, u, p=p), zero.forward_dynamics(q, u, p=p | {"m": 0}), rtol=1e-13
    )


def test_an_unknown_that_vanishes_at_every_angle_is_proved_zero(derived) -> None:
    """With the last length zero the last link feels nothing but the force along it."""
    chain = judge(derived("pendulum_chain", "kane"))
    names = chain.names
    values = dict.fromkeys(names, 0.0) | {"q1": 0.7, "q2": 0.7, "q3": 0.7, "q1_dot": 1.0}
    values |= {"l0": 1.0, "l1": 3.0, "l2": 7.0, "m0": 1.0, "m1": 3.0, "m2": 7.0, "m3": 11.0}
    found = chain.at(list(values.values()))
    # Links in line, without gravity: no angle accelerates but by the pull of the cart.
    assert found.solution is not None
    assert any(found.proved_zero) and not all(found.proved_zero)
    for zero, ball in zip(found.proved_zero, found.solution, strict=True):
        assert ball.is_zero() or not zero


def test_singular_where_only_the_angles_make_it_so(derived) -> None:
    """Two free masses at the ends of massless links in line: no mass resists their fold."""
    chain = judge(derived("pendulum_chain", "kane"))
    names = chain.names
    values = dict.fromkeys(names, 1.0) | {"q1": 0.3, "q2": 0.3, "q3": 0.9, "m1": 0.0}
    assert chain.at(list(values.values())).solution is None
    apart = chain.at(list((values | {"q2": 0.4}).values()))
    assert apart.solution is not None


@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_one_unit_of_the_last_place_is_measured_as_one(pendulum, kind) -> None:
    values = (0.25, 0.5, 0.0, 1.0, 1.0, 1.0, 9.5, 10.0, 1.0)
    found = pendulum.at(values)
    best = np.array([float(x) for x in found.solution]).astype(kind)
    assert measure(found, best.astype(float).tolist(), kind).forward <= 0.51
    for i in range(2):
        off = best.copy()
        off[i] = np.nextafter(off[i], kind(np.inf))
        errors = measure(found, off.astype(float).tolist(), kind)
        assert 0.49 <= errors.forward <= 1.51
        assert 0 < errors.backward < 2
    assert measure(found, [float("nan"), 1.0], kind).backward == float("inf")


def test_spacing_is_that_of_numpy() -> None:
    for kind in (np.float32, np.float64):
        for value in (1.0, 1.5, 0.75, 3e-39, 1e-30, 7.0e20, 0.0):
            rounded = kind(value)
            assert float(spacing(arb(float(rounded)), np.finfo(kind))) == np.spacing(abs(rounded))


def test_computed_values_are_those_of_the_model(derived) -> None:
    model = compile(derived("rolling_disc", "kane"))
    points = np.random.default_rng(2).uniform(0.1, 1.0, (5, 13))
    expected = model.forward_dynamics(points[:, :5], points[:, 5:10], p=points[:, 10:])
    assert np.array_equal(computed(model, points, np.float64), expected)


def test_what_overflows_is_named(derived) -> None:
    model = compile(derived("elastic_pendulum", "kane"), form="elimination", compiler=None)
    code = model.program("forward_dynamics")
    point = np.array([[0.1, 0.5, 0.0, 1.0, 1e200, 1.0, 9.81, 10.0, 1.0]])
    events = trace(code, point, np.float64)
    assert describe(code, int(events.broken[0]), model.entries) == "L * L"
    small = np.array([[0.1, 0.5, 0.0, 1.0, 1e-200, 1.0, 9.81, 10.0, 1.0]])
    assert (
        describe(code, int(trace(code, small, np.float64).underflow[0]), model.entries) == "L * L"
    )
    usual = np.array([[0.1, 0.5, 0.0, 1.0, 1.0, 1.0, 9.81, 10.0, 1.0]])
    assert trace(code, usual, np.float32).normal.all()
