"""Rows of four-bars: every loop is closed by itself, and all routes agree."""

import pytest
from linkages import pin
from sympy import Integer, Rational, cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.checks.admissible import check_scene
from mechanics.checks.agreement import compare_pairs
from mechanics.crosscheck.programs import derive_rows
from mechanics.scene import RigidBody, Scene, gravity, holonomic, parameters

ROUTES = ("free_body", "moving_point", "kane", "lagrange")


def distinct(which: str, k: int) -> Rational:
    """Lengths that no two neighbours share."""
    base, factor, offset, size = {
        "crank": (100, 3, 0, 2),
        "coupler": (100, 5, 2, 3),
        "ground": (105, 4, 1, 2),
    }[which]
    return Rational(base + (factor * k + offset) % 7 * size, 100)


def equal(_which: str, _k: int) -> Integer:
    """IFToMM's benchmark A02: all lengths are 1."""
    return Integer(1)


def row_of_four_bars(count: int, length) -> Scene:
    """Rocker k is the crank of loop k + 1."""
    ground, origin = ReferenceFrame("N"), Point("A")
    m, g = parameters("m g", typical="1 9.81")

    def rod(name: str, frame: ReferenceFrame, start: Point, size: Rational) -> RigidBody:
        centre = start.locatenew(f"centre of {name}", size / 2 * frame.x)
        return RigidBody(name, centre, frame, m, m * size**2 / 12)

    q = dynamicsymbols(f"q0:{2 * count + 1}")
    frames = [ground.orientnew(f"F{k}", "Axis", (angle, ground.z)) for k, angle in enumerate(q)]
    bodies = [rod("rod 0", frames[0], origin, length("crank", 0))]
    reactions, constraints = [*pin("O", origin, "rod 0", None, ground)], []
    at, crank, example = origin, 0, {"q0": 1.0}
    for k in range(count):
        a, b, c, d = (
            length(*of) for of in (("crank", k), ("coupler", k), ("crank", k + 1), ("ground", k))
        )
        i, j = 2 * k + 1, 2 * k + 2
        joint = at.locatenew(f"B{k}", a * frames[crank].x)
        foot = at.locatenew(f"D{k}", d * ground.x)
        bodies += [rod(f"rod {i}", frames[i], joint, b), rod(f"rod {j}", frames[j], foot, c)]
        end = joint.locatenew(f"C{k}", b * frames[i].x)
        reactions += [
            *pin(f"B{k}", joint, f"rod {i}", f"rod {crank}", ground),
            *pin(f"D{k}", foot, f"rod {j}", None, ground),
            *pin(f"C{k}", end, f"rod {i}", f"rod {j}", ground),
        ]
        constraints += [
            holonomic(f"x{k}", a * cos(q[crank]) + b * cos(q[i]) - d - c * cos(q[j]), f"C{k}x"),
            holonomic(f"y{k}", a * sin(q[crank]) + b * sin(q[i]) - c * sin(q[j]), f"C{k}y"),
        ]
        example |= {f"q{i}": 0.0, f"q{j}": 1.0}
        at, crank = foot, j
    return Scene(
        f"{count} four-bars",
        ground,
        origin,
        coordinates=tuple(q),
        bodies=tuple(bodies),
        loads=(gravity(-g * ground.y),),
        reactions=tuple(reactions),
        constraints=tuple(constraints),
        example=example,
    )


@pytest.mark.parametrize(
    ("count", "length"),
    [
        (2, equal),
        (2, distinct),
        pytest.param(10, equal, marks=pytest.mark.campaign),
        pytest.param(10, distinct, marks=pytest.mark.campaign),
        pytest.param(40, equal, marks=pytest.mark.campaign),
        pytest.param(40, distinct, marks=pytest.mark.campaign),
    ],
)
def test_all_routes_agree_on_a_row_of_four_bars(count: int, length) -> None:
    mechanism = check_scene(row_of_four_bars(count, length))
    assert len(mechanism.closure.values) == 4 * count
    pairs = compare_pairs(derive_rows(mechanism, ROUTES).routes)
    assert len(pairs) == 6
    assert all(finding.shown for finding in pairs.values())
