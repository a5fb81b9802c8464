"""Maps of errors over values of quantities, as inline SVG: a grid for a pair, a strip for a line.

A cell's colour is the error of the accelerations while every equation holds, in epsilon of the
precision; where something broke it is the cause, which a letter names too.
"""

from collections.abc import Callable, Sequence
from html import escape
from itertools import groupby, pairwise
from math import log10, pi

import numpy as np

from mechanics.extremes.cause import CAUSES, Cause
from mechanics.extremes.result import PRECISIONS, Figures
from mechanics.report.notation import svg_name

CELL = 14.0
LEFT, TOP, BOTTOM, RIGHT = 44.0, 22.0, 58.0, 4.0
STRIP_WIDTH, STRIP_HEIGHT = 618.0, 12.0
LETTERS = {
    Cause.CONDITION: "c", Cause.CANCELLATION: "x", Cause.UNDERFLOW: "u", Cause.OVERFLOW: "o",
    Cause.RANGE: "r", Cause.SINGULAR: "s", Cause.INPUT: "",
}  # fmt: skip
LIGHT = frozenset({Cause.CANCELLATION, Cause.OVERFLOW, Cause.RANGE})
"""Causes whose letter is light on a dark colour."""

STEPS = (2.0, 16.0, 256.0)
"""Errors in epsilon at which the colour of an accurate cell changes."""


def shade(figures: Figures, index: int) -> str:
    """CSS class of one point."""
    cause = figures.cause(index)
    if cause is not Cause.ACCURATE:
        return cause.name.lower()
    epsilon = float(np.finfo(PRECISIONS[figures.precision]).eps)
    error = float(figures.relative[index]) / epsilon
    return f"accurate{sum(error > step for step in STEPS)}"


def heat_map(
    title: str, names: Sequence[str], units: Sequence[str],
    values: Sequence[Sequence[float]], figures: Figures,
) -> str:  # fmt: skip
    """A grid: the first quantity upwards, the second one to the right.

    Parameters
    ----------
    title : str
        What the map shows, for those who cannot see it.
    names, units : of the two quantities
    values : of the two quantities; the second one varies fastest in `figures`
    """
    rows, columns = map(len, values)
    width, height = LEFT + columns * CELL + RIGHT, TOP + rows * CELL + BOTTOM
    parts: list[str] = []
    for i in range(rows):
        y = TOP + (rows - 1 - i) * CELL
        shades = [shade(figures, i * columns + j) for j in range(columns)]
        parts += _cells(shades, lambda j: LEFT + j * CELL, y)
        parts += _letters([figures.cause(i * columns + j) for j in range(columns)], y)
        parts.append(
            f'<text class="tick" x="{LEFT - 5}" y="{y + CELL / 2:g}" dy=".35em"'
            f' text-anchor="end">{value_label(values[0][i], units[0])}</text>'
        )
    bottom = TOP + rows * CELL
    for j in range(columns):
        x = LEFT + (j + 0.5) * CELL
        parts.append(
            f'<text class="tick" transform="translate({x:g} {bottom + 5:g}) rotate(-90)" dy=".35em"'
            f' text-anchor="end">{value_label(values[1][j], units[1])}</text>'
        )
    parts.append(
        f'<rect class="frame" x="{LEFT}" y="{TOP}" width="{columns * CELL:g}"'
        f' height="{rows * CELL:g}"/>'
    )
    parts.append(
        f'<text class="axis-title" x="{LEFT + columns * CELL:g}" y="{height - 4:g}"'
        f' text-anchor="end">{svg_name(names[1])}{_in(units[1])}</text>'
        f'<text class="axis-title" x="0" y="14">{svg_name(names[0])}{_in(units[0])}</text>'
    )
    return (
        f'<svg class="heat" width="{width:g}" viewBox="0 0 {width:g} {height:g}" role="img"'
        f' aria-label="{escape(title)}">{"".join(parts)}</svg>'
    )


def strip(title: str, values: Sequence[float], figures: Figures) -> str:
    """All decades of one quantity as a band from 10^-308 to 10^308."""
    places = [i for i, value in enumerate(values) if value > 0]
    ends = [0.0]
    for a, b in pairwise(places):
        ends.append((log10(values[a]) + log10(values[b])) / 2 + 309)
    ends.append(STRIP_WIDTH)
    starts = [max(0.0, log10(values[places[0]]) + 308), *ends[1:-1]]
    stops = [*ends[1:-1], min(STRIP_WIDTH, log10(values[places[-1]]) + 310)]
    parts = [f'<rect class="track" width="{STRIP_WIDTH:g}" height="{STRIP_HEIGHT:g}"/>']
    spans = list(zip(places, starts, stops, strict=True))
    for name, run in groupby(spans, key=lambda span: shade(figures, span[0])):
        members = list(run)
        start, stop = members[0][1], members[-1][2]
        parts.append(
            f'<rect class="{name}" x="{start:.1f}" width="{max(stop - start, 1.5):.1f}"'
            f' height="{STRIP_HEIGHT:g}"/>'
        )
    for exponent in (-300, -200, -100, 0, 100, 200, 300):
        x = exponent + 309
        parts.append(f'<line class="decade" x1="{x}" x2="{x}" y1="0" y2="{STRIP_HEIGHT:g}"/>')
    return (
        f'<svg class="strip" viewBox="0 0 {STRIP_WIDTH:g} {STRIP_HEIGHT:g}"'
        f' preserveAspectRatio="none" role="img" aria-label="{escape(title)}">'
        f"{''.join(parts)}</svg>"
    )


def sample(name: str, letter: str = "") -> str:
    """One cell, for the legend."""
    light = " light" if any(name == cause.name.lower() for cause in LIGHT) else ""
    text = (
        f'<text class="letter{light}" x="7" y="7" dy=".33em" text-anchor="middle">{letter}</text>'
        if letter
        else ""
    )
    return (
        '<svg class="heat sample" viewBox="0 0 14 14" aria-hidden="true">'
        f'<rect class="{name}" width="14" height="14"/>{text}</svg>'
    )


def value_label(value: float, unit: str) -> str:
    """A value on an axis: a power of ten, a multiple of pi/2, or zero."""
    if value == 0:
        return "0"
    if unit == "rad" and (multiple := _quarter(value)):
        mark = "" if value == multiple * pi / 2 else "\u2032"
        return f"{_QUARTERS[multiple]}{mark}"
    exponent = round(log10(abs(value)))
    if abs(value / 10.0**exponent - 1) > 1e-6:
        return f"{value:.3g}".replace("-", "\u2212")
    power = str(exponent).replace("-", "\u2212")
    return f'10<tspan class="power" dy="-.4em">{power}</tspan>'


_QUARTERS = {1: "π/2", 2: "π", 3: "3π/2", 4: "2π"}


def _quarter(value: float) -> int:
    k = round(value / (pi / 2))
    return k if k in _QUARTERS and abs(value - k * pi / 2) < 1e-6 else 0


def unit_text(unit: str) -> str:
    """A unit as it is printed: m/s² for ``m/s^2``."""
    return escape(unit).replace("^2", "²").replace("^3", "³").replace("*", "\u2009")


def _in(unit: str) -> str:
    return f" in {unit_text(unit)}" if unit else ""


def _cells(shades: Sequence[str], left: Callable[[int], float], y: float) -> list[str]:
    """One rectangle for each run of equal cells."""
    parts, start = [], 0
    for name, run in groupby(shades):
        count = len(list(run))
        parts.append(
            f'<rect class="{name}" x="{left(start):g}" y="{y:g}"'
            f' width="{count * CELL:g}" height="{CELL:g}"/>'
        )
        start += count
    return parts


def _letters(causes: Sequence[Cause], y: float) -> list[str]:
    parts = []
    for light in (False, True):
        marked = [
            (LEFT + (j + 0.5) * CELL, LETTERS[cause])
            for j, cause in enumerate(causes)
            if LETTERS.get(cause) and (cause in LIGHT) == light
        ]
        if marked:
            places = " ".join(f"{x:g}" for x, _ in marked)
            parts.append(
                f'<text class="letter{" light" if light else ""}" x="{places}"'
                f' y="{y + CELL / 2:g}" dy=".33em" text-anchor="middle">'
                f"{''.join(letter for _, letter in marked)}</text>"
            )
    return parts


LEGEND: tuple[tuple[str, str, str], ...] = (
    ("accurate0", "", f"error of the accelerations at most {STEPS[0]:g} epsilon"),
    ("accurate1", "", f"at most {STEPS[1]:g}"),
    ("accurate2", "", f"at most {STEPS[2]:g}"),
    ("accurate3", "", "at most 4504: 1e-12 in double, 5.4e-4 in single precision"),
    *(
        (cause.name.lower(), LETTERS[cause], cause.value)
        for cause in CAUSES
        if cause is not Cause.ACCURATE
    ),
)
"""Class, letter and meaning of every colour."""
