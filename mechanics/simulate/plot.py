"""A plot of a simulated motion: coordinates by unit, the energies beneath.

matplotlib is imported when something is drawn: it takes a fifth of the time of the whole package.
"""

from __future__ import annotations

import textwrap
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from mechanics.simulate.file_names import writable
from mechanics.simulate.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

# Paul Tol's bright scheme: told apart by everybody, and dark enough on white.
COLOURS = ("#4477aa", "#ee6677", "#228833", "#aa3377", "#66ccee", "#ccbb44")
INK, FAINT = "#222222", "#d9d9d9"
EDGE = "#aa3300"
WIDTH, PANEL = 8.0, 2.3  # in
QUANTITIES = {"rad": "angle", "m": "position"}

STYLE: Any = {
    "font.family": "sans-serif",
    "font.size": 10,
    "text.color": INK,
    "axes.edgecolor": "#888888",
    "axes.labelcolor": INK,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": FAINT,
    "grid.linewidth": 0.6,
    "xtick.color": "#555555",
    "ytick.color": "#555555",
    "lines.linewidth": 1.5,
    # The same motion gives the same file.
    "svg.hashsalt": "mechanics",
}


def write_plot(trajectory: Trajectory, path: str | Path) -> Path:
    """Write a plot of the motion as an SVG file with a light background.

    Raises
    ------
    InputError
        For another suffix than .svg, or a folder that does not exist.
    """
    import matplotlib

    target = writable(path, (".svg",))
    with matplotlib.rc_context(STYLE):
        figure(trajectory).savefig(
            target, format="svg", facecolor="white", metadata={"Date": None, "Creator": None}
        )
    return target


def figure(trajectory: Trajectory) -> Figure:
    """The figure itself: panels for the coordinates, and one for the energies beneath."""
    from matplotlib.figure import Figure

    groups = _groups(trajectory)
    # A figure without pyplot needs no display.
    drawing = Figure(figsize=(WIDTH, PANEL * (len(groups) + 1) + 0.9), layout="constrained")
    axes = drawing.subplots(len(groups) + 1, 1, sharex=True, squeeze=False)[:, 0]
    for panel, (unit, lines) in zip(axes, groups, strict=False):
        _draw(panel, trajectory.times, lines)
        panel.set_ylabel(f"{QUANTITIES.get(unit, 'coordinate')} / {unit or '1'}")
    energies = {
        "kinetic": trajectory.kinetic,
        "potential": trajectory.potential,
        "total": trajectory.total,
    }
    _draw(axes[-1], trajectory.times, energies)
    axes[-1].get_lines()[-1].set(color=INK, linewidth=2.0)
    axes[-1].get_legend().get_lines()[-1].set(color=INK, linewidth=2.0)
    for panel in axes:
        _mark(panel, trajectory)
    axes[-1].set_ylabel("energy / J")
    axes[-1].set_xlabel("time / s")
    axes[-1].set_xlim(trajectory.times[0], max(trajectory.times[-1], trajectory.times[0] + 1e-9))
    drawing.align_ylabels(axes)
    drawing.suptitle(trajectory.title, x=0.01, ha="left", fontsize=13, fontweight="bold")
    # textwrap does not break at a no-break space.
    note = "\n".join(textwrap.wrap(trajectory.note.replace(" = ", "\u00a0=\u00a0"), 110))
    axes[0].set_title(note, loc="left", fontsize=8.5, color="#555555")
    return drawing


def _mark(panel: Axes, trajectory: Trajectory) -> None:
    """A line at each crossing of the domain's edge, and a shade where the model is not valid."""
    for crossing in trajectory.crossings:
        panel.axvline(crossing.time, color=EDGE, linewidth=1.0, linestyle=(0, (4, 2)))
    for begin, end in trajectory.outside:
        panel.axvspan(begin, end, color=EDGE, alpha=0.08, linewidth=0)


def _groups(trajectory: Trajectory) -> list[tuple[str, dict[str, NDArray[np.float64]]]]:
    """Coordinates that share a panel: of one unit, and angles that go round by themselves."""
    groups: dict[tuple[str, bool], dict[str, NDArray[np.float64]]] = {}
    for name, values in trajectory.coordinates.items():
        unit = trajectory.units[name]
        turns = unit == "rad" and bool(np.ptp(values) > 2 * np.pi)
        groups.setdefault((unit, turns), {})[name] = values
    return [(unit, lines) for (unit, _), lines in groups.items()]


def _draw(
    panel: Axes, times: NDArray[np.float64], lines: Mapping[str, NDArray[np.float64]]
) -> None:
    """Lines over time, with their names at the right, where they cover nothing."""
    if len(lines) <= len(COLOURS):
        colours: list[Any] = list(COLOURS)
    else:
        import matplotlib

        colours = list(matplotlib.colormaps["viridis"](np.linspace(0.0, 0.9, len(lines))))
    for (name, values), colour in zip(lines.items(), colours, strict=False):
        panel.plot(times, values, color=colour, label=name)
    panel.legend(
        loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False, handlelength=1.4, fontsize=9
    )
