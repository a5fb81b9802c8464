"""What scenes of the corpus have in common: bodies without a joint to the ground."""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from benchmarks.corpus.builders import P
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    ball,
    euler,
    force,
    gravity,
    reaction,
    torque,
)


def turning_body(rates, moments, torques=(), *, name, angles="yaw pitch roll", load=None):
    """A rigid body that turns freely about its mass centre.

    Its rates and moments of inertia are about its principal axes, and so are the torques, unless
    `load` says otherwise, of the body's frame.
    """
    a, b, c = dynamicsymbols(angles)
    w, I = dynamicsymbols(rates), P(moments, typical="10 15 20")
    N, O = ReferenceFrame("N"), Point("O")
    hold = ball("hold", None, name, at=O, frame=N, rotation=euler("zyx", a, b, c))
    F = hold.frame
    of_angles = (
        c.diff() - a.diff() * sin(b),
        b.diff() * cos(c) + a.diff() * cos(b) * sin(c),
        -b.diff() * sin(c) + a.diff() * cos(b) * cos(c),
    )
    loads = []
    if load is not None:
        loads.append(torque("thrust", load(F), on=name))
    elif torques:
        moment = torques[0] * F.x + torques[1] * F.y + torques[2] * F.z
        loads.append(torque("torque", moment, on=name))
    return Scene(
        name, N, O, joints=(hold,), inputs=torques, speeds=tuple(zip(w, of_angles, strict=True)),
        bodies=(RigidBody(name, O, F, 0, inertia(F, *I)),), loads=loads,
        example={str(w[0].func): 0.5},
    )  # fmt: skip


def chaser(m, n, turned, pull, thrust, other):
    """A body near a target in a circular orbit with the rate n: the linear gravity, and forces.

    The axes turn as `turned` says of the ground's frame; `pull` has the gravity in parts of
    m n^2 times each coordinate.
    """
    q = dynamicsymbols("x y z")
    N, O = ReferenceFrame("N"), Point("O")
    A = turned(N)

    def along(entries):
        return sum((e * axis for e, axis in zip(entries, A, strict=True)), 0 * A.x)

    C = O.locatenew("C", along(q))
    loads = [force("gravity", C, along([m * n**2 * k * x for k, x in zip(pull, q, strict=True)]),
                   on="chaser")]  # fmt: skip
    if thrust:
        loads.append(force("thrust", C, along(thrust), on="chaser"))
    return Scene(
        "chaser", N, O, coordinates=q, bodies=(Particle("chaser", C, m),), loads=loads,
        inputs=thrust, example={"x": 0.3, other: 0.4},
    )  # fmt: skip


def craft(names, m, J, loads, inputs, *, g=None, sense=1, name="craft"):
    """A rigid body in a plane at two coordinates, turned by a third; loads of (N, A, C).

    Sense +1: counterclockwise.
    """
    x, y, a = dynamicsymbols(names)
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (sense * a, N.z))
    C = O.locatenew("C", x * N.x + y * N.y)
    weight = (gravity(-g * N.y),) if g is not None else ()
    return Scene(
        name, N, O, coordinates=(x, y, a), inputs=inputs, plane=N.z,
        bodies=(RigidBody(name, C, A, m, J),), loads=(*weight, *loads(N, A, C)),
    )  # fmt: skip


def central_force(coordinates, m, pull, thrust=None, inputs=(), speeds=()):
    """A particle at r, theta from a fixed point that pulls it; a thrust outwards and forwards."""
    r, theta = coordinates
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    C = O.locatenew("C", r * A.x)
    loads = [force("gravity", C, -pull * A.x, on="craft")]
    if thrust is not None:
        loads.append(force("thrust", C, thrust[0] * A.x + thrust[1] * A.y, on="craft"))
    return Scene(
        "orbit", N, O, coordinates=(r, theta), bodies=(Particle("craft", C, m),), loads=loads,
        inputs=inputs, speeds=speeds,
        reactions=(reaction("side", at=C, on="craft", by=None, along=N.z),), example={"r": 2.0},
    )  # fmt: skip
