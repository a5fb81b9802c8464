"""Wilberforce's pendulum: a bob on a helical spring that couples stretch and twist."""

from sympy import Rational
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import RigidBody, Scene, force, parameters, reaction, torque

z, theta = dynamicsymbols("z theta")
m, I, k, delta, epsilon = parameters(
    "m I k delta epsilon", units="kg kg*m^2 N/m N*m N", typical="0.49 0.00014 2.6 0.00074 0.0093"
)


def make_scene():
    """z and theta from rest; the spring's force and couple are declared as loads."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    C = O.locatenew("C", z * N.z)
    from sympy.physics.mechanics import inertia

    half = Rational(1, 2)
    return Scene(
        "Wilberforce pendulum",
        N,
        O,
        coordinates=(z, theta),
        bodies=(RigidBody("bob", C, A, m, inertia(A, I, I, I)),),
        loads=(
            force("spring", C, -(k * z + half * epsilon * theta) * N.z, on="bob"),
            torque("twist", -(delta * theta + half * epsilon * z) * N.z, on="bob"),
        ),
        reactions=_held(C, N),
        example={"z": 0.1},
    )


def _held(C, N):
    from mechanics.scene import reaction_couple

    return (
        reaction("X", at=C, on="bob", by=None, along=N.x),
        reaction("Y", at=C, on="bob", by=None, along=N.y),
        reaction_couple("MX", on="bob", by=None, along=N.x),
        reaction_couple("MY", on="bob", by=None, along=N.y),
    )
