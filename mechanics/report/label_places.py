"""Names in a drawing that do not lie on each other: each goes where it overlaps least.

    cost(place) = OTHERS * share of the name on other names + share on lines + distance / FAR

A name moves only where it lies on another one, or across many lines; then to the cheapest of a few
places around where it was. What cannot be read anywhere is left out.
"""

import re
from collections.abc import Sequence

import numpy as np

from mechanics.report.labels import TEXT, places, width

HALF_HEIGHT = 8.0
OTHERS, FAR, OUTSIDE = 12.0, 60.0, 50.0
LINES = 0.12
"""Cost of each sample of a line under a name; samples are every few pixels."""
RINGS = (9.0, 16.0, 24.0, 34.0, 46.0)
"""Pixels from where a name was to where it is tried."""
MOST = 0.4
"""Share of a name that may lie on others; beyond, it is left out."""

Box = np.ndarray
"""Left, top, right, bottom, in pixels."""
GAP = np.array([-4.0, -1.0, 4.0, 1.0])
"""Pixels between a name and what is beside it, as a box is larger for them."""


def apart(parts: Sequence[str], fixed: Sequence[str], size: tuple[float, float]) -> list[str]:
    """The parts of a drawing with their names moved apart.

    Parameters
    ----------
    parts : sequence of str
        SVG of what is drawn, names in it.
    fixed : sequence of str
        Drawn as well, in place: its names do not move.
    size : tuple of float
        Of the drawing, in pixels.

    Examples
    --------
    >>> name = '<text class="name" x="50.0" y="50.0" dy=".35em" text-anchor="middle">{}</text>'
    >>> one, other = apart([name.format("one"), name.format("other")], [], (100.0, 100.0))
    >>> one == name.format("one"), other == name.format("other")
    (False, True)
    """
    strokes = places([re.sub(TEXT, "", part) for part in (*parts, *fixed)])
    names = [match for part in parts for match in TEXT.finditer(part)]
    boxes = [box_of(match) for match in names]
    held = [box_of(match) for part in fixed for match in TEXT.finditer(part)]
    shifts = [np.zeros(2) for _ in names]
    for _ in range(2):
        for k, box in enumerate(boxes):
            others = np.array([*held, *(b + _both(s) for b, s in _without(boxes, shifts, k))])
            shifts[k] = _best(box, shifts[k], others.reshape(-1, 4), strokes, size)
    moved = iter(zip(boxes, shifts, strict=True))
    every = [*held, *(b + _both(s) for b, s in zip(boxes, shifts, strict=True))]

    def put(match: re.Match[str]) -> str:
        box, shift = next(moved)
        at = box + _both(shift)
        others = np.array([other for other in every if not np.array_equal(other, at)])
        if overlap(at, others.reshape(-1, 4)) > MOST:
            every[:] = [other for other in every if not np.array_equal(other, at)]
            return ""
        x, y = (float(match[k]) + shift[k - 1] for k in (1, 2))
        return match[0].replace(f'x="{match[1]}" y="{match[2]}"', f'x="{x:.1f}" y="{y:.1f}"', 1)

    return [TEXT.sub(put, part) for part in parts]


def box_of(match: re.Match[str]) -> Box:
    """Where a name is, from its element."""
    x, y, anchor, content = float(match[1]), float(match[2]), match[3], match[4]
    wide = width(content)
    left = x - {"start": 0.0, "middle": wide / 2, "end": wide}[anchor]
    return np.array([left, y - HALF_HEIGHT, left + wide, y + HALF_HEIGHT])


def _both(shift: np.ndarray) -> np.ndarray:
    return np.tile(shift, 2)


def _without(
    boxes: Sequence[Box], shifts: Sequence[np.ndarray], place: int
) -> list[tuple[Box, np.ndarray]]:
    return [(b, s) for k, (b, s) in enumerate(zip(boxes, shifts, strict=True)) if k != place]


def _best(
    box: Box, now: np.ndarray, others: np.ndarray, strokes: np.ndarray, size: tuple[float, float]
) -> np.ndarray:
    """The shift that costs least; none where nothing is in the way."""
    around = np.arange(16) * np.pi / 8
    ring = [r * np.array([np.cos(a), np.sin(a)]) for r in RINGS for a in around]
    tried = [np.zeros(2), now, *ring]
    return min(tried, key=lambda shift: _cost(box, shift, others, strokes, size))


def _cost(
    box: Box, shift: np.ndarray, others: np.ndarray, strokes: np.ndarray, size: tuple[float, float]
) -> float:
    at = box + _both(shift)
    wide = at + GAP
    inside = np.all((strokes > wide[:2]) & (strokes < wide[2:]), axis=1).sum()
    beyond = max(0.0, -at[0], -at[1], at[2] - size[0], at[3] - size[1])
    away = float(np.hypot(*shift)) / FAR
    return float(
        OTHERS * overlap(at, others + GAP) + LINES * inside + away + OUTSIDE * beyond / 100
    )


def overlap(box: Box, others: np.ndarray) -> float:
    """Share of a box that lies on others."""
    if not len(others):
        return 0.0
    wide = np.minimum(box[2], others[:, 2]) - np.maximum(box[0], others[:, 0])
    high = np.minimum(box[3], others[:, 3]) - np.maximum(box[1], others[:, 1])
    area = (box[2] - box[0]) * (box[3] - box[1])
    return float((np.clip(wide, 0, None) * np.clip(high, 0, None)).sum() / area)
