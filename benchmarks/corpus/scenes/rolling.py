"""A plank that rocks on a log, a ball in a bowl."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import held
from mechanics.scene import RigidBody, Scene, gravity, parameters, roll

theta, spin = dynamicsymbols("theta spin")
m, a, b, R, r, g = parameters(
    "m a b R r g", units="kg m m m m m/s^2", typical="1 0.3 1 0.5 0.05 9.81"
)


def plank():
    """Thin plank of length 2b on a log of radius a, theta from the horizontal, without slip."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (-theta, N.z))
    K = O.locatenew("K", a * A.y)
    C = K.locatenew("C", -a * theta * A.x)
    return Scene(
        "plank on a log",
        N,
        O,
        coordinates=(theta,),
        bodies=(RigidBody("plank", C, A, m, m * b**2 / 3),),
        loads=(gravity(-g * N.y),),
        reactions=held(K, "plank", P=A.y, F=A.x),
        example={"theta": 0.2},
    )


def ball():
    """Homogeneous ball of radius r in a fixed cylinder of radius R, across its axis."""
    N, O = ReferenceFrame("N"), Point("O")
    contact = roll(
        "contact",
        None,
        "ball",
        at=O,
        normal=-N.y,
        axis=N.z,
        inside=R,
        radius=r,
        angles=(theta, spin),
    )
    return Scene(
        "ball in a trough",
        N,
        O,
        bodies=(RigidBody("ball", contact.point, contact.frame, m, 2 * m * r**2 / 5),),
        joints=(contact,),
        plane=N.z,
        loads=(gravity(-g * N.y),),
        example={"theta": 0.4},
    )
