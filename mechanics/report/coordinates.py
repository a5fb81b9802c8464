"""Coordinates as pictures: an arc or arrow from the pose at q = 0, dashed, to the pose as it is.

    r(q) = c + (a cos q + n x a sin q)      an angle: the point goes round c, from a, about n
    r(q) = r(0) + q d                       a length

Which of the two a coordinate is, and where it begins, is found from poses of the scene alone, the
other coordinates held.
"""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from sympy import Symbol

from mechanics.report import strokes
from mechanics.report.labels import places
from mechanics.report.notation import svg_name
from mechanics.report.projection import Paper, View, normal, unit
from mechanics.scene import Body, RigidBody
from mechanics.scene.rotations import Rotation
from mechanics.scene.symbols import plain_symbol

THIRD = 2 * np.pi / 3
SAMPLES = 33
"""Points of an arc; of a spiral, for each turn."""
LEAST = 0.15
"""In rad: what turns less is drawn with an arrow of this sense, which is longer."""
RADIUS = (26.0, 54.0)
"""Of arcs, in pixels."""
SPIRAL = 7.0
"""Pixels by which an arc grows with every turn."""
TURNS = 3
"""Whole turns of a spiral that are drawn; of more, the last ones."""
FULL = 2 * np.pi
ARROW = 20.0
"""Length of the arrow of a coordinate that is about zero, in pixels: it shows the sense alone."""
ASIDE, EDGE = 44.0, 16.0
"""Pixels from a body to the arrow of a length, or less, where that stands beyond the edge."""
CLEAR = 14.0
"""Pixels from the arrow of a length to what is drawn."""
AXES = 62.0
"""Length of the axes of a body that a quaternion turns, in pixels."""


class Turn(NamedTuple):
    """How an angle turns a body: about a centre, from a direction at q = 0, about an axis.

    Inertial components in m, the directions with length 1; `reach` is how far the mass centre is
    from the centre.
    """

    centre: np.ndarray
    start: np.ndarray
    axis: np.ndarray
    reach: float

    def at(self, angle: float, radius: float) -> np.ndarray:
        """The point at an angle from the start."""
        across = np.cross(self.axis, self.start)
        return self.centre + radius * (np.cos(angle) * self.start + np.sin(angle) * across)


def moved(view: View, coordinate: Symbol) -> Body | None:
    """The body that the coordinate moves, and the fewest others; of several the first."""
    scene, coordinates = view.scene, {*view.scene.q}
    moving = []
    for body in scene.bodies:
        free = scene.position(body.centre).free_symbols
        if isinstance(body, RigidBody):
            free = free | scene.rotation(body.frame).free_symbols
        if coordinate in free:
            moving.append((len(free & coordinates), body))
    return min(moving, key=lambda one: one[0])[1] if moving else None


def _turned(view: View, body: Body, coordinate: Symbol) -> bool:
    return isinstance(body, RigidBody) and (
        coordinate in view.scene.rotation(body.frame).free_symbols
    )


def set_to(view: View, coordinate: Symbol, value: float) -> View:
    """The scene with another value of one coordinate."""
    return view.at({**view.state, coordinate.name: value})


def turn_of(view: View, body: Body, coordinate: Symbol) -> Turn | None:
    """How a coordinate turns a body, or None where it is no angle."""
    places = _three(view, coordinate, lambda at: at.place(body.centre))
    middle = np.mean(places, axis=0)
    arms = places - middle
    reaches = np.linalg.norm(arms, axis=1)
    round_middle = np.ptp(reaches) < 1e-9 * (1 + reaches[0])
    if not isinstance(body, RigidBody) or not _turned(view, body, coordinate):
        quarter = set_to(view, coordinate, np.pi / 2).place(body.centre) - middle
        if not round_middle or reaches[0] < 1e-9 or abs(quarter @ arms[0]) > 1e-9 * reaches[0] ** 2:
            return None
        return Turn(middle, arms[0] / reaches[0], _axis(arms[0], arms[1]), float(reaches[0]))
    frames = _three(view, coordinate, lambda at: at.frame(body.frame))
    quarter = set_to(view, coordinate, np.pi / 2).frame(body.frame) @ frames[0].T
    third = frames[1] @ frames[0].T
    if abs(np.trace(third)) > 1e-9 or abs(np.trace(quarter) - 1) > 1e-9:
        return None  # no turn by q about one axis
    axis = np.array(
        [third[2, 1] - third[1, 2], third[0, 2] - third[2, 0], third[1, 0] - third[0, 1]]
    )
    axis = axis / np.linalg.norm(axis)
    if round_middle and reaches[0] > 1e-9:
        return Turn(middle, arms[0] / reaches[0], axis, float(reaches[0]))
    # It turns about its own centre, or goes on as it rolls: where a joint holds it, or an axis.
    arm = _held_aside(view, body, axis)
    if arm is not None:
        reach = float(np.linalg.norm(arm))
        start = frames[0] @ view.frame(body.frame).T @ arm / reach
        return Turn(view.place(body.centre), start, axis, reach)
    y, x, z = frames[0][:, 1], frames[0][:, 0], frames[0][:, 2]
    start = next(a for a in (y, x, z) if abs(a @ axis) < 0.9)
    start = start - (start @ axis) * axis
    return Turn(view.place(body.centre), start / np.linalg.norm(start), axis, 0.0)


def _held_aside(view: View, body: RigidBody, axis: np.ndarray) -> np.ndarray | None:
    """From the centre to the first joint with another body, across an axis."""
    for reaction in view.scene.reactions:
        pair = (reaction.on, reaction.by)
        if reaction.at is not None and None not in pair and body.name in pair:
            arm = view.place(reaction.at) - view.place(body.centre)
            arm = arm - (arm @ axis) * axis
            if np.linalg.norm(arm) > 1e-9:
                return arm
    return None


def _three(view: View, coordinate: Symbol, look: Callable[[View], np.ndarray]) -> np.ndarray:
    return np.array([look(set_to(view, coordinate, k * THIRD)) for k in range(3)])


def _axis(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    found = np.cross(first, second)
    return found / np.linalg.norm(found)


def coordinate_picture(
    view: View,
    paper: Paper,
    coordinate: Symbol,
    drawn: Sequence[str] = (),
    aside: np.ndarray | None = None,
) -> str:
    """The arc or arrow of a coordinate, from zero to where it is.

    Parameters
    ----------
    view : View
    paper : Paper
    coordinate : Symbol
    drawn : sequence of str
        Ground and bodies: an arrow stands clear of them.
    aside : ndarray, optional
        Pixels by which an arrow stands beside its body, see `aside_of`. None in a picture that does
        not move: then what is almost zero is drawn large enough to show its sense.
    """
    body = moved(view, coordinate)
    if body is None or coordinate in view.scene.quaternions:
        return ""
    turn = turn_of(view, body, coordinate)
    still = aside is None
    if turn is not None:
        rod = _reaches(view, body, turn)
        shift = view.projection.T @ view.slack.get(body.centre, np.zeros(2))
        turn = turn._replace(centre=turn.centre + shift)
        return _arc(view, paper, coordinate, turn, rod, still)
    aside = aside_of(view, paper, coordinate, drawn) if aside is None else aside
    return _arrow(view, paper, coordinate, body, aside, still)


def _reaches(view: View, body: Body, turn: Turn) -> bool:
    """Whether a rigid body is held at the centre, so that it is drawn from there by itself."""
    held = (r.at for r in view.scene.reactions if body.name in (r.on, r.by) and r.at is not None)
    return isinstance(body, RigidBody) and any(
        np.linalg.norm(view.place(at) - turn.centre) < 1e-9 for at in held
    )


def zero_end(view: View, coordinate: Symbol) -> np.ndarray | None:
    """Where the dashed line of an angle ends, or the arrow of a length begins, in m on paper."""
    body = moved(view, coordinate)
    if body is None or coordinate in view.scene.quaternions:
        return None
    turn = turn_of(view, body, coordinate)
    if turn is None:
        return set_to(view, coordinate, 0.0).point(body.centre)
    return view.project(turn.at(0.0, turn.reach))


def _arc(view: View, paper: Paper, coordinate: Symbol, turn: Turn, rod: bool, still: bool) -> str:
    """A dashed line at zero, an arc, and a line to the body where it is no rod itself."""
    value = float(view.state.get(coordinate.name, 0.0))
    reach = turn.reach * paper.scale
    radius = float(np.clip(0.5 * reach, *RADIUS))
    swept = value if not still or abs(value) > LEAST else ARROW / radius

    def pixel(angle: float, length: float) -> np.ndarray:
        return paper.place(view.project(turn.at(angle, length / paper.scale)))

    swept -= np.sign(swept) * FULL * max(abs(swept) // FULL - TURNS, 0)
    angles = np.linspace(0, swept, SAMPLES * max(int(np.ceil(abs(swept) / FULL)), 1))
    grown = SPIRAL * np.abs(angles) / FULL
    arc = [pixel(a, radius + more) for a, more in zip(angles, grown, strict=True)]
    longest = max(1.12 * reach, radius + 16)
    zero = [pixel(0, 0), pixel(0, longest)]
    now = [pixel(0, 0), pixel(value, reach if reach > 1 else radius + 10)]
    name = pixel(swept / 2, radius + SPIRAL * abs(swept) / FULL + 14)
    size = min(8.0, 0.5 * radius * abs(swept))
    return "".join(
        (
            strokes.path(zero, "zero"),
            "" if rod else strokes.path(now, "arm"),
            strokes.path(arc, "motion"),
            strokes.head(arc[-1], arc[-1] - arc[-3], "motion", size),
            strokes.text(name, svg_name(coordinate.name), "motion-name"),
        )
    )


def _arrow(
    view: View, paper: Paper, coordinate: Symbol, body: Body, aside: np.ndarray, still: bool
) -> str:
    end = paper.place(view.point(body.centre))
    start = paper.place(set_to(view, coordinate, 0.0).point(body.centre))
    along = unit(paper.turn(view.shift(body.centre, coordinate)))
    if not along.any():
        return ""
    if still and np.hypot(*(end - start)) < 12:
        end = start + ARROW * along
    start, end = start + aside, end + aside
    size = min(8.0, 0.5 * float(np.hypot(*(end - start))))
    tick = 9 * normal(along)
    forward = 1.0 if (end - start) @ along >= 0 else -1.0
    return "".join(
        (
            strokes.path([start - tick, start + tick], "zero"),
            strokes.path([start, end], "motion"),
            strokes.head(end, end - start, "motion", size),
            strokes.text(end + 13 * forward * along, svg_name(coordinate.name), "motion-name"),
        )
    )


def aside_of(view: View, paper: Paper, coordinate: Symbol, drawn: Sequence[str] = ()) -> np.ndarray:
    """Pixels from a body to the arrow of a coordinate: outwards, but clear of what is drawn."""
    body = moved(view, coordinate)
    if body is None:
        return np.zeros(2)
    along = unit(paper.turn(view.shift(body.centre, coordinate)))
    side = normal(along)
    ends = [paper.place(at.point(body.centre)) for at in (view, set_to(view, coordinate, 0.0))]
    outward = side @ (ends[0] - paper.middle)
    side = side if outward > 1 or (abs(outward) <= 1 and side[1] > 0) else -side
    asides = [share * ASIDE * way for way in (side, -side) for share in (1.0, 0.75, 0.5)]
    room = paper.middle - EDGE
    inside = [a for a in asides if all(np.all(abs(e + a - paper.middle) < room) for e in ends)]
    arrow, strokes = np.linspace(ends[0], ends[1], SAMPLES)[:, None], places(drawn)
    distances = [np.linalg.norm(arrow + a - strokes, axis=2).min() for a in inside]
    clear = (a for a, distance in zip(inside, distances, strict=True) if distance > CLEAR)
    widest = inside[int(np.argmax(distances))] if inside else asides[2]
    return next(clear, widest)


def coordinate_words(view: View, coordinate: Symbol) -> str:
    """What a coordinate is, made from the frames: of what, from where, which way.

    The words hold at every state: where zero itself moves with other coordinates they say so.
    """
    body = moved(view, coordinate)
    if body is None:
        return "coordinate"
    if coordinate in view.scene.quaternions:
        return _part_words(view, body, coordinate)
    turn = turn_of(view, body, coordinate)
    other = view.at({q.name: 0.3 + 0.2 * k for k, q in enumerate(view.scene.q)})
    if turn is None:
        along, elsewhere = (_way(at, body, coordinate) for at in (view, other))
        what = f"displacement of {_the(body)}"
        from_zero = f"{what} from where it is at {coordinate.name.replace('_', ' ')} = 0"
        if not np.allclose(along, elsewhere, atol=1e-9):
            return f"{from_zero}, along a line that turns with other coordinates"
        name = _axis_name(along)
        return f"{what} along {name}" if name else f"{from_zero}, {_along(view, along)}"
    again = turn_of(other, body, coordinate)
    same = again is not None and np.allclose(turn.start, again.start, atol=1e-9)
    zero = _from(view, turn.start) if same else "relative to what carries it"
    about = again is not None and np.allclose(turn.axis, again.axis, atol=1e-9)
    return f"angle of {_the(body)} {zero}" + (_sense(view, turn.axis) if about else "")


def _the(body: Body) -> str:
    """A name with its article, where it is a word."""
    return f"the {body.name}" if body.name.replace(" ", "").isalpha() else body.name


def _way(view: View, body: Body, coordinate: Symbol) -> np.ndarray:
    start, end = (set_to(view, coordinate, value).place(body.centre) for value in (0.0, 1.0))
    length = np.linalg.norm(end - start)
    return (end - start) / length if length > 1e-12 else end - start


def _axis_name(direction: np.ndarray) -> str:
    """A letter with its sign, where the direction is one of the inertial axes."""
    place = int(np.argmax(np.abs(direction)))
    if abs(abs(direction[place]) - 1) > 1e-9:
        return ""
    return ("" if direction[place] > 0 else "\u2212") + "xyz"[place]


def _along(view: View, direction: np.ndarray) -> str:
    """Which way a fixed line leads that is none of the axes."""
    if view.field is None:
        return "along a fixed line"
    rise = -float(view.field @ direction / np.linalg.norm(view.field))
    if abs(rise) < 1e-9:
        return "along a level line"
    way = "up" if rise > 0 else "down"
    return f"{way}wards" if abs(rise) > 1 - 1e-9 else f"{way} a slope"


def _from(view: View, direction: np.ndarray) -> str:
    if view.field is not None:
        share = float(view.field @ direction / np.linalg.norm(view.field))
        if abs(abs(share) - 1) < 1e-9:
            return "from hanging straight down" if share > 0 else "from the upright"
    name = _axis_name(direction)
    return f"from the direction of {name}" if name else "from where it is at zero"


def _sense(view: View, axis: np.ndarray) -> str:
    if view.planar:
        towards = np.cross(*view.projection) @ axis
        return ", counterclockwise" if towards > 0 else ", clockwise"
    name = _axis_name(axis)
    return f", about {name}" if name else ""


def _part_words(view: View, body: Body, coordinate: Symbol) -> str:
    """What a part of a quaternion is, by its place."""
    parts = next(p for r in view.scene.rotations if coordinate in (p := parts_of(r)))
    place = parts.index(coordinate)
    what = (
        "cosine of half the angle" if not place else f"{' xyz'[place]} of the axis times its sine"
    )
    return f"part of the unit quaternion that turns {_the(body)}: {what}"


def parts_of(rotation: Rotation) -> tuple[Symbol, ...]:
    """The parts of a quaternion as plain symbols, the scalar first."""
    return tuple(plain_symbol(part) for part in rotation.coordinates)


def orientation_picture(view: View, paper: Paper, rotation: Rotation) -> str:
    """What a quaternion turns: its axes at no turn, dashed, and as they are; and the arc."""
    parts = parts_of(rotation)
    body = moved(view, parts[1])
    if not isinstance(body, RigidBody):
        return ""
    none = view.at({**view.state, **dict(zip((p.name for p in parts), (1, 0, 0, 0), strict=True))})
    before, now = none.frame(body.frame), view.frame(body.frame)
    middle = view.place(body.centre)

    def pixel(direction: np.ndarray, length: float) -> np.ndarray:
        return paper.place(view.project(middle + length / paper.scale * direction))

    drawn = [strokes.path([pixel(a, 0), pixel(a, 1.1 * AXES)], "zero") for a in before.T]
    for name, axis in zip("xyz", now.T, strict=True):
        drawn.append(strokes.arrow(pixel(axis, 0), pixel(axis, AXES), "motion"))
        drawn.append(strokes.text(pixel(axis, AXES + 14), svg_name(name), "motion-name"))
    turn = now @ before.T
    angle = float(np.arccos(np.clip((np.trace(turn) - 1) / 2, -1, 1)))
    if angle > LEAST:
        axis = np.linalg.svd(turn - np.eye(3))[2][2]
        across = before[:, int(np.argmin(np.abs(axis @ before)))]
        start = across - (across @ axis) * axis
        start /= np.linalg.norm(start)
        if np.cross(axis, start) @ turn @ start < 0:
            axis = -axis
        swept = Turn(middle, start, axis, 0.0)
        arc = [pixel(swept.at(a, 1.0) - middle, AXES / 2) for a in np.linspace(0, angle, SAMPLES)]
        drawn += [strokes.path(arc, "motion"), strokes.head(arc[-1], arc[-1] - arc[-3], "motion")]
    return "".join(drawn)


def movers(view: View, body: Body) -> list[Symbol]:
    """The coordinates that move the centre of a body."""
    return [q for q in view.scene.q if q in view.scene.position(body.centre).free_symbols]


def trace(view: View, body: Body) -> np.ndarray | None:
    """The way of a point mass, in m on paper: the circle that one coordinate leads it round.

    Where several move it, its way along the motion that the view holds. None for other bodies.
    """
    moving = movers(view, body)
    if isinstance(body, RigidBody):
        return None
    if len(moving) > 1 and view.motion is not None:
        return view.way(body.centre)
    if len(moving) != 1:
        return None
    turn = turn_of(view, body, moving[0])
    if turn is None:
        return None
    around = np.linspace(0, 2 * np.pi, 61)
    return np.array([view.project(turn.at(angle, turn.reach)) for angle in around])
