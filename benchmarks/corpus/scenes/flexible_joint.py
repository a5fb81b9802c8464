"""A link that a motor turns through a spring."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import held
from mechanics.scene import RigidBody, Scene, gravity, parameters, torque, torsion_spring

q_1, q_2, theta, beta, u, tau = dynamicsymbols("q_1 q_2 theta beta u tau")
I, J, M, L, k, g = parameters(
    "I J M L k g", units="kg*m^2 kg*m^2 kg m N*m m/s^2", typical="1 0.1 1 0.5 100 9.81"
)
Jh, Jl, Ks, m, h = parameters(
    "Jh Jl Ks m h", units="kg*m^2 kg*m^2 N*m kg m", typical="0.0021 0.0059 1.61 0.403 0.06"
)


def spong():
    """Link q_1 from hanging, motor q_2, both absolute; I counts about the pivot; u on the motor."""
    N, O = ReferenceFrame("N"), Point("O")
    A, B = (N.orientnew(n, "Axis", (q, N.z)) for n, q in (("A", q_1), ("B", q_2)))
    C = O.locatenew("C", -L * A.y)
    return _scene(
        N,
        O,
        (q_1, q_2),
        RigidBody("link", C, A, M, I - M * L**2),
        RigidBody("motor", O, B, 0, J),
        q_1 - q_2,
        k,
        u,
        {"q_1": 0.5},
    )


def _scene(N, O, q, link, motor, twist, stiffness, drive, example):
    return Scene(
        "flexible joint",
        N,
        O,
        coordinates=q,
        bodies=(link, motor),
        loads=(
            gravity(-g * N.y),
            torsion_spring("spring", twist, N.z, stiffness, on="link", by="motor"),
            torque("drive", drive * N.z, on="motor"),
        ),
        reactions=(*held(O, "link", X=N.x, Y=N.y), *held(O, "motor", X2=N.x, Y2=N.y)),
        inputs=(drive,),
        example=example,
    )
