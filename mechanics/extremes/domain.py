"""The domain in which a system is accurate: how far each quantity goes, the others as usual."""

from collections.abc import Mapping, Sequence

import numpy as np

from mechanics.compiled import Model
from mechanics.compiled.programs.describe import describe
from mechanics.compiled.programs.trace import trace
from mechanics.extremes.axes import Axis
from mechanics.extremes.cause import CAUSES, Cause
from mechanics.extremes.result import PRECISIONS, Array, End, Figures, Reach, Visited


def reaches(
    visited: Sequence[Visited], axes: Sequence[Axis], usual: Array, models: Mapping[str, Model]
) -> tuple[Reach, ...]:
    """The range of every quantity, in every form and precision; models by form."""
    known = {axis.name: axis for axis in axes}
    return tuple(
        _reach(entry, known[entry.walk.names[0]], usual, figures, models[figures.form])
        for entry in visited
        if entry.walk.kind == "line"
        for figures in entry.figures
    )


def _reach(entry: Visited, axis: Axis, usual: Array, figures: Figures, model: Model) -> Reach:
    """The largest run of accurate points around the usual value.

    Zero and points that are no numbers of the precision are passed over: they say nothing about
    their neighbours.
    """
    values = np.array(entry.walk.values[0])
    known = (figures.causes != CAUSES.index(Cause.INPUT)) & (values != 0)
    places = np.flatnonzero(known)
    start = abs(float(usual[axis.column])) or 1.0
    middle = int(np.argmin(np.abs(np.log(values[places]) - np.log(start))))
    good = figures.causes[places] == CAUSES.index(Cause.ACCURATE)
    low, high = middle, middle
    while low > 0 and good[low - 1]:
        low -= 1
    while high < len(places) - 1 and good[high + 1]:
        high += 1
    before = int(places[low - 1]) if low > 0 else -1
    after = int(places[high + 1]) if high < len(places) - 1 else -1
    inside = places[low : high + 1]
    return Reach(
        axis.name, axis.unit, figures.form, figures.precision, float(usual[axis.column]),
        float(values[places[low]]), float(values[places[high]]),
        _end(entry, figures, model, before), _end(entry, figures, model, after),
        float(figures.backward[inside].max()),
    )  # fmt: skip


def _end(entry: Visited, figures: Figures, model: Model, index: int) -> End:
    """What breaks at a point of a line; nothing where there is no point any more."""
    if index < 0:
        return End(Cause.ACCURATE, "")
    cause = figures.cause(index)
    code, point = model.program("forward_dynamics"), entry.walk.points[index : index + 1]
    events = trace(code, point, PRECISIONS[figures.precision])
    known = {
        Cause.OVERFLOW: events.broken, Cause.RANGE: events.broken,
        Cause.UNDERFLOW: events.underflow,
    }  # fmt: skip
    node = int(known[cause][0]) if cause in known else -1
    return End(cause, describe(code, node, model.entries) if node >= 0 else "")
