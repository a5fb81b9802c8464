"""What scenes of the corpus have in common: pendulums, carts with rods, arms, masses on a line."""

from dataclasses import replace

from sympy import cos, sin, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.scene import (
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


def P(text, **more):
    """Parameters, "m:kg l:m"."""
    names, units = zip(*(one.split(":") for one in text.split()), strict=True)
    return parameters(" ".join(names), units=" ".join(units), **more)


def pendulum(angle, m, inertia, reach, g, moment=0, inputs=(), *, up=False):
    """A body on a pin, counterclockwise from the downward vertical (clockwise from the upward
    one)."""
    N, O = ReferenceFrame("N"), Point("O")
    axis = -N.z if up else N.z
    hold = pin("hold", None, "body", at=O, axis=axis, angle=angle)
    C = hold.point.locatenew("C", (1 if up else -1) * reach * hold.frame.y)
    loads = [gravity(-g * N.y)] if g != 0 else []
    if moment != 0:
        loads.append(torque("moment", moment * axis, on="body"))
    return Scene(
        "pendulum",
        N,
        O,
        plane=N.z,
        bodies=(RigidBody("body", C, hold.frame, m, inertia),),
        joints=(hold,),
        inputs=inputs,
        loads=loads,
    )


def double_pendulum(angles, m1, m2, l1, l2, g, drag=0):
    """Two bobs, both angles from the downward vertical; a drag per mass."""
    a, b = dynamicsymbols(angles)
    N, O = ReferenceFrame("N"), Point("O")
    first = pin("first", None, "upper", at=O, axis=N.z, angle=a)
    E1 = first.point.locatenew("E1", -l1 * first.frame.y)
    second = pin("second", "upper", "lower", at=E1, axis=N.z, angle=b)
    E2 = E1.locatenew("E2", -l2 * second.frame.y)
    loads = [gravity(-g * N.y)]
    if drag != 0:
        v1 = l1 * a.diff() * first.frame.x
        v2 = v1 + l2 * b.diff() * second.frame.x
        loads += [
            force("drag one", E1, -drag * m1 * v1, on="upper"),
            force("drag two", E2, -drag * m2 * v2, on="lower"),
        ]
    return Scene(
        "double pendulum",
        N,
        O,
        plane=N.z,
        joints=(first, second),
        loads=loads,
        bodies=(
            RigidBody("upper", E1, first.frame, m1, 0),
            RigidBody("lower", E2, second.frame, m2, 0),
        ),
    )


def spring_pendulum(angle, length, m, g, pull, across=0, order=None):
    """A bob at the distance `length`, the angle from the downward vertical; pull inwards, across
    forwards. The order holds the coordinates where the length is none itself."""
    coordinates = order or (length, angle)
    start = 2.0 if length in coordinates else 0.2
    N, O = ReferenceFrame("N"), Point("O")
    B = N.orientnew("B", "Axis", (angle, N.z))
    C = O.locatenew("C", -length * B.y)
    return Scene(
        "spring pendulum",
        N,
        O,
        coordinates=coordinates,
        bodies=(Particle("bob", C, m),),
        loads=(gravity(-g * N.y), force("spring", C, pull * B.y + across * B.x, on="bob")),
        reactions=(reaction("side", at=C, on="bob", by=None, along=N.z),),
        example={str(q.func): 0.5 if q is angle else start for q in coordinates},
    )


def cart_with_rods(x, mass, rods, g, push, inputs=(), moments=(), height=0):
    """A cart at x; each rod: name, parent, angle, up, sense, mass, reach, inertia, length.

    Sense +1: the top of an upright rod, or the end of a hanging one, goes to the right.
    """
    N, O = ReferenceFrame("N"), Point("O")
    base = O if height == 0 else O.locatenew("B", height * N.y)
    track = slide("track", None, "cart", at=base, axis=N.x, distance=x)
    bodies, joints, ends = (
        [RigidBody("cart", track.point, N, mass, 0)],
        [track],
        {"cart": track.point},
    )
    loads = [gravity(-g * N.y)]
    if push != 0:
        loads.append(force("push", track.point, push * N.x, on="cart"))
    for name, parent, angle, up, sense, m, reach, moment_of_inertia, length in rods:
        axis = -N.z if up * sense > 0 else N.z
        joint = pin(f"pin {name}", parent, name, at=ends[parent], axis=axis, angle=angle)
        y = up * joint.frame.y
        bodies.append(
            RigidBody(
                name,
                joint.point.locatenew(f"C {name}", reach * y),
                joint.frame,
                m,
                moment_of_inertia,
            )
        )
        joints.append(joint)
        ends[name] = joint.point.locatenew(f"E {name}", length * y)
        for on, moment in moments:
            if on == name:
                loads.append(torque(f"friction {name}", moment * axis, on=name, by=parent))
    return Scene("cart", N, O, plane=N.z, bodies=bodies, joints=joints, loads=loads, inputs=inputs)


def cart_pole(x, angle, M, m, reach, g, push, *, up, sense, I=0, inputs=(), moment=0, height=0):
    """A cart with one rod, with a moment in the pin."""
    moments = (("rod", moment),) if moment != 0 else ()
    rod = ("rod", "cart", angle, up, sense, m, reach, I, 0)
    return cart_with_rods(x, M, [rod], g, push, inputs, moments, height)


def two_link_arm(angles, length, first, second, g, moments, inputs):
    """Two links from the horizontal, the second angle from the first link; each (mass, reach,
    inertia)."""
    a, b = angles
    N, O = ReferenceFrame("N"), Point("O")
    shoulder = pin("shoulder", None, "one", at=O, axis=N.z, angle=a)
    A = shoulder.frame
    elbow = pin(
        "elbow", "one", "two", at=shoulder.point.locatenew("E", length * A.x), axis=A.z, angle=b
    )
    (m1, c1, I1), (m2, c2, I2) = first, second
    loads = [gravity(-g * N.y)] if g != 0 else []
    loads += [
        torque("shoulder moment", moments[0] * N.z, on="one"),
        torque("elbow moment", moments[1] * N.z, on="two", by="one"),
    ]
    return Scene(
        "arm",
        N,
        O,
        plane=N.z,
        joints=(shoulder, elbow),
        loads=loads,
        inputs=inputs,
        bodies=(
            RigidBody("one", shoulder.point.locatenew("C1", c1 * A.x), A, m1, I1),
            RigidBody("two", elbow.point.locatenew("C2", c2 * elbow.frame.x), elbow.frame, m2, I2),
        ),
    )


def two_masses(coordinates, masses, loads, inputs=()):
    """Two masses on a line, with loads of (N, A, B)."""
    N, O = ReferenceFrame("N"), Point("O")
    joints = [
        slide(f"track {n}", None, n, at=O, axis=N.x, distance=q)
        for n, q in zip(("one", "two"), coordinates, strict=True)
    ]
    bodies = [
        RigidBody(n, j.point, N, m, 0)
        for n, j, m in zip(("one", "two"), joints, masses, strict=True)
    ]
    return Scene(
        "masses on a line",
        N,
        O,
        plane=N.z,
        joints=joints,
        bodies=bodies,
        inputs=inputs,
        loads=loads(N, *(j.point for j in joints)),
    )


def one_mass(x, m, push, inputs=(), g=0, sense=0):
    """One mass; sense: whether the axis rises (1) or falls (-1)."""
    N, O = ReferenceFrame("N"), Point("O")
    track = slide("track", None, "mass", at=O, axis=N.x, distance=x)
    loads = [force("all", track.point, push * N.x, on="mass")] if push != 0 else []
    if sense:
        loads.append(gravity(-sense * g * N.x))
    return Scene(
        "mass",
        N,
        O,
        plane=N.z,
        joints=(track,),
        bodies=(RigidBody("mass", track.point, N, m, 0),),
        inputs=inputs,
        loads=loads,
    )


def rotary_pendulum(
    arm, rod, reach, arm_inertia, mass, centre, moments, sense, up, g, drive, brake, inputs
):
    """The rod's end goes forward with sense +1; moments of the rod about its hinge, across,
    along."""
    N, O = ReferenceFrame("N"), Point("O")
    shaft = pin("shaft", None, "arm", at=O, axis=N.z, angle=arm)
    A = shaft.frame
    axis = -A.x if sense * up > 0 else A.x
    hinge = pin(
        "hinge", "arm", "rod", at=shaft.point.locatenew("E", reach * A.x), axis=axis, angle=rod
    )
    B = hinge.frame
    C = hinge.point.locatenew("C", up * centre * B.z)
    loads = [gravity(-g * N.z), torque("motor", drive * N.z, on="arm")]
    if brake != 0:
        loads.append(torque("hinge moment", brake * axis, on="rod", by="arm"))
    return Scene(
        "rotary pendulum",
        N,
        O,
        joints=(shaft, hinge),
        loads=loads,
        inputs=inputs,
        bodies=(
            RigidBody("arm", O, A, 0, inertia(A, 0, 0, arm_inertia)),
            RigidBody("rod", C, B, mass, inertia(B, *moments)),
        ),
    )


def two_bobs(angles, m1, m2, l1, l2, g):
    """Two bobs on light rods, both angles from the downward vertical; R_1, R_2 pull inwards."""
    a, b = dynamicsymbols(angles)
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (a, N.z))
    B = N.orientnew("B", "Axis", (b, N.z))
    P = O.locatenew("P", -l1 * A.y)
    Q = P.locatenew("Q", -l2 * B.y)
    return Scene(
        "double pendulum", N, O, coordinates=(a, b),
        bodies=(Particle("upper", P, m1), Particle("lower", Q, m2)), loads=(gravity(-g * N.y),),
        reactions=(reaction("R_1", at=P, on="upper", by=None, along=A.y),
                   reaction("R_2", at=Q, on="lower", by="upper", along=B.y)),
    )  # fmt: skip


def bead_on_parabola(m, a, g):
    """A bead on a wire y = a x^2."""
    x = dynamicsymbols("x")
    N, O = ReferenceFrame("N"), Point("O")
    P = O.locatenew("P", x * N.x + a * x**2 * N.y)
    normal = (-2 * a * x * N.x + N.y) / sqrt(1 + 4 * a**2 * x**2)
    return Scene(
        "bead on a parabola", N, O, coordinates=(x,), bodies=(Particle("bead", P, m),),
        loads=(gravity(-g * N.y),),
        reactions=(reaction("R", at=P, on="bead", by=None, along=normal),),
    )  # fmt: skip


def roller(m, R, r, g, inertia):
    """Something round m, r rolls inside a hollow cylinder R.

    The angle theta is that of the line of centres from the vertical.
    """
    theta = dynamicsymbols("theta")
    N, O = ReferenceFrame("N"), Point("O")
    out = sin(theta) * N.x - cos(theta) * N.y
    along = cos(theta) * N.x + sin(theta) * N.y
    C = O.locatenew("C", (R - r) * out)
    K = C.locatenew("K", r * out)
    B = N.orientnew("B", "Axis", (-(R - r) / r * theta, N.z))
    return Scene(
        "roller",
        N,
        O,
        coordinates=(theta,),
        loads=(gravity(-g * N.y),),
        bodies=(RigidBody("roller", C, B, m, inertia),),
        reactions=(
            reaction("f", at=K, on="roller", by=None, along=along),
            reaction("N", at=K, on="roller", by=None, along=-out),
        ),
    )


def held(point, on, by=None, /, **directions):
    """Reactions of the ground or a body at a point of a body, by their names and directions."""
    return tuple(reaction(n, at=point, on=on, by=by, along=v) for n, v in directions.items())


def of_one_particle(
    title, N, O, coordinates, body, /, loads=(), example=None, inputs=(), **directions
):
    """A particle: its name, point and mass; reactions of the ground by their names."""
    name, point, mass = body
    return Scene(
        title, N, O, coordinates=coordinates, inputs=inputs, loads=loads, example=example or {},
        bodies=(Particle(name, point, mass),), reactions=held(point, name, **directions),
    )  # fmt: skip


def shared(first, *others):
    """One reaction in several places: a thread."""
    return replace(first, parts=others)


def on_walls(names, m1, m2, left, middle, right):
    """Wall, spring, mass, spring, mass, spring, wall."""
    a, b = dynamicsymbols(names)
    return two_masses(
        (a, b),
        (m1, m2),
        lambda N, A, B: (
            force("left", A, -left * a * N.x, on="one"),
            force("right", B, -right * b * N.x, on="two"),
            force("between", B, -middle * (b - a) * N.x, on="two", by="one"),
        ),
    )


def two_discs(angles, inertias, shaft, ground, inputs=()):
    """Two discs on one axis; the moment of the shaft on the first, by the second, and the
    ground's on each."""
    N, O = ReferenceFrame("N"), Point("O")
    names = ("one", "two")
    pins = [pin(n, None, n, at=O, axis=N.z, angle=q) for n, q in zip(names, angles, strict=True)]
    loads = [torque("shaft", shaft * N.z, on="one", by="two")]
    loads += [
        torque(f"on {n}", M * N.z, on=n) for n, M in zip(names, ground, strict=True) if M != 0
    ]
    return Scene(
        "two discs", N, O, plane=N.z, joints=pins, loads=loads, inputs=inputs,
        bodies=[RigidBody(n, p.point, p.frame, 0, J)
                for n, p, J in zip(names, pins, inertias, strict=True)],
    )  # fmt: skip
