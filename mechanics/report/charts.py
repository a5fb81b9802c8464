"""Line charts and bars as inline SVG, in the colours of the page.

Ticks are multiples of 1, 2 or 5 times a power of ten.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from math import ceil, floor, isfinite, log10

import numpy as np
from markupsafe import Markup

from mechanics.report.notation import svg_name

WIDTH, HEIGHT = 460.0, 270.0
LEFT, RIGHT, TOP, BOTTOM = 58.0, 14.0, 16.0, 44.0
# Curves are drawn through at most this many samples.
SAMPLES = 480
COLOURS = 8

Tick = tuple[float, str]
"""A value on an axis, and its label."""


@dataclass(frozen=True)
class Chart:
    """A chart with its legend: samples of strokes and plain names."""

    title: str
    svg: Markup
    legend: tuple[tuple[Markup, str], ...]


@dataclass(frozen=True)
class Axis:
    """One axis: from data to pixels, and where its ticks are."""

    low: float
    high: float
    start: float
    end: float

    def place(self, value: float) -> float:
        """Pixel of a value."""
        share = (value - self.low) / (self.high - self.low)
        return self.start + share * (self.end - self.start)

    @property
    def ticks(self) -> list[float]:
        """Round values inside the axis."""
        step = round_step((self.high - self.low) / 5)
        first, last = ceil(self.low / step - 1e-9), floor(self.high / step + 1e-9)
        return [k * step for k in range(first, last + 1)]


def round_step(step: float) -> float:
    """The next larger of 1, 2, 5 times a power of ten."""
    power = 10.0 ** floor(log10(step))
    return next(k * power for k in (1.0, 2.0, 5.0, 10.0) if k * power >= step * (1 - 1e-9))


def line_chart(
    title: str, times: Sequence[float], curves: Mapping[str, Sequence[float]], unit: str
) -> str:
    """Curves over time, in s.

    Parameters
    ----------
    title : str
        What the chart shows, for those who cannot see it.
    times : sequence of float
        Shape (N,).
    curves : mapping of str to sequence of float
        By plain name, each of shape (N,).
    unit : str
        Of all the curves.
    """
    t = np.asarray(times, dtype=float)
    stride = max(1, ceil(len(t) / SAMPLES))
    rows = {name: np.asarray(values, dtype=float) for name, values in curves.items()}
    values = np.concatenate([row[np.isfinite(row)] for row in rows.values()])
    low, high = float(values.min()), float(values.max())
    room = 0.06 * (high - low) or max(abs(high), 1.0) * 0.5
    x = Axis(float(t[0]), float(t[-1]), LEFT, WIDTH - RIGHT)
    y = Axis(low - room, high + room, HEIGHT - BOTTOM, TOP)
    ticks = ([(value, _number(value)) for value in axis.ticks] for axis in (x, y))
    parts = [grid(x, y, *ticks, lines=False)]
    for n, row in enumerate(rows.values()):
        points = " ".join(
            f"{x.place(a):.1f},{y.place(b):.1f}"
            for a, b in zip(t[::stride], row[::stride], strict=True)
            if isfinite(b)
        )
        parts.append(f'<polyline class="curve s{n % COLOURS}" points="{points}"/>')
    parts.append(
        f'<text class="axis-title" x="{WIDTH - RIGHT}" y="{HEIGHT - 6}"'
        f' text-anchor="end">{svg_name("t")} in s</text>'
    )
    if unit:
        parts.append(
            f'<text class="axis-title" x="{LEFT - 6}" y="{TOP - 4}"'
            f' text-anchor="end">{escape(unit)}</text>'
        )
    return (
        f'<svg class="chart" viewBox="0 0 {WIDTH:.0f} {HEIGHT:.0f}" role="img"'
        f' aria-label="{escape(title)}">{"".join(parts)}</svg>'
    )


def key(n: int) -> str:
    """The sample of a curve's stroke that stands in a legend."""
    return (
        '<svg class="key" viewBox="0 0 28 8" aria-hidden="true">'
        f'<line class="curve s{n % COLOURS}" x1="1" y1="4" x2="27" y2="4"/></svg>'
    )


def bar(share: float) -> str:
    """A horizontal bar over a share of the width, 0 to 1."""
    return (
        '<svg class="bar" viewBox="0 0 100 8" preserveAspectRatio="none" aria-hidden="true">'
        '<rect class="track" width="100" height="8"/>'
        f'<rect class="value" width="{max(100 * share, 0.8):.1f}" height="8"/></svg>'
    )


def grid(
    x: Axis, y: Axis, columns: Iterable[Tick], rows: Iterable[Tick], *, lines: bool = True
) -> str:
    """Ticks with their labels, a line at each, and the frame; x has short marks without `lines`."""
    parts = []
    for value, label in rows:
        at = y.place(value)
        parts.append(
            f'<line class="grid" x1="{x.start}" x2="{x.end}" y1="{at:.1f}" y2="{at:.1f}"/>'
            f'<text class="tick" x="{x.start - 6}" y="{at:.1f}" dy=".35em"'
            f' text-anchor="end">{label}</text>'
        )
    kind, end = ("grid", y.end) if lines else ("tick-mark", y.start + 4)
    for value, label in columns:
        at = x.place(value)
        parts.append(
            f'<line class="{kind}" x1="{at:.1f}" x2="{at:.1f}" y1="{y.start}" y2="{end}"/>'
            f'<text class="tick" x="{at:.1f}" y="{y.start + 18}"'
            f' text-anchor="middle">{label}</text>'
        )
    parts.append(f'<line class="frame" x1="{x.start}" x2="{x.end}" y1="{y.start}" y2="{y.start}"/>')
    return "".join(parts)


def _number(value: float) -> str:
    """A tick as SVG text: 2.5, 20,000, 2·10 to the power 6."""
    if not value or 1e-4 < abs(value) < 1e5:
        text, after = f"{value:.10g}" if abs(value) < 1e4 else f"{value:,.0f}", ""
    else:
        digits, exponent = f"{value:.3e}".split("e")
        text, after = f"{float(digits):g}·", power(int(exponent))
    return text.replace("-", "\u2212") + after


def power(exponent: int) -> str:
    """A power of ten as SVG text; 1 as it is."""
    if not exponent:
        return "1"
    return f'10<tspan class="power" dy="-.45em">{str(exponent).replace("-", chr(0x2212))}</tspan>'
