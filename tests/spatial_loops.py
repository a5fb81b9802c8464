"""Closed loops in space, made of joints: a four-bar, Bricard's mechanism, Stewart's platform."""

from sympy import Expr, Rational
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.scene import (
    RigidBody,
    Scene,
    ball,
    force,
    free,
    gravity,
    parameters,
    pin,
    quaternion,
    slide,
    universal,
)

CORNERS = ((0, 0, 0), (1, 0, 0), (1, -1, 0), (1, -1, 1), (0, -1, 1), (0, 0, 1))
"""Six edges of a cube, one after the other; the last joins the two ends that are at rest."""
CIRCLE = ((1, 0), (3, 4), (-3, 4), (-1, 0), (-3, -4), (3, -4))
"""Points on a circle, those with a 4 over 5."""


def _cross(a: tuple, b: tuple) -> tuple:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def _vector(entries: tuple, frame: ReferenceFrame) -> Expr:
    return sum((x * e for x, e in zip(entries, frame, strict=True)), 0)


def four_bar() -> Scene:
    """Crank and rocker turn about axes across each other; a Cardan joint and a ball hold the rod.

    It is closed where all angles are 0.
    """
    m, g, A, B = parameters("m g A B", typical="1 9.81 0.1 0.2")
    N, O = ReferenceFrame("N"), Point("O")
    q1, q2, q3, q4 = dynamicsymbols("q1:5")
    crank = pin("crank_pin", None, "crank", at=O, axis=N.z, angle=q1)
    end = O.locatenew("E", crank.frame.x)
    rod = universal("cross", "crank", "rod", at=end, frame=crank.frame, axes="yz", angles=(q2, q3))
    post = O.locatenew("G", 4 * N.x + 2 * N.z)
    rocker = pin("rocker_pin", None, "rocker", at=post, axis=N.y, angle=q4)
    # From E to H along x, by 3; from G down to H, by 2.
    tip = rod.point.locatenew("T", 3 * rod.frame.x)
    hung = post.locatenew("H", -2 * rocker.frame.z)
    close = ball("close", "rod", "rocker", at=tip, frame=rod.frame, onto=hung)
    bodies = tuple(
        RigidBody(name, start.locatenew(f"C{name}", half), frame, m, inertia(frame, A, B, B))
        for name, start, half, frame in (
            ("crank", O, crank.frame.x / 2, crank.frame),
            ("rod", end, 3 * rod.frame.x / 2, rod.frame),
            ("rocker", post, -rocker.frame.z, rocker.frame),
        )
    )
    return Scene("four-bar in space", N, O, bodies=bodies, joints=(crank, rod, rocker, close),
                 loads=(gravity(-g * N.z),))  # fmt: skip


def bricard() -> Scene:
    """Five rods of length 1 and six pins, each axis across both of its rods.

    IFToMM's benchmark A04: a closed chain of six pins cannot move but for such axes.
    """
    m, g = parameters("m g", typical="1 9.81")
    ground, origin = ReferenceFrame("N"), Point("O")
    angles = dynamicsymbols("q1:6")
    edges = [
        tuple(b - a for a, b in zip(CORNERS[i], CORNERS[(i + 1) % 6], strict=True))
        for i in range(6)
    ]
    axes = [_cross(edges[i - 1], edges[i]) for i in range(6)]
    frame, point, parent = ground, origin, None
    joints, bodies = [], []
    for i, angle in enumerate(angles):
        joint = pin(
            f"pin{i}", parent, f"rod{i}", at=point, axis=_vector(axes[i], frame), angle=angle
        )
        joints.append(joint)
        along = _vector(edges[i], joint.frame)
        moments = (m * Rational(1 - abs(x), 12) for x in edges[i])
        centre = joint.point.locatenew(f"C{i}", along / 2)
        rod = RigidBody(f"rod{i}", centre, joint.frame, m, inertia(joint.frame, *moments))
        bodies.append(rod)
        frame, parent = joint.frame, f"rod{i}"
        point = joint.point.locatenew(f"P{i + 1}", along)
    end = origin.locatenew("E", _vector(CORNERS[5], ground))
    close = pin(
        "close", None, "rod4", at=end, axis=_vector(axes[5], ground),
        onto=(point, _vector(axes[5], frame)),
    )  # fmt: skip
    return Scene(
        "Bricard's mechanism", ground, origin,
        bodies=tuple(bodies), joints=(*joints, close), loads=(gravity(-g * ground.y),),
    )  # fmt: skip


def stewart() -> Scene:
    """A platform on six legs, each a Cardan joint, a slide and a ball."""
    ground, origin = ReferenceFrame("N"), Point("O")
    M, m, I, J, g, b, p, h = parameters(
        "M m I J g b p h",
        units="kg kg kg*m^2 kg*m^2 m/s^2 m m m",
        typical="10 1 1 0.1 9.81 1 0.5 0.4",
    )
    base = free(
        "base", "platform", at=origin, frame=ground, coordinates=dynamicsymbols("x y z"),
        rotation=quaternion("e0 e1 e2 e3", "wx wy wz"),
    )  # fmt: skip
    bodies = [RigidBody("platform", base.point, base.frame, M, inertia(base.frame, I, I, 2 * I))]
    joints, loads, inputs = [base], [gravity(-g * ground.z)], []
    circle = [(x, y) if y == 0 else (Rational(x, 5), Rational(y, 5)) for x, y in CIRCLE]
    for i, place in enumerate(circle):
        above = circle[(i + (-1 if i % 2 else 1)) % 6]
        foot = origin.locatenew(f"B{i}", b * _vector((*place, 0), ground))
        top = base.point.locatenew(f"T{i}", p * _vector((*above, 0), base.frame))
        first, second, length, push = dynamicsymbols(f"a{i} b{i} d{i} f{i}")
        lower, upper = f"lower{i}", f"upper{i}"
        cardan = universal(f"cardan{i}", None, lower, at=foot, frame=ground, angles=(first, second))
        leg = cardan.frame
        stroke = slide(f"stroke{i}", lower, upper, at=cardan.point, axis=leg.z, distance=length)
        end = {"at": stroke.point, "frame": stroke.frame, "onto": top}
        joints += [cardan, stroke, ball(f"ball{i}", upper, "platform", **end)]
        for name, point, frame, sense in (
            (lower, cardan.point, leg, 1),
            (upper, stroke.point, stroke.frame, -1),
        ):
            centre = point.locatenew(f"centre of {name}", sense * h * frame.z)
            bodies.append(RigidBody(name, centre, frame, m, inertia(frame, J, J, J / 10)))
        loads.append(force(f"f{i}", stroke.point, push * leg.z, on=upper, by=lower))
        inputs.append(push)
    return Scene(
        "Stewart's platform", ground, origin,
        bodies=tuple(bodies), joints=tuple(joints), loads=tuple(loads), inputs=tuple(inputs),
        example={"z": 1.0, **{f"d{i}": 1.2 for i in range(6)}},
    )  # fmt: skip
