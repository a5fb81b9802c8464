"""Names of points and lengths in a drawing, where the text beside it uses them.

Points: mass centres, and where reactions and forces act. Lengths: from a point to the one that it
is located from, where that is a number times one parameter along an axis.
"""

import re
from collections.abc import Sequence
from html import unescape
from itertools import pairwise

import numpy as np
from sympy import Expr, Symbol
from sympy.physics.vector import Point

from mechanics.kinematics.printer import Printer
from mechanics.mechanism import lower
from mechanics.program import Builder
from mechanics.report import strokes
from mechanics.report.notation import SMALL, svg_name, svg_row
from mechanics.report.projection import Paper, View, normal, unit
from mechanics.scene.loads import Force

SHORT = re.compile(r"[A-Z]\w{0,2}'?")
AWAY = 15.0
"""Pixels from a point to its name, and from a length to its line."""
TEXT = re.compile(
    r'<text class="[\w-]+" x="(-?[\d.]+)" y="(-?[\d.]+)"[^>]*text-anchor="(\w+)">(.*?)</text>'
)
SUBSCRIPT = re.compile(r'font-size="72%">([^<]*)<')
SIZE = 15.0
"""Pixels of an em."""
NARROW, WIDE = "fijlrtI.,:;'()[]|-\u2212 ", "mwMWOQGDNHUCAK%@\u03a9"
WIDTHS = 0.36, 0.54, 0.86
"""Of a narrow letter, of most, and of a wide one, in em: the widest of the fonts of the pages."""
LEAST = 26.0
"""Pixels of a length that is named."""
CROWDED = 9.0
"""Pixels from a name to the next thing below which it is left out."""


def point_labels(view: View, paper: Paper, parts: Sequence[str]) -> str:
    """Names of points with dots, each on the side where there is room."""
    scene = view.scene
    points = [body.centre for body in scene.bodies]
    points += [reaction.at for reaction in scene.reactions if reaction.at is not None]
    points += [load.at for load in scene.loads if isinstance(load, Force)]
    names: dict[tuple[int, int], list[Point]] = {}
    for point in dict.fromkeys(points):
        if SHORT.fullmatch(point.name):
            x, y = paper.place(view.point(point))
            names.setdefault((round(x), round(y)), []).append(point)
    obstacles, drawn = places(parts), []
    for pixel, shared in names.items():
        at = np.array(pixel, dtype=float)
        label = "".join(svg_name(point.name) for point in shared[:1])
        around = [at + AWAY * np.array([np.cos(a), np.sin(a)]) for a in np.arange(8) * np.pi / 4]
        spot = max(around, key=lambda place: _room(place, obstacles, at))
        if _room(spot, obstacles, at) < CROWDED:
            continue
        obstacles = np.vstack([obstacles, spot])
        drawn.append(strokes.dot(at, 2.2, "ink") + strokes.text(spot, label, "name"))
    return "".join(drawn)


def length_labels(view: View, paper: Paper, parts: Sequence[str]) -> str:
    """Dimension lines of lengths, each once, beside what they measure."""
    scene, obstacles, drawn = view.scene, places(parts), []
    mechanism = lower(scene, Builder())
    printer, named = Printer(scene, mechanism), {point.name: point for point in _points(view)}
    seen: set[Expr] = set()
    for place in mechanism.points:
        if place.parent < 0 or len(place.step) != 1 or place.name not in named:
            continue
        start = named.get(mechanism.points[place.parent].name)
        ((_, entries),) = place.step
        sizes = [abs(entry) for entry in printer(entries) if entry != 0]
        if start is None or len(sizes) != 1 or not _is_length(sizes[0]) or sizes[0] in seen:
            continue
        ends = [paper.place(view.point(point)) for point in (start, named[place.name])]
        span = ends[1] - ends[0]
        if np.hypot(*span) < LEAST:
            continue
        seen.add(sizes[0])
        middle = (ends[0] + ends[1]) / 2
        sides = [AWAY * sign * normal(unit(span)) for sign in (1.0, -1.0)]
        side = max(sides, key=lambda s: _room(middle + 1.8 * s, obstacles, middle))
        line = [end + side for end in ends]
        text = middle + 1.9 * side
        if _room(text, obstacles, middle) < CROWDED:
            continue
        obstacles = np.vstack([obstacles, text])
        ticks = (strokes.path([end - 0.3 * side, end + 0.3 * side], "thin") for end in line)
        drawn.append(strokes.path(line, "thin") + "".join(ticks))
        drawn.append(strokes.text(text, _size_name(sizes[0]), "axis-name"))
    return "".join(drawn)


def _points(view: View) -> list[Point]:
    """Every point that the scene locates, from the origin on."""
    found, waiting = [], [view.scene.origin]
    while waiting:
        point = waiting.pop()
        if point not in found:
            found.append(point)
            waiting += point._pos_dict
    return found


def _is_length(size: Expr) -> bool:
    number, symbol = size.as_coeff_Mul()
    return (
        bool(number.is_Rational)
        and isinstance(symbol, Symbol)
        and (getattr(symbol, "unit", "") == "m")
    )


def _size_name(size: Expr) -> str:
    number, symbol = size.as_coeff_Mul()
    before = "" if number.p == 1 else str(number.p)
    after = "" if number.q == 1 else f"/{number.q}"
    return svg_row((before, svg_name(symbol.name), after))


def places(parts: Sequence[str]) -> np.ndarray:
    """Pixels of what is drawn; of lines also every few pixels between their corners."""
    found = [np.array([1e4, 1e4])]
    for points in re.findall(r'points="([^"]*)"', "".join(parts)):
        corners = [np.array([float(v) for v in pair.split(",")]) for pair in points.split()]
        found += corners
        for one, other in pairwise(corners):
            count = min(int(np.hypot(*(other - one)) / 8), 60)
            found += [one + (other - one) * k / (count + 1) for k in range(1, count + 1)]
    for x, y in re.findall(r'cx="(-?[\d.]+)" cy="(-?[\d.]+)"', "".join(parts)):
        found.append(np.array([float(x), float(y)]))
    for x, y, anchor, content in TEXT.findall("".join(parts)):
        wide = width(content)
        left = {"start": 0.0, "middle": -wide / 2, "end": -wide}[anchor]
        found += [
            np.array([float(x) + left + wide * share, float(y)])
            for share in np.linspace(0, 1, 1 + int(wide / 8))
        ]
    return np.array(found)


def width(content: str) -> float:
    """Pixels of a name at most, by the widths of its letters; those of a subscript are small."""
    small = sum(map(_ems, SUBSCRIPT.findall(content)))
    return SIZE * (_ems(re.sub(r"<[^>]*>", "", content)) - (1 - SMALL) * small)


def _ems(letters: str) -> float:
    narrow, plain, wide = WIDTHS
    sizes = (narrow if c in NARROW else wide if c in WIDE else plain for c in unescape(letters))
    return sum(sizes)


def _room(place: np.ndarray, obstacles: np.ndarray, at: np.ndarray) -> float:
    """Distance to the next thing that is not at the point itself."""
    others = obstacles[np.hypot(*(obstacles - at).T) > 4]
    return float(np.min(np.hypot(*(others - place).T))) if len(others) else 1e4
