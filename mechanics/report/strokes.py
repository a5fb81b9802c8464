"""Strokes of a technical drawing as SVG text, in pixels, y downwards.

Colours are the classes and CSS variables of the page, so that a drawing follows light and dark.
"""

from collections.abc import Iterable
from typing import Any

import numpy as np

from mechanics.report.projection import normal, unit

Pixel = np.ndarray[Any, Any]
TURNS, ZIGZAG, DASHPOT = 6, 7.0, 8.0
"""Turns of a spring, and half the widths of a spring and a damper, in pixels."""


def path(points: Iterable[Pixel], style: str, closed: bool = False) -> str:
    """A polyline or polygon."""
    text = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    return f'<{"polygon" if closed else "polyline"} class="{style}" points="{text}"/>'


def around(points: Iterable[Pixel]) -> list[Pixel]:
    """The corners of the convex polygon around some points, in their order."""
    rest = sorted(points, key=tuple)
    corners: list[Pixel] = []
    for side in (rest, rest[::-1]):
        start = len(corners)
        for point in side:
            while len(corners) > start + 1 and not _turns_left(corners[-2], corners[-1], point):
                corners.pop()
            corners.append(point)
        corners.pop()
    return corners


def _turns_left(first: Pixel, second: Pixel, third: Pixel) -> bool:
    return bool(normal(second - first) @ (third - second) > 0)


def dot(at: Pixel, radius: float, style: str) -> str:
    """A circle."""
    return f'<circle class="{style}" cx="{at[0]:.1f}" cy="{at[1]:.1f}" r="{radius:.1f}"/>'


def text(at: Pixel, content: str, style: str = "name", anchor: str = "middle") -> str:
    """A label; its content is SVG already."""
    return (
        f'<text class="{style}" x="{at[0]:.1f}" y="{at[1]:.1f}" dy=".35em"'
        f' text-anchor="{anchor}">{content}</text>'
    )


def arrow(start: Pixel, end: Pixel, style: str) -> str:
    """A straight arrow with a slender head."""
    return path([start, end], style) + head(end, end - start, style)


def head(tip: Pixel, direction: Pixel, style: str, size: float = 8.0) -> str:
    """The head of an arrow."""
    along = unit(direction)
    base, side = tip - size * along, 0.38 * size * normal(along)
    return path([tip, base + side, base - side], f"{style} head", closed=True)


def arc(centre: Pixel, radius: float, start: float, sweep: float, style: str) -> str:
    """An arc with an arrow head; angles in rad, counterclockwise as seen on the page."""
    angles = np.linspace(start, start + sweep, 24)
    points = [centre + radius * np.array([np.cos(a), -np.sin(a)]) for a in angles]
    return path(points, style) + head(points[-1], points[-1] - points[-3], style)


def zigzag(start: Pixel, end: Pixel) -> str:
    """A spring."""
    span, length = end - start, float(np.hypot(*(end - start)))
    side, lead = normal(unit(span)) * ZIGZAG, min(0.2, 10 / max(length, 1.0))
    points = [start, start + lead * span]
    for i in range(2 * TURNS):
        share = lead + (1 - 2 * lead) * (i + 0.5) / (2 * TURNS)
        points.append(start + share * span + (side if i % 2 else -side))
    return path([*points, end - lead * span, end], "line")


def dashpot(start: Pixel, end: Pixel) -> str:
    """A damper."""
    span = end - start
    side = normal(unit(span)) * DASHPOT
    middle, back, mouth = start + 0.5 * span, start + 0.35 * span, start + 0.65 * span
    return "".join(
        (
            path([start, back], "line"),
            path([mouth + side, back + side, back - side, mouth - side], "line"),
            path([middle + 0.8 * side, middle - 0.8 * side], "line"),
            path([middle, end], "line"),
        )
    )


def hatching(centre: Pixel, along: Pixel, into: Pixel, reach: float) -> str:
    """A line of the ground through `centre`, hatched on the side of `into`."""
    along, into = unit(along), unit(into)
    count = max(3, int(2 * reach / 9))
    strokes = [path([centre - reach * along, centre + reach * along], "line")]
    for i in range(count):
        foot = centre + (2 * reach * (i + 0.7) / count - reach) * along
        strokes.append(path([foot, foot + 8 * into - 6 * along], "thin"))
    return "".join(strokes)


def pin(at: Pixel, into: Pixel) -> str:
    """A pivot on the ground: a triangle on a hatched line."""
    into = unit(into)
    side, foot = 11 * normal(into), at + 18 * into
    triangle = path([at, foot + side, foot - side], "plate", closed=True)
    return triangle + hatching(foot, normal(into), into, 18)


def block(centre: Pixel, along: Pixel, width: float, height: float) -> str:
    """A box with its longer side along a direction."""
    x, y = 0.5 * width * unit(along), 0.5 * height * normal(unit(along))
    corners = [centre + x + y, centre - x + y, centre - x - y, centre + x - y]
    return path(corners, "body", closed=True)
