"""Stability from signs of coefficients, against the poles in numbers; borderlines in a gain."""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from sympy import And, Gt, Lt, Symbol, pi, symbols
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics import (
    Particle,
    RigidBody,
    Scene,
    force,
    gravity,
    parameters,
    pin,
    reaction,
    slide,
    torque,
)
from mechanics.errors import ExpressionError, InputError
from mechanics.linear import (
    Stability,
    close_loop,
    conditions,
    linearize,
    numeric_poles,
    stability,
    stability_region,
    verdict,
)
from mechanics.linear.algebra import sign
from mechanics.routes.derivation import by_route
from systems import half_car, rocker, two_mass_chain


@pytest.fixture(scope="module")
def upright():
    return linearize(by_route("lagrange", rocker.scene()), {"theta": 0}, {"f": 0})


def test_rocker_without_control_falls(upright) -> None:
    assert stability(upright) is Stability.UNSTABLE
    assert stability(upright).stable is False
    assert numeric_poles(upright)[0].real > 0


def test_rocker_needs_a_gain_above_the_borderline(upright, gain) -> None:
    K, r = gain
    loop = close_loop(upright, {"f": K * (r - rocker.theta)}, (r,))
    region = stability_region(loop, K)
    border = rocker.M * rocker.g / 3
    assert region.lower == (border,)
    assert region.upper == ()
    assert region.stable == Gt(K, border)
    assert stability(loop) is Stability.OPEN
    above, below = (numeric_poles(loop, {"M": 1.0, "K": 9.81 / 3 * f}) for f in (1.01, 0.99))
    assert np.abs(above.real).max() < 1e-9 < below.real.max()


def test_two_mass_chain_oscillates() -> None:
    linear = linearize(by_route("lagrange", two_mass_chain.scene()), {"x1": 0, "x2": 0})
    assert stability(linear) is Stability.BOUNDED


@pytest.mark.parametrize("dampings", [(1,), (1, 1), (0, 1), (1, 0)])
def test_damped_rows_come_to_rest(row, constants, dampings) -> None:
    m, k, c = constants
    n = len(dampings)
    linear = row((m,) * n, (k,) * n, tuple(c * f for f in dampings))
    assert stability(linear) is Stability.ASYMPTOTIC
    assert numeric_poles(linear).real.max() < 0


def test_gain_between_two_bounds(row, constants) -> None:
    # Negative stiffness K and negative damping K: m s^2 + (c - K) s + k + K.
    m, k, c = constants
    K = Symbol("K", real=True)
    plant = row((m,), (k,), (c,))
    (x,) = plant.scene.coordinates
    region = stability_region(close_loop(plant, {"F": K * x.diff("t") - K * x}), K)
    assert region.stable == And(Gt(K, -k), Lt(K, c))


def test_hurwitz_finds_what_positive_coefficients_hide(row, constants) -> None:
    # s^4 + s^3 + ... with all coefficients positive and two poles in the right half plane.
    m, k, c = constants
    plant = row((m, m), (k, k), (0, c))
    x1, _ = plant.scene.coordinates
    loop = close_loop(plant, {"F": -2 * k * x1})
    *coefficients, determinant = conditions(loop)
    assert [sign(entry) for entry in coefficients] == [1, 1, 1, 1]
    assert sign(determinant) == -1
    assert stability(loop) is Stability.UNSTABLE
    assert numeric_poles(loop).real.max() > 0


@pytest.mark.campaign
@settings(
    max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(gains=st.lists(st.integers(-12, 12), min_size=4, max_size=4))
def test_conditions_agree_with_the_poles(row, gains) -> None:
    plant = row((1, 2), (3, 4), (1, 1))
    x1, x2 = plant.scene.coordinates
    p, q, u, v = gains
    loop = close_loop(plant, {"F": p * x1 + q * x2 + u * x1.diff("t") + v * x2.diff("t")})
    slowest = numeric_poles(loop).real.max()
    if abs(slowest) < 1e-9:
        return
    expected = Stability.ASYMPTOTIC if slowest < 0 else Stability.UNSTABLE
    found = stability(loop)
    assert found is expected or (found is Stability.OPEN and slowest > 0)


def test_circulatory_pair_flutters(row) -> None:
    # Equal oscillators, coupled by a force that follows the other one: x'' + x = (0, K y).
    plant = row((1, 1), (2, 1, 2))
    x1, _ = plant.scene.coordinates
    loop = close_loop(plant, {"F": -5 * x1})
    assert stability(loop) is Stability.UNSTABLE
    assert numeric_poles(loop).real.max() > 0.1


def test_gain_that_changes_nothing_is_refused(upright, gain) -> None:
    K, _ = gain
    with pytest.raises(InputError, match="which K does not change"):
        stability_region(upright, K)
    linear = linearize(by_route("lagrange", two_mass_chain.scene()), {"x1": 0, "x2": 0})
    with pytest.raises(InputError, match="K changes nothing about stability"):
        stability_region(linear, K)


def test_condition_that_is_not_linear_in_the_gain_is_refused(row, constants) -> None:
    m, k, c = constants
    K = Symbol("K", real=True)
    plant = row((m,), (k,), (c,))
    (x,) = plant.scene.coordinates
    with pytest.raises(ExpressionError, match="no single linear factor in K"):
        stability_region(close_loop(plant, {"F": (K**2 - 2 * k) * x}), K)


def test_sign_is_known_only_where_the_parameters_settle_it() -> None:
    a, b = symbols("a b", positive=True)
    K = Symbol("K", real=True)
    assert sign(a**2 - 2 * a * b + b**2 + 2 * a * b) == 1
    assert sign(-a / (a + b)) == -1
    assert sign((a + b) ** 2 - a**2 - 2 * a * b - b**2) == 0
    assert sign(a - b) is None
    assert sign(K) is None


@pytest.mark.campaign
def test_conditions_that_are_too_long_say_so() -> None:
    rest = dict.fromkeys(("x", "theta", "x1", "x2"), 0)
    linear = linearize(by_route("kane", half_car.scene()), rest, {"y1": 0, "y2": 0})
    assert stability(linear) is Stability.ASYMPTOTIC
    with pytest.raises(ExpressionError, match="8 poles in 12 parameters are too long"):
        conditions(linear)


@pytest.mark.parametrize("damper", ["ground", "between", "ends alike"])
def test_damping_that_a_mode_escapes_does_not_end_it(damper: str) -> None:
    """Two equal masses, three equal springs: the masses swing together past a damper between."""
    x, y = dynamicsymbols("x y")
    m, k, c = parameters("m k c", units="kg N/m N*s/m", typical="1 1 1")
    N, O = ReferenceFrame("N"), Point("O")
    one, two = O.locatenew("A", x * N.x), O.locatenew("B", y * N.x)
    apart = c * (x.diff() - y.diff())
    pulls = {"ground": (-c * x.diff(), 0), "ends alike": (-c * x.diff(), -c * y.diff()),
             "between": (-apart, apart)}[damper]  # fmt: skip
    masses = (Particle("one", one, m), Particle("two", two, m))
    springs = (-k * x - k * (x - y), -k * y - k * (y - x))
    places = {"one": one, "two": two}
    loads = tuple(
        force(f"F_{name}", place, (spring + pull) * N.x, on=name)
        for (name, place), spring, pull in zip(places.items(), springs, pulls, strict=True)
    )
    guides = tuple(reaction(f"R_{name}", at=place, on=name, by=None, along=N.y)
                   for name, place in places.items())  # fmt: skip
    scene = Scene("between walls", N, O, plane=N.z, coordinates=(x, y), bodies=masses, loads=loads,
                  reactions=guides)  # fmt: skip
    expected = Stability.OPEN if damper == "between" else Stability.ASYMPTOTIC
    assert stability(linearize(by_route("kane", scene), {"x": 0, "y": 0})) is expected


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("cart", "rod", "expected", "words"),
    [
        (1, 1, Stability.NEIGHBOUR, "a pole at 0: x may rest anywhere"),
        (1, 0, Stability.NEIGHBOUR, "a pole at 0: x may rest anywhere"),
        (0, 1, Stability.DRIFTING, "a double pole at 0: x may drift"),
        (0, 0, Stability.DRIFTING, "a double pole at 0: x may drift"),
    ],
)
@pytest.mark.parametrize("up", [False, True])
def test_cart_may_rest_anywhere(
    cart: int, rod: int, expected: Stability, words: str, up: bool
) -> None:
    x, phi = dynamicsymbols("x phi")
    M, m, l, c, g = parameters("M m l c g", "kg kg m N*s/m m/s^2", "2 1 1 1 9.81")
    N, O = ReferenceFrame("N"), Point("O")
    rail = slide("rail", None, "cart", at=O, axis=N.x, distance=x)
    hinge = pin("hinge", "cart", "rod", at=rail.point, axis=N.z, angle=phi)
    G = hinge.point.locatenew("G", -l * hinge.frame.y)
    scene = Scene(
        "cart", N, O, plane=N.z, joints=(rail, hinge),
        bodies=(
            RigidBody("cart", rail.point, rail.frame, M, 0),
            RigidBody("rod", G, hinge.frame, m, m * l**2),
        ),
        loads=(
            gravity(-g * N.y),
            force("D", rail.point, -cart * c * x.diff() * N.x, on="cart", by=None),
            torque("E", -rod * c * l**2 * phi.diff() * N.z, on="rod", by="cart"),
        ),
    )  # fmt: skip
    linear = linearize(by_route("lagrange", scene), {"x": 0, "phi": pi if up else 0})
    assert linear.ignorable == (linear.coordinates[0],)
    assert stability(linear) is (Stability.UNSTABLE if up else expected)
    assert verdict(linear).startswith("a pole has a positive real part" if up else words)


def test_coordinate_whose_force_is_cubic_is_not_ignorable() -> None:
    x, (m, k) = dynamicsymbols("x"), parameters("m k", "kg N/m^3", "1 1")
    N, O = ReferenceFrame("N"), Point("O")
    rail = slide("rail", None, "cart", at=O, axis=N.x, distance=x)
    pull = force("F", rail.point, -k * x**3 * N.x, on="cart", by=None)
    scene = Scene("cubic", N, O, plane=N.z, joints=(rail,), loads=(pull,),
                  bodies=(RigidBody("cart", rail.point, rail.frame, m, 0),))  # fmt: skip
    linear = linearize(by_route("lagrange", scene), {"x": 0})
    assert linear.ignorable == ()
    assert stability(linear) is Stability.OPEN
