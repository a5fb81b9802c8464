"""Figures at many points: every form, in both precisions, against one enclosure a point."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from flint import arb
from numpy.typing import NDArray

from mechanics.compiled import Model
from mechanics.compiled.programs.trace import trace
from mechanics.extremes.cause import CAUSES
from mechanics.extremes.judge import Case, cause
from mechanics.extremes.measure import LOST, Errors, measure
from mechanics.extremes.points import Walk
from mechanics.extremes.result import PRECISIONS, Array, Figures, Visited
from mechanics.extremes.truth import Enclosed, Truth

GROUPS = ("q", "u", "inputs", "p")
CHUNK = 4096
"""Points whose enclosures are kept at a time."""


def survey(judge: Truth, models: Mapping[str, Model], found: Sequence[Walk]) -> tuple[Visited, ...]:
    """Figures along walks.

    Parameters
    ----------
    judge : Truth
        Of the equations that the models were compiled from.
    models : mapping of str to Model
        By form.
    """
    points = np.vstack([walk.points for walk in found])
    parts = [_part(judge, models, points[i : i + CHUNK]) for i in range(0, len(points), CHUNK)]
    whole = _Part(
        np.concatenate([part.condition for part in parts]),
        np.concatenate([part.sensitivity for part in parts]),
        tuple(_joined(group) for group in zip(*(part.figures for part in parts), strict=True)),
    )
    return tuple(_split(whole, found))


@dataclass(frozen=True, eq=False)
class _Part:
    condition: Array
    sensitivity: Array
    figures: tuple[Figures, ...]


ARRAYS = ("forward", "relative", "backward", "causes", "normal")


def _joined(group: Sequence[Figures]) -> Figures:
    arrays = {name: np.concatenate([getattr(f, name) for f in group]) for name in ARRAYS}
    return Figures(group[0].form, group[0].precision, **arrays)


def _split(whole: _Part, found: Sequence[Walk]) -> Iterator[Visited]:
    start = 0
    for walk in found:
        part = slice(start, start + len(walk))
        figures = tuple(
            Figures(f.form, f.precision, **{name: getattr(f, name)[part] for name in ARRAYS})
            for f in whole.figures
        )
        yield Visited(walk, whole.condition[part], whole.sensitivity[part], figures)
        start += len(walk)


def _part(judge: Truth, models: Mapping[str, Model], points: Array) -> _Part:
    enclosed = [judge.at(point) for point in points.tolist()]
    figures = [f for name in PRECISIONS for f in figures_at(enclosed, models, points, name)]
    condition = np.array([_float(e.condition) for e in enclosed])
    return _Part(condition, np.array(list(map(_sensitivity, enclosed))), tuple(figures))


def figures_at(
    enclosed: Sequence[Enclosed], models: Mapping[str, Model], points: Array, precision: str
) -> Iterator[Figures]:
    """Figures of every form in one precision, at points whose true values are enclosed."""
    kind = PRECISIONS[precision]
    given = representable(points, kind)
    normal = given & np.array([found.solution is not None for found in enclosed])
    any_model = next(iter(models.values()))
    for name in ("mass_matrix", "forcing"):
        normal &= trace(any_model.program(name), points, kind).normal
    seen: dict[tuple[int, bytes], Errors] = {}
    for form, model in models.items():
        values = computed(model, points, kind)
        errors = [
            _once(seen, index, enclosed[index], row, kind) if given[index] else LOST
            for index, row in enumerate(values)
        ]
        events = trace(model.program("forward_dynamics"), points, kind)
        causes = [
            cause(Case(enclosed[i], bool(given[i]), values[i], errors[i], events, i), precision)
            for i in range(len(points))
        ]
        yield Figures(
            form,
            precision,
            np.array([e.forward for e in errors]),
            np.array([e.relative for e in errors]),
            np.array([e.backward for e in errors]),
            np.array([CAUSES.index(c) for c in causes], dtype=np.int8),
            normal & events.normal,
        )


def _once(
    seen: dict[tuple[int, bytes], Errors],
    index: int,
    found: Enclosed,
    row: Array,
    kind: type[np.floating],
) -> Errors:
    """Errors of computed values; forms often agree to the last bit."""
    key = (index, row.tobytes())
    if key not in seen:
        seen[key] = measure(found, row.tolist(), kind)
    return seen[key]


def _float(ball: arb) -> float:
    return float(ball) if ball.is_finite() else float("inf")


def _sensitivity(found: Enclosed) -> float:
    """max_i spread_i / |x_i|; infinite where an unknown is zero though its terms are not."""
    if found.solution is None:
        return float("inf")
    pairs = zip(found.spread, found.solution, strict=True)
    return max((_float(s / abs(x)) for s, x in pairs if not s.is_zero()), default=0.0)


def computed(model: Model, points: Array, kind: type[np.floating]) -> Array:
    """u' and multipliers of a compiled model, N x n, as doubles.

    By the function of one state, whose operations are those of its form; that of many states has
    sines of its own, which are proved apart.
    """
    known = model.quantities
    sizes = np.cumsum([len(getattr(known, group)) for group in GROUPS])
    with np.errstate(all="ignore"):
        parts = np.split(points.astype(kind), sizes[:-1], axis=1)
    cells = [np.ascontiguousarray(part) for part in parts]
    found = model.kernel("forward_dynamics", kind)(cells, len(points))
    return np.hstack(found).astype(np.float64)


def representable(points: Array, kind: type[np.floating]) -> NDArray[np.bool_]:
    """Whether every value of a point is zero or a normal number of the precision."""
    with np.errstate(all="ignore"):
        rounded = points.astype(kind).astype(np.float64)
    normal = (points == 0) | (np.abs(points) >= float(np.finfo(kind).tiny))
    same: NDArray[np.bool_] = ((rounded == points) & normal).all(axis=1)
    return same
