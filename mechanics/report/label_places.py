"""Names in a drawing that do not lie on each other: each goes where it overlaps least.

    cost(place) = OTHERS * (names that it touches + share of it on them)
                  + HEADS * share of heads of arrows under it + LINES * samples of lines under it
                  + distance / FAR + OUTSIDE * pixels outside

A name moves only where it lies on something; then to the cheapest of the places around where it
was, until none moves any more. Far from there, a thin line leads back. What cannot be read anywhere
is left out.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mechanics.report import strokes
from mechanics.report.labels import TEXT, places, width

ABOVE, BELOW = 8.0, 10.0
"""Pixels of a name above and below its middle; the tail of a subscript is below."""
OTHERS, HEADS, FAR, OUTSIDE = 8.0, 6.0, 30.0, 5.0
LINES = 0.15
"""Cost of each sample of a line under a name; samples are every few pixels."""
RINGS = (6.0, 12.0, 18.0, 25.0, 33.0, 42.0, 52.0, 64.0, 78.0, 94.0, 112.0)
"""Pixels from where a name was to where it is tried."""
AROUND = 24
"""Places on a ring."""
PASSES = 6
"""Times that every name is tried, at most."""
LED = 26.0
"""Pixels that a name moves before a line leads back to where it was."""
TOUCHING = 1.0
"""Square pixels that two names may share: estimates of letters are no better."""

Box = np.ndarray
"""Left, top, right, bottom, in pixels."""
GAP = np.array([-2.0, -1.0, 2.0, 1.0])
"""Pixels between a name and what is beside it, as a box is larger for them."""
ANGLES = np.arange(AROUND) * 2 * np.pi / AROUND
SHIFTS = np.array([[0.0, 0.0], *([r * np.cos(a), r * np.sin(a)] for r in RINGS for a in ANGLES)])
HEAD = re.compile(r'<polygon class="[\w -]*\bhead" points="([^"]*)"')


@dataclass(frozen=True)
class Sheet:
    """What is on the paper beside names.

    Attributes
    ----------
    counts : ndarray
        Samples of lines to the left of and above each pixel.
    heads : ndarray, shape (N, 4)
        Boxes of the heads of arrows.
    size : tuple of float
        Of the drawing, in pixels.
    """

    counts: np.ndarray
    heads: np.ndarray
    size: tuple[float, float]

    def lines_under(self, boxes: np.ndarray) -> np.ndarray:
        """How many samples of lines are in each box."""
        high, wide = np.array(self.counts.shape) - 1
        left, top, right, bottom = np.clip(
            np.round(boxes).astype(int), 0, [wide, high, wide, high]
        ).T
        n = self.counts
        inside: np.ndarray = n[bottom, right] - n[top, right] - n[bottom, left] + n[top, left]
        return inside


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
    sheet = _sheet([re.sub(TEXT, "", part) for part in (*parts, *fixed)], size)
    boxes = [box_of(match) for part in parts for match in TEXT.finditer(part)]
    still = [box_of(match) for part in fixed for match in TEXT.finditer(part)]
    now = list(boxes)
    for _ in range(PASSES):
        before = list(now)
        for k, box in enumerate(boxes):
            others = np.array([*still, *now[:k], *now[k + 1 :]]).reshape(-1, 4)
            tried = np.vstack([now[k], box + np.tile(SHIFTS, 2)])
            now[k] = tried[int(np.argmin(_costs(tried, box, others, sheet)))]
        if np.array_equal(before, now):
            break
    shown = _readable(still, now)
    moved = iter(zip(boxes, now, shown, strict=True))

    def put(match: re.Match[str]) -> str:
        box, place, readable = next(moved)
        if not readable:
            return ""
        x, y = np.array([float(match[1]), float(match[2])]) + (place - box)[:2]
        name = match[0].replace(f'x="{match[1]}" y="{match[2]}"', f'x="{x:.1f}" y="{y:.1f}"', 1)
        return _lead(box, place) + name

    return [TEXT.sub(put, part) for part in parts]


def box_of(match: re.Match[str]) -> Box:
    """Where a name is, from its element."""
    x, y, anchor, content = float(match[1]), float(match[2]), match[3], match[4]
    wide = width(content)
    left = x - {"start": 0.0, "middle": wide / 2, "end": wide}[anchor]
    return np.array([left, y - ABOVE, left + wide, y + BELOW])


def shared(boxes: np.ndarray, others: np.ndarray) -> np.ndarray:
    """Square pixels that each box shares with each of the others."""
    low = np.maximum(boxes[:, None, :2], others[None, :, :2])
    high = np.minimum(boxes[:, None, 2:], others[None, :, 2:])
    area: np.ndarray = np.prod(np.clip(high - low, 0, None), axis=2)
    return area


def heads_of(parts: Sequence[str]) -> np.ndarray:
    """Boxes of the heads of arrows, shape (N, 4)."""
    found = []
    for points in HEAD.findall("".join(parts)):
        corners = np.array([pair.split(",") for pair in points.split()], dtype=float)
        found.append([*corners.min(axis=0), *corners.max(axis=0)])
    return np.array(found).reshape(-1, 4)


def _sheet(parts: Sequence[str], size: tuple[float, float]) -> Sheet:
    wide, high = (int(np.ceil(length)) for length in size)
    pixels = np.floor(places(parts)).astype(int)
    inside = np.all((pixels >= 0) & (pixels < [wide, high]), axis=1)
    counts = np.zeros((high + 1, wide + 1), dtype=int)
    np.add.at(counts, (pixels[inside, 1] + 1, pixels[inside, 0] + 1), 1)
    return Sheet(counts.cumsum(axis=0).cumsum(axis=1), heads_of(parts), size)


def _costs(tried: np.ndarray, box: Box, others: np.ndarray, sheet: Sheet) -> np.ndarray:
    """What a name costs at each of the boxes, when it was at one of them at first."""
    area = np.prod(box[2:] - box[:2])
    wide = tried + GAP
    on_names = shared(wide, others)
    on_heads = shared(wide, sheet.heads) / np.prod(sheet.heads[:, 2:] - sheet.heads[:, :2], axis=1)
    ends = [-tried[:, 0], -tried[:, 1], tried[:, 2] - sheet.size[0], tried[:, 3] - sheet.size[1]]
    beyond = np.clip(ends, 0, None).sum(axis=0)
    shift = (tried - box)[:, :2]
    distance = np.hypot(*shift.T)
    # A line that leads back crosses no other name.
    middle = (box[:2] + box[2:]) / 2
    back = [middle + share * shift for share in (0.0, 0.25, 0.5, 0.75)]
    crossed = sum(shared(np.hstack([p - 1, p + 1]), others).any(axis=1) for p in back)
    costs: np.ndarray = (
        OTHERS * ((on_names > TOUCHING).sum(axis=1) + on_names.sum(axis=1) / area)
        + HEADS * on_heads.sum(axis=1)
        + LINES * sheet.lines_under(wide)
        + distance / FAR
        + OUTSIDE * beyond
        + np.where(distance > LED, 2.0 * crossed, 0.0)
    )
    return costs


def _readable(still: Sequence[Box], now: Sequence[Box]) -> list[bool]:
    """Whether each name lies on none of those that rest, and of those before it."""
    kept, shown = list(still), []
    for place in now:
        free = not (shared(place[None], np.array(kept).reshape(-1, 4)) > TOUCHING).any()
        shown.append(free)
        kept += [place] if free else []
    return shown


def _lead(box: Box, place: Box) -> str:
    """A thin line from a name back to where it was, if that is far."""
    start, middle = (box[:2] + box[2:]) / 2, (place[:2] + place[2:]) / 2
    if np.hypot(*(middle - start)) <= LED:
        return ""
    end = np.clip(start, place[:2] + 1, place[2:] - 1)
    return strokes.path([start, end], "lead")
