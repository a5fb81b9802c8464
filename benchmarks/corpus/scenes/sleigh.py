"""Chaplygin's sleigh: a body on a smooth plane with a knife edge."""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import RigidBody, Scene, nonholonomic, parameters, reaction

x, y, theta, v, omega, w = dynamicsymbols("x y theta v omega w")
m, I, a = parameters("m I a", units="kg kg*m^2 m", typical="1 0.1 0.2")


def make_scene():
    """x, y of the knife edge, theta of its heading; mass centre a ahead; w = 0 to the side."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    K = O.locatenew("K", x * N.x + y * N.y)
    C = K.locatenew("C", a * A.x)
    side = -x.diff() * sin(theta) + y.diff() * cos(theta)
    return Scene(
        "Chaplygin sleigh",
        N,
        O,
        coordinates=(x, y, theta),
        speeds=(
            (v, x.diff() * cos(theta) + y.diff() * sin(theta)),
            (omega, theta.diff()),
            (w, side),
        ),
        bodies=(RigidBody("sleigh", C, A, m, I),),
        reactions=(reaction("lambda_", at=K, on="sleigh", by=None, along=A.y),),
        constraints=(nonholonomic("knife edge", side, "lambda_"),),
        example={"omega": 1.0},
    )
