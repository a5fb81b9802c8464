"""A schematic drawing of a scene as inline SVG, made from its geometry alone.

Bodies are drawn between their centres and the points where reactions act; a body that hangs at one
point is drawn as the uniform rod, or as the ellipse, that has its inertia.
"""

import re
from collections.abc import Mapping
from html import escape

import numpy as np
from sympy import Symbol
from sympy.physics.vector import Dyadic, Point

from mechanics.report import ink
from mechanics.report.notation import svg_name
from mechanics.report.projection import View, normal, unit
from mechanics.report.supports import BLOCK, Paper, gravity_arrow, ground, load_symbol
from mechanics.scene import Body, RigidBody, Scene
from mechanics.scene.actions import carrier_of
from mechanics.scene.loads import Damper, Force, Gravity, Spring, Torque

WIDTH, HEIGHT, MARGIN = 460.0, 340.0, 74.0
PUSHED = 92.0
"""Room for the arrow of a force beyond its point."""
# Beyond this many bodies only the first and the last are named.
FEW = 4
CLEAR = 16.0
"""Pixels between an arrow and the name of another one."""
PLACES = ((44, 0), (70, 0), (96, 0), (-44, 24), (-70, 24))
"""Where the arrow of a coordinate may begin: beside its body and ahead, in pixels."""
CORNER = (160.0, 92.0)
"""Room for axes and gravity, in pixels."""


def drawing(scene: Scene, state: Mapping[str, float]) -> str:
    """A scene at a state as an SVG element.

    Parameters
    ----------
    scene : Scene
    state : mapping of str to float
        Values by plain name; what is missing is zero, parameters are typical ones.
    """
    view = View(scene, state)
    outlines = {body.name: outline(view, body) for body in scene.bodies}
    places = [view.point(point) for point in _loaded(scene)]
    margin = PUSHED if any(isinstance(load, Force) for load in scene.loads) else MARGIN
    paper = _paper(view, [*places, *(p for points in outlines.values() for p in points)], margin)
    named = scene.bodies if len(scene.bodies) <= FEW else (scene.bodies[0], scene.bodies[-1])
    parts = [ground(view, paper)]
    parts += [_body(view, paper, body, outlines[body.name]) for body in scene.bodies]
    parts += [load_symbol(view, paper, load) for load in scene.loads]
    parts += [_joints(view, paper)]
    parts += _coordinates(view, paper) if len(scene.q) <= FEW else []
    parts += [_label(view, paper, body) for body in named]
    x, y = _free_corner("".join(parts))
    directions = _axes(view, paper) + (gravity_arrow(view, paper) if _heavy(scene) else "")
    parts.append(f'<g transform="translate({x:g} {y:g})">{directions}</g>')
    title = escape(f"Schematic drawing of the system {scene.name}")
    return (
        f'<svg class="drawing" viewBox="0 0 {WIDTH:.0f} {HEIGHT:.0f}" role="img"'
        f' aria-label="{title}">{"".join(parts)}</svg>'
    )


def _heavy(scene: Scene) -> bool:
    return any(isinstance(load, Gravity) for load in scene.loads)


def _free_corner(drawn: str) -> tuple[float, float]:
    """Where axes and gravity go, in pixels from the upper left: the corner with least in it."""
    width, height = CORNER
    pairs = re.findall(r"(-?[\d.]+),(-?[\d.]+)", drawn)
    pairs += re.findall(r'x="(-?[\d.]+)" (?:c)?y="(-?[\d.]+)"', drawn)
    places = np.array([(float(x), float(y)) for x, y in pairs]).reshape(-1, 2)
    corners = [(x, y) for y in (0.0, HEIGHT - height) for x in (0.0, WIDTH - width)]
    inside = [np.sum(np.all((places > c) & (places < np.add(c, CORNER)), axis=1)) for c in corners]
    return corners[int(np.argmin(inside))]


def _loaded(scene: Scene) -> list[Point]:
    """The points at which loads act, on bodies and on the ground."""
    ends = (vars(load).get(name) for load in scene.loads for name in ("at", "first", "second"))
    return [end for end in ends if isinstance(end, Point)]


def attached(scene: Scene, body: Body) -> list[Point]:
    """The centre of a body and the points where reactions and springs act on it."""
    points = [body.centre]
    for reaction in scene.reactions:
        if body.name in (reaction.on, reaction.by) and reaction.at is not None:
            points.append(reaction.at)
    for load in scene.loads:
        if isinstance(load, Spring | Damper):
            for point, stated in ((load.first, load.first_on), (load.second, load.second_on)):
                if carrier_of(scene, load, point, stated) == body.name:
                    points.append(point)
    return points


def outline(view: View, body: Body) -> list[np.ndarray]:
    """Corners of a body on paper, in m: one for a block, two or more for a rod, many for a disc."""
    found: list[np.ndarray] = []
    for point in attached(view.scene, body):
        place = view.point(point)
        if all(np.hypot(*(place - other)) > 1e-9 for other in found):
            found.append(place)
    if not isinstance(body, RigidBody) or len(found) > 2:
        return found
    first, second = _semi_axes(view, body)
    long, short = (float(np.hypot(*axis)) for axis in (first, second))
    centre = found[0]
    if len(found) == 2:
        arm = found[1] - centre
        # A uniform rod of half length a has I = m a^2 / 3; the ellipse of that I has a sqrt(2/3).
        reach = float(np.hypot(*arm))
        if abs(reach - long * np.sqrt(1.5)) < 0.01 * long and view.planar:
            return [centre - arm, centre, centre + arm]
        if view.planar and 0.5 * long < reach < 1.3 * long:
            # Of the ellipses with this inertia the one that ends at the joint or contact.
            across = np.sqrt(2 * long**2 - reach**2)
            first, second, short = arm, across * unit(normal(arm)), across
    if long < 1e-9:
        return found
    if short < 0.02 * long:
        return [centre - first, centre, centre + first]
    angles = np.linspace(0, 2 * np.pi, 49)
    return [centre + np.cos(a) * first + np.sin(a) * second for a in angles]


def _semi_axes(view: View, body: RigidBody) -> tuple[np.ndarray, np.ndarray]:
    """Semi-axes on paper of the thin uniform ellipse that has the body's inertia.

    Of a plate with second moments S_1 > S_2 the semi-axes are 2 sqrt(S_i / m).
    """
    mass = view.number(body.mass) or 1.0
    if not isinstance(body.inertia, Dyadic):
        radius = 2 * np.sqrt(view.number(body.inertia) / 2 / mass)
        axes = view.numbers(view.scene.rotation(body.frame))
        return view.project(radius * axes[:, 0]), view.project(radius * axes[:, 1])
    tensor = body.inertia.to_matrix(body.frame).applyfunc(view.scene.plain)
    moments, axes = np.linalg.eigh(view.numbers(tensor))
    second = np.clip(moments.sum() / 2 - moments, 0, None)
    order = np.argsort(-second)
    axes = view.numbers(view.scene.rotation(body.frame)) @ axes
    first, other = (2 * np.sqrt(second[i] / mass) * axes[:, i] for i in order[:2])
    return view.project(first), view.project(other)


def _paper(view: View, points: list[np.ndarray], margin: float) -> Paper:
    corners = np.array([*points, view.point(view.scene.origin)])
    low, high = corners.min(axis=0), corners.max(axis=0)
    span = np.maximum(high - low, 1e-9)
    scale = min((WIDTH - 2 * margin) / span[0], (HEIGHT - 2 * margin) / span[1], 1e6)
    middle = np.array([WIDTH, HEIGHT]) / 2
    return Paper(scale, middle - scale * (low + high) / 2 * np.array([1, -1]), middle)


def _body(view: View, paper: Paper, body: Body, corners: list[np.ndarray]) -> str:
    pixels = [paper.place(corner) for corner in corners]
    centre = paper.place(view.point(body.centre))
    if len(corners) == 1:
        slides = [r for r in view.scene.reactions if r.on == body.name and r.by is None]
        if not slides:
            moving = [q for q in view.scene.q if np.hypot(*view.shift(body.centre, q)) > 1e-9]
            if len(moving) != 1:
                return ink.dot(centre, 11, "body")
            return ink.block(centre, paper.turn(view.shift(body.centre, moving[0])), *BLOCK)
        rail = normal(paper.turn(view.direction(slides[0].along)))
        return ink.block(centre, rail, *BLOCK)
    if len(corners) > 20:
        shape = ink.path(pixels, "body", closed=True)
        spoke = ink.path([pixels[0], centre, pixels[12]], "faint")
        return shape + spoke + ink.dot(centre, 3, "ink")
    rods = "".join(
        ink.path([centre, pixel], style)
        for style in ("rim", "rod")
        for pixel in pixels
        if np.hypot(*(pixel - centre)) > 1
    )
    point_mass = isinstance(body, RigidBody) and body.inertia == 0
    return rods + ink.dot(centre, 8 if point_mass else 3, "ink")


def _joints(view: View, paper: Paper) -> str:
    places = {
        r.at: paper.place(view.point(r.at))
        for r in view.scene.reactions
        if r.at is not None and r.by is not None
    }
    return "".join(ink.dot(place, 4.5, "joint") for place in places.values())


def _axes(view: View, paper: Paper) -> str:
    """The directions of the inertial frame, in a corner."""
    frame, corner = view.scene.frame, np.array([34.0 if view.planar else 54.0, 68.0])
    parts = []
    for name, axis in zip("xyz", (frame.x, frame.y, frame.z), strict=True):
        along = paper.turn(view.direction(axis))
        if np.hypot(*along) > 1e-9:
            tip = corner + 34 * along
            parts.append(ink.arrow(corner, tip, "axis"))
            parts.append(ink.text(tip + 11 * unit(along), svg_name(name), "axis-name"))
    return "".join(parts)


def _coordinates(view: View, paper: Paper) -> list[str]:
    taken: list[np.ndarray] = []
    return [_coordinate(view, paper, q, taken) for q in view.scene.q]


def _coordinate(view: View, paper: Paper, coordinate: Symbol, taken: list[np.ndarray]) -> str:
    """An arrow for the way in which a coordinate moves the first body that it moves.

    It stands clear of the arrows before it, whose places are in `taken`.
    """
    for body in view.scene.bodies:
        centre = paper.place(view.point(body.centre))
        if (
            view.planar
            and isinstance(body, RigidBody)
            and coordinate in view.scene.rotation(body.frame).free_symbols
        ):
            return _turning(view, paper, body, coordinate)
        shift = view.shift(body.centre, coordinate)
        if np.hypot(*shift) > 1e-9:
            along = unit(paper.turn(shift))
            side = _aside(paper, centre, along)
            starts = [centre + away * side + ahead * along for away, ahead in PLACES]
            start = next((s for s in starts if _free(s, along, taken)), starts[0])
            tip = start + 40 * along
            taken += [start, start + 20 * along, tip, tip + 12 * along]
            return ink.arrow(start, tip, "motion") + ink.text(
                tip + 12 * along, svg_name(coordinate.name), "motion-name"
            )
    return ""


def _free(start: np.ndarray, along: np.ndarray, taken: list[np.ndarray]) -> bool:
    """Whether an arrow with its name is on the paper, and clear of others."""
    name = start + 52 * along
    inside = np.all(name > CLEAR) and np.all(name < np.array([WIDTH, HEIGHT]) - CLEAR)
    return bool(inside) and all(_apart(start, along, place) > CLEAR for place in taken)


def _apart(start: np.ndarray, along: np.ndarray, place: np.ndarray) -> float:
    """The distance of a place from an arrow with its name."""
    way = float(np.clip((place - start) @ along, 0, 52))
    return float(np.hypot(*(start + way * along - place)))


def _aside(paper: Paper, centre: np.ndarray, along: np.ndarray) -> np.ndarray:
    """Normal of a direction, on the side that leads out of the drawing; downwards if neither."""
    side = normal(along)
    outward = side @ (centre - paper.middle)
    return side if outward > 1 or (abs(outward) <= 1 and side[1] > 0) else -side


def _lever(view: View, paper: Paper, body: RigidBody) -> tuple[np.ndarray, np.ndarray, float]:
    """Pivot of a body, the pixels from there to its centre, and the sense in which it turns."""
    moving = [q for q in view.scene.q if q in view.scene.rotation(body.frame).free_symbols]
    centre = paper.place(view.point(body.centre))
    if not moving or not view.planar:
        return centre, np.zeros(2), 1.0
    (coordinate, *_) = moving
    pivots = [
        paper.place(view.point(point))
        for point in attached(view.scene, body)
        if np.hypot(*view.shift(point, coordinate)) < 1e-9
    ]
    pivot = pivots[0] if pivots else centre
    rate = view.numbers(view.scene.rotation(body.frame).diff(coordinate))
    frame = view.numbers(view.scene.rotation(body.frame))
    return pivot, centre - pivot, 1.0 if (rate @ frame.T)[1, 0] > 0 else -1.0


def _turning(view: View, paper: Paper, body: RigidBody, coordinate: Symbol) -> str:
    """An arc that ends at the body; counterclockwise where the angle is."""
    pivot, arm, sense = _lever(view, paper, body)
    angle = float(np.arctan2(-arm[1], arm[0])) if np.hypot(*arm) > 1 else 0.6
    radius = float(np.clip(0.62 * np.hypot(*arm), 30, 58))
    middle = angle - sense * 0.45
    at = pivot + (radius + 13) * np.array([np.cos(middle), -np.sin(middle)])
    return ink.arc(pivot, radius, angle - sense * 0.95, sense * 0.8, "motion") + ink.text(
        at, svg_name(coordinate.name), "motion-name"
    )


def _label(view: View, paper: Paper, body: Body) -> str:
    centre = paper.place(view.point(body.centre))
    if isinstance(body, RigidBody):
        _, arm, sense = _lever(view, paper, body)
        side = -sense * normal(unit(arm)) if np.hypot(*arm) > 1 else np.array([0.7, 0.7])
        anchor = "start" if side[0] > 0.3 else "end" if side[0] < -0.3 else "middle"
        driven = any(isinstance(load, Torque) and load.on == body.name for load in view.scene.loads)
        return ink.text(centre + (44 if driven else 20) * side, escape(body.name), "name", anchor)
    if not view.scene.reactions:
        return ink.text(centre, escape(body.name))
    # A block has its coordinate on one half of its outer side, and its name on the other.
    below = 1 if centre[1] >= paper.middle[1] - 1 else -1
    return ink.text(centre + np.array([-12, 44 * below]), escape(body.name), "name", "end")
