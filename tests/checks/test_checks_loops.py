"""Rows of four-bars: every loop is closed by itself, and all routes agree."""

from dataclasses import replace

import pytest
from sympy import Expr, Rational
from sympy.physics.mechanics import Point, ReferenceFrame, inertia
from sympy.physics.vector import dynamicsymbols

from benchmarks.space.deriving import distinct
from mechanics.checks.admissible import check_scene
from mechanics.checks.agreement import compare_pairs
from mechanics.crosscheck.programs import derive_rows
from mechanics.scene import RigidBody, Scene, ball, gravity, parameters, pin, quaternion
from systems import four_bar_chain

ROUTES = ("free_body", "moving_point", "kane", "lagrange")


@pytest.mark.parametrize(
    ("count", "length"),
    [
        (2, None),
        (2, distinct),
        pytest.param(10, None, marks=pytest.mark.campaign),
        pytest.param(10, distinct, marks=pytest.mark.campaign),
        pytest.param(40, None, marks=pytest.mark.campaign),
        pytest.param(40, distinct, marks=pytest.mark.campaign),
    ],
)
def test_all_routes_agree_on_a_row_of_four_bars(count: int, length) -> None:
    """Without lengths of its own it is A02: all are 1."""
    sizes = (count, length) if length else (count,)
    mechanism = check_scene(four_bar_chain.scene(*sizes))
    assert len(mechanism.closure.values) == 4 * count
    pairs = compare_pairs(derive_rows(mechanism, ROUTES).routes)
    assert len(pairs) == 6
    assert all(finding.shown for finding in pairs.values())


SIZES = {"crank": Rational(1), "coupler": Rational(2), "ground": Rational(21, 10)}
LONG = Rational(33, 10)


def shared(kind: str, _: int) -> Expr:
    """Three lengths for all loops."""
    (length,) = parameters(kind, typical=str(float(SIZES[kind])))
    return length


def mixed(kind: str, number: int) -> Expr:
    """Numbers, and lengths that neighbours and bars of one loop share."""
    a, b, c = parameters("a b c", typical="2.9 3 2")
    of = {"crank": (a, b, LONG, LONG), "coupler": (LONG, a, c), "ground": (b, a, LONG)}
    return of[kind][number]


def numbers(kind: str, _: int) -> Expr:
    return SIZES[kind]


CROSSED = {"q1": -1.02, "q2": -2.11, "q3": 0.03, "q4": -2.23, "q5": 0.05, "q6": -2.36,
           "q7": 0.06, "q8": -2.53, "q9": 0.10, "q10": -2.76}  # fmt: skip
"""The other branch of every loop of `shared` and `numbers`."""


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("count", "length", "example"),
    [
        (5, shared, {}), (3, mixed, {}), (2, shared, CROSSED), (2, numbers, CROSSED),
        pytest.param(5, shared, CROSSED, marks=pytest.mark.campaign),
        pytest.param(5, numbers, CROSSED, marks=pytest.mark.campaign),
    ],
)  # fmt: skip
def test_points_follow_the_branch_of_the_example(count: int, length, example: dict) -> None:
    """Lengths that loops share go with one loop; all others are closed by angles."""
    scene = four_bar_chain.scene(count, length)
    own = {name: value for name, value in example.items() if int(name[1:]) <= 2 * count}
    mechanism = check_scene(replace(scene, example={**scene.example, **own}))
    assert len(mechanism.closure.values) == 4 * count
    assert (mechanism.closure.start["q2"] < -2) == bool(example)
    pairs = compare_pairs(derive_rows(mechanism, ROUTES).routes)
    assert all(finding.shown for finding in pairs.values())


@pytest.mark.campaign
def test_all_routes_agree_on_a_four_bar_in_space_without_points_on_its_constraints() -> None:
    """Crank and rocker turn about skew axes; balls at both ends of the coupler."""
    ground, origin = ReferenceFrame("N"), Point("O")
    m, g = parameters("m g", typical="1 9.81")

    def rod(joint, length: Rational) -> RigidBody:
        centre = joint.point.locatenew(f"centre of {joint.child}", length / 2 * joint.frame.x)
        tensor = inertia(joint.frame, m / 50, m / 12, m / 12)
        return RigidBody(joint.child, centre, joint.frame, m, tensor)

    long, short = Rational(5, 2), Rational(3, 2)
    crank = pin("A", None, "crank", at=origin, axis=ground.z, angle=dynamicsymbols("q0"))
    turning = quaternion("e0 e1 e2 e3", "wx wy wz")
    at = crank.point.locatenew("B", crank.frame.x)
    coupler = ball("B", "crank", "coupler", at=at, frame=crank.frame, rotation=turning)
    foot = origin.locatenew("D", 2 * ground.x + ground.z)
    rocker = pin("D", None, "rocker", at=foot, axis=ground.y, angle=dynamicsymbols("q1"))
    end = coupler.point.locatenew("end", long * coupler.frame.x)
    at = rocker.point.locatenew("C", short * rocker.frame.x)
    closing = ball("C", "rocker", "coupler", at=at, frame=rocker.frame, onto=end)
    scene = Scene(
        "four-bar in space",
        ground,
        origin,
        bodies=(rod(crank, Rational(1)), rod(coupler, long), rod(rocker, short)),
        loads=(gravity(-g * ground.y),),
        joints=(crank, coupler, rocker, closing),
        example={"q0": 1.0, "q1": -1.2},
    )
    mechanism = check_scene(scene)
    assert mechanism.closure.start
    assert not mechanism.closure.values
    pairs = compare_pairs(derive_rows(mechanism, ROUTES).routes)
    assert len(pairs) == 6
    assert all(finding.shown for finding in pairs.values())
