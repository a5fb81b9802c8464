"""Whether what is declared has the properties that the engine builds on.

m, I      constant, I symmetric with no negative moment
along     a unit vector, for springs and dampers fixed in the inertial frame
k, l      free of coordinates, or the spring would have another force
R         R^T R = 1, det R = 1
"""

from itertools import pairwise

import numpy as np
from sympy import Expr, Matrix, Symbol, eye, sympify
from sympy.core.function import AppliedUndef
from sympy.physics.vector import Dyadic, Point, Vector, dynamicsymbols

from mechanics.errors import SceneError
from mechanics.scene.attachment import moved_by
from mechanics.scene.bodies import Body, Particle, RigidBody, inertia_entries
from mechanics.scene.declaration import Declaration
from mechanics.scene.geometry import (
    Placed,
    components,
    frame_path,
    point_path,
    relative_rotation,
    step_vector,
)
from mechanics.scene.loads import Coulomb, Damper, Force, Gravity, Spring, Torque, TorsionSpring
from mechanics.scene.symbols import by_name
from mechanics.symbolic import canonical, is_zero

ROUNDING = 1e-9
"""Of decimals such as 0.1 + 0.7 beside 0.8, relative to the largest moment."""


def check_bodies(scene: Declaration) -> None:
    """Masses and inertias are constant, inertias symmetric, orientations rotations.

    Raises
    ------
    SceneError
        Names the body.
    """
    for body in scene.bodies:
        if _moves(body.mass):
            raise SceneError(
                f"body {body.name}: the mass {body.mass} changes with time or coordinates:"
                " the mass of a body is constant"
            )
        if isinstance(body, RigidBody):
            _inertia(scene, body)
        _typical(body)
    _orientations(scene)


def _typical(body: Body) -> None:
    """A mass that is declared positive has no typical value of zero: no motion would start."""
    for symbol in massive(body):
        typical = getattr(symbol, "typical", None)
        if symbol.is_positive and typical is not None and typical <= 0:
            raise SceneError(
                f"body {body.name}: {symbol} of its mass or inertia is positive, but {typical} is"
                " its typical value: give one above zero, or '-' for none"
            )


def massive(body: Body) -> list[Symbol]:
    """Symbols of the mass and inertia of a body, in order of their names."""
    entries = inertia_entries(body) if isinstance(body, RigidBody) else []
    found = set().union(*(sympify(entry).free_symbols for entry in (body.mass, *entries)))
    return sorted(found, key=by_name)


def _inertia(scene: Declaration, body: RigidBody) -> None:
    entries = [canonical(scene.plain(e, f"body {body.name}")) for e in inertia_entries(body)]
    changing = {*scene.q, *scene.u, *scene.input_symbols, dynamicsymbols._t}
    if any(entry.free_symbols & changing for entry in entries):
        raise SceneError(
            f"body {body.name}: the inertia {body.inertia} changes in the body's frame:"
            f" give it in {body.frame.name}, where a rigid body's inertia is constant"
        )
    if isinstance(body.inertia, Dyadic):
        matrix = Matrix(3, 3, entries)
        if _differs(matrix, matrix.T):
            raise SceneError(f"body {body.name}: the inertia {body.inertia} is not symmetric")
        entries = [matrix[i, i] for i in range(3)]
        values = {symbol: getattr(symbol, "exact", None) for symbol in matrix.free_symbols}
        if None not in values.values():
            _possible(scene, body, matrix.subs(values))
    if any(entry.is_negative for entry in entries):
        raise SceneError(
            f"body {body.name}: the inertia {body.inertia} is negative: a moment of inertia is"
            " zero or more"
        )


def _possible(scene: Declaration, body: RigidBody, matrix: Matrix) -> None:
    """Mass at distances from the centre: A, B, C >= 0 and A + B >= C of principal moments."""
    moments = np.linalg.eigvalsh(np.array(matrix, dtype=float))
    low, middle, high = (float(moment) for moment in moments)
    rounding = ROUNDING * max(abs(low), abs(high))
    if low < -rounding:
        raise SceneError(
            f"body {body.name}: the inertia {body.inertia}{_at_typical(body)} is negative about an"
            f" axis, a principal moment is {low:.3g}: give inertia(frame, xx, yy, zz, xy, yz, zx)"
            " smaller products"
        )
    # A body that stays in a plane has moments of 0 where none matters; readers of files tell.
    planar = any(matrix[i, i] == 0 for i in range(3)) or scene.plane is not None
    if high > low + middle + rounding and not planar and not scene.notes:
        raise SceneError(
            f"body {body.name}: no body has the inertia {body.inertia}{_at_typical(body)}: the"
            f" principal moment {high:.3g} exceeds the sum of the others, {low:.3g} and"
            f" {middle:.3g}: check units and the order of inertia(frame, xx, yy, zz, xy, yz, zx);"
            " where a source prints it so, say that in notes= of the scene"
        )


def _at_typical(body: RigidBody) -> str:
    symbols = {symbol for entry in inertia_entries(body) for symbol in sympify(entry).free_symbols}
    values = [f"{symbol} = {float(symbol.exact):.6g}" for symbol in sorted(symbols, key=by_name)]
    return f" at the typical values {', '.join(values)}" if values else ""


def _orientations(scene: Declaration) -> None:
    frames = {body.frame for body in scene.bodies if isinstance(body, RigidBody)}
    ways = [pairwise(point_path(scene.origin, body.centre)) for body in scene.bodies]
    for parent, child in {step for way in ways for step in way}:
        frames |= {frame for _, frame in step_vector(parent, child).args}
    for part in (*scene.reactions, *scene.loads):
        vectors = [value for value in vars(part).values() if isinstance(value, Vector)]
        frames |= {frame for vector in vectors for _, frame in vector.args}
    steps = {step for frame in frames for step in pairwise(frame_path(scene.frame, frame))}
    for parent, child in sorted(steps, key=str):
        step = relative_rotation(parent, child).applyfunc(
            lambda entry, name=child.name: scene.plain(entry, f"frame {name}")
        )
        _norm(scene, child.name, step)
        if scene.constraints:
            continue  # four Euler parameters give a rotation only where their constraint holds
        if _differs(step.T * step, eye(3)) or is_zero(step.det(method="berkowitz") - 1) is False:
            raise SceneError(
                f"frame {child.name}: its matrix from {parent.name} is no rotation (R^T R = 1,"
                " det R = 1): orient it with orientnew"
            )


def _norm(scene: Declaration, name: str, step: Matrix) -> None:
    """Four coordinates that a frame is oriented with as a quaternion have a norm of 1."""
    parts = {symbol for symbol in step.free_symbols if symbol in scene.q}
    if len(parts) != 4 or not all(entry.is_polynomial(*parts) for entry in step):
        return
    if any(parts <= scene.plain(held.expression, name).free_symbols for held in scene.constraints):
        return
    if is_zero(step[:, 0].dot(step[:, 0]) - sum(part**2 for part in parts) ** 2):
        words = " ".join(str(q) for q in scene.q if q in parts)
        raise SceneError(
            f"frame {name}: nothing holds the norm of the quaternion {words} at 1: orient it by"
            f' quaternion("{words}", "wx wy wz").orient("{name}", parent), which does'
        )


def check_loads(scene: Declaration) -> None:
    """Loads act on something, and have the properties from which their force is derived.

    Raises
    ------
    SceneError
        Names the load or reaction.
    """
    for reaction in scene.reactions:
        # What its unknown does elsewhere may be a multiple: in a gear, say.
        unit_vector(scene, f"reaction {reaction.name}", reaction.along)
    for load in scene.loads:
        where = f"load {load.name}"
        on, by = getattr(load, "on", None), getattr(load, "by", None)
        if on is not None and on == by:
            raise SceneError(f"{where}: body {on!r} acts on itself")
        if isinstance(load, Gravity):
            _fixed(scene, where, load.field)
        elif isinstance(load, Spring | Damper):
            _line(scene, where, load)
        elif isinstance(load, Coulomb):
            unit_vector(scene, where, load.along)
            given = (load.coefficient, load.sliding)
            _no_accelerations(scene, where, [scene.plain(entry, where) for entry in given])
        elif isinstance(load, TorsionSpring):
            unit_vector(scene, where, load.axis)
            _constant(scene, where, load.stiffness)
        if isinstance(load, Torque | TorsionSpring) and _is_particle(scene, load.on):
            raise SceneError(
                f"{where}: it turns {load.on!r}, which is a particle and has no orientation:"
                " declare a RigidBody"
            )
        if isinstance(load, Torque | Force):
            placed = Placed(scene.frame, scene.origin)
            entries = [scene.plain(entry, where) for entry in placed.vector(load.vector)]
            _no_accelerations(scene, where, entries)


def _line(scene: Declaration, where: str, load: Spring | Damper) -> None:
    if load.first == load.second:
        raise SceneError(f"{where}: both ends are point {load.first.name}: name two points")
    for title, point in (("first_on", load.first), ("second_on", load.second)):
        stated = getattr(load, title)
        if stated is not None:
            _carried(scene, f"{where}: {title} is {stated!r}, but point {point.name}", title,
                     stated, point)  # fmt: skip
    if load.along is not None:
        unit_vector(scene, where, load.along)
        span = scene.position(load.second) - scene.position(load.first)
        if any(map(canonical, span.cross(scene.vector(load.along, where)))):
            _fixed(scene, where, load.along)
    if isinstance(load, Spring):
        _constant(scene, where, load.stiffness)
        _constant(scene, where, load.length)
    else:
        _no_accelerations(scene, where, [scene.plain(load.coefficient, where)])


def _carried(scene: Declaration, what: str, title: str, stated: str, point: Point) -> None:
    """A point is the centre of no other body, and stays where it is on the one that is stated."""
    centred = [body.name for body in scene.bodies if body.centre == point]
    if centred and stated not in centred:
        raise SceneError(f"{what} is the centre of {centred[0]}: write {title}={centred[0]!r}")
    moving = moved_by(scene, stated, point)
    if moving:
        names = [body.name for body in scene.bodies if not moved_by(scene, body.name, point)]
        mend = f"take a point of {stated}"
        if not moved_by(scene, None, point):
            mend = f"it is a point of the ground, leave {title} out"
        elif names:
            mend = f"it is a point of {names[0]}, write {title}={names[0]!r}"
        raise SceneError(f"{what} moves against {stated} by {moving}: {mend}")


def unit_vector(scene: Declaration, where: str, direction: Vector) -> None:
    """A direction has the length 1.

    Raises
    ------
    SceneError
        Naming where it stands.
    """
    # Frames are orthonormal: within one, its components alone give the length.
    given = components(direction)
    if len(given) == 1:
        entries = given[0][1].applyfunc(lambda entry: scene.plain(entry, where))
    else:
        entries = scene.vector(direction, where)
    square = canonical(entries.dot(entries))
    # A gradient such as (x, y)/L has unit length only where the constraints hold.
    if scene.constraints and square.free_symbols & set(scene.q):
        return
    if is_zero(square - 1) is False:
        raise SceneError(
            f"{where}: the direction {direction} has the length sqrt({square}): give a unit vector"
        )


def _fixed(scene: Declaration, where: str, direction: Vector) -> None:
    if scene.vector(direction, where).free_symbols & {*scene.q, *scene.u}:
        raise SceneError(
            f"{where}: the direction {direction} turns with the coordinates: give one that is fixed"
            f" in {scene.frame.name}"
        )


def _constant(scene: Declaration, where: str, value: Expr) -> None:
    if scene.plain(value, where).free_symbols & {*scene.q, *scene.u, *scene.ud}:
        raise SceneError(
            f"{where}: {value} depends on coordinates, which changes its force: declare it as a"
            " force or torque"
        )


def _no_accelerations(scene: Declaration, where: str, entries: list[Expr]) -> None:
    for entry in entries:
        found = entry.free_symbols & set(scene.ud)
        if found:
            raise SceneError(
                f"{where}: it depends on the acceleration {found.pop()}: a load depends on"
                " coordinates, speeds, inputs and time"
            )


def _is_particle(scene: Declaration, name: str) -> bool:
    return isinstance(scene.body(name), Particle)


def _differs(one: Matrix, two: Matrix) -> bool:
    return any(is_zero(entry) is False for entry in one - two)


def _moves(expression: Expr) -> bool:
    return bool(expression.atoms(AppliedUndef)) or expression.has(dynamicsymbols._t)
