"""Transfer functions and poles against the state space, and closed loops."""

import numpy as np
import pytest
from sympy import Symbol, lambdify
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.errors import InputError, SingularError, ValueMissingError
from mechanics.kernel import Verdict
from mechanics.linear import (
    characteristic_polynomial,
    close_loop,
    linearize,
    numeric_poles,
    state_space,
    transfer_function,
)
from mechanics.routes.derivation import by_route
from mechanics.scene import Particle, Scene, parameters, spring
from mechanics.symbolic import prove_equal
from systems import rocker

s = Symbol("s")
POINTS = (0.3 + 0.7j, -1.1 + 0.2j, 2.0 + 0.0j, 5.0j)


@pytest.fixture(params=[((1,), (1,), (1,)), ((3, 2), (1, 1), (0, 1)), ((1, 2, 3), (1, 1, 1, 1))])
def linear(request, row, constants):
    m, k, c = constants
    masses, stiffnesses, *dampings = request.param
    scaled = [c * factor for factor in (dampings[0] if dampings else ())]
    return row([m * f for f in masses], [k * f for f in stiffnesses], scaled)


def typical(linear) -> dict:
    return {symbol: float(symbol.typical) for symbol in linear.scene.parameters}


def test_transfer_function_is_that_of_the_state_space(linear) -> None:
    a, b = state_space(linear)
    identity = np.eye(len(a))
    for i, coordinate in enumerate(linear.coordinates):
        exact = transfer_function(linear, coordinate.name, "F", s).subs(typical(linear))
        value = lambdify(s, exact)
        for point in POINTS:
            numeric = np.linalg.solve(point * identity - a, b)[i, 0]
            assert value(point) == pytest.approx(numeric, rel=1e-10)


def test_poles_are_the_eigenvalues_of_the_state_space(linear) -> None:
    polynomial = characteristic_polynomial(linear, s).subs(typical(linear)).as_poly(s)
    roots = np.roots([float(c) for c in polynomial.all_coeffs()])
    assert_same_points(numeric_poles(linear), roots)


def assert_same_points(one: np.ndarray, two: np.ndarray) -> None:
    """Two sets of complex numbers are the same within rounding."""
    assert len(one) == len(two)
    distance = np.abs(one[:, None] - two[None, :])
    assert distance.min(axis=0).max() < 1e-7
    assert distance.min(axis=1).max() < 1e-7


def test_closed_loop_is_the_feedback_formula(row, constants, gain) -> None:
    # H = K G / (1 + K G)
    m, k, c = constants
    K, r = gain
    plant = row((m,), (k,), (c,))
    (x,) = plant.scene.coordinates
    loop = close_loop(plant, {"F": K * (r - x)}, (r,))
    open_loop = transfer_function(plant, "x1", "F", s)
    closed = transfer_function(loop, "x1", "r", s)
    formula = K * open_loop / (1 + K * open_loop)
    assert prove_equal("closed loop", closed, formula).verdict is Verdict.PROVED


def test_rate_feedback_adds_damping(row, constants) -> None:
    m, k, _ = constants
    D = Symbol("D", real=True)
    plant = row((m,), (k,))
    (x,) = plant.scene.coordinates
    loop = close_loop(plant, {"F": -D * x.diff("t")})
    assert loop.damping[0] == D
    assert loop.inputs == ()
    assert not loop.undamped


def test_other_inputs_stay(constants, gain) -> None:
    K, r = gain
    linear = linearize(by_route("lagrange", rocker.scene()), {"theta": 0}, {"f": 0})
    loop = close_loop(linear, {rocker.f: K * (r - rocker.theta)}, (r,))
    assert [symbol.name for symbol in loop.inputs] == ["r"]
    with pytest.raises(InputError, match="'f' is no input of the linear equations: there are r"):
        transfer_function(loop, "theta", "f", s)


@pytest.mark.parametrize("law", [lambda x, r: x**2 - r, lambda x, r: r - x + 1])
def test_law_that_is_not_linear_is_refused(row, constants, gain, law) -> None:
    m, k, _ = constants
    plant = row((m,), (k,))
    (x,) = plant.scene.coordinates
    with pytest.raises(InputError, match="the law for F"):
        close_loop(plant, {"F": law(x, gain[1])}, (gain[1],))


def test_unknown_names_are_refused(row, constants) -> None:
    m, k, _ = constants
    plant = row((m,), (k,))
    with pytest.raises(InputError, match="'y' is no coordinate of the linear equations"):
        transfer_function(plant, "y", "F", s)
    with pytest.raises(InputError, match="there is no parameter 'kk'"):
        state_space(plant, {"kk": 1.0})


def test_missing_and_singular_values_are_refused(row) -> None:
    m, k = parameters("m k")
    with pytest.raises(ValueMissingError, match="has no value"):
        state_space(row((m,), (k,)))
    with pytest.raises(SingularError, match="mass matrix is singular"):
        state_space(row((m,), (k,)), {"m": 0.0, "k": 1.0})


def test_prescribed_motion_enters_by_its_second_derivative(constants) -> None:
    # A mass on a spring on a shaken base, z relative to the base: m z'' + k z = -m y''.
    m, k, _ = constants
    ground, origin = ReferenceFrame("N"), Point("O")
    z, y = dynamicsymbols("z y")
    base = origin.locatenew("B", y * ground.x)
    mass = base.locatenew("P", z * ground.x)
    scene = Scene(
        "shaken base",
        ground,
        origin,
        coordinates=(z,),
        bodies=(Particle("mass", mass, m),),
        loads=(spring("k", base, mass, k, along=ground.x),),
        inputs=(y,),
    )
    linear = linearize(by_route("lagrange", scene), {"z": 0}, {"y": 0})
    assert transfer_function(linear, "z", "y", s) == -m * s**2 / (m * s**2 + k)
    with pytest.raises(InputError, match="derivatives of the inputs drive the system"):
        state_space(linear)
    with pytest.raises(InputError, match="input y enters by its derivatives"):
        close_loop(linear, {"y": -z})
