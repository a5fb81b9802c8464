"""The trade of speed for accuracy as one self-contained HTML page."""

import re
from dataclasses import dataclass
from itertools import groupby
from math import isfinite
from statistics import median

from markupsafe import Markup, escape

from mechanics.report import charts, trade_plot
from mechanics.report.environment import environment
from mechanics.report.notation import latex_name
from mechanics.report.trade_amplitude import amplitude_chart, legend
from mechanics.report.typeset import maths
from mechanics.trade import Measurement, Trade
from mechanics.trade.amplitude import Amplitude
from mechanics.trade.recommend import milliseconds

NUMBER = re.compile(r"\b(\d(?:\.\d+)?)e([+-]\d+)\b")


@dataclass(frozen=True)
class Small:
    """How far the linear equations about one equilibrium are enough."""

    place: str
    picture: Markup
    keys: list[tuple[Markup, Markup]]
    rows: list[Amplitude]


def trade_html(found: Trade) -> str:
    """The report of a trade.

    Parameters
    ----------
    found : Trade

    Returns
    -------
    str
        A whole page.
    """
    made = environment()
    made.filters.update(error=error, power=power, powers=powers, time=duration)
    made.globals["median"] = median
    return made.get_template("trade.html").render(
        found=found,
        front=found.front,
        best=min(
            (pick for pick in found.recommendations if pick.measurement is not None),
            key=lambda pick: pick.target,
            default=None,
        ),
        noisy=sum(m.noisy for m in found.front),
        wide=Markup(trade_plot.work_precision(found, trade_plot.WIDE)),
        narrow=Markup(trade_plot.work_precision(found, trade_plot.NARROW)),
        keys=[(Markup(trade_plot.key(c)), c.name) for c in trade_plot.curves(found)],
        families=_families(found),
        small=_small(found),
    )


def error(value: float | None) -> Markup:
    """An error as a number times a power of ten; a dash where there is none."""
    if value is None:
        return Markup("–")
    if not isfinite(value):
        return Markup("∞")
    if value == 0:
        return Markup("0")
    digits, exponent = f"{value:.1e}".split("e")
    if -2 <= int(exponent) <= 2:
        return Markup(f"{value:.2g}")
    return Markup(f"{digits}·10<sup>{str(int(exponent)).replace('-', chr(0x2212))}</sup>")


def powers(text: str) -> Markup:
    """A sentence with its numbers such as 1e-07 written as powers of ten."""

    def written(match: re.Match[str]) -> str:
        digits, exponent = match[1], str(int(match[2])).replace("-", chr(0x2212))
        return f"{'' if digits == '1' else digits + '·'}10<sup>{exponent}</sup>"

    return Markup(NUMBER.sub(written, str(escape(text))).replace(" us", " µs"))


def power(value: float) -> Markup:
    """A target: ``10^-6`` where it is a power of ten."""
    digits, exponent = f"{value:.0e}".split("e")
    if digits == "1" and float(f"1e{exponent}") == value:
        return Markup(f"10<sup>{str(int(exponent)).replace('-', chr(0x2212))}</sup>")
    return error(value)


def duration(seconds: float) -> str:
    """A time with its unit."""
    return milliseconds(seconds).replace("us", "µs")


def _families(found: Trade) -> list[tuple[str, list[Measurement]]]:
    """All measurements by integrator, in the order in which they were made."""
    order = list(dict.fromkeys(m.choice.setting.integrator for m in found.measurements))
    rows = sorted(found.measurements, key=lambda m: order.index(m.choice.setting.integrator))
    return [(n, list(g)) for n, g in groupby(rows, key=lambda m: m.choice.setting.integrator)]


def _small(found: Trade) -> list[Small]:
    if found.least is None:
        return []
    rows = found.least.amplitudes
    return [
        Small(
            place,
            Markup(amplitude_chart(group)),
            [(Markup(charts.key(n)), Markup(maths(latex_name(g.coordinate))))
             for (n, _), g in zip(legend(group), (r for r in group if r.curve), strict=True)],
            group,
        )
        for place, made in groupby(rows, key=lambda row: row.place)
        for group in [list(made)]
    ]  # fmt: skip
