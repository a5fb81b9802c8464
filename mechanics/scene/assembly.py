"""What joints and rotations add to the scene that has them."""

from typing import Any

from sympy.physics.vector import dynamicsymbols

from mechanics.scene.declaration import Declaration
from mechanics.scene.joints.plane import out_of_plane
from mechanics.scene.symbols import name_of


def with_joints(scene: Declaration) -> dict[str, Any]:
    """Coordinates, rotations, reactions and constraints with those of the joints, once.

    Raises
    ------
    SceneError
        For a joint that leaves the plane of the scene.
    """
    if not scene.joints:
        return {}
    kept: dict[str, tuple[Any, ...]] = {
        title: _with(getattr(scene, title), [p for j in scene.joints for p in getattr(j, title)])
        for title in ("coordinates", "rotations", "reactions", "constraints")
    }
    # Of the joints' own only: a reaction that was typed by hand stays, whatever its name.
    gone: list[Any] = []
    for joint in scene.joints:
        names = out_of_plane(scene, joint)
        gone += [r for r in joint.reactions if r.name in names]
        gone += [c for c in joint.constraints if names & {*c.reactions}]
    for title in ("reactions", "constraints"):
        kept[title] = tuple(p for p in kept[title] if all(p is not g for g in gone))
    return kept


def with_rotations(scene: Declaration) -> dict[str, Any]:
    """Coordinates, speeds and example of a scene with what its rotations and joints bring, once.

    A rotation of which the example says nothing starts where frame and parent coincide.
    """
    own = {u: (q, definition) for joint in scene.joints for q, u, definition in joint.own}
    if not scene.rotations and not own:
        return {}
    coordinates = list(scene.coordinates)
    speeds, example = list(scene.speeds), dict(scene.example)
    turning = {u for rotation in scene.rotations for u in rotation.speeds}
    covered = {q for rotation in scene.rotations for q in rotation.coordinates}
    covered |= {q for q, _ in own.values()}
    if all(u in turning or u in own for u, _ in speeds):
        others = [q for q in coordinates if q not in covered]
        rates = [(dynamicsymbols(f"{name_of(q)}_dot"), q.diff(dynamicsymbols._t)) for q in others]
        speeds = [*rates, *speeds]
    known = {u for u, _ in speeds}
    speeds += [(u, definition) for u, (_, definition) in own.items() if u not in known]
    for rotation in scene.rotations:
        coordinates += [q for q in rotation.coordinates if q not in coordinates]
        known = {u for u, _ in speeds}
        speeds += [(u, value) for u, value in rotation.definitions if u not in known]
        names = list(map(name_of, rotation.coordinates))
        if not example.keys() & set(names):
            example[names[0]] = 1
    return {"coordinates": tuple(coordinates), "speeds": tuple(speeds), "example": example}


def _with(own: tuple[Any, ...], parts: list[Any]) -> tuple[Any, ...]:
    """A copy of a scene has them already."""
    return (*own, *(p for p in parts if all(p is not o and p != o for o in own)))
