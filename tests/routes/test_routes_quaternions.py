"""All routes for bodies that a quaternion turns, and the equations of Euler."""

from collections.abc import Callable

import pytest
from quaternions import ball_top, flyer, rolling_ball, sliding_top, thrown_body

from mechanics import crosscheck
from mechanics.checks.admissible import check_scene
from mechanics.checks.agreement import compare_pairs
from mechanics.checks.statements import equal
from mechanics.crosscheck.programs import check_laws, derive_rows
from mechanics.kernel import Verdict
from mechanics.kinematics.chain import motions
from mechanics.mechanism import lower
from mechanics.program import Builder
from mechanics.program.vectors import add, cross, dot, scale, subtract
from mechanics.routes.derivation import ROUTES, is_written_out
from mechanics.routes.loads import balanced, unit_reactions
from mechanics.scene import Scene


@pytest.mark.sample(2)
@pytest.mark.parametrize("make", [thrown_body, ball_top, sliding_top, rolling_ball])
def test_all_routes_agree_and_all_laws_hold(make: Callable[[], Scene]) -> None:
    programs = derive_rows(check_scene(make()), [route.name for route in ROUTES])
    pairs = compare_pairs(programs.routes)
    assert len(pairs) == 6
    assert all(finding.shown for finding in pairs.values())
    assert all(finding.shown for finding in check_laws(programs))


@pytest.mark.campaign
@pytest.mark.parametrize("make", [thrown_body, ball_top, sliding_top, rolling_ball, flyer])
def test_everything_that_is_checked_is_shown(make: Callable[[], Scene]) -> None:
    """SymPy's Lagrange is given one body: it would take a minute for two."""
    found = crosscheck(make())
    absent = {name for name, column in found.sympy.items() if column.absent}
    assert absent == ({"lagrange_sympy"} if make is flyer else set())
    assert all(finding.shown for finding in found.findings)
    assert {finding.verdict for finding in found.witnesses} == {Verdict.SUPPORTED}


def test_what_acts_between_two_bodies_crosses_no_boundary_that_holds_both() -> None:
    """Also along directions whose components are differences, as a quaternion turns them."""
    mechanism = lower(flyer(), Builder())
    units = unit_reactions(mechanism, motions(mechanism).poses)
    pairs = [pair for pair in units if len(pair) == 2]
    assert len(pairs) == 5
    assert all(balanced(pair, pair) for pair in pairs)
    assert not any(balanced(pair, pair[:1]) for pair in pairs)


def test_kanes_rows_of_the_top_are_eulers_equations_about_its_point() -> None:
    mechanism = check_scene(ball_top())
    rows = derive_rows(mechanism, ["kane"]).routes["kane"].rows.values
    build = mechanism.builder
    m, g, l, A, C = map(build.input, "mglAC")
    inertia = (A + m * l * l, A + m * l * l, C)
    omega, alpha = mechanism.u, mechanism.ud
    spin = tuple(i * w for i, w in zip(inertia, omega, strict=True))
    up = scaled_vertical(mechanism.q)
    arm = (build.zero, build.zero, l)
    weight = scale(-(m * g), up)
    right = subtract(
        add(tuple(i * a for i, a in zip(inertia, alpha, strict=True)), cross(omega, spin)),
        cross(arm, weight),
    )
    assert equal("Euler", mechanism, rows, right).shown


def scaled_vertical(q):
    """Components of the vertical in the body, on the unit sphere: the third row of R."""
    e0, e1, e2, e3 = q
    return (2 * (e1 * e3 - e0 * e2), 2 * (e2 * e3 + e0 * e1), 1 - 2 * (e1 * e1 + e2 * e2))


def test_what_is_true_on_the_unit_sphere_only_is_found_there() -> None:
    mechanism = check_scene(ball_top())
    e0, e1, e2, e3 = mechanism.q
    up = scaled_vertical(mechanism.q)
    unit = mechanism.builder.one
    finding = equal("vertical", mechanism, [dot(up, up)], [unit])
    assert finding.shown
    assert not equal("not", mechanism, [e0 * e0 + e1 * e1], [e2 * e2 + e3 * e3]).shown


@pytest.mark.parametrize("make", [thrown_body, ball_top, flyer])
def test_scenes_with_quaternions_stay_programs(make: Callable[[], Scene]) -> None:
    assert not is_written_out(lower(make(), Builder()))
