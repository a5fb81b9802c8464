"""A rigid body that turns freely, with torques about its principal axes."""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.scene import RigidBody, Scene, ball, euler, parameters, torque

a1, a2, a3 = dynamicsymbols("yaw pitch roll")
t = dynamicsymbols._t


def _scene(speeds, moments, torques, names):
    N, O = ReferenceFrame("N"), Point("O")
    joint = ball("hold", None, "satellite", at=O, frame=N, rotation=euler("zyx", a1, a2, a3))
    F = joint.frame
    p = a3.diff() - a1.diff() * sin(a2)
    q = a2.diff() * cos(a3) + a1.diff() * cos(a2) * sin(a3)
    r = -a2.diff() * sin(a3) + a1.diff() * cos(a2) * cos(a3)
    loads = ()
    if torques:
        vector = torques[0] * F.x + torques[1] * F.y + torques[2] * F.z
        loads = (torque("torque", vector, on="satellite"),)
    return Scene(
        "satellite",
        N,
        O,
        bodies=(RigidBody("satellite", O, F, 0, inertia(F, *moments)),),
        joints=(joint,),
        loads=loads,
        inputs=tuple(torques),
        speeds=tuple(zip(speeds, (p, q, r), strict=True)),
        example={f"{speeds[0].func.__name__}": 0.5},
    )


def free():
    """Without torque, as code has it: w1, w2, w3 and I1, I2, I3."""
    w = dynamicsymbols("w1 w2 w3")
    I = parameters("I1 I2 I3", units="kg*m^2 kg*m^2 kg*m^2", typical="10 15 20")
    return _scene(w, I, (), None)


def driven():
    """With torque, p q r and Ixx Iyy Izz."""
    w = dynamicsymbols("p q r")
    T = dynamicsymbols("Tx Ty Tz")
    I = parameters("Ixx Iyy Izz", units="kg*m^2 kg*m^2 kg*m^2", typical="10 15 20")
    return _scene(w, I, T, None)


def wertz():
    """Symbols of a handbook: I_1 omega_1' = N_1 + ..."""
    w = dynamicsymbols("omega_1 omega_2 omega_3")
    T = dynamicsymbols("N_1 N_2 N_3")
    I = parameters("I_1 I_2 I_3", units="kg*m^2 kg*m^2 kg*m^2", typical="10 15 20")
    return _scene(w, I, T, None)
