"""Poles over a parameter or a speed: their real parts above, their imaginary parts beneath.

It stands in a narrow column or on a telephone as well: few labels, and letters that stay readable
at half of the width.
"""

from __future__ import annotations

import io
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from mechanics.linear.sweep import Sweep
from mechanics.scene.parameters import Parameter
from mechanics.simulate.plot import COLOURS, EDGE, STYLE

if TYPE_CHECKING:
    from matplotlib.axes import Axes

WIDTH, HEIGHT = 5.2, 5.6  # in
GREY = "#555555"


def modes_plot(found: Sweep) -> str:
    """The plot as SVG with a light background."""
    import matplotlib
    from matplotlib.figure import Figure

    stream = io.StringIO()
    with matplotlib.rc_context(STYLE):
        # A figure without pyplot needs no display.
        drawing = Figure(figsize=(WIDTH, HEIGHT), layout="constrained")
        real, imaginary = drawing.subplots(2, 1, sharex=True)
        _shade(real, found)
        _shade(imaginary, found)
        real.axhline(0.0, color=GREY, linewidth=0.8)
        for column, poles in enumerate(found.poles.T):
            colour = COLOURS[column % len(COLOURS)]
            real.plot(found.values, poles.real, color=colour)
            # Of a pair of conjugate poles the upper one.
            upper = np.where(poles.imag >= 0, poles.imag, np.nan)
            imaginary.plot(found.values, upper, color=colour)
        for border in found.borders:
            for panel in (real, imaginary):
                panel.axvline(border, color=EDGE, linewidth=1.0, linestyle=(0, (4, 2)))
            real.annotate(
                f"{border:.4g}", (border, 1.0), xycoords=("data", "axes fraction"), color=EDGE,
                xytext=(0, 2), textcoords="offset points", ha="center", va="bottom", fontsize=9,
            )  # fmt: skip
        real.set_ylabel("real part / (1/s)")
        imaginary.set_ylabel("imaginary part / (rad/s)")
        imaginary.set_ylim(bottom=0.0)
        shade = "\nshaded: a pole has a positive real part" if found.unstable.any() else ""
        imaginary.set_xlabel(label(found) + shade)
        imaginary.set_xlim(found.values[0], found.values[-1])
        drawing.align_ylabels((real, imaginary))
        title = f"Poles of {found.linear.scene.name} over {found.over}"
        drawing.suptitle(title, x=0.01, ha="left", fontsize=12, fontweight="bold")
        drawing.savefig(
            stream, format="svg", facecolor="white", metadata={"Date": None, "Creator": None}
        )
    return stream.getvalue()


def label(found: Sweep) -> str:
    """What it goes over, with its unit where that is declared."""
    symbol = found.linear.names.get(found.over)
    unit = symbol.unit if isinstance(symbol, Parameter) else ""
    return f"{found.over} / ({unit})" if unit else found.over


def _shade(panel: Axes, found: Sweep) -> None:
    """Where a pole has a positive real part."""
    edges = [found.values[0], *found.borders, found.values[-1]]
    grows = bool(found.unstable[0])
    for low, high in pairwise(edges):
        if grows:
            panel.axvspan(low, high, color=EDGE, alpha=0.08, linewidth=0)
        grows = not grows
