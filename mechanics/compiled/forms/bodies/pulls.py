"""What the loads of a scene do: the forces f of Gauss's function.

    f . a  +=  F . a_P        a force at a point that the body carries
    f . a  +=  F . a_C + ((P - C) x F) . alpha        at any other point
    f . a  +=  tau . alpha                            a couple

Components are those of the frame in which a load was given; a spring's are inertial. A field of
gravity that is the same everywhere is no load: it is carried along with the accelerations.
"""

import casadi as ca
from sympy.physics.vector import Point, ReferenceFrame, Vector

from mechanics.compiled.forms.bodies.affine import STILL, Graphs, cross, dot, minus, scaled
from mechanics.compiled.forms.bodies.affine import Vector as Accelerations
from mechanics.compiled.forms.bodies.carried import Carried
from mechanics.compiled.forms.bodies.reading import Reading
from mechanics.scene import Body, RigidBody
from mechanics.scene.actions import carrier_of
from mechanics.scene.geometry import components, point_path
from mechanics.scene.loads import Damper, Force, Gravity, Load, Spring, Torque, TorsionSpring


def carried_gravity(reading: Reading) -> Graphs:
    """The sum of the fields that are the same everywhere, inertial components."""
    scene, total = reading.scene, STILL
    for load in scene.loads:
        if isinstance(load, Gravity) and uniform(reading, load):
            column = reading.column(scene.vector(load.field, load.name))
            total = tuple(a + b for a, b in zip(total, column, strict=True))
    return total


def uniform(reading: Reading, load: Gravity) -> bool:
    """Whether a field of gravity depends on no coordinate and no speed."""
    scene = reading.scene
    return not scene.vector(load.field, load.name).free_symbols & {*scene.q, *scene.u}


def pull(carried: Carried, load: Load) -> None:
    """Add one load."""
    scene, read = carried.reading.scene, carried.reading
    if isinstance(load, Gravity):
        if not uniform(read, load):
            _weights(carried, load)
    elif isinstance(load, Spring | Damper):
        _tension(carried, load)
    elif isinstance(load, Force):
        on = carrier_of(scene, load, load.at, load.on)
        for frame, force in parts(read, load.vector, load.name):
            _force(carried, on, load.at, frame, force)
            _force(carried, load.by, load.at, frame, minus(force))
    elif isinstance(load, Torque):
        _couples(carried, (load.on, load.by), load.vector, load.name, ca.SX(1))
    elif isinstance(load, TorsionSpring):  # friction has no form by bodies
        angle, stiffness = (scene.plain(e, load.name) for e in (load.angle, load.stiffness))
        torque = -(read(stiffness) * read(angle))
        _couples(carried, (load.on, load.by), load.axis, load.name, torque)


def parts(read: Reading, vector: Vector, name: str) -> list[tuple[ReferenceFrame, Graphs]]:
    """A vector in the frames in which it was given."""
    return [
        (frame, read.column(read.scene.plain(entry, name) for entry in column))
        for frame, column in components(vector)
    ]


def _weights(carried: Carried, load: Gravity) -> None:
    read = carried.reading
    for body in read.scene.bodies:
        mass = read(read.scene.plain(body.mass, body.name))
        for frame, field in parts(read, load.field, load.name):
            _force(carried, body.name, body.centre, frame, scaled(mass, field))


def _couples(
    carried: Carried, pair: tuple[str, str | None], vector: Vector, name: str, size: ca.SX
) -> None:
    on, by = pair
    for frame, column in parts(carried.reading, vector, name):
        couple = scaled(size, column)
        _couple(carried, on, frame, couple)
        _couple(carried, by, frame, minus(couple))


def _tension(carried: Carried, load: Spring | Damper) -> None:
    scene, read = carried.reading.scene, carried.reading
    span, drift = carried.offset(load.first, load.second, scene.frame)
    if load.along is not None:
        direction = read.column(scene.vector(load.along, load.name))
        distance = dot(span, direction)
    else:
        distance = ca.sqrt(dot(span, span))
        direction = tuple(entry / distance for entry in span)
    if isinstance(load, Spring):
        slack = read(scene.plain(load.length, load.name))
        tension = read(scene.plain(load.stiffness, load.name)) * (distance - slack)
    else:
        tension = read(scene.plain(load.coefficient, load.name)) * dot(drift, direction)
    force = scaled(tension, direction)
    ends = ((load.first, load.by, force), (load.second, load.on, minus(force)))
    for point, stated, pulls in ends:
        _force(carried, carrier_of(scene, load, point, stated), point, scene.frame, pulls)


def _force(
    carried: Carried, name: str | None, at: Point, frame: ReferenceFrame, force: Graphs
) -> None:
    if name is None or all(entry.is_zero() for entry in force):
        return
    body = carried.reading.scene.body(name)
    if at == body.centre or fastened(carried, body, at):
        _work(carried, carried.acceleration(at, frame), force)
        return
    _work(carried, carried.acceleration(body.centre, frame), force)
    arm, _ = carried.offset(body.centre, at, frame)
    _couple(carried, name, frame, cross(arm, force))


def fastened(carried: Carried, body: Body, point: Point) -> bool:
    """Whether a point keeps its place in the body, so that it moves as the body does there."""
    if not isinstance(body, RigidBody):
        return False
    origin = carried.reading.scene.origin
    paths = [point_path(origin, end) for end in (body.centre, point)]
    shared = sum(a == b for a, b in zip(*paths, strict=False))
    moving = set(carried.reading.rates)
    return all(
        leg.frame == body.frame and not leg.column.free_symbols & moving
        for path in paths
        for between in path[shared:]
        for leg in carried.legs(between)[1]
    )


def _couple(carried: Carried, name: str | None, frame: ReferenceFrame, couple: Graphs) -> None:
    if name is not None:
        body = carried.reading.scene.body(name)
        if isinstance(body, RigidBody):
            _work(carried, carried.alpha(body.frame, frame), couple)


def _work(carried: Carried, acceleration: Accelerations, force: Graphs) -> None:
    for entry, component in zip(acceleration, force, strict=True):
        for unknown, coefficient in entry.coefficients.items():
            carried.g.add_force(unknown, coefficient * component)
