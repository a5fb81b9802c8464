"""Pendulum with a reaction wheel at its end."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import held
from mechanics.scene import RigidBody, Scene, gravity, parameters, torque

theta, phi, u, tau = dynamicsymbols("theta phi u tau")


def _scene(
    name,
    inertia_of_rod,
    mass,
    place,
    wheel_inertia,
    wheel_mass,
    wheel_place,
    motor,
    g,
    upright,
    friction=(0, 0),
    inputs=(),
):
    N, O = ReferenceFrame("N"), Point("O")
    side = 1 if upright else -1
    A = N.orientnew("A", "Axis", (theta, N.z))
    B = A.orientnew("B", "Axis", (phi, A.z))
    C = O.locatenew("C", side * place * A.y)
    D = O.locatenew("D", side * wheel_place * A.y)
    loads = [gravity(-g * N.y), torque("motor", motor * N.z, on="wheel", by="rod")]
    rod_friction, wheel_friction = friction
    if rod_friction:
        loads.append(torque("pivot friction", -rod_friction * theta.diff() * N.z, on="rod"))
        loads.append(
            torque("wheel friction", -wheel_friction * phi.diff() * N.z, on="wheel", by="rod")
        )
    return Scene(
        name,
        N,
        O,
        coordinates=(theta, phi),
        bodies=(
            RigidBody("rod", C, A, mass, inertia_of_rod),
            RigidBody("wheel", D, B, wheel_mass, wheel_inertia),
        ),
        loads=tuple(loads),
        reactions=(*held(O, "rod", X1=N.x, Y1=N.y), *held(D, "wheel", "rod", X2=N.x, Y2=N.y)),
        inputs=inputs,
        example={"theta": 0.3},
    )


I_P, I_F, m, l, g = parameters(
    "I_P I_F m l g", units="kg*m^2 kg*m^2 kg m m/s^2", typical="0.01 0.002 0.5 0.2 9.81"
)


def hanging():
    """theta from hanging; phi of the wheel against the pendulum; m at l is all the mass."""
    return _scene("reaction wheel, hanging", I_P, m, l, I_F, 0, l, u, g, False, inputs=(u,))


M_R, L_RCoM, M_W, L_WCoM, J_R, J_W = parameters(
    "M_R L_RCoM M_W L_WCoM J_R J_W",
    units="kg m kg m kg*m^2 kg*m^2",
    typical="0.3 0.1 0.2 0.2 0.004 0.001",
)


def upright():
    """theta from upright; rod R and wheel W with their masses, and inertias about these."""
    return _scene(
        "reaction wheel, upright", J_R, M_R, L_RCoM, J_W, M_W, L_WCoM, tau, g, True, inputs=(tau,)
    )


I_p, I_w, b_p, b_w = parameters(
    "I_p I_w b_p b_w", units="kg*m^2 kg*m^2 N*m*s N*m*s", typical="0.02 0.001 0.003 0.001"
)


def with_friction():
    """theta from upright; I_p counts about the pivot, the mass of the wheel in it."""
    return _scene(
        "reaction wheel with friction",
        I_p - m * l**2,
        m,
        l,
        I_w,
        0,
        l,
        tau,
        g,
        True,
        (b_p, b_w),
        inputs=(tau,),
    )
