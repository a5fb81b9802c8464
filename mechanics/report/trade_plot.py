"""The work-precision plot: time for a second of motion over error, both logarithmic, as inline SVG.

Accuracy grows to the right, so the lower right is where one wants to be. A curve is an integrator
over its tolerances or steps; the band behind joins the choices that no other beats.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from itertools import groupby
from math import ceil, floor, isfinite, log10

from mechanics.report.charts import Axis, grid, power
from mechanics.report.style import plot_colours, template
from mechanics.trade import Measurement, Trade

# The least accurate motion that is still shown, and the smallest error that is told apart.
COARSEST, FINEST = 1.0, 1e-16
DASHES = ("", "7 3", "2 3", "9 3 2 3", "4 2")
LINE = 15.0
# Targets nearer to each other than this get one name.
APART = 24.0


@dataclass(frozen=True)
class Size:
    """Of a plot in pixels; labels stand at the ends of curves where there is room for them."""

    width: float
    height: float
    right: float

    left = 58.0
    top = 44.0
    bottom = 44.0

    @property
    def named(self) -> bool:
        """Whether the names of the curves stand at their ends."""
        return self.right > 100


WIDE, NARROW = Size(910.0, 520.0, 210.0), Size(372.0, 420.0, 27.0)


@dataclass(frozen=True)
class Curve:
    """An integrator over its tolerances or steps."""

    name: str
    family: str
    dash: str
    points: tuple[Measurement, ...]


@dataclass(frozen=True)
class Scales:
    """Where errors and times are drawn."""

    x: Axis
    y: Axis

    def place(self, m: Measurement) -> tuple[float, float]:
        """Pixels of a measurement."""
        error = max(m.error_largest, FINEST)
        return self.x.place(-log10(error)), self.y.place(log10(m.time))


def work_precision(found: Trade, size: Size = WIDE) -> str:
    """The plot of a trade, in the colours of the page."""
    lines, others = curves(found), [m for m in shown(found) if not _plain(m)]
    scales = _scales(found, size)
    parts = [_grid(scales, size), _band(found, scales)]
    parts += [_curve(line, scales) for line in lines]
    parts += [_other(m, scales) for m in others]
    parts += [_front(m, scales) for m in found.front if m.error_largest <= COARSEST]
    parts.append(_picks(found, scales, size))
    if size.named:
        parts.append(_labels(lines, scales))
    title = (
        f"Work-precision plot of {found.title}: time for a second of motion over largest error,"
        f" {len(lines)} integrators"
    )
    return (
        f'<svg class="trade-plot" viewBox="0 0 {size.width:.0f} {size.height:.0f}" role="img"'
        f' aria-label="{escape(title)}">{"".join(parts)}</svg>'
    )


def standalone(found: Trade) -> str:
    """The plot as a file of its own, which follows light and dark."""
    body = work_precision(found)
    head = '<svg xmlns="http://www.w3.org/2000/svg"'
    opened = body.replace("<svg", head, 1)
    start = opened.index(">") + 1
    return f"{opened[:start]}<style>{style()}</style>{opened[start:]}\n"


def style() -> str:
    """Rules of the plot as a file of its own."""
    return plot_colours() + template("trade_plot")


def curves(found: Trade) -> list[Curve]:
    """Plain integrators in double precision, each over its settings."""
    plain = [m for m in shown(found) if _plain(m)]
    plain.sort(key=lambda m: (m.choice.setting.integrator, -m.choice.amount))
    made: list[Curve] = []
    for name, group in groupby(plain, key=lambda m: m.choice.setting.integrator):
        family = name.split()[0]
        dash = DASHES[sum(c.family == family for c in made) % len(DASHES)]
        made.append(Curve(name, family, dash, _to_the_best(list(group))))
    return made


def _to_the_best(points: list[Measurement]) -> tuple[Measurement, ...]:
    """Points up to the most accurate one; finer settings only cost more."""
    best = min(range(len(points)), key=lambda i: points[i].error_largest)
    return tuple(points[: best + 1])


def shown(found: Trade) -> list[Measurement]:
    """Measurements that are drawn: those that tell the motion at all."""
    return [m for m in found.measurements if m.error_largest <= COARSEST]


def key(line: Curve) -> str:
    """The sample of a curve in a legend."""
    return (
        '<svg class="key" viewBox="0 0 28 8" aria-hidden="true">'
        f'<line class="line {line.family}" stroke-dasharray="{line.dash}" x1="1" y1="4" x2="27"'
        ' y2="4"/></svg>'
    )


def _plain(m: Measurement) -> bool:
    return m.choice.variant.plain and m.choice.setting.arithmetic == "double"


def _scales(found: Trade, size: Size) -> Scales:
    times = [log10(m.time) for m in shown(found)]
    errors = [-log10(max(m.error_largest, FINEST)) for m in shown(found)]
    low, high = floor(2 * min(times)) / 2, ceil(2 * max(times)) / 2
    x = Axis(0.0, max(ceil(max(errors)), 1), size.left, size.width - size.right)
    return Scales(x, Axis(low, high, size.height - size.bottom, size.top))


def _grid(scales: Scales, size: Size) -> str:
    x, y = scales.x, scales.y
    columns = [(n, power(-n)) for n in range(0, int(x.high) + 1, 2 if size.named else 3)]
    rows = [(n, _seconds(n)) for n in range(ceil(y.low), floor(y.high) + 1)]
    return (
        f'{grid(x, y, columns, rows)}<text class="axis-title" x="{x.end}" y="{size.height - 5}"'
        ' text-anchor="end">largest error along the way, relative</text>'
        '<text class="axis-title" x="2" y="13">time for a second of motion</text>'
    )


def _seconds(exponent: int) -> str:
    """``10 ms`` for -2: whole powers of ten have short names."""
    for unit, base in (("s", 0), ("ms", -3), ("us", -6), ("ns", -9)):
        if exponent >= base:
            return f"{10 ** (exponent - base)} {unit}".replace("us", "µs")
    return f"1e{exponent} s"


def _band(found: Trade, scales: Scales) -> str:
    front = [scales.place(m) for m in found.front if m.error_largest <= COARSEST]
    points = " ".join(f"{a:.1f},{b:.1f}" for a, b in front)
    return f'<polyline class="band" points="{points}"/>'


def _curve(line: Curve, scales: Scales) -> str:
    places = [scales.place(m) for m in line.points]
    points = " ".join(f"{a:.1f},{b:.1f}" for a, b in places)
    dots = "".join(
        f'<circle class="dot {line.family}{_noise(m)}" cx="{a:.1f}" cy="{b:.1f}" r="2.2">'
        f"<title>{escape(_title(m))}</title></circle>"
        for m, (a, b) in zip(line.points, places, strict=True)
    )
    dash = f' stroke-dasharray="{line.dash}"' if line.dash else ""
    return f'<polyline class="line {line.family}"{dash} points="{points}"/>{dots}'


def _noise(m: Measurement) -> str:
    """The class of a dot whose time is noise."""
    return " noisy" if m.noisy else ""


def _other(m: Measurement, scales: Scales) -> str:
    """A cross for another form, compiler setting or model, a hollow square for single precision."""
    a, b = scales.place(m)
    family = m.choice.setting.integrator.split()[0]
    title = f"<title>{escape(_title(m))}</title>"
    if m.choice.variant.plain:
        return (
            f'<rect class="single {family}" x="{a - 2.5:.1f}" y="{b - 2.5:.1f}" width="5"'
            f' height="5">{title}</rect>'
        )
    return f'<path class="cross {family}" d="M{a - 3:.1f} {b - 3:.1f}l6 6m0-6l-6 6">{title}</path>'


def _front(m: Measurement, scales: Scales) -> str:
    """A ring, with a stroke from quartile to quartile of the times."""
    a, b = scales.place(m)
    low, high = (scales.y.place(log10(value)) for value in m.spread)
    return (
        f'<line class="front" x1="{a:.1f}" x2="{a:.1f}" y1="{low:.1f}" y2="{high:.1f}"/>'
        f'<circle class="front" cx="{a:.1f}" cy="{b:.1f}" r="4.6"/>'
    )


def _picks(found: Trade, scales: Scales, size: Size) -> str:
    """A line from each target down to the pick that was shown to meet it."""
    parts, last = [], -APART
    for pick in found.recommendations:
        at = scales.x.place(-log10(pick.target))
        if at > scales.x.end:
            continue
        exponent = log10(pick.target)
        text = power(round(exponent)) if abs(exponent - round(exponent)) < 1e-9 else ""
        text = text or f"{pick.target:.1e}"
        text, last = (text, at) if at - last >= APART else ("", last)
        parts.append(
            f'<line class="target" x1="{at:.1f}" x2="{at:.1f}" y1="{scales.y.start}"'
            f' y2="{scales.y.end}"/>'
            f'<text class="target-name" x="{at:.1f}" y="{size.top - 6}" text-anchor="middle">'
            f"{text}</text>"
        )
        if pick.measurement is not None:
            a, b = scales.place(pick.measurement)
            parts.append(
                f'<path class="pick" d="M{a:.1f} {b - 7:.1f}l7 7-7 7-7-7z"><title>'
                f"{escape(pick.reason)}</title></path>"
                f'<line class="pick-line" x1="{at:.1f}" x2="{a - 7:.1f}" y1="{b:.1f}"'
                f' y2="{b:.1f}"/>'
            )
    return "".join(parts)


def _labels(lines: Sequence[Curve], scales: Scales) -> str:
    """Names beside the plot, in the order of the curves' ends, pushed apart where they meet."""
    ends = sorted(((scales.place(c.points[-1]), c) for c in lines), key=lambda e: e[0][1])
    heights = spaced([b for (_, b), _ in ends], LINE, scales.y.start)
    parts, edge = [], scales.x.end + 10
    order = uncrossed([place for place, _ in ends], heights, edge)
    for ((a, b), line), height in zip((ends[k] for k in order), heights, strict=True):
        parts.append(
            f'<path class="leader" d="M{a + 4:.1f} {b:.1f}L{edge:.1f} {height:.1f}h6"/>'
            f'<text class="name {line.family}" x="{edge + 9:.1f}" y="{height:.1f}" dy=".35em">'
            f"{escape(line.name)}</text>"
        )
    return "".join(parts)


def uncrossed(
    starts: Sequence[tuple[float, float]], heights: Sequence[float], edge: float
) -> list[int]:
    """Which start leads to each height, so that straight lines to the edge do not cross.

    Neighbours that cross change places until none does, as numbers are sorted.

    Examples
    --------
    >>> uncrossed([(0.0, 10.0), (90.0, 12.0)], [10.0, 40.0], 100.0)
    [0, 1]
    >>> uncrossed([(0.0, 10.0), (90.0, 12.0)], [40.0, 50.0], 100.0)
    [1, 0]
    """
    order = list(range(len(starts)))

    def height_at(x: float, start: int, place: int) -> float:
        across, level = starts[start]
        return level + (x - across) / (edge - across) * (heights[place] - level)

    for _ in order:
        for k in range(len(order) - 1):
            upper, lower = order[k : k + 2]
            x = max(starts[upper][0], starts[lower][0])
            if height_at(x, lower, k + 1) < height_at(x, upper, k):
                order[k], order[k + 1] = lower, upper
    return order


def spaced(wanted: Sequence[float], distance: float, most: float) -> list[float]:
    """Heights in order, as near to what is wanted as the distance and the lower end allow."""
    heights: list[float] = []
    for height in wanted:
        heights.append(max(height, heights[-1] + distance) if heights else height)
    limit = most
    for i in reversed(range(len(heights))):
        heights[i] = min(heights[i], limit)
        limit = heights[i] - distance
    return heights


def _title(m: Measurement) -> str:
    error = f"{m.error_largest:.1e}" if isfinite(m.error_largest) else "no end"
    return f"{m.choice.words}: {m.time * 1e6:.3g} µs for a second, error {error}"
