"""Overhead cranes."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import Particle, Scene, force, gravity, parameters, reaction

x, l, theta, f_x, f_l, u = dynamicsymbols("x l theta f_x f_l u")
M, m, g, r, d_c, d_p = parameters(
    "M m g r d_c d_p", units="kg kg m/s^2 m N*s/m N*m*s", typical="10 0.2 9.81 1 2 0.5"
)


def hoisting():
    """Trolley at x, load on a rope of length l, theta from hanging; f_l pays out."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    P = O.locatenew("P", x * N.x)
    Q = P.locatenew("Q", -l * A.y)
    return Scene(
        "overhead crane with hoist",
        N,
        O,
        coordinates=(x, l, theta),
        bodies=(Particle("trolley", P, M), Particle("load", Q, m)),
        loads=(
            gravity(-g * N.y),
            force("f_x", P, f_x * N.x, on="trolley"),
            force("pull", Q, -f_l * A.y, on="load"),
            force("back", P, f_l * A.y, on="trolley"),
        ),
        reactions=(reaction("N", at=P, on="trolley", by=None, along=N.y),),
        inputs=(f_x, f_l),
        example={"l": 1.0, "theta": 0.2},
    )


def gantry():
    """Rope of constant length r; d_c brakes the trolley, d_p the swing; u drives."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    P = O.locatenew("P", x * N.x)
    Q = P.locatenew("Q", -r * A.y)
    # A couple on a point mass is a force across the rope, and the opposite on the trolley.
    couple = d_p * theta.diff() / r * A.x
    return Scene(
        "gantry crane",
        N,
        O,
        coordinates=(x, theta),
        bodies=(Particle("trolley", P, M), Particle("load", Q, m)),
        loads=(
            gravity(-g * N.y),
            force("u", P, (u - d_c * x.diff()) * N.x, on="trolley"),
            force("swing", Q, -couple, on="load"),
            force("swing back", P, couple, on="trolley"),
        ),
        reactions=(
            reaction("N", at=P, on="trolley", by=None, along=N.y),
            reaction("S", at=Q, on="load", by="trolley", along=A.y),
        ),
        inputs=(u,),
        example={"theta": 0.2},
    )
