"""The domain in which a system is accurate: how far each quantity goes, the others as usual."""

from collections.abc import Sequence

import numpy as np

from mechanics.extremes.axes import Axis
from mechanics.extremes.cause import CAUSES, Cause
from mechanics.extremes.result import Array, Figures, Reach, Visited


def reaches(visited: Sequence[Visited], axes: Sequence[Axis], usual: Array) -> tuple[Reach, ...]:
    """The range of every quantity, in every form and precision."""
    known = {axis.name: axis for axis in axes}
    return tuple(
        _reach(entry, known[entry.walk.names[0]], usual, figures)
        for entry in visited
        if entry.walk.kind == "line"
        for figures in entry.figures
    )


def _reach(entry: Visited, axis: Axis, usual: Array, figures: Figures) -> Reach:
    """The largest run of accurate points around the usual value.

    Zero and points that are no numbers of the precision are passed over: they say nothing about
    their neighbours.
    """
    values = np.array(entry.walk.values[0])
    known = (figures.causes != CAUSES.index(Cause.INPUT)) & (values != 0)
    places = np.flatnonzero(known)
    middle = int(np.argmin(np.abs(np.log(values[places]) - np.log(usual[axis.column]))))
    good = figures.causes[places] == CAUSES.index(Cause.ACCURATE)
    low, high = middle, middle
    while low > 0 and good[low - 1]:
        low -= 1
    while high < len(places) - 1 and good[high + 1]:
        high += 1
    below = figures.cause(places[low - 1]) if low > 0 else Cause.ACCURATE
    above = figures.cause(places[high + 1]) if high < len(places) - 1 else Cause.ACCURATE
    inside = places[low : high + 1]
    return Reach(
        axis.name, axis.unit, figures.form, figures.precision, float(usual[axis.column]),
        float(values[places[low]]), float(values[places[high]]), below, above,
        float(figures.backward[inside].max()),
    )  # fmt: skip
