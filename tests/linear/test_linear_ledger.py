"""The ledger of small motions: rows are held against the scene, and bad rows are refused."""

from dataclasses import replace
from functools import cache

import pytest
from sympy import Eq, Gt, ImmutableMatrix, Rational, Symbol

from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from mechanics.linear.ledger import check_linear_row
from mechanics.routes.derivation import by_route
from mechanics.scene import Particle, RigidBody
from mechanics.scene.linear_quantities import (
    Eigenvalue,
    Laplace,
    LinearizedEquation,
    ModeShape,
    operating_point,
)
from systems import rocker, rocker_control_ledger, two_mass_chain, two_mass_chain_ledger
from systems.rocker_control_ledger import LOOP, K
from systems.two_mass_chain_ledger import AT_REST

CONTROL = {row.label: row for row in rocker_control_ledger.PUBLISHED}
MODES = {row.label: row for row in two_mass_chain_ledger.MODES}


@cache
def of_rocker() -> Equations:
    return by_route("lagrange", rocker.scene())


@cache
def of_chain() -> Equations:
    return by_route("lagrange", two_mass_chain.scene())


def check(equations: Equations, row, **changes):
    return check_linear_row(equations.scene, replace(row, **changes), equations)


@pytest.mark.campaign
def test_rows_are_held_against_the_scene_and_not_against_each_other() -> None:
    # Twice as heavy on the right: whatever the masses enter is refuted or cannot be shown.
    scene = two_mass_chain.scene()
    first, second = scene.bodies
    heavy = replace(scene, bodies=(first, Particle("second", second.centre, 4 * two_mass_chain.m)))
    equations = by_route("lagrange", heavy)
    shown = {row.tag for row in MODES.values() if check_linear_row(heavy, row, equations).shown}
    assert shown == {"lambda"}


def test_rocker_rows_are_refuted_by_another_rocker() -> None:
    scene = rocker.scene()
    (body,) = scene.bodies
    other = replace(
        scene,
        bodies=(RigidBody(body.name, body.centre, body.frame, rocker.M, 2 * rocker.I_C),),
    )
    equations = by_route("lagrange", other)
    verdicts = {row.tag: check_linear_row(other, row, equations).verdict
                for row in CONTROL.values()}  # fmt: skip
    refuted = {tag for tag, verdict in verdicts.items() if verdict is Verdict.REFUTED}
    # With I_A' named by a symbol, and where the inertia does not matter, rows stay right.
    assert refuted == {"(8)", "I_A'"}
    assert set(verdicts.values()) == {Verdict.PROVED, Verdict.REFUTED}


def test_definitions_are_expanded_where_a_side_needs_them() -> None:
    # M = rho h R^2 (pi + 2): the borderline written with the density.
    row = CONTROL["gain on the borderline between stability and instability"]
    mass = rocker.ROCKER.mass
    assert check(of_rocker(), row, sides=(mass * rocker.g / 3,)).verdict is Verdict.PROVED
    assert check(of_rocker(), row, sides=(mass * rocker.g / 2,)).verdict is Verdict.REFUTED


def test_equation_may_be_scaled_and_turned_round() -> None:
    row = CONTROL["linearized equation of motion"]
    left, right = row.sides
    assert check(of_rocker(), row, sides=(-2 * right, -2 * left)).verdict is Verdict.PROVED
    rows = MODES["equations of motion in matrix form"]
    combined = ImmutableMatrix([[1, 1], [2, -3]])
    sides = tuple(combined * side for side in rows.sides)
    assert check(of_chain(), rows, sides=sides).verdict is Verdict.PROVED
    dependent = ImmutableMatrix([[1, 1], [2, 2]])
    sides = tuple(dependent * side for side in rows.sides)
    assert check(of_chain(), rows, sides=sides).verdict is Verdict.UNDECIDED


def test_shape_up_to_a_factor() -> None:
    shape = ImmutableMatrix([Rational(-4, 3), -2])
    row = MODES["shape of the first mode"]
    assert check(of_chain(), row, sides=(shape,)).verdict is Verdict.REFUTED
    free = ModeShape(AT_REST, 1, scaled=False)
    assert check(of_chain(), row, sides=(shape,), quantity=free).verdict is Verdict.PROVED
    other = ImmutableMatrix([Rational(4, 3), -2])
    assert check(of_chain(), row, sides=(other,), quantity=free).verdict is Verdict.REFUTED
    nothing = check(of_chain(), row, sides=(ImmutableMatrix([0, 0]),), quantity=free)
    assert nothing.verdict is Verdict.UNDECIDED


def test_wrong_side_of_the_borderline_is_refuted() -> None:
    row = CONTROL["for larger values of K the system is stable"]
    finding = check(of_rocker(), row, sides=(rocker.M * rocker.g / 3 > K,))
    assert finding.verdict is Verdict.REFUTED
    assert finding.witness is not None


@pytest.mark.parametrize(
    ("label", "changes", "message"),
    [
        ("linearized equation of motion", {"sides": (0,)}, "1 sides typed: an equation has two"),
        (
            "linearized equation of motion",
            {"sides": (ImmutableMatrix([0, 0]), 0)},
            "2 entries on the left, 1 on the right",
        ),
        (
            "linearized equation of motion",
            {"quantity": LinearizedEquation(operating_point({"theta": 1}, {"f": 0}))},
            "theta = 1 rad, f = 0 is no equilibrium",
        ),
        (
            "the upright equilibrium without control",
            {"sides": ("wobbly",)},
            "write 'stable' or 'unstable'",
        ),
        (
            "for larger values of K the system is stable",
            {"sides": (Eq(K, 1),)},
            "write an inequality",
        ),
        (
            "for larger values of K the system is stable",
            {"sides": (Gt(K**2, 1),)},
            "is not linear in K",
        ),
    ],
)
def test_bad_rows_are_refused(label: str, changes: dict, message: str) -> None:
    with pytest.raises(InputError, match=message):
        check(of_rocker(), CONTROL[label], **changes)


def test_missing_image_and_mode_are_refused() -> None:
    row = CONTROL["transform of (8)"]
    laplace = Laplace(Symbol("s"), ())
    with pytest.raises(InputError, match="theta has no image in the s-domain"):
        check(of_rocker(), row, quantity=replace(row.quantity, laplace=laplace))
    with pytest.raises(InputError, match="there is no mode 3"):
        check(of_chain(), MODES["shape of the first mode"], quantity=Eigenvalue(AT_REST, 3))


def test_rows_of_another_scene_are_refused() -> None:
    with pytest.raises(InputError, match="the equations belong to the scene rocker"):
        check_linear_row(of_chain().scene, CONTROL["transform of (8)"], of_rocker())


def test_loop_names_its_own_gain() -> None:
    assert LOOP.gain == K
    assert K.is_positive is None
