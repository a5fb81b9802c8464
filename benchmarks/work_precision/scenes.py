"""Problems of published collections that do not ship as systems, as scenes."""

from functools import partial

from sympy import Expr, Matrix, Rational, S, pi, sin, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    ball,
    force,
    gravity,
    holonomic,
    parameters,
    pin,
    quaternion,
    reaction,
    torque,
)

TIME = dynamicsymbols._t
PLEIADES = (
    ((3, 3), (0, 0)), ((3, -3), (0, 0)), ((-1, 2), (0, 0)), ((-3, 0), (0, S(-5) / 4)),
    ((2, 0), (0, 1)), ((-2, -4), (S(7) / 4, 0)), ((2, 4), (S(-3) / 2, 0)),
)  # fmt: skip
"""Where star i, of mass i, begins, and how fast."""


def pendulum() -> Scene:
    """IFToMM A01: a point mass on a massless rod of 1 m that starts level, by its angle."""
    m, l, g = parameters("m l g", typical="1 1 9.81")
    ground, pivot = ReferenceFrame("N"), Point("O")
    joint = pin("pivot", None, "rod", at=pivot, axis=ground.z, angle=dynamicsymbols("theta"))
    tip = pivot.locatenew("P", l * joint.frame.x)
    return Scene("pendulum", ground, pivot, plane=ground.z, joints=(joint,),
                 bodies=(RigidBody("rod", tip, joint.frame, m, 0),),
                 loads=(gravity(-g * ground.y),), example={"theta": float(pi)})  # fmt: skip


def pendulum_by_place() -> Scene:
    """The same by x and y, with the rod as a constraint."""
    x, y = dynamicsymbols("x y")
    m, l, g = parameters("m l g", typical="1 1 9.81")
    ground, pivot = ReferenceFrame("N"), Point("O")
    tip = pivot.locatenew("P", x * ground.x + y * ground.y)
    along = (x * ground.x + y * ground.y) / sqrt(x**2 + y**2)
    return Scene("pendulum by x and y", ground, pivot, coordinates=(x, y),
                 bodies=(Particle("bob", tip, m),), loads=(gravity(-g * ground.y),),
                 reactions=(reaction("S", at=tip, on="bob", by=None, along=along),),
                 constraints=(holonomic("rod", x**2 + y**2 - l**2, "S"),),
                 example={"x": -1.0})  # fmt: skip


def pleiades() -> Scene:
    """Seven stars in a plane that attract each other: PLEIADES of the Test Set."""
    ground, origin = ReferenceFrame("N"), Point("O")
    places, bodies, loads, example = [], [], [], {}
    for i, (at, speed) in enumerate(PLEIADES, 1):
        place = dynamicsymbols(f"x{i} y{i}")
        places.append(Matrix(place))
        point = origin.locatenew(f"P{i}", place[0] * ground.x + place[1] * ground.y)
        bodies.append(Particle(f"star{i}", point, S(i)))
        for name, value, rate in zip((f"x{i}", f"y{i}"), at, speed, strict=True):
            example |= {name: float(value), f"{name}_dot": float(rate)}
    for i, body in enumerate(bodies):
        for j in range(i + 1, len(bodies)):
            apart = places[j] - places[i]
            pull = (i + 1) * (j + 1) * apart / (apart.dot(apart) * sqrt(apart.dot(apart)))
            along = pull[0] * ground.x + pull[1] * ground.y
            loads += [
                force(f"F{i}{j}", body.centre, along, on=body.name),
                force(f"F{j}{i}", bodies[j].centre, -along, on=bodies[j].name),
            ]
    return Scene("Pleiades", ground, origin, coordinates=tuple(c for p in places for c in p),
                 bodies=tuple(bodies), loads=tuple(loads), example=example)  # fmt: skip


def three_bodies() -> Scene:
    """Arenstorf's orbit of the restricted problem of three bodies, seen from the turning frame."""
    x, y = dynamicsymbols("x y")
    mu = Rational("0.012277471")
    ground, origin = ReferenceFrame("N"), Point("O")
    turning = ground.orientnew("R", "Axis", (TIME, ground.z))
    probe = origin.locatenew("P", x * turning.x + y * turning.y)
    loads = []
    for name, mass, place in (("earth", 1 - mu, -mu), ("moon", mu, 1 - mu)):
        off = x - place
        pull = -mass * (off * turning.x + y * turning.y) / ((off**2 + y**2) * sqrt(off**2 + y**2))
        loads.append(force(name, probe, pull, on="probe"))
    return Scene("restricted three bodies", ground, origin, coordinates=(x, y),
                 bodies=(Particle("probe", probe, S.One),), loads=tuple(loads),
                 example={"x": 0.994, "y_dot": -2.00158510637908252240537862224})  # fmt: skip


def in_a_potential(title: str, potential: Expr, example: dict[str, float]) -> Scene:
    """A particle of mass 1 in a plane, in a potential of its coordinates q1 and q2."""
    q = dynamicsymbols("q1 q2")
    ground, origin = ReferenceFrame("N"), Point("O")
    place = origin.locatenew("P", q[0] * ground.x + q[1] * ground.y)
    slope = [potential.diff(coordinate) for coordinate in q]
    pull = force("field", place, -slope[0] * ground.x - slope[1] * ground.y, on="particle")
    return Scene(title, ground, origin, coordinates=tuple(q), loads=(pull,),
                 bodies=(Particle("particle", place, S.One),), example=example)  # fmt: skip


Q1, Q2 = dynamicsymbols("q1 q2")
HENON_HEILES = (Q1**2 + Q2**2) / 2 + Q1**2 * Q2 - Q2**3 / 3
QUADRUPOLE_BOSON = (
    (Q1**2 + Q2**2) / 2
    + Rational("0.55") / sqrt(2) * Q1 * (3 * Q2**2 - Q1**2)
    + Rational("0.1") * (Q1**2 + Q2**2) ** 2
)
henon_heiles = partial(in_a_potential, "Henon-Heiles", HENON_HEILES, {"q1": 0.1, "q2_dot": 0.5})
quadrupole_boson = partial(
    in_a_potential, "quadrupole boson", QUADRUPOLE_BOSON,
    {"q1": 4.919080920016389, "q2": 2.836942666663649},
)  # fmt: skip


def rigid_body() -> Scene:
    """Euler's equations with a torque about the third axis that changes with time."""
    moments = (Rational(1, 2), S(2), S(3))
    ground, centre = ReferenceFrame("N"), Point("O")
    joint = ball("centre", None, "body", at=centre, frame=ground,
                 rotation=quaternion("e0 e1 e2 e3", "y1 y2 y3"))  # fmt: skip
    body = RigidBody("body", centre, joint.frame, S.One, inertia(joint.frame, *moments))
    push = torque("k", moments[2] * sin(TIME) ** 2 / 4 * joint.frame.z, on="body")
    return Scene("rigid body", ground, centre, bodies=(body,), joints=(joint,), loads=(push,),
                 example={"y1": 1.0, "y3": 0.9},
                 notes=("body body: -2, 1.25 and -0.5 of the source belong to no real body",),
                 )  # fmt: skip
