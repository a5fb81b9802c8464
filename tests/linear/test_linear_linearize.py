"""Linearization: the same by all routes, refused away from an equilibrium."""

from functools import cache
from types import ModuleType

import pytest
from particles import on_a_spring
from sympy import Matrix, Symbol, pi, sqrt

from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from mechanics.linear import linearize
from mechanics.routes.derivation import by_route
from mechanics.symbolic import prove_equal
from systems import elastic_pendulum, four_bar, rocker, rolling_disc, two_mass_chain

ROUTES = ("free_body", "moving_point", "kane")
PARALLELOGRAM = {four_bar.l3: four_bar.l1, four_bar.l2: four_bar.d}
POINTS = {
    elastic_pendulum: ({"x": 0, "theta": pi}, {}, {}),
    rocker: ({"theta": 0}, {"f": 0}, {}),
    two_mass_chain: ({"x1": 0, "x2": 0}, {}, {}),
    four_bar: ({"q1": pi / 2, "q2": 0, "q3": -pi / 2}, {"tau": 0}, PARALLELOGRAM),
    rolling_disc: ({q: 0 for q in ("x", "y", "yaw", "lean", "spin")}, {}, {}),
}


@cache
def derived(system: ModuleType, route: str) -> Equations:
    return by_route(route, _scene(system))


@cache
def _scene(system: ModuleType):
    return system.scene()


def accelerations(linear) -> list:
    """M^-1 (K, C, E): what is left when rows are scaled and combined."""
    right = Matrix.hstack(linear.stiffness, linear.damping, *linear.input_matrices)
    return list(linear.mass.LUsolve(right))


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "route",
    ROUTES,
)
@pytest.mark.parametrize("system", POINTS, ids=lambda system: system.__name__)
def test_routes_agree_on_the_linear_equations(system: ModuleType, route: ModuleType) -> None:
    point = POINTS[system]
    reference = linearize(derived(system, "lagrange"), *point)
    other = linearize(derived(system, route), *point)
    assert other.coordinates == reference.coordinates
    finding = prove_equal("linear", accelerations(other), accelerations(reference))
    assert finding.verdict is Verdict.PROVED


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", POINTS, ids=lambda system: system.__name__)
def test_conjugate_rows_are_symmetric(system: ModuleType) -> None:
    linear = linearize(derived(system, "lagrange"), *POINTS[system])
    assert linear.conjugate
    assert linear.mass == linear.mass.T
    if system != rolling_disc:
        assert linear.stiffness == linear.stiffness.T


def test_pendulum_upside_down_has_the_textbook_stiffness() -> None:
    M, m, L, k, g = (getattr(elastic_pendulum, name) for name in "MmLkg")
    linear = linearize(derived(elastic_pendulum, "lagrange"), *POINTS[elastic_pendulum])
    assert linear.mass == Matrix([[M + m, -M * L / 2], [-M * L / 2, M * L**2 / 3]])
    assert linear.stiffness == Matrix([[2 * k, 0], [0, -M * g * L / 2]])


def test_parallelogram_linkage_is_reduced_to_one_coordinate() -> None:
    l1, m1, m2, m3, g = (getattr(four_bar, name) for name in ("l1", "m1", "m2", "m3", "g"))
    linear = linearize(derived(four_bar, "lagrange"), *POINTS[four_bar])
    (q3,) = linear.coordinates
    assert q3.name == "q3"
    assert linear.reach == Matrix([1, 0, 1])
    # The rods turn about fixed pivots, the coupler is carried along: no rotation of its own.
    assert linear.mass == Matrix([((m1 + m3) / 3 + m2) * l1**2]).expand()
    assert linear.stiffness == Matrix([-(m1 / 2 + m2 + m3 / 2) * g * l1]).expand()


def test_tilted_equilibrium_under_a_constant_force() -> None:
    # f (R + R/2 cos theta) + M g R/2 sin theta = 0 at 30 degrees.
    M, R, g = rocker.M, rocker.R, rocker.g
    held = -M * g / (4 + sqrt(3))
    linear = linearize(derived(rocker, "lagrange"), {"theta": pi / 6}, {"f": held})
    moment = M * g * R / 2 * sqrt(3) / 2 - held * R / 4
    assert prove_equal("K", linear.stiffness[0], -moment).verdict is Verdict.PROVED


def test_point_out_of_balance_is_refused_with_the_force_that_is_left() -> None:
    with pytest.raises(InputError, match=r"theta = pi/2 rad, f = 0 is no equilibrium.*M\*R\*g"):
        linearize(derived(rocker, "lagrange"), {"theta": pi / 2}, {"f": 0})
    with pytest.raises(
        InputError, match=r"x1 = 1 m, x2 = 0 m is no equilibrium.*x1 at rest is -2\*k N"
    ):
        linearize(derived(two_mass_chain, "lagrange"), {"x1": 1, "x2": 0})


def test_a_place_where_the_equations_divide_by_zero_is_named() -> None:
    equations = by_route("kane", on_a_spring())
    with pytest.raises(InputError, match=r"divide by zero at theta = 0 rad, r = 0 m: take another"):
        linearize(equations, {"theta": 0, "r": 0})
    m, g, l, k = (Symbol(name, positive=True) for name in "mglk")
    hanging = linearize(equations, {"theta": 0, "r": l + m * g / k})
    assert str(hanging.stiffness[1, 1]) == "k"


def test_broken_constraint_is_refused() -> None:
    with pytest.raises(InputError, match=r"closure along x is .* at the operating point"):
        linearize(derived(four_bar, "lagrange"), {"q1": 0, "q2": 0, "q3": 0}, {"tau": 0})


@pytest.mark.parametrize(
    ("at", "inputs", "message"),
    [
        ({}, {"f": 0}, "gives no value for coordinate theta"),
        ({"theta": 0}, {}, "gives no value for input f"),
        ({"theta": 0, "phi": 0}, {"f": 0}, "'phi' is no coordinate: the coordinates are theta"),
        ({"theta": 0}, {"f": 0, "tau": 0}, "'tau' is no input: the inputs are f"),
    ],
)
def test_incomplete_operating_point_is_refused(at: dict, inputs: dict, message: str) -> None:
    with pytest.raises(InputError, match=message):
        linearize(derived(rocker, "lagrange"), at, inputs)


def test_operating_point_by_symbols_and_by_names_is_the_same() -> None:
    equations = derived(rocker, "lagrange")
    by_name = linearize(equations, {"theta": 0}, {"f": 0})
    dynamic = linearize(equations, {rocker.theta: 0}, {rocker.f: 0})
    plain = linearize(equations, {Symbol("theta", real=True): 0}, {Symbol("f", real=True): 0})
    assert by_name.stiffness == dynamic.stiffness == plain.stiffness
    assert by_name.point == dynamic.point == plain.point


@pytest.mark.parametrize("route", (*ROUTES, "lagrange"))
@pytest.mark.parametrize(
    ("at", "message"),
    [
        ({"q1": 0, "q2": 0, "q3": 0}, "closure along x is .*, not zero"),
        ({"q1": 0, "q2": 0, "q3": pi}, "1 of 2 constraints are independent: a singular"),
    ],
)
def test_a_place_where_the_loop_is_open_or_stretched_out_is_refused(
    at: dict, message: str, route: str
) -> None:
    with pytest.raises(InputError, match=message):
        linearize(derived(four_bar, route), at, {"tau": 0}, PARALLELOGRAM)
