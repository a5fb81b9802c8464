"""One and two masses on springs: a car's quarter, an unbalanced machine, a rotor, a chain."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import Particle, Scene, damper, force, parameters, reaction, spring

t = dynamicsymbols._t
zs, zu, zr, x, y, z, x1, x2 = dynamicsymbols("zs zu zr x y z x1 x2")
ms, mu, ks, kt, d = parameters(
    "ms mu ks kt d", units="kg kg N/m N/m N*s/m", typical="300 40 16000 160000 1000"
)
M, m, e, c, k, omega, epsilon = parameters(
    "M m e c k omega epsilon",
    units="kg kg m N*s/m N/m 1/s m",
    typical="100 2 0.1 50 40000 20 0.001",
)
m1, m2, k1, k2, k3, d1, d2 = parameters(
    "m1 m2 k1 k2 k3 d1 d2", units="kg kg N/m N/m N/m N*s/m N*s/m", typical="1 2 10 20 10 0.5 0.3"
)


def quarter_car():
    """zs of the body, zu of the wheel, zr of the road, from rest."""
    N, O = ReferenceFrame("N"), Point("O")
    S, U, R = (O.locatenew(n, s * N.y) for n, s in (("S", zs), ("U", zu), ("R", zr)))
    return Scene(
        "quarter car",
        N,
        O,
        coordinates=(zs, zu),
        bodies=(Particle("body", S, ms), Particle("wheel", U, mu)),
        loads=(
            spring("ks", U, S, ks, along=N.y),
            damper("d", U, S, d, along=N.y),
            spring("kt", R, U, kt, along=N.y, second_on="wheel"),
        ),
        inputs=(zr,),
        example={"zs": 0.05},
    )


def unbalance():
    """A machine of mass M, m of it at e on a shaft that turns by omega t; x upwards from rest."""
    N, O = ReferenceFrame("N"), Point("O")
    P = O.locatenew("P", x * N.y)
    A = N.orientnew("A", "Axis", (omega * t, N.z))
    Q = P.locatenew("Q", e * A.x)
    return Scene(
        "machine with unbalance",
        N,
        O,
        coordinates=(x,),
        bodies=(Particle("machine", P, M - m), Particle("unbalance", Q, m)),
        loads=(spring("k", O, P, k, along=N.y), damper("c", O, P, c, along=N.y)),
        reactions=(
            reaction("guide", at=P, on="machine", by=None, along=N.x),
            reaction("shaft x", at=Q, on="unbalance", by="machine", along=N.x),
            reaction("shaft y", at=Q, on="unbalance", by="machine", along=N.y),
        ),
        example={"x": 0.01},
    )


def seismometer():
    """A mass on a spring and a damper in a case that moves by y; x is absolute."""
    N, O = ReferenceFrame("N"), Point("O")
    P, B = O.locatenew("P", x * N.y), O.locatenew("B", y * N.y)
    return Scene(
        "seismometer",
        N,
        O,
        coordinates=(x,),
        bodies=(Particle("mass", P, m),),
        loads=(
            spring("k", B, P, k, along=N.y, second_on="mass"),
            damper("c", B, P, c, along=N.y, second_on="mass"),
        ),
        inputs=(y,),
        example={"x": 0.01},
    )


def jeffcott():
    """Disc on a shaft that turns by omega t; x, y of the shaft, epsilon to the mass centre."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (omega * t, N.z))
    S = O.locatenew("S", x * N.x + y * N.y)
    G = S.locatenew("G", epsilon * A.x)
    return Scene(
        "Jeffcott rotor",
        N,
        O,
        coordinates=(x, y),
        bodies=(Particle("disc", G, m),),
        loads=(
            force(
                "shaft", G, -(k * x + c * x.diff()) * N.x - (k * y + c * y.diff()) * N.y, on="disc"
            ),
        ),
        example={"x": 0.001},
    )


def chain():
    """Wall, k1 and d1, m1, k2 and d2, m2, k3, wall."""
    N, O = ReferenceFrame("N"), Point("O")
    A, B = O.locatenew("A", x1 * N.x), O.locatenew("B", x2 * N.x)
    return Scene(
        "two masses",
        N,
        O,
        coordinates=(x1, x2),
        bodies=(Particle("one", A, m1), Particle("two", B, m2)),
        loads=(
            spring("k1", O, A, k1, along=N.x),
            damper("d1", O, A, d1, along=N.x),
            spring("k2", A, B, k2, along=N.x),
            damper("d2", A, B, d2, along=N.x),
            spring("k3", O, B, k3, along=N.x),
        ),
        example={"x1": 0.1},
    )
