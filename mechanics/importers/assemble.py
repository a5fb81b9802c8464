"""The scene of a robot, made of the joints of `mechanics.scene`: no reaction is typed."""

from collections.abc import Collection

from sympy import Expr, Integer
from sympy.physics.mechanics import Point, ReferenceFrame

from mechanics.errors import InputError
from mechanics.importers.couplings import couple, tied
from mechanics.importers.joints import join
from mechanics.importers.parts import Parts, Spot, identifier, numbered
from mechanics.importers.robot import Connection, Polynomial, Robot, ordered
from mechanics.scene import Output, Scene, gravity, orientation, parameters, position
from mechanics.scene.declaration import REFUSE

SYMBOLIC = ("mass", "com", "inertia", "lengths")
ROOTS = {"fixed": "fixed", "free": "floating", "planar": "planar"}
UP = (Integer(0), Integer(0), Integer(1))


def assemble(
    robot: Robot,
    root: str = "fixed",
    symbolic: Collection[str] = SYMBOLIC,
    field: tuple[Expr, Expr, Expr] | None = None,
    notes: tuple[str, ...] = (),
    redundant: str = REFUSE,
) -> Scene:
    """The scene of a robot.

    Parameters
    ----------
    root : str
        What holds its first link: ``"fixed"`` to the ground, ``"free"`` or ``"planar"`` (in the
        plane of x and y).
    symbolic : collection of str
        Which numbers become parameters, with the number as typical value; 0 stays 0.
    field : three Expr, optional
        Acceleration of gravity; by default g downwards along z, a parameter.
    notes : tuple of str
        Of the reader.
    redundant : str
        As of a scene.

    Raises
    ------
    InputError, SceneError
        When it is no tree, or cannot be a system; names the link or joint.
    """
    if root not in ROOTS:
        raise InputError(f"root={root!r}: choose one of {', '.join(map(repr, ROOTS))}")
    unknown = [name for name in symbolic if name not in SYMBOLIC]
    if unknown or isinstance(symbolic, str):
        raise InputError(f"symbolic={symbolic!r}: give a tuple of some of {SYMBOLIC}")
    if field is None:
        (g,) = parameters("g", "m/s^2", "9.81")
        field = (Integer(0), Integer(0), -g)
    ground, origin = ReferenceFrame("N"), Point("O")
    first, robot = ordered(robot)
    parts = Parts(robot, frozenset(symbolic), Spot(None, origin, ground), field)
    for connection in robot.joints:
        parts.name(connection.name)
    if root == "fixed":
        parts.spots[first] = parts.ground
    else:
        used = {connection.name for connection in robot.joints}
        name = next(name for name in ("base", "root", "floating_base") if name not in used)
        parts.name(name)
        join(parts, Connection(name, ROOTS[root], "", first, axis=UP, driven=False), parts.ground)
    for connection in robot.joints:
        join(parts, connection, parts.spots[connection.parent])
    for coupling in robot.couplings:
        couple(parts, coupling)
    if not any(j.carries and (j.coordinates or j.rotations) for j in parts.joints):
        raise InputError(f"robot {robot.name}: no joint moves anything")
    if any(not joint.carries for joint in parts.joints) or parts.constraints:
        _begin(parts)
    if any(field):
        pull = field[0] * ground.x + field[1] * ground.y + field[2] * ground.z
        parts.loads.insert(0, gravity(pull))
    return Scene(
        identifier(robot.name), ground, origin, bodies=tuple(parts.bodies),
        joints=tuple(parts.joints), loads=tuple(parts.loads), reactions=tuple(parts.reactions),
        constraints=tuple(parts.constraints), conditions=tuple(parts.conditions),
        inputs=tuple(parts.inputs), example=parts.example, outputs=_outputs(parts), notes=notes,
        redundant=redundant,
    )  # fmt: skip


def _begin(parts: Parts) -> None:
    """A state at which the constraints hold: loops are closed as the file draws them."""
    for connection in parts.robot.joints:
        if connection.name in parts.drives:
            parts.example.setdefault(parts.names[connection.name], float(connection.zero))
    for coupling in parts.robot.couplings:
        if isinstance(coupling, Polynomial):
            other = 0.0 if coupling.other is None else parts.example[parts.names[coupling.other]]
            parts.example[parts.names[coupling.joint]] = float(tied(coupling, other))


def _outputs(parts: Parts) -> dict[str, Output]:
    """Position and orientation of the links that carry nothing more."""
    found: dict[str, Output] = {}
    parents = {joint.parent for joint in parts.robot.joints}
    for link, spot in parts.spots.items():
        if link not in parents and spot.body is not None:
            name = numbered(parts.link(link), parts.known)
            found |= {f"{name}_position": position(spot.point),
                      f"{name}_orientation": orientation(spot.frame)}  # fmt: skip
    return found
