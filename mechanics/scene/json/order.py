"""In which order frames, points and joints are placed: JSON does not keep one."""

from collections.abc import Iterator, Mapping
from graphlib import CycleError, TopologicalSorter
from typing import Any

from mechanics.scene.json.expressions import refuse
from mechanics.scene.json.joints import FUNCTIONS, carriers

LINKS = {"frames": "in", "points": "from"}
Key = tuple[str, str]


def kinds_of_joints(whole: Mapping[str, Any]) -> dict[str, tuple[int, dict[str, Any]]]:
    """Joints that are given by their kind: by name their place in the list, and what they are."""
    rows = whole.get("joints")
    return {
        str(tree.get("name")): (k, tree)
        for k, tree in enumerate(rows if isinstance(rows, list) else ())
        if isinstance(tree, dict) and tree.get("kind") in [*FUNCTIONS]
    }


def placing_order(whole: Mapping[str, Any], roots: Mapping[str, str]) -> Iterator[Key]:
    """``("frames" | "points" | "joints", name)``, each after what carries it.

    Raises
    ------
    InputError
        Where a frame, point or joint stands on none, or on itself.
    """
    joints = kinds_of_joints(whole)
    graph: dict[Key, list[Key]] = {}
    for title, link in LINKS.items():
        table = whole.get(title, {})
        if not isinstance(table, dict) or roots[title] not in table:
            raise refuse(f"$.{title}", f"{roots[title][:40]!r} is missing")
        for name, own in table.items():
            if not isinstance(own, dict):
                raise refuse(f"$.{title}.{name}", "an object expected")
            path, wanted = f"$.{title}.{name}", []
            if name != roots[title]:
                wanted.append(_key(whole, joints, title, own.get(link), f"{path}.{link}"))
            if title == "points" and isinstance(by := own.get("by"), dict):
                wanted += [_key(whole, joints, "frames", frame, f"{path}.by") for frame in by]
            graph[title, name] = wanted
    for name, (place, tree) in joints.items():
        path = f"$.joints[{place}]"
        graph["joints", name] = [_key(whole, joints, *x, path) for x in carriers(tree)]
    try:
        yield from TopologicalSorter(graph).static_order()
    except CycleError as error:
        title, name = min(error.args[1])
        root = repr(roots.get(title, roots["points"]))
        raise refuse(f"$.{title}.{name}", f"nothing leads to it from {root}: a circle") from None


def _key(
    whole: Mapping[str, Any], joints: Mapping[str, Any], title: str, name: Any, path: str
) -> Key:
    """A frame or point, or the joint that brings it."""
    if isinstance(name, str) and name in whole[title]:
        return title, name
    if isinstance(name, str) and name in joints:
        return "joints", name
    shown = "nothing" if name is None else repr(name)[:40]
    raise refuse(path, f"{shown} is none of $.{title}")
