"""A body that stands on two wheels, as a cart and as a wheel that rolls."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import held
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    force,
    gravity,
    parameters,
    reaction,
    torque,
)

x, phi, theta, eta, u, tau, tau_m = dynamicsymbols("x phi theta eta u tau tau_m")
I__b, m__b, m__w, b, l, g, I__w, r = parameters(
    "I__b m__b m__w b l g I__w r",
    units="kg*m^2 kg kg N*s/m m m/s^2 kg*m^2 m",
    typical="0.02 1 0.2 0.1 0.3 9.81 0.001 0.05",
)
m1, m2, J1, J2, R, L = parameters(
    "m1 m2 J1 J2 R L", units="kg kg kg*m^2 kg*m^2 m m", typical="2 0.5 0.03 0.002 0.1 0.2"
)


def hanging_cart():
    """Wheels without inertia: a cart that u pushes and b brakes; theta from hanging."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    P = O.locatenew("P", x * N.x)
    C = P.locatenew("C", -l * A.y)
    return Scene(
        "pendulum on wheels",
        N,
        O,
        coordinates=(x, theta),
        bodies=(Particle("cart", P, m__w), RigidBody("body", C, A, m__b, I__b)),
        loads=(gravity(-g * N.y), force("push", P, (u - b * x.diff()) * N.x, on="cart")),
        reactions=(
            reaction("Nw", at=P, on="cart", by=None, along=N.y),
            *held(P, "body", "cart", X=N.x, Y=N.y),
        ),
        inputs=(u,),
        example={"theta": 0.5},
    )


def mip():
    """Wheels that roll: phi of the wheel against the vertical, theta of the body from upright.

    Both counted so that positive angles go in +x; the motor's tau acts on the wheel by the body.
    """
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (-theta, N.z))
    W = N.orientnew("W", "Axis", (-phi, N.z))
    P = O.locatenew("P", r * phi * N.x + r * N.y)
    contact = O.locatenew("K", r * phi * N.x)
    C = P.locatenew("C", l * A.y)
    return Scene(
        "mobile inverted pendulum",
        N,
        O,
        coordinates=(phi, theta),
        bodies=(RigidBody("wheel", P, W, m__w, I__w), RigidBody("body", C, A, m__b, I__b)),
        loads=(gravity(-g * N.y), torque("motor", -tau * N.z, on="wheel", by="body")),
        reactions=(
            *held(contact, "wheel", Nw=N.y, Fw=N.x),
            *held(P, "body", "wheel", X=N.x, Y=N.y),
        ),
        inputs=(tau,),
        example={"theta": 0.2},
    )


def monowheel():
    """A pendulum (1) that hangs from a wheel (2), eta along the track; tau_m drives the wheel."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    W = N.orientnew("W", "Axis", (-eta / R, N.z))
    P = O.locatenew("P", eta * N.x + R * N.y)
    contact = O.locatenew("K", eta * N.x)
    C = P.locatenew("C", -L * A.y)
    return Scene(
        "monowheel",
        N,
        O,
        coordinates=(eta, theta),
        bodies=(RigidBody("wheel", P, W, m2, J2), RigidBody("pendulum", C, A, m1, J1)),
        loads=(gravity(-g * N.y), torque("motor", -tau_m * N.z, on="wheel", by="pendulum")),
        reactions=(
            *held(contact, "wheel", Nw=N.y, Fw=N.x),
            *held(P, "pendulum", "wheel", X=N.x, Y=N.y),
        ),
        inputs=(tau_m,),
        example={"theta": 0.2},
    )
