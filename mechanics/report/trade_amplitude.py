"""Error of the linearized model over amplitude, both logarithmic, as inline SVG."""

from collections.abc import Sequence
from html import escape
from math import ceil, floor, log10

from mechanics.report.charts import COLOURS, Axis, Tick, grid, power
from mechanics.report.notation import svg_name
from mechanics.trade.amplitude import Amplitude
from mechanics.trade.dropping import ENOUGH

WIDTH, HEIGHT = 460.0, 290.0
LEFT, RIGHT, TOP, BOTTOM = 58.0, 16.0, 26.0, 44.0


def amplitude_chart(rows: Sequence[Amplitude]) -> str:
    """Curves of the coordinates that have one; empty where none has.

    Parameters
    ----------
    rows : sequence of Amplitude
        About one equilibrium.
    """
    drawn = [row for row in rows if row.curve]
    if not drawn:
        return ""
    points = {row.coordinate: _logs(row) for row in drawn}
    every = [point for curve in points.values() for point in curve]
    x = Axis(floor(min(a for a, _ in every)), ceil(max(a for a, _ in every)), LEFT, WIDTH - RIGHT)
    y = Axis(floor(min(e for _, e in every)), ceil(max(e for _, e in every)), HEIGHT - BOTTOM, TOP)
    units = " or ".join(dict.fromkeys(row.unit for row in drawn))
    parts = [
        grid(x, y, _powers(x), _powers(y)),
        f'<text class="axis-title" x="{x.end}" y="{HEIGHT - 5}" text-anchor="end">'
        f"amplitude in {escape(units)}</text>"
        '<text class="axis-title" x="2" y="13">largest error</text>',
    ]
    at = y.place(log10(ENOUGH))
    parts.append(
        f'<line class="target" x1="{x.start}" x2="{x.end}" y1="{at:.1f}" y2="{at:.1f}"/>'
        f'<text class="target-name" x="{x.start + 5}" y="{at - 6:.1f}">{ENOUGH:.0%}</text>'
    )
    for n, row in enumerate(drawn):
        line = " ".join(f"{x.place(a):.1f},{y.place(e):.1f}" for a, e in points[row.coordinate])
        limit = x.place(log10(row.limit))
        parts.append(
            f'<polyline class="curve s{n % COLOURS}" points="{line}"/>'
            f'<circle class="limit" cx="{limit:.1f}" cy="{at:.1f}" r="4"/>'
        )
    title = f"Error of the linearized model over amplitude, {len(drawn)} coordinates"
    return (
        f'<svg class="chart" viewBox="0 0 {WIDTH:.0f} {HEIGHT:.0f}" role="img"'
        f' aria-label="{escape(title)}">{"".join(parts)}</svg>'
    )


def legend(rows: Sequence[Amplitude]) -> list[tuple[int, str]]:
    """Number of the stroke and symbol of each coordinate that is drawn."""
    return [(n, svg_name(r.coordinate)) for n, r in enumerate(r for r in rows if r.curve)]


def _logs(row: Amplitude) -> list[tuple[float, float]]:
    return [(log10(a), log10(e)) for a, e in row.curve if 0 < e < float("inf")]


def _powers(axis: Axis) -> list[Tick]:
    step = max(1, ceil((axis.high - axis.low) / 6))
    return [(n, power(n)) for n in range(ceil(axis.low), floor(axis.high) + 1, step)]
