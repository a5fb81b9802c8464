"""Arms in space that something holds: a table under the last body, a wheel, a track that rubs."""

from dataclasses import replace

from serial_arms import serial_arm
from sympy import Symbol, cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.scene import (
    RigidBody,
    Scene,
    condition,
    coulomb,
    force,
    gravity,
    holonomic,
    nonholonomic,
    parameters,
    reaction,
    reaction_couple,
)

HELD = {"x": "1.1", "y": "0.1", "z": "-0.2"}
"""Where the last mass centre of an arm of four to seven joints comes in m."""


def closed_arm(count: int, held: str = "xz") -> Scene:
    """An arm whose last mass centre is held where the ground's axes say: a loop in space."""
    free = serial_arm(count, axes="zyx", fixed="zxy").scene
    centre, ground = free.bodies[-1].centre, free.frame
    position = centre.pos_from(free.origin).express(ground)
    reactions, constraints = list(free.reactions), []
    for axis in held:
        along = getattr(ground, axis)
        (place,) = parameters(f"h_{axis}", units="m", typical=HELD[axis], positive=False)
        last = free.bodies[-1].name
        reactions.append(reaction(f"H{axis}", at=centre, on=last, by=None, along=along))
        constraints.append(holonomic(f"held along {axis}", position.dot(along) - place, f"H{axis}"))
    return replace(
        free,
        name=f"arm of {count}, held along {' and '.join(held)}",
        reactions=tuple(reactions),
        constraints=tuple(constraints),
        example={f"q{i}": 0.3 * i for i in range(1, count + 1)},
    )


def rolling_arm(count: int = 3) -> Scene:
    """A wheel that rolls without slip on a plane and carries an arm on its axle."""
    x, y, yaw, lean, spin = dynamicsymbols("x y yaw lean spin")
    m, R, g = parameters("m R g", units="kg m m/s^2", typical="2 0.5 9.81")
    ground, origin = ReferenceFrame("N"), Point("O")
    heading = ground.orientnew("Y", "Axis", (yaw, ground.z))
    leaning = heading.orientnew("L", "Axis", (lean, heading.x))
    disc = leaning.orientnew("D", "Axis", (spin, leaning.y))
    contact = origin.locatenew("P", x * ground.x + y * ground.y)
    centre = contact.locatenew("C", R * leaning.z)
    across, along = m * R**2 / 4, m * R**2 / 2
    reactions = [
        reaction("Fx", at=contact, on="wheel", by=None, along=ground.x),
        reaction("Fy", at=contact, on="wheel", by=None, along=ground.y),
        reaction("N", at=contact, on="wheel", by=None, along=ground.z),
    ]
    more, pins = links(count, disc, centre, "wheel")
    return Scene(
        f"rolling wheel with an arm of {count}",
        ground,
        origin,
        coordinates=(x, y, yaw, lean, spin, *angles(count)),
        bodies=(RigidBody("wheel", centre, disc, m, inertia(disc, across, along, across)), *more),
        loads=(gravity(-g * ground.z),),
        reactions=(*reactions, *pins),
        constraints=(
            nonholonomic("no slip along x", x.diff() - R * spin.diff() * cos(yaw), "Fx"),
            nonholonomic("no slip along y", y.diff() - R * spin.diff() * sin(yaw), "Fy"),
        ),
        example={"lean": 0.2, "q1": 0.4, "spin_dot": 6.0, "yaw_dot": 0.5},
    )


def rubbing_arm(count: int = 4) -> Scene:
    """An arm on a sledge that is pushed along a track, which presses and rubs."""
    s, F = dynamicsymbols("s F")
    m, J, mu, g = parameters("m J mu g", units="kg kg*m^2 1 m/s^2", typical="5 0.3 0.2 9.81")
    ground, origin = ReferenceFrame("N"), Point("O")
    base = origin.locatenew("S", s * ground.x)
    more, pins = links(count, ground, base, "sledge")
    axes = {"x": ground.x, "y": ground.y, "z": ground.z}
    held = [reaction_couple(f"C{name}", "sledge", None, axis) for name, axis in axes.items()]
    return Scene(
        f"sledge with an arm of {count}",
        ground,
        origin,
        coordinates=(s, *angles(count)),
        bodies=(RigidBody("sledge", base, ground, m, inertia(ground, J, J, J)), *more),
        loads=(
            gravity(-g * ground.z),
            force("F", base, F * ground.x, on="sledge"),
            coulomb("track", "N", along=ground.x, sliding=s.diff(), coefficient=mu),
        ),
        reactions=(
            reaction("Y", at=base, on="sledge", by=None, along=ground.y),
            reaction("N", at=base, on="sledge", by=None, along=ground.z),
            *held,
            *pins,
        ),
        inputs=(F,),
        conditions=(condition("contact", Symbol("N", real=True) > 0, "lifts off its track"),),
        example={"s_dot": 1.0, "q1": 0.4, "q2": 0.2},
    )


def hanging_arm(count: int = 4) -> Scene:
    """An arm that hangs at rest with all angles zero."""
    (g,) = parameters("g", units="m/s^2", typical="9.81")
    ground, origin = ReferenceFrame("N"), Point("O")
    bodies, pins = links(count, ground, origin, None)
    return Scene(
        f"hanging arm of {count}",
        ground,
        origin,
        coordinates=angles(count),
        bodies=tuple(bodies),
        loads=(gravity(g * ground.z),),
        reactions=tuple(pins),
    )


def angles(count: int) -> tuple:
    return tuple(dynamicsymbols(f"q1:{count + 1}"))


def links(count: int, outer: ReferenceFrame, at: Point, inner: str | None) -> tuple[list, list]:
    """Bodies in space on turning joints, each along the z axis of its frame, and their pins."""
    bodies, pins = [], []
    for i, way, angle in zip(range(1, count + 1), "yxzyxzy", angles(count), strict=False):
        length, c, mass, A, B, C = parameters(
            f"l{i} c{i} m{i} A{i} B{i} C{i}",
            units="m m kg kg*m^2 kg*m^2 kg*m^2",
            typical=f"0.3 0.2 0.{4 + i} 0.0{3 + i} 0.0{4 + i} 0.0{2 + i}",
        )
        frame = outer.orientnew(f"B{i}", "Axis", (angle, getattr(outer, way)))
        centre, name = at.locatenew(f"C{i}", c * frame.z), f"link{i}"
        bodies.append(RigidBody(name, centre, frame, mass, inertia(frame, A, B, C)))
        for axis in "xyz":
            direction = getattr(outer, axis)
            pins.append(reaction(f"R{i}{axis}", at=at, on=name, by=inner, along=direction))
            if axis != way:
                pins.append(reaction_couple(f"M{i}{axis}", name, inner, direction))
        outer, at, inner = frame, at.locatenew(f"J{i}", length * frame.z), name
    return bodies, pins
