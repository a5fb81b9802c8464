"""What can be seen to be wrong from the declaration alone.

Whether reactions do work, are complete, or constraints are redundant needs velocities, and is
checked in `mechanics.checks.soundness` before any route runs.
"""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from sympy.physics.vector import Point

from mechanics.errors import SceneError
from mechanics.scene.bodies import RigidBody
from mechanics.scene.geometry import frame_path, in_root, point_path, rotation
from mechanics.scene.symbols import name_of

if TYPE_CHECKING:
    from mechanics.scene.scene import Scene


def validate(scene: Scene) -> None:
    """Refuse a scene that cannot be right.

    Raises
    ------
    SceneError
        Names the object, what was found, and what to do.
    """
    _names(scene)
    _bodies(scene)
    _coordinates(scene)
    _speeds(scene)
    _attachments(scene)
    _constraints(scene)


def _names(scene: Scene) -> None:
    if not scene.coordinates:
        raise SceneError(f"{scene.name}: there are no coordinates, so nothing can move")
    if not scene.bodies:
        raise SceneError(f"{scene.name}: there are no bodies, so there is nothing to move")
    symbols = [name_of(f) for f in (*scene.coordinates, *scene.inputs)]
    symbols += [name_of(u) for u, _ in scene.speeds] + [r.name for r in scene.reactions]
    for kind, names in (
        ("body", [body.name for body in scene.bodies]),
        ("load", [load.name for load in scene.loads]),
        ("constraint", [constraint.name for constraint in scene.constraints]),
        ("coordinate, speed, input or reaction", symbols),
    ):
        for name, count in Counter(names).items():
            if count > 1:
                raise SceneError(
                    f"{scene.name}: {count} times a {kind} named {name!r}: names must differ"
                )


def _bodies(scene: Scene) -> None:
    for body in scene.bodies:
        try:
            point_path(scene.origin, body.centre)
            if isinstance(body, RigidBody):
                frame_path(scene.frame, body.frame)
        except SceneError as error:
            raise SceneError(f"body {body.name} is placed by nothing: {error}") from None


def _coordinates(scene: Scene) -> None:
    """Every coordinate moves a body, and every body is moved by a coordinate or an input."""
    movers = set(scene.coordinates) | set(scene.inputs)
    used: set = set()
    for body in scene.bodies:
        entries = list(in_root(scene.frame, body.centre.pos_from(scene.origin)))
        if isinstance(body, RigidBody):
            entries += list(rotation(scene.frame, body.frame))
        moved = {mover for mover in movers if any(entry.has(mover) for entry in entries)}
        if not moved:
            raise SceneError(
                f"body {body.name}: no coordinate moves it: let its position or orientation"
                " depend on a coordinate, or leave it out"
            )
        used |= moved
    for coordinate in scene.coordinates:
        if coordinate not in used:
            raise SceneError(
                f"coordinate {name_of(coordinate)}: no body uses it: remove it or let a position"
                " or orientation depend on it"
            )


def _speeds(scene: Scene) -> None:
    if scene.speeds and len(scene.speeds) != len(scene.coordinates):
        raise SceneError(
            f"{scene.name}: {len(scene.speeds)} speeds for {len(scene.coordinates)} coordinates:"
            " declare as many speeds as coordinates (constraints make some of them dependent)"
        )


def _attachments(scene: Scene) -> None:
    """Loads and reactions name bodies that exist and points that are placed."""
    bodies = {body.name for body in scene.bodies}
    for kind, parts in (("load", scene.loads), ("reaction", scene.reactions)):
        for part in parts:
            for role in ("on", "by"):
                name = getattr(part, role, None)
                if name is not None and name not in bodies:
                    raise SceneError(
                        f"{kind} {part.name}: there is no body {name!r}: the bodies are"
                        f" {', '.join(sorted(bodies))}"
                    )
            if kind == "reaction" and part.on == part.by:
                raise SceneError(f"reaction {part.name}: body {part.on!r} acts on itself")
            for value in vars(part).values():
                if isinstance(value, Point):
                    try:
                        point_path(scene.origin, value)
                    except SceneError as error:
                        raise SceneError(
                            f"{kind} {part.name} acts on a point that is not in the scene: {error}"
                        ) from None


def _constraints(scene: Scene) -> None:
    names = {reaction.name for reaction in scene.reactions}
    owner: dict[str, str] = {}
    for constraint in scene.constraints:
        if not constraint.reactions:
            raise SceneError(
                f"constraint {constraint.name}: it names no reaction that maintains it:"
                " declare the reaction and name it"
            )
        for name in constraint.reactions:
            if name not in names:
                raise SceneError(
                    f"constraint {constraint.name}: there is no reaction {name!r}: the reactions"
                    f" are {', '.join(sorted(names)) or 'none'}"
                )
            if name in owner:
                raise SceneError(
                    f"reaction {name} is named by the constraints {owner[name]} and"
                    f" {constraint.name}: each reaction maintains one"
                )
            owner[name] = constraint.name
    if len(scene.constraints) >= len(scene.coordinates):
        raise SceneError(
            f"{scene.name}: {len(scene.constraints)} constraints on {len(scene.coordinates)}"
            " coordinates leave nothing to move"
        )
