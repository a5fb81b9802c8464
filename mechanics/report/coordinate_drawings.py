"""A drawing for each coordinate, where one drawing would be crowded: in space, or of many bodies.

The bodies alone, and in them one coordinate from zero to where it is; the four parts of a
quaternion are one turn.
"""

from collections.abc import Mapping

from sympy import Symbol

from mechanics.report.coordinates import coordinate_picture, orientation_picture, parts_of
from mechanics.report.drawing import few_of, paper_for, plain_picture, svg
from mechanics.report.label_places import apart
from mechanics.report.projection import View, closed
from mechanics.scene import Scene

SIZE = (230.0, 190.0)


def coordinate_drawings(
    scene: Scene, state: Mapping[str, float]
) -> list[tuple[tuple[str, ...], str]]:
    """Names of coordinates and an SVG element of them; none where one drawing marks them all.

    Parameters
    ----------
    scene : Scene
    state : mapping of str to float
        As for `drawing`.
    """
    if few_of(scene):
        return []
    view = View(scene, closed(scene, state))
    drawn = []
    for rotation in scene.rotations:
        parts = parts_of(rotation)
        names = tuple(part.name for part in parts)
        paper = paper_for([view], (), SIZE)
        shown = [*_bodies(view), orientation_picture(view, paper, rotation)]
        drawn.append((names, _element(scene, shown, names)))
    for q in scene.q:
        if q not in scene.quaternions:
            drawn.append(((q.name,), _element(scene, _marked(view, q), (q.name,))))
    return drawn


def _bodies(view: View, *few: Symbol) -> list[str]:
    large, small = plain_picture(view, paper_for([view], few, SIZE))
    return [*large, *small]


def _marked(view: View, coordinate: Symbol) -> list[str]:
    paper = paper_for([view], (coordinate,), SIZE)
    bodies = _bodies(view, coordinate)
    return [*bodies, coordinate_picture(view, paper, coordinate, bodies)]


def _element(scene: Scene, parts: list[str], names: tuple[str, ...]) -> str:
    return svg(apart(parts, [], SIZE), f"{scene.name}: {', '.join(names)}", SIZE)
