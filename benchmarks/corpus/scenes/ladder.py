"""Ladder that slides down between a smooth wall and a smooth floor."""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import RigidBody, Scene, gravity, parameters, reaction

theta = dynamicsymbols("theta")
m, l, g, L, M, d = parameters("m l g L M d", units="kg m m/s^2 m kg m", typical="5 1 9.81 2 5 2")


def from_vertical():
    """Length 2l, theta from the wall."""
    return _ladder(m, l, theta, False)


def from_floor():
    """Length L, theta from the floor."""
    return _ladder(m, L / 2, theta, True)


def from_floor_in_d():
    """Length d and mass M, theta from the floor."""
    return _ladder(M, d / 2, theta, True)


def _ladder(mass, half, angle, floor):
    N, O = ReferenceFrame("N"), Point("O")
    across, up = (cos(angle), sin(angle)) if floor else (sin(angle), cos(angle))
    # The rod's own frame: its y runs from foot to top.
    A = N.orientnew("A", "Axis", (-angle if floor else angle, N.z))
    C = O.locatenew("C", half * across * N.x + half * up * N.y)
    foot = O.locatenew("F", 2 * half * across * N.x)
    top = O.locatenew("T", 2 * half * up * N.y)
    return Scene(
        "sliding ladder",
        N,
        O,
        coordinates=(theta,),
        bodies=(RigidBody("ladder", C, A, mass, mass * (2 * half) ** 2 / 12),),
        loads=(gravity(-g * N.y),),
        reactions=(
            reaction("N1", at=top, on="ladder", by=None, along=N.x),
            reaction("N2", at=foot, on="ladder", by=None, along=N.y),
        ),
        example={"theta": 0.6},
    )
