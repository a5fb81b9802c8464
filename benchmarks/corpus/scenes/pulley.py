"""Atwood's machine with a pulley that has mass: a disc of mass M and radius R."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import Particle, RigidBody, Scene, gravity, parameters, reaction

x = dynamicsymbols("x")
m1, m2, M, R, g = parameters("m1 m2 M R g", units="kg kg kg m m/s^2", typical="2 1 1 0.1 9.81")


def make_scene():
    """x of m1, downwards; the string does not slip; tensions T1 and T2 on both sides."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (x / R, N.z))
    one = O.locatenew("one", -R * N.x - x * N.y)
    two = O.locatenew("two", R * N.x + x * N.y)
    return Scene(
        "Atwood machine with a massive pulley",
        N,
        O,
        coordinates=(x,),
        bodies=(
            Particle("m1", one, m1),
            Particle("m2", two, m2),
            RigidBody("pulley", O, A, M, M * R**2 / 2),
        ),
        loads=(gravity(-g * N.y),),
        reactions=(
            reaction("T1", at=one, on="m1", by="pulley", along=N.y),
            reaction("T2", at=two, on="m2", by="pulley", along=N.y),
            reaction("axle x", at=O, on="pulley", by=None, along=N.x),
            reaction("axle y", at=O, on="pulley", by=None, along=N.y),
            reaction("guide 1", at=one, on="m1", by=None, along=N.x),
            reaction("guide 2", at=two, on="m2", by=None, along=N.x),
        ),
        example={"x": 0.0},
    )
