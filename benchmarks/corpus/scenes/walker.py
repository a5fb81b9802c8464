"""A foot, an arc of a circle, that rolls down a slope and carries a mass."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import held
from mechanics.scene import RigidBody, Scene, gravity, parameters

phi = dynamicsymbols("phi")
m, R, d, I, gamma, g = parameters(
    "m R d I gamma g", units="kg m m kg*m^2 rad m/s^2", typical="0.838 0.2 0.72 0.0545 0.0456 9.81"
)


def make_scene():
    """phi of the leg from the vertical, downhill; d from the arc's centre to the mass centre."""
    N, O = ReferenceFrame("N"), Point("O")
    S = N.orientnew("S", "Axis", (-gamma, N.z))
    leg = N.orientnew("B", "Axis", (-phi, N.z))
    contact = O.locatenew("K", R * phi * S.x)
    centre = contact.locatenew("M", R * S.y)
    C = centre.locatenew("C", d * leg.y)
    return Scene(
        "rolling foot",
        N,
        O,
        coordinates=(phi,),
        bodies=(RigidBody("leg", C, leg, m, I),),
        loads=(gravity(-g * N.y),),
        reactions=held(contact, "leg", normal=S.y, grip=S.x),
        example={"phi": -0.3},
    )
