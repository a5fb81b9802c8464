"""Block on a wedge that slides on a smooth table."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import Particle, Scene, gravity, parameters, reaction

X, x = dynamicsymbols("X x")
M, m, alpha, g = parameters("M m alpha g", units="kg kg rad m/s^2", typical="0.431 0.1 0.593 9.81")


def make_scene():
    """X of the wedge, x of the block down the slope, which falls in the direction of X."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (-alpha, N.z))
    W = O.locatenew("W", X * N.x)
    B = W.locatenew("B", x * A.x)
    return Scene(
        "block on a wedge",
        N,
        O,
        coordinates=(X, x),
        bodies=(Particle("wedge", W, M), Particle("block", B, m)),
        loads=(gravity(-g * N.y),),
        reactions=(
            reaction("table", at=W, on="wedge", by=None, along=N.y),
            reaction("slope", at=B, on="block", by="wedge", along=A.y),
        ),
        example={"x": 0.1},
    )
