"""Bicycle with a rider who sits still, after Whipple: two wheels that roll, a frame and a fork.

    x, y    of the rear contact, x forward and z down
    yaw, lean, pitch, steer    of the frame, and of the fork against it
    tR, tF  of the wheels against rear frame's hub and fork

Pitch follows from the front contact, a holonomic constraint; four conditions of no slip leave three
freedoms. Geometry and parameters are those of the benchmark of J. P. Meijaard, J. M. Papadopoulos,
A. Ruina and A. L. Schwab, "Linearized dynamics equations for the balance and steer of a bicycle: a
benchmark and review", Proceedings of the Royal Society A 463 (2007), table 1; zB, zH and IHxz are
given with the other sign here. The frame's tilt of the steering axis is pi/10.
"""

from sympy import Symbol, pi
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia
from sympy.physics.vector import Dyadic

from mechanics.scene import Outline, RigidBody, Scene, gravity, parameters, pin, roll

TYPICAL = {
    "m": "w 1.02, c 0.08, rR 0.3, xB 0.3, zB 0.9, xH 0.9, zH 0.7, rF 0.35",
    "m/s^2": "g 9.81",
    "kg": "mR 2, mB 85, mH 4, mF 3",
    "kg*m^2": "IRx 0.0603, IRy 0.12, IBx 9.2, IBy 11, IBz 2.8, IBxz 2.4, IHx 0.05892, IHy 0.06,"
    " IHz 0.00708, IHxz 0.00756, IFx 0.1405, IFy 0.28",
}
"""Wheelbase w, trail c, radii r, mass centres (x, -z), masses and inertias of the rear wheel R, the
frame with its rider B, the fork with the handlebar H and the front wheel F, by unit."""


def bicycle_parameters() -> dict[str, Symbol]:
    """The parameters by name."""
    found: dict[str, Symbol] = {}
    for unit, text in TYPICAL.items():
        for name, value in (entry.split() for entry in text.split(",")):
            (found[name],) = parameters(name, units=unit, typical=value)
    return found


def bicycle_inertia(frame: ReferenceFrame, p: dict[str, Symbol], name: str, sign: int) -> Dyadic:
    """The inertia of a part that is symmetric to its plane; the sign is that of the xz product."""
    x, y, z, product = (p[name + axes] for axes in ("x", "y", "z", "xz"))
    return inertia(frame, x, y, z, 0, 0, sign * product)


def scene() -> Scene:
    """The bicycle at any lean, steer and heading."""
    p = bicycle_parameters()
    x, y, yaw, lean, pitch, steer, tR, tF = dynamicsymbols("x y yaw lean pitch steer tR tF")
    ground, origin = ReferenceFrame("N"), Point("O")
    rear = roll("R", None, "rear", at=origin, normal=-ground.z, radius=p["rR"],
                coordinates=(x, y), angles=(yaw, lean, tR))  # fmt: skip
    assert rear.hub is not None
    seat = pin("B", "rear", "frame", at=rear.point, axis=rear.hub.y, angle=pitch)
    frame = seat.frame
    base = rear.point.locatenew("base", p["rR"] * frame.z)
    axis = base.locatenew("axis", (p["w"] + p["c"]) * frame.x)
    head = frame.orientnew("S", "Axis", (pi / 10, frame.y))
    steering = pin("H", "frame", "fork", at=axis, axis=head.z, angle=steer)
    fork = steering.frame.orientnew("Hf", "Axis", (-pi / 10, steering.frame.y))
    axle = axis.locatenew("Fc", -p["c"] * fork.x - p["rF"] * fork.z)
    hub = pin("F", "fork", "front", at=axle, axis=fork.y, angle=tF)
    wheel = hub.frame
    front = roll("Q", None, "front", at=origin, normal=-ground.z, radius=p["rF"], axis=wheel.y,
                 onto=(axle, wheel))  # fmt: skip
    rider = base.locatenew("Bc", p["xB"] * frame.x - p["zB"] * frame.z)
    bars = axis.locatenew("Hc", (p["xH"] - p["w"] - p["c"]) * fork.x - p["zH"] * fork.z)
    wheels = {
        name: (Outline(p[name] * turns.x, p[name] * turns.z, filled=True),)
        for name, turns in (("rR", rear.frame), ("rF", wheel))
    }
    return Scene(
        "bicycle",
        ground,
        origin,
        bodies=(
            RigidBody("rear", rear.point, rear.frame, p["mR"],
                      inertia(rear.frame, p["IRx"], p["IRy"], p["IRx"]), wheels["rR"]),
            RigidBody("frame", rider, frame, p["mB"], bicycle_inertia(frame, p, "IB", 1)),
            RigidBody("fork", bars, fork, p["mH"], bicycle_inertia(fork, p, "IH", -1)),
            RigidBody("front", axle, wheel, p["mF"],
                      inertia(wheel, p["IFx"], p["IFy"], p["IFx"]), wheels["rF"]),
        ),
        joints=(rear, seat, steering, hub, front),
        loads=(gravity(p["g"] * ground.z),),
        example={"tR_dot": -10},
    )  # fmt: skip
