"""Ball, a point mass, on a beam that turns about its left end; a force F lifts the other end."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import held
from mechanics.scene import Particle, RigidBody, Scene, force, gravity, parameters, reaction

z, theta, F = dynamicsymbols("z theta F")
m1, m2, l, g = parameters("m1 m2 l g", units="kg kg m m/s^2", typical="0.35 2 0.5 9.81")


def make_scene():
    """z along the beam from its pivot, theta from the horizontal."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    ball = O.locatenew("B", z * A.x)
    centre = O.locatenew("C", l / 2 * A.x)
    end = O.locatenew("E", l * A.x)
    return Scene(
        "ball on beam",
        N,
        O,
        coordinates=(z, theta),
        bodies=(Particle("ball", ball, m1), RigidBody("beam", centre, A, m2, m2 * l**2 / 12)),
        loads=(gravity(-g * N.y), force("F", end, F * N.y, on="beam")),
        reactions=(
            *held(O, "beam", X=N.x, Y=N.y),
            reaction("P", at=ball, on="ball", by="beam", along=A.y),
        ),
        inputs=(F,),
        example={"z": 0.2, "theta": 0.1},
    )
