"""The bicycle of `systems.bicycle` again, without joints: its reactions and constraints by hand."""

from sympy import pi, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, cross, dot, dynamicsymbols, inertia

from mechanics.scene import (
    RigidBody,
    Scene,
    gravity,
    holonomic,
    nonholonomic,
    reaction,
    reaction_couple,
)
from systems.bicycle import bicycle_inertia, bicycle_parameters


def whipple_bicycle() -> Scene:
    """Two wheels that roll, a frame with its rider and a fork; pitch follows from the contacts."""
    p = bicycle_parameters()
    x, y, yaw, lean, pitch, steer = dynamicsymbols("x y yaw lean pitch steer")
    tR, tF = dynamicsymbols("tR tF")
    ground, origin = ReferenceFrame("N"), Point("O")
    heading = ground.orientnew("Y", "Axis", (yaw, ground.z))
    leaning = heading.orientnew("L", "Axis", (lean, heading.x))
    frame = leaning.orientnew("B", "Axis", (pitch, leaning.y))
    head = frame.orientnew("S", "Axis", (pi / 10, frame.y))
    turned = head.orientnew("T", "Axis", (steer, head.z))
    fork = turned.orientnew("H", "Axis", (-pi / 10, turned.y))
    rear = frame.orientnew("R", "Axis", (tR, frame.y))
    front = fork.orientnew("F", "Axis", (tF, fork.y))

    touch = origin.locatenew("P", x * ground.x + y * ground.y)
    hub = touch.locatenew("Rc", -p["rR"] * leaning.z)
    # Where the rear wheel touches the plane when all angles are zero, as a point of the frame.
    base = hub.locatenew("base", p["rR"] * frame.z)
    rider = base.locatenew("Bc", p["xB"] * frame.x - p["zB"] * frame.z)
    axis = base.locatenew("axis", (p["w"] + p["c"]) * frame.x)
    bars = axis.locatenew("Hc", (p["xH"] - p["w"] - p["c"]) * fork.x - p["zH"] * fork.z)
    axle = axis.locatenew("Fc", -p["c"] * fork.x - p["rF"] * fork.z)
    # The lowest point of the front wheel.
    slope = dot(ground.z, fork.y)
    steep = sqrt(1 - slope**2)
    down = p["rF"] / steep * (ground.z - slope * fork.y)
    tip = axle.locatenew("Q", down)

    origin.set_vel(ground, 0)
    slips = {
        "rear": hub.pos_from(origin).dt(ground)
        + cross(rear.ang_vel_in(ground), p["rR"] * leaning.z),
        "front": axle.pos_from(origin).dt(ground) + cross(front.ang_vel_in(ground), down),
    }
    wheels = {"rear": touch, "front": tip}
    axes = {"x": heading.x, "y": heading.y}
    joints = (
        ("rear", "frame", frame, hub, "xz"),
        ("fork", "frame", head, axis, "xy"),
        ("front", "fork", fork, axle, "xz"),
    )
    return Scene(
        "bicycle",
        ground,
        origin,
        coordinates=(x, y, yaw, lean, pitch, steer, tR, tF),
        bodies=(
            RigidBody("rear", hub, rear, p["mR"], inertia(rear, p["IRx"], p["IRy"], p["IRx"])),
            RigidBody("frame", rider, frame, p["mB"], bicycle_inertia(frame, p, "IB", 1)),
            RigidBody("fork", bars, fork, p["mH"], bicycle_inertia(fork, p, "IH", -1)),
            RigidBody("front", axle, front, p["mF"], inertia(front, p["IFx"], p["IFy"], p["IFx"])),
        ),
        loads=(gravity(p["g"] * ground.z),),
        reactions=(
            *(reaction(f"N{w}", at=at, on=w, by=None, along=ground.z) for w, at in wheels.items()),
            *(
                reaction(f"F{wheel}{k}", at=at, on=wheel, by=None, along=axes[k])
                for wheel, at in wheels.items()
                for k in axes
            ),
            *(
                reaction(f"R{on}{k}", at=at, on=on, by=by, along=getattr(turns, k))
                for on, by, turns, at, _ in joints
                for k in "xyz"
            ),
            *(
                reaction_couple(f"M{on}{k}", on, by, getattr(turns, k))
                for on, by, turns, _, held in joints
                for k in held
            ),
        ),
        constraints=(
            holonomic(
                "front wheel on the plane",
                dot(axle.pos_from(origin), ground.z) + p["rF"] * steep,
                "Nfront",
            ),
            *(
                nonholonomic(f"{wheel} wheel does not slip along {k}", dot(slip, axes[k]),
                             f"F{wheel}{k}")
                for wheel, slip in slips.items()
                for k in axes
            ),
        ),
        example={"tR_dot": -10},
    )  # fmt: skip
