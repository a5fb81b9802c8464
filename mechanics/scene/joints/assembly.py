"""What joints add to their scene."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from mechanics.scene.joints.plane import out_of_plane

if TYPE_CHECKING:
    from mechanics.scene.scene import Scene


def with_joints(scene: Scene) -> dict[str, Any]:
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


def _with(own: tuple[Any, ...], parts: list[Any]) -> tuple[Any, ...]:
    """A copy of a scene has them already."""
    return (*own, *(p for p in parts if all(p is not o and p != o for o in own)))
