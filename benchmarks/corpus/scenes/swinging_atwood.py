"""Swinging Atwood machine: bob m swings, counterweight M moves up and down."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import Particle, Scene, gravity, parameters, reaction, rope

r, theta, y = dynamicsymbols("r theta y")
m, M, g, ell, d = parameters("m M g ell d", units="kg kg m/s^2 m m", typical="1 2 9.81 3 1")


def make_scene():
    """theta from hanging, r from the pulley to the bob, y the depth of the counterweight."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    other = O.locatenew("Q", -d * N.x)
    bob = O.locatenew("P", -r * A.y)
    weight = other.locatenew("W", -y * N.y)
    cord = rope(
        "S",
        ("bob", bob),
        (None, O),
        (None, other),
        ("weight", weight),
        length=ell,
        along=(A.y, -N.y),
    )
    return Scene(
        "swinging Atwood machine",
        N,
        O,
        coordinates=(r, theta, y),
        bodies=(Particle("bob", bob, m), Particle("weight", weight, M)),
        reactions=(reaction("guide", at=weight, on="weight", by=None, along=N.x),),
        joints=(cord,),
        loads=(gravity(-g * N.y),),
        example={"r": 1.0, "theta": 0.5, "y": 2.0},
    )
