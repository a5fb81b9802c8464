"""A satellite about a fixed planet, in the plane of its orbit."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import Particle, Scene, force, parameters

r, theta, u_r, u_t = dynamicsymbols("r theta u_r u_theta")
m, mu = parameters("m mu", units="kg m^3/s^2", typical="100 3.986e14")


def make_scene():
    """r and theta; thrusts u_r outwards and u_theta forwards."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    P = O.locatenew("P", r * A.x)
    pull = -mu * m / r**2
    return Scene(
        "satellite in orbit",
        N,
        O,
        coordinates=(r, theta),
        bodies=(Particle("sat", P, m),),
        loads=(
            force("gravity of the planet", P, pull * A.x, on="sat"),
            force("thrust", P, u_r * A.x + u_t * A.y, on="sat"),
        ),
        inputs=(u_r, u_t),
        example={"r": 7.0e6, "theta_dot": 0.00108},
    )
