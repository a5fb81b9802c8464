"""Closed loops of bodies whose last pin is told in two ways, one only where the loop is closed."""

from sympy import Expr, cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    force,
    gravity,
    holonomic,
    parameters,
    reaction,
    spring,
)
from mechanics.scene import pin as hinge

q1, q2, q3, q4, q5 = dynamicsymbols("q1:6")
alpha, beta, x, F = dynamicsymbols("a b x F")
r, l, m, g = parameters("r l m g", units="m m kg m/s^2", typical="0.1 0.3 1 9.81")
a, b = parameters("a_0 b_0", units="m m", typical="1 2")
l1, l2, l3, l4, l5, d, e = parameters(
    "l1 l2 l3 l4 l5 d e", units="m m m m m m m", typical="0.1 0.3 0.25 0.2 0.3 0.28 0.35"
)


def rod(name: str, frame: ReferenceFrame, start: Point, length: Expr) -> RigidBody:
    """A uniform rod from a point along the x axis of its frame."""
    centre = start.locatenew(f"centre of the {name}", length / 2 * frame.x)
    return RigidBody(name, centre, frame, m, m * length**2 / 12)


def pin(name: str, at: Point, on: str, by: str | None, ground: ReferenceFrame) -> tuple:
    """Both forces of a pin."""
    axes = {"x": ground.x, "y": ground.y}
    return tuple(reaction(f"{name}{i}", at=at, on=on, by=by, along=e) for i, e in axes.items())


def slider_crank(cut: str) -> Scene:
    """r cos a + l cos b = x, r sin a + l sin b = 0, cut at the end of the rod or at the slider."""
    ground, origin = ReferenceFrame("N"), Point("O")
    crank = ground.orientnew("A", "Axis", (alpha, ground.z))
    other = ground.orientnew("B", "Axis", (beta, ground.z))
    joint = origin.locatenew("P", r * crank.x)
    slider = origin.locatenew("S", x * ground.x)
    points = {"end of the rod": joint.locatenew("Q", l * other.x), "slider": slider}
    return Scene(
        "slider crank",
        ground,
        origin,
        coordinates=(alpha, beta, x),
        bodies=(
            rod("crank", crank, origin, r),
            rod("rod", other, joint, l),
            Particle("slider", slider, m),
        ),
        loads=(gravity(-g * ground.y), force("F", slider, F * ground.x, on="slider")),
        inputs=(F,),
        reactions=(
            *pin("O", origin, "crank", None, ground),
            *pin("P", joint, "rod", "crank", ground),
            *pin("Q", points[cut], "slider", "rod", ground),
            reaction("W", at=slider, on="slider", by=None, along=ground.y),
        ),
        constraints=(
            holonomic("along x", r * cos(alpha) + l * cos(beta) - x, "Qx"),
            holonomic("along y", r * sin(alpha) + l * sin(beta), "Qy"),
        ),
        example={"a": 0.7},
    )


def parallelogram(folded: bool, cut: str) -> Scene:
    """Crank and rocker of one length, coupler and ground of another; two ways to close.

    One has q2 = 0 and q3 = q1. Its folded twin, where crank and rocker turn in opposite senses, is
    another component of the same constraints. Cut at the end of the coupler or of the rocker.
    """
    ground, origin = ReferenceFrame("N"), Point("A")
    crank, coupler, rocker = (
        ground.orientnew(name, "Axis", (angle, ground.z))
        for name, angle in (("C", q1), ("K", q2), ("R", q3))
    )
    other = origin.locatenew("D", b * ground.x)
    joint = origin.locatenew("B", a * crank.x)
    points = {
        "coupler": joint.locatenew("end of the coupler", b * coupler.x),
        "rocker": other.locatenew("end of the rocker", a * rocker.x),
    }
    return Scene(
        "parallelogram",
        ground,
        origin,
        coordinates=(q1, q2, q3),
        bodies=(
            rod("crank", crank, origin, a),
            rod("coupler", coupler, joint, b),
            rod("rocker", rocker, other, a),
        ),
        loads=(gravity(-g * ground.y),),
        reactions=(
            *pin("A", origin, "crank", None, ground),
            *pin("B", joint, "coupler", "crank", ground),
            *pin("D", other, "rocker", None, ground),
            *pin("C", points[cut], "coupler", "rocker", ground),
        ),
        constraints=(
            holonomic("along x", a * cos(q1) + b * cos(q2) - b - a * cos(q3), "Cx"),
            holonomic("along y", a * sin(q1) + b * sin(q2) - a * sin(q3), "Cy"),
        ),
        example={"q1": 1.0, "q2": -0.9, "q3": -2.0} if folded else {"q1": 1.0, "q3": 1.0},
    )


def peaucellier() -> Scene:
    """Peaucellier's linkage: bars of two lengths, whose last point P moves on a straight line.

    Arms OA and OC, a rhombus A B P C, and a crank from D to B, as long as D is from O. P = B closes
    it, too: two components, which meet where the rhombus is flat.
    """
    r, L = parameters("r L", units="m m", typical="0.4 1")
    ground, origin = ReferenceFrame("N"), Point("O")
    places = {"O": origin, "D": origin.locatenew("D", r * ground.x)}
    bodies, joints = [], []
    bars = (("DB", None, r), ("OA", None, L), ("OC", None, L), ("AB", "OA", l), ("CB", "OC", l),
            ("AP", "OA", l), ("CP", "OC", l))  # fmt: skip
    for (name, parent, length), angle in zip(bars, dynamicsymbols("q1:8"), strict=True):
        at = places[name[0]]
        joint = hinge(f"pin {name}", parent, name, at=at, axis=ground.z, angle=angle)
        bodies.append(rod(name, joint.frame, at, length))
        end = at.locatenew(f"end of {name}", length * joint.frame.x)
        before = places.setdefault(name[1], end)
        joints.append(joint)
        if before is not end:
            one = next(bar for bar, _, _ in bars if bar[1] == name[1])
            joints.append(hinge(f"{one} {name}", one, name, at=before, axis=ground.z, onto=end))
    start = (0.6, 0.81, -0.21, -1.49, 2.09, -1.05, 1.65)
    return Scene("Peaucellier", ground, origin, plane=ground.z, bodies=bodies, joints=joints,
                 loads=(gravity(-g * ground.y),),
                 example={f"q{k}": angle for k, angle in enumerate(start, 1)})  # fmt: skip


def two_loops() -> Scene:
    """A four-bar linkage whose rocker is the crank of a second one."""
    ground, origin = ReferenceFrame("N"), Point("A")
    angles = {"crank": q1, "coupler": q2, "rocker": q3, "second coupler": q4, "last": q5}
    frames = {
        name: ground.orientnew(name, "Axis", (angle, ground.z)) for name, angle in angles.items()
    }
    middle = origin.locatenew("D", d * ground.x)
    end = middle.locatenew("F", e * ground.x)
    first = origin.locatenew("B", l1 * frames["crank"].x)
    second = middle.locatenew("E", l3 * frames["rocker"].x)
    starts = {"crank": origin, "coupler": first, "rocker": middle, "second coupler": second,
              "last": end}  # fmt: skip
    lengths = dict(zip(starts, (l1, l2, l3, l4, l5), strict=True))
    return Scene(
        "two loops",
        ground,
        origin,
        coordinates=tuple(angles.values()),
        bodies=tuple(rod(name, frames[name], starts[name], lengths[name]) for name in starts),
        loads=(gravity(-g * ground.y),),
        reactions=(
            *pin("A", origin, "crank", None, ground),
            *pin("B", first, "coupler", "crank", ground),
            *pin("D", middle, "rocker", None, ground),
            *pin("C", first.locatenew("C", l2 * frames["coupler"].x), "coupler", "rocker", ground),
            *pin("E", second, "second coupler", "rocker", ground),
            *pin("F", end, "last", None, ground),
            *pin("G", end.locatenew("G", l5 * frames["last"].x), "second coupler", "last", ground),
        ),
        constraints=(
            holonomic("x 1", l1 * cos(q1) + l2 * cos(q2) - d - l3 * cos(q3), "Cx"),
            holonomic("y 1", l1 * sin(q1) + l2 * sin(q2) - l3 * sin(q3), "Cy"),
            holonomic("x 2", l3 * cos(q3) + l4 * cos(q4) - e - l5 * cos(q5), "Gx"),
            holonomic("y 2", l3 * sin(q3) + l4 * sin(q4) - l5 * sin(q5), "Gy"),
        ),
        example={"q1": 1.0, "q2": 0.5, "q3": 1.8, "q4": 0.2, "q5": 1.5},
    )


def lifted_bead() -> Scene:
    """A bead with a spring on a level rail that is lifted, y = l sin t."""
    ground, origin = ReferenceFrame("N"), Point("O")
    height = dynamicsymbols("y")
    bead = origin.locatenew("B", x * ground.x + height * ground.y)
    return Scene(
        "lifted bead",
        ground,
        origin,
        coordinates=(x, height),
        bodies=(Particle("bead", bead, m),),
        loads=(gravity(-g * ground.y), spring("spring", origin, bead, m * g / l, length=l)),
        reactions=(reaction("S", at=bead, on="bead", by=None, along=ground.y),),
        constraints=(holonomic("rail", height - l * sin(dynamicsymbols._t), "S"),),
    )


LINKAGES = {
    "slider crank, cut at the rod": lambda: slider_crank("end of the rod"),
    "slider crank, cut at the slider": lambda: slider_crank("slider"),
    "parallelogram, cut at the coupler": lambda: parallelogram(False, "coupler"),
    "parallelogram, cut at the rocker": lambda: parallelogram(False, "rocker"),
    "folded, cut at the coupler": lambda: parallelogram(True, "coupler"),
    "folded, cut at the rocker": lambda: parallelogram(True, "rocker"),
    "a rhombus in three loops": peaucellier,
    "two loops": two_loops,
    "lifted bead": lifted_bead,
}
