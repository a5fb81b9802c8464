"""Accelerations at the extremes: ``extremes(equations) -> Extremes``.

points -> compiled forms, double and single -> errors against Arb -> what broke, and where
"""

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled import FORMS, Model, compile
from mechanics.compiled.trace import trace
from mechanics.equations import Equations
from mechanics.extremes.axes import axes
from mechanics.extremes.cause import CAUSES
from mechanics.extremes.domain import reaches
from mechanics.extremes.judge import Case, cause
from mechanics.extremes.measure import LOST, Errors, measure
from mechanics.extremes.points import Walk, usual, walks
from mechanics.extremes.result import (
    PRECISIONS,
    Extremes,
    Figures,
    Visited,
)
from mechanics.extremes.truth import Enclosed, Truth, truth
from mechanics.scene.system import Path

Array = NDArray[np.float64]
GROUPS = ("q", "u", "inputs", "p")


def extremes(
    equations: Equations,
    *,
    name: str = "",
    paths: Sequence[Path] = (),
    forms: Sequence[str] = (),
    compiler: str | None = "auto",
) -> Extremes:
    """Walk out along every parameter, coordinate and speed until something breaks.

    Parameters
    ----------
    equations : Equations
    name : str
        Of the system, for people; by default that of the scene.
    paths : sequence of Path
        Further points worth a visit.
    forms : sequence of str
        Forms of forward dynamics; by default all that suit the equations.
    compiler : str or None
        As for `compile`.

    Raises
    ------
    InputError
        If there is no such form, or the equations have no such one.
    ExpressionError
        If an operation of the equations has no enclosure; it is named.
    """
    default = compile(equations, compiler=compiler)
    chosen = forms or [f.name for f in FORMS if not f.unsuited(equations)]
    models = {form: compile(equations, compiler=compiler, form=form) for form in chosen}
    known = default.quantities
    entries = [e for group in GROUPS for e in getattr(known, group)]
    judge = truth(equations, [entry.symbol for entry in entries])
    visited = tuple(_visit(judge, models, walk) for walk in _cut(models, walks(known, paths)))
    start = usual(known)
    return Extremes(
        system=name or equations.scene.name,
        route=equations.route,
        default=default.form,
        forms=tuple(models),
        unknowns=tuple(e.name for e in (*known.ud, *known.multipliers)),
        axes=axes(known),
        usual=tuple(start.tolist()),
        visited=visited,
        reaches=reaches(visited, axes(known), start),
        backend=default.backend,
    )


def computed(model: Model, points: Array, kind: type[np.floating]) -> Array:
    """u' and multipliers of a compiled model, N x n, as doubles."""
    known = model.quantities
    sizes = np.cumsum([len(getattr(known, group)) for group in GROUPS])
    with np.errstate(all="ignore"):
        parts = np.split(points.astype(kind), sizes[:-1], axis=1)
    found = model.evaluate("forward_dynamics", kind, **dict(zip(GROUPS, parts, strict=True)))
    return np.hstack([found["ud"], found["multipliers"]]).astype(np.float64)


def _cut(models: dict[str, Model], found: Sequence[Walk]) -> Iterator[Walk]:
    """Lines end at the first value at which no form gives a number in double precision."""
    for walk in found:
        if walk.kind != "line":
            yield walk
            continue
        alive = np.zeros(len(walk), dtype=bool)
        for model in models.values():
            alive |= np.isfinite(computed(model, walk.points, np.float64)).all(axis=1)
        dead = np.flatnonzero(~alive)
        middle = _middle(walk)
        first = max(dead[dead < middle], default=0)
        last = min(dead[dead > middle], default=len(walk) - 1)
        part = slice(int(first), int(last) + 1)
        yield Walk(walk.kind, walk.names, (walk.values[0][part],), walk.points[part])


def _middle(walk: Walk) -> int:
    """The value of a line that is nearest to one."""
    sizes = np.abs(np.array(walk.values[0]))
    with np.errstate(divide="ignore"):
        return int(np.argmin(np.abs(np.log10(sizes))))


def _visit(judge: Truth, models: dict[str, Model], walk: Walk) -> Visited:
    enclosed = [judge.at(point) for point in walk.points.tolist()]
    regular = np.array([found.solution is not None for found in enclosed])
    any_model = next(iter(models.values()))
    figures: list[Figures] = []
    for precision, kind in PRECISIONS.items():
        given = representable(walk.points, kind)
        normal = given & regular
        for name in ("mass_matrix", "forcing"):
            normal &= trace(any_model.program(name), walk.points, kind).normal
        seen: dict[tuple[int, bytes], Errors] = {}
        for form, model in models.items():
            values = computed(model, walk.points, kind)
            errors = [
                _once(seen, index, enclosed[index], row, kind) if given[index] else LOST
                for index, row in enumerate(values)
            ]
            events = trace(model.program("forward_dynamics"), walk.points, kind)
            causes = [
                cause(Case(enclosed[i], bool(given[i]), values[i], errors[i], events, i), precision)
                for i in range(len(walk))
            ]
            figures.append(
                Figures(
                    form,
                    precision,
                    np.array([e.forward for e in errors]),
                    np.array([e.relative for e in errors]),
                    np.array([e.backward for e in errors]),
                    np.array([CAUSES.index(c) for c in causes], dtype=np.int8),
                    normal & events.normal,
                )
            )
    condition = np.array([_float(e.condition) for e in enclosed])
    return Visited(walk, condition, np.array(list(map(_sensitivity, enclosed))), tuple(figures))


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


def _float(ball: object) -> float:
    return float(ball) if ball.is_finite() else float("inf")  # type: ignore[attr-defined,arg-type]


def _sensitivity(found: Enclosed) -> float:
    if found.solution is None:
        return float("inf")
    worst = 0.0
    for spread, x in zip(found.spread, found.solution, strict=True):
        if not spread.is_zero():
            worst = max(worst, _float(spread / abs(x)))
    return worst


def representable(points: Array, kind: type[np.floating]) -> NDArray[np.bool_]:
    """Whether every value of a point is zero or a normal number of the precision."""
    with np.errstate(all="ignore"):
        rounded = points.astype(kind).astype(np.float64)
    normal = (points == 0) | (np.abs(points) >= float(np.finfo(kind).tiny))
    same: NDArray[np.bool_] = ((rounded == points) & normal).all(axis=1)
    return same
