"""Rolling bodies, a yo-yo, pulleys and ropes."""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P, held
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    force,
    gravity,
    reaction,
    roll,
    rope,
)


def hollow():
    """A solid cylinder in a hollow one, theta of the line of centres."""
    theta, spin = dynamicsymbols("theta spin")
    m, R, r, g = P("m:kg R:m r:m g:m/s^2", typical="1 0.5 0.1 9.81")
    N, O = ReferenceFrame("N"), Point("O")
    contact = roll(
        "contact",
        None,
        "cylinder",
        at=O,
        normal=-N.y,
        axis=N.z,
        inside=R,
        radius=r,
        angles=(theta, spin),
    )
    return Scene(
        "cylinder in a cylinder",
        N,
        O,
        plane=N.z,
        joints=(contact,),
        loads=(gravity(-g * N.y),),
        bodies=(RigidBody("cylinder", contact.point, contact.frame, m, m * r**2 / 2),),
        example={"theta": 0.4},
    )


def slope():
    """A solid cylinder rolls down, x along the slope; f is friction, up the slope."""
    x = dynamicsymbols("x")
    M, R, a, g = P("M:kg R:m theta:1 g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    along, normal = cos(a) * N.x - sin(a) * N.y, sin(a) * N.x + cos(a) * N.y
    C = O.locatenew("C", x * along)
    K = C.locatenew("K", -R * normal)
    B = N.orientnew("B", "Axis", (-x / R, N.z))
    return Scene(
        "cylinder on a slope",
        N,
        O,
        coordinates=(x,),
        bodies=(RigidBody("cylinder", C, B, M, M * R**2 / 2),),
        loads=(gravity(-g * N.y),),
        reactions=held(K, "cylinder", f=-along, N=normal),
    )


def ring():
    """A light ring rolls on a line with a mass R/2 from its centre, theta from the horizontal,
    counterclockwise."""
    theta = dynamicsymbols("theta")
    m, R, g = P("m:kg R:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    C = O.locatenew("C", -R * theta * N.x + R * N.y)
    K = C.locatenew("K", -R * N.y)
    return Scene(
        "ring with a mass",
        N,
        O,
        coordinates=(theta,),
        bodies=(RigidBody("ring", C.locatenew("M", R / 2 * A.x), A, m, 0),),
        loads=(gravity(-g * N.y),),
        reactions=held(K, "ring", friction=N.x, normal=N.y),
    )


def yoyo():
    """y upwards; the string unrolls from an axle of radius R_0; T is its tension."""
    y = dynamicsymbols("y")
    M, R, I, g = P("M:kg R_0:m I_com:kg*m^2 g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    C = O.locatenew("C", y * N.y)
    B = N.orientnew("B", "Axis", (y / R, N.z))
    K = C.locatenew("K", -R * N.x)
    return Scene(
        "yo-yo",
        N,
        O,
        coordinates=(y,),
        bodies=(RigidBody("yo-yo", C, B, M, I),),
        loads=(gravity(-g * N.y),),
        reactions=(
            reaction("T", at=K, on="yo-yo", by=None, along=N.y),
            reaction("side", at=C, on="yo-yo", by=None, along=N.x),
        ),
    )


def irodov():
    """m_0 on a smooth table pulls up a pulley by a thread; over it hang m_1 and m_2; depths
    x_1, x_2, x_p; T in their thread."""
    x0, xp, x1, x2 = dynamicsymbols("x_0 x_p x_1 x_2")
    m0, m1, m2, l0, l, g = P("m_0:kg m_1:kg m_2:kg l_0:m l:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    at = {"zero": O.locatenew("A", (x0 - l0) * N.x)}
    at |= {n: O.locatenew(n, -s * N.y) for n, s in (("pulley", xp), ("one", x1), ("two", x2))}
    upper = rope(
        "S", ("zero", at["zero"]), (None, O), ("pulley", at["pulley"]), length=l0, along=(N.x, -N.y)
    )
    lower = rope(
        "T",
        ("one", at["one"]),
        ("pulley", at["pulley"]),
        ("two", at["two"]),
        length=l,
        along=(N.y, -N.y),
    )
    return Scene(
        "movable pulley",
        N,
        O,
        coordinates=(x0, xp, x1, x2),
        loads=(gravity(-g * N.y),),
        joints=(upper, lower),
        bodies=tuple(
            Particle(n, at[n], m)
            for n, m in (("zero", m0), ("pulley", 0), ("one", m1), ("two", m2))
        ),
        reactions=(
            reaction("table", at=at["zero"], on="zero", by=None, along=N.y),
            *(
                reaction(f"guide_{n}", at=at[n], on=n, by=None, along=N.x)
                for n in ("pulley", "one", "two")
            ),
        ),
        example={"x_p": 0.5, "x_0": 0.5, "x_1": 1.0, "x_2": 1.0},
    )


def double_incline():
    """m_1 goes down its slope (alpha) by x, m_2 is y down its own (beta); S in the string over
    the ridge."""
    x, y = dynamicsymbols("x y")
    m1, m2, a, b, l, g = P("m_1:kg m_2:kg alpha:1 beta:1 l:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    u, v = -cos(a) * N.x - sin(a) * N.y, cos(b) * N.x - sin(b) * N.y
    A, B = O.locatenew("A", x * u), O.locatenew("B", y * v)
    string = rope("S", ("one", A), (None, O), ("two", B), length=l, along=(-u, v))
    return Scene(
        "double incline",
        N,
        O,
        coordinates=(x, y),
        loads=(gravity(-g * N.y),),
        joints=(string,),
        bodies=(Particle("one", A, m1), Particle("two", B, m2)),
        reactions=(
            reaction("R_1", at=A, on="one", by=None, along=-sin(a) * N.x + cos(a) * N.y),
            reaction("R_2", at=B, on="two", by=None, along=sin(b) * N.x + cos(b) * N.y),
        ),
        example={"x": 0.5, "y": 0.5},
    )


def verma():
    """A block on a string over a pulley (r, I) to a spring below; x of the block down from rest."""
    x = dynamicsymbols("x")
    m, I, r, k, g = P("m:kg I:kg*m^2 r:m k:N/m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    C, K = O.locatenew("C", -r * N.x - x * N.y), O.locatenew("K", r * N.x)
    B = N.orientnew("B", "Axis", (x / r, N.z))
    return Scene(
        "block, pulley and spring",
        N,
        O,
        coordinates=(x,),
        bodies=(Particle("block", C, m), RigidBody("pulley", O, B, 0, I)),
        loads=(gravity(-g * N.y), force("spring", K, -(k * x + m * g) * N.y, on="pulley")),
        reactions=(
            reaction("S", at=C, on="block", by="pulley", along=N.y),
            reaction("guide", at=C, on="block", by=None, along=N.x),
            *held(O, "pulley", axle_x=N.x, axle_y=N.y),
        ),
    )
