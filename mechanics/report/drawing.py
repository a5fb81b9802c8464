"""A schematic drawing of a scene as inline SVG, made from its geometry alone.

Bodies are drawn as declared, or between their centres and the points where reactions act. A body
without a shape that hangs at one point is drawn as the uniform rod, or dashed as the ellipse, that
has its inertia; the words beside the drawing say so.
"""

import re
from collections.abc import Mapping, Sequence
from html import escape
from itertools import pairwise

import numpy as np
from sympy import Symbol
from sympy.physics.vector import Dyadic, Point

from mechanics.report import strokes
from mechanics.report.coordinates import coordinate_picture, movers, trace, zero_end
from mechanics.report.label_places import apart
from mechanics.report.labels import length_labels, point_labels
from mechanics.report.notation import svg_name
from mechanics.report.projection import Paper, View, attached, closed, normal, unit
from mechanics.report.supports import (
    BLOCK,
    gravity_arrow,
    ground,
    is_slack_at_anchor,
    load_symbol,
    rail,
)
from mechanics.scene import Body, Damper, Position, RigidBody, Scene, Spring
from mechanics.scene.loads import Force, Gravity, Torque

WIDTH, HEIGHT, MARGIN = 460.0, 340.0, 74.0
UNMARKED = 56.0
"""Margin where no coordinates are marked beyond the bodies."""
PUSHED = 100.0
"""Room for the arrow of a force beyond its point, or for a spring before it."""
# Beyond this many bodies only the first and the last are named.
FEW = 4
MARKED, MARKED_IN_SPACE = 6, 2
"""Coordinates up to which one drawing marks them; more have a drawing each."""
FAR = 4.0
"""Times as wide as the bodies and what holds them: a wider motion is not all shown."""
CORNER = (160.0, 92.0)
"""Room for axes and gravity, in pixels."""


def drawing(
    scene: Scene, state: Mapping[str, float], motion: Mapping[str, np.ndarray] | None = None
) -> str:
    """A scene at a state as an SVG element.

    Parameters
    ----------
    scene : Scene
    state : mapping of str to float
        Values by plain name; what is missing is zero, or closes the loops; parameters are typical.
    motion : mapping of str to array, optional
        Coordinates along a motion, by plain name: the ways of point masses are drawn.
    """
    view = View(scene, closed(scene, state), motion=motion)
    paper = paper_for([view])
    parts = picture(view, paper)
    if len(scene.bodies) <= FEW:
        parts.append(point_labels(view, paper, parts))
        parts.append(length_labels(view, paper, parts))
    corner = directions(view, paper, parts)
    return svg((*apart(parts, [corner], (WIDTH, HEIGHT)), corner), _title(scene))


def svg(parts: Sequence[str], title: str, size: tuple[float, float] = (WIDTH, HEIGHT)) -> str:
    """Parts of a drawing as an element that says what it shows."""
    return (
        f'<svg class="drawing" viewBox="0 0 {size[0]:.0f} {size[1]:.0f}" role="img"'
        f' aria-label="{escape(title)}">{"".join(parts)}</svg>'
    )


def _title(scene: Scene) -> str:
    """What is drawn, in words."""
    bodies = ", ".join(body.name for body in scene.bodies[:FEW])
    more = f" and {len(scene.bodies) - FEW} more" if len(scene.bodies) > FEW else ""
    marked = ", ".join(q.name for q in few_of(scene))
    return f"Drawing of {scene.name}: {bodies}{more}" + (f"; marked are {marked}" if marked else "")


def few_of(scene: Scene) -> tuple[Symbol, ...]:
    """The coordinates that are marked in one drawing: all, or none of many."""
    most = MARKED if View(scene, {}).planar else MARKED_IN_SPACE
    return tuple(scene.q) if len(scene.q) <= most and not scene.quaternions else ()


def paper_for(
    views: Sequence[View],
    few: Sequence[Symbol] | None = None,
    size: tuple[float, float] = (WIDTH, HEIGHT),
) -> Paper:
    """The paper on which a scene at all of these states, in metres, fills the drawing.

    `few` are the coordinates that are marked, `few_of` the scene by default.
    """
    scene = views[0].scene
    few = few_of(scene) if few is None else few
    margin = np.full(2, MARGIN if few else UNMARKED)
    for view in views[:: max(1, len(views) // 8)]:
        margin = np.maximum(margin, _pushed(view))
    margin = margin if size[0] == WIDTH else np.full(2, MARGIN * size[0] / WIDTH)
    points = [view.point(point) for view in views for point in view.loaded]
    for view in views:
        points += [corner for body in scene.bodies for corner in outline(view, body)]
    # A line at zero is long as its body is far: a few of the views tell where it ends.
    for view in views[:: max(1, len(views) // 8)]:
        points += [zero for q in few if (zero := zero_end(view, q)) is not None]
    # A motion that leads far off leaves the paper: the bodies would be a dot on all of it.
    size_of_bodies = np.ptp(points, axis=0).max()
    for body in scene.bodies:
        way = trace(views[0], body)
        led = len(movers(views[0], body)) == 1
        if way is not None and (led or np.ptp(way, axis=0).max() <= FAR * size_of_bodies):
            points += list(way)
    # Where nothing leads to the ground, the origin is far from what is drawn.
    held = any(reaction.by is None for reaction in scene.reactions)
    return paper_of([*points, *([views[0].point(scene.origin)] if held else [])], margin, size)


def _pushed(view: View) -> np.ndarray:
    """Room for arrows of forces and for springs that are drawn with a length, in x and in y."""
    loads = view.scene.loads
    pushing = [load.vector for load in loads if isinstance(load, Force)]
    pushing += [
        load.along
        for load in loads
        if isinstance(load, Spring | Damper) and load.along and is_slack_at_anchor(view, load)
    ]
    ways = [np.abs(unit(view.direction(vector))) for vector in pushing]
    return PUSHED * np.max([np.zeros(2), *ways], axis=0)


def plain_picture(view: View, paper: Paper, moving: bool = False) -> tuple[list[str], list[str]]:
    """Ground, traces and bodies: those with an extension, and dots that lie above all else."""
    extended: list[str] = []
    small: list[str] = []
    for body in view.scene.bodies:
        corners = outline(view, body)
        (small if len(corners) == 1 else extended).append(body_shape(view, paper, body, corners))
    traces = (_trace(view, paper, body) for body in view.scene.bodies)
    return [ground(view, paper, moving), *traces, *extended], small


def picture(view: View, paper: Paper, asides: Sequence[np.ndarray] | None = None) -> list[str]:
    """The parts of a drawing: ground, traces, bodies, loads, joints, coordinates, names.

    `asides` are given for a picture that moves: `aside_of` each coordinate at its start. Names of
    bodies are left out of it.
    """
    scene = view.scene
    named = scene.bodies if len(scene.bodies) <= FEW else (scene.bodies[0], scene.bodies[-1])
    moves = asides is not None
    large, small = plain_picture(view, paper, moves)
    arrows = [
        coordinate_picture(view, paper, q, [*large, *small], None if asides is None else asides[k])
        for k, q in enumerate(few_of(scene))
    ]
    return [
        *large,
        *arrows,
        *small,
        *(load_symbol(view, paper, load) for load in scene.loads),
        _joints(view, paper),
        *(_label(view, paper, body) for body in (() if moves else named)),
    ]


def directions(view: View, paper: Paper, parts: Sequence[str]) -> str:
    """Axes and gravity, in the corner where the other parts leave room."""
    x, y = _free_corner("".join(parts))
    drawn = _axes(view, paper) + (gravity_arrow(view, paper) if _heavy(view.scene) else "")
    return f'<g transform="translate({x:g} {y:g})">{drawn}</g>'


def _trace(view: View, paper: Paper, body: Body) -> str:
    """The circle that a point mass goes round."""
    circle = trace(view, body)
    return "" if circle is None else strokes.path([paper.place(p) for p in circle], "trace")


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


def outline(view: View, body: Body) -> list[np.ndarray]:
    """Corners of a body on paper, in m: one for a block, two or more for a rod, many for a disc."""
    return _outline(view, body)[0]


def shape_words(scene: Scene) -> str:
    """Which bodies have no shape but by their inertia; empty where all have one."""
    view = View(scene, closed(scene, scene.example))
    names = [body.name.replace("_", " ") for body in scene.bodies if _outline(view, body)[1]]
    if not names:
        return ""
    of = " and ".join(filter(None, (", ".join(names[:-1]), names[-1])))
    rest = "it is" if len(names) == 1 else "each is"
    return (
        f"No shape is declared for {of}: {rest} drawn as the uniform rod or ellipse of its inertia."
    )


def _outline(view: View, body: Body) -> tuple[list[np.ndarray], bool]:
    """Corners of a body, and whether they follow from its inertia alone."""
    if declared := view.outlines(body):
        return [point for points in declared for point in points], False
    if not isinstance(body, RigidBody):
        return [view.point(body.centre)], False
    found: list[np.ndarray] = []
    for point in attached(view.scene, body):
        place = view.point(point)
        if all(np.hypot(*(place - other)) > 1e-9 for other in found):
            found.append(place)
    if ends := _ends(view, body):
        return [view.point(end) for end in ends], False
    if len(found) > 2 or (len(found) == 1 and rail(view, body) is not None):
        return found, False
    if len(found) == 2 and view.planar and (tips := _tips(view, body, found)):
        return [*found, *tips], False
    if view.number(body.mass) == 0:
        return found, False  # a moment of inertia alone says nothing about a shape
    first, second = _semi_axes(view, body)
    long, short = (float(np.hypot(*axis)) for axis in (first, second))
    centre = found[0]
    if len(found) == 2:
        arm = found[1] - centre
        # A uniform rod of half length a has I = m a^2 / 3; the ellipse of that I has a sqrt(2/3).
        reach = float(np.hypot(*arm))
        if abs(reach - long * np.sqrt(1.5)) < 0.01 * long and view.planar:
            return [centre - arm, centre, centre + arm], True
        rolls = not all(_carries(view, body, point) for point in attached(view.scene, body))
        if view.planar and rolls and 0.5 * long < reach < 1.3 * long:
            # Of the ellipses with this inertia the one that ends at the contact.
            across = np.sqrt(2 * long**2 - reach**2)
            first, second, short = arm, across * unit(normal(arm)), across
        elif view.planar:
            return found, False  # a bar from the hinge
    if long < 1e-9:
        return found, False
    if short < 0.02 * long:
        return [centre - first, centre, centre + first], True
    angles = np.linspace(0, 2 * np.pi, 49)
    return [centre + np.cos(a) * first + np.sin(a) * second for a in angles], True


def _ends(view: View, body: RigidBody) -> list[Point]:
    """Where a link of a chain in space is drawn: from joint to joint, or to its output."""
    scene = view.scene
    if view.planar or len(scene.bodies) <= FEW:
        return []
    joints = {r.at for r in scene.reactions if body.name in (r.on, r.by) and r.at is not None}
    points = sorted(joints, key=lambda point: point.name)
    for shown in (o.point for o in scene.outputs.values() if isinstance(o, Position)):
        for carrier, step in shown._pos_dict.items():
            if carrier in joints and all(frame == body.frame for _, frame in step.args):
                points.append(shown)
    places = [view.place(point) for point in points]
    apart = [
        point
        for k, point in enumerate(points)
        if all(np.linalg.norm(places[k] - other) > 1e-9 for other in places[:k])
    ]
    if len(apart) == 1 and len(points) > 1:
        return [*apart, body.centre]
    return apart if len(apart) > 1 else []


def _tips(view: View, body: RigidBody, known: Sequence[np.ndarray]) -> list[np.ndarray]:
    """Outputs on paper that the body carries, but for those at `known` points."""
    outputs = [o.point for o in view.scene.outputs.values() if isinstance(o, Position)]
    ends = [view.point(point) for point in outputs if _carries(view, body, point)]
    return [end for end in ends if all(np.hypot(*(end - one)) > 1e-9 for one in known)]


def _carries(view: View, body: RigidBody, point: Point) -> bool:
    """Whether a point is fixed in a body, as a hinge is; a contact moves on as the body rolls."""
    other = view.at({q.name: 0.3 + 0.2 * k for k, q in enumerate(view.scene.q)})
    here, there = (
        at.frame(body.frame).T @ (at.place(point) - at.place(body.centre)) for at in (view, other)
    )
    return bool(np.allclose(here, there, atol=1e-9))


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


def paper_of(
    points: Sequence[np.ndarray], margin: float | np.ndarray, size: tuple[float, float]
) -> Paper:
    """The paper that these points fill but for a margin, or one in x and one in y."""
    corners = np.array(points)
    low, high = corners.min(axis=0), corners.max(axis=0)
    span = np.maximum(high - low, 1e-9)
    scale = min(*((np.array(size) - 2 * margin) / span), 1e6)
    middle = np.array(size) / 2
    return Paper(scale, middle - scale * (low + high) / 2 * np.array([1, -1]), middle)


def body_shape(view: View, paper: Paper, body: Body, corners: list[np.ndarray]) -> str:
    """A body alone: a dot, a block, rods, or an ellipse."""
    if isinstance(body, RigidBody) and body.outlines:
        return _declared_shape(view, paper, body)
    pixels = [paper.place(corner) for corner in corners]
    centre = paper.place(view.point(body.centre))
    if len(corners) == 1:
        way = rail(view, body)
        return (
            strokes.dot(centre, 9, "mass")
            if way is None
            else strokes.block(centre, paper.turn(way), *BLOCK)
        )
    ends = _ends(view, body) if isinstance(body, RigidBody) else []
    if len(ends) > 2:
        shape = strokes.path(strokes.around(pixels), "body", closed=True)
        return shape + strokes.dot(centre, 3, "ink")
    if ends:
        # The mass centre need not lie on the line of the joints.
        middle = (pixels[0] + pixels[1]) / 2
        aside = strokes.path([middle, centre], "faint")
        return aside + _rods(pixels[0], pixels) + strokes.dot(centre, 3, "ink")
    if len(corners) > 20:
        shape = strokes.path(pixels, "body inferred", closed=True)
        spoke = strokes.path([pixels[0], centre, pixels[12]], "faint")
        return shape + spoke + strokes.dot(centre, 3, "ink")
    point_mass = isinstance(body, RigidBody) and body.inertia == 0
    return _rods(centre, pixels) + strokes.dot(centre, 8 if point_mass else 3, "ink")


def _rods(start: np.ndarray, pixels: Sequence[np.ndarray]) -> str:
    return "".join(
        strokes.path([start, pixel], style)
        for style in ("rim", "rod")
        for pixel in pixels
        if np.hypot(*(pixel - start)) > 1
    )


def _declared_shape(view: View, paper: Paper, body: RigidBody) -> str:
    """The outlines that a body is declared to have: discs with a spoke, rings and rods.

    Several discs in the plane are the ends of one body, which is drawn around them.
    """
    centre, drawn = paper.place(view.point(body.centre)), ""
    if view.planar and len(body.outlines) > 1 and all(one.filled for one in body.outlines):
        corners = [paper.place(point) for points in view.outlines(body) for point in points]
        shape = strokes.path(strokes.around(corners), "body", closed=True)
        return shape + strokes.dot(centre, 3, "ink")
    for outline, points in zip(body.outlines, view.outlines(body), strict=True):
        pixels = [paper.place(point) for point in points]
        if outline.filled:
            middle = np.mean(pixels[:-1], axis=0)
            drawn += strokes.path(pixels, "body", closed=True)
            drawn += strokes.path([pixels[0], middle, pixels[12]], "faint")
        else:
            drawn += "".join(strokes.path(pixels, style) for style in ("rim", "rod"))
    return drawn + strokes.dot(centre, 3, "ink")


def _joints(view: View, paper: Paper) -> str:
    places = {
        r.at: paper.place(view.point(r.at))
        for r in view.scene.reactions
        if r.at is not None and r.by is not None and not r.parts
    }
    return "".join(strokes.dot(place, 4.5, "joint") for place in places.values())


def _axes(view: View, paper: Paper) -> str:
    """The directions of the inertial frame, in a corner."""
    frame, corner = view.scene.frame, np.array([34.0, 68.0] if view.planar else [54.0, 60.0])
    parts = []
    for name, axis in zip("xyz", (frame.x, frame.y, frame.z), strict=True):
        along = paper.turn(view.direction(axis))
        if np.hypot(*along) > 1e-9:
            tip = corner + 34 * along
            parts.append(strokes.arrow(corner, tip, "axis"))
            parts.append(strokes.text(tip + 11 * unit(along), svg_name(name), "axis-name"))
    return "".join(parts)


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


def _words(body: Body) -> str:
    return escape(body.name.replace("_", " "))


def _label(view: View, paper: Paper, body: Body) -> str:
    centre = paper.place(view.point(body.centre))
    if isinstance(body, RigidBody) and (body.outlines or _is_rod_or_oval_in_space(view, body)):
        at = _clear_corner(view, paper, body)
        return strokes.text(at + 18 * unit(at - paper.middle), _words(body))
    if isinstance(body, RigidBody) and (rail(view, body) is None or len(outline(view, body)) > 1):
        _, arm, sense = _lever(view, paper, body)
        side = -sense * normal(unit(arm)) if np.hypot(*arm) > 1 else np.array([0.7, 0.7])
        anchor = "start" if side[0] > 0.3 else "end" if side[0] < -0.3 else "middle"
        driven = any(isinstance(load, Torque) and load.on == body.name for load in view.scene.loads)
        # The arrow of a torque is above its point.
        away = 44 if driven and side[1] < 0.5 else 20
        return strokes.text(centre + away * side, _words(body), "name", anchor)
    if not view.scene.reactions:
        return strokes.text(centre, escape(body.name))
    if trace(view, body) is not None:
        return strokes.text(centre + 22 * unit(centre - paper.middle), escape(body.name))
    below = 1 if centre[1] >= paper.middle[1] - 1 else -1
    way = rail(view, body)
    if way is None or abs(way[0]) < abs(way[1]):
        # A point, or a block that goes up and down, with its coordinate beside it.
        away = 22 if way is None else 40
        return strokes.text(centre + np.array([0, away * below]), escape(body.name))
    # Any other block has its coordinate on one half of its outer side, and its name on the other.
    return strokes.text(centre + np.array([-12, 44 * below]), escape(body.name), "name", "end")


def _clear_corner(view: View, paper: Paper, body: Body) -> np.ndarray:
    """The pixel of a body's outlines that is far out, and far from those of all others."""
    own = _edge(view, paper, body)
    others = [p for b in view.scene.bodies if b is not body for p in _edge(view, paper, b)]
    others = others or [paper.place(view.point(body.centre))]
    apart = [min(float(np.hypot(*(at - other))) for other in others) for at in own]
    out = [float(np.hypot(*(at - paper.middle))) for at in own]
    return own[int(np.argmax(np.add(apart, out)))]


def _edge(view: View, paper: Paper, body: Body) -> list[np.ndarray]:
    """Pixels of a body's corners and of the middles between them."""
    corners = [paper.place(corner) for corner in outline(view, body)]
    return [*corners, *((one + other) / 2 for one, other in pairwise(corners))]


def _is_rod_or_oval_in_space(view: View, body: Body) -> bool:
    corners = np.array(outline(view, body))
    straight = int(np.linalg.matrix_rank(corners - corners[0], tol=1e-9)) == 1
    return not view.planar and (straight or len(corners) > 20)
