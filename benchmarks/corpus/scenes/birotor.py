"""Planar quadrotor, and a rocket with a gimbaled engine."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import RigidBody, Scene, force, gravity, parameters

x, y, theta, phi, u1, u2, T1, T2 = dynamicsymbols("x y theta phi u1 u2 T1 T2")
T, delta = dynamicsymbols("T delta")
m, I, g, r, l, Izz, J, L = parameters(
    "m I g r l Izz J L",
    units="kg kg*m^2 m/s^2 m m kg*m^2 kg*m^2 m",
    typical="1 0.02 9.81 0.2 4.6 500 50 4",
)


def _birotor(angle, inertia, arm, right, left):
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (angle, N.z))
    C = O.locatenew("C", x * N.x + y * N.y)
    return Scene(
        "planar quadrotor",
        N,
        O,
        coordinates=(x, y, angle),
        bodies=(RigidBody("body", C, A, m, inertia),),
        loads=(
            gravity(-g * N.y),
            force("right", C.locatenew("P1", arm * A.x), right * A.y, on="body"),
            force("left", C.locatenew("P2", -arm * A.x), left * A.y, on="body"),
        ),
        inputs=(right, left) if right is u1 else (left, right),
        example={"y": 1.0},
    )


def sciml():
    """u1 from the right rotor, u2 from the left one."""
    return _birotor(theta, I, r, u1, u2)


def taxi():
    """T1 from the left rotor, T2 from the right one; phi of the body."""
    return _birotor(phi, Izz, l, T2, T1)


def rocket():
    """Thrust T at the tail, L below the mass centre, turned by delta; theta of the axis."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    E = A.orientnew("E", "Axis", (delta, A.z))
    C = O.locatenew("C", x * N.x + y * N.y)
    tail = C.locatenew("P", -L * A.y)
    return Scene(
        "rocket",
        N,
        O,
        coordinates=(x, y, theta),
        bodies=(RigidBody("rocket", C, A, m, J),),
        loads=(gravity(-g * N.y), force("thrust", tail, T * E.y, on="rocket")),
        inputs=(T, delta),
        example={"y": 10.0},
    )
