"""The map as JSON, and any figure of it computed anew.

    walk  ->  values of what is varied, hexadecimal  ->  point  ->  figures

Lines and pairs name their values, the last name varying fastest; all other quantities are as usual.
Paths and mixed points are written out. Figures have three digits; null stands for no number. A
cause is a place in the list `causes`.
"""

from collections.abc import Mapping, Sequence
from math import isfinite
from typing import Any

import numpy as np

from mechanics.compiled import Model
from mechanics.extremes.cause import CAUSES
from mechanics.extremes.result import PRECISIONS, End, Extremes, Figures, Reach, Visited, tolerance
from mechanics.extremes.survey import GROUPS, figures_at
from mechanics.extremes.truth import truth

DIGITS = 3
Record = Mapping[str, Any]


def to_record(found: Extremes) -> dict[str, Any]:
    """Everything that a walk found, for `json.dumps`."""
    return {
        "system": found.system,
        "route": found.route,
        "default_form": found.default,
        "forms": list(found.forms),
        "backend": found.backend,
        "unknowns": list(found.unknowns),
        "tolerance": {precision: tolerance(precision) for precision in PRECISIONS},
        "causes": [entry.value for entry in CAUSES],
        "quantities": [
            {"name": axis.name, "unit": axis.unit, "usual": value.hex()}
            for axis, value in zip(found.axes, found.usual, strict=True)
        ],
        "domain": [_reach(reach) for reach in found.reaches],
        "walks": [_walk(visited) for visited in found.visited],
    }


def _reach(reach: Reach) -> dict[str, Any]:
    return {
        "quantity": reach.name, "unit": reach.unit,
        "form": reach.form, "precision": reach.precision,
        "low": reach.low.hex(), "high": reach.high.hex(),
        "below": _end(reach.below), "above": _end(reach.above),
        "worst_backward": rounded(reach.worst),
    }  # fmt: skip


def _end(end: End) -> dict[str, str]:
    return {"cause": end.cause.name.lower(), "where": end.where}


def _walk(visited: Visited) -> dict[str, Any]:
    walk = visited.walk
    record: dict[str, Any] = {"kind": walk.kind, "names": list(walk.names)}
    if walk.kind in ("line", "pair"):
        record["values"] = [[value.hex() for value in values] for values in walk.values]
    else:
        record["points"] = [[value.hex() for value in row] for row in walk.points.tolist()]
    record["condition"] = list(map(rounded, visited.condition.tolist()))
    record["sensitivity"] = list(map(rounded, visited.sensitivity.tolist()))
    record["figures"] = [_figures(figures) for figures in visited.figures]
    return record


def _figures(figures: Figures) -> dict[str, Any]:
    return {"form": figures.form, "precision": figures.precision, **_columns(figures)}


def _columns(figures: Figures) -> dict[str, list[Any]]:
    return {
        "forward_ulp": list(map(rounded, figures.forward.tolist())),
        "relative": list(map(rounded, figures.relative.tolist())),
        "backward_eps": list(map(rounded, figures.backward.tolist())),
        "cause": figures.causes.tolist(),
    }


def rounded(value: float) -> float | None:
    """Three digits; None for what is no number."""
    short = float(f"{value:.{DIGITS}g}")
    return short if isfinite(short) else None


def point(record: Record, walk: int, index: int) -> tuple[float, ...]:
    """The values of all quantities at one point of a record."""
    entry = record["walks"][walk]
    if "points" in entry:
        return tuple(map(float.fromhex, entry["points"][index]))
    values = [float.fromhex(quantity["usual"]) for quantity in record["quantities"]]
    names = [quantity["name"] for quantity in record["quantities"]]
    shape = tuple(map(len, entry["values"]))
    places = np.unravel_index(index, shape)
    for name, column, place in zip(entry["names"], entry["values"], places, strict=True):
        values[names.index(name)] = float.fromhex(column[int(place)])
    return tuple(values)


def reproduce(model: Model, values: Sequence[float], precision: str) -> dict[str, Any]:
    """The figures of one point, computed anew.

    Parameters
    ----------
    model : Model
        Compiled in the form in question.
    values : sequence of float
        From `point`.
    precision : str
        ``"double"`` or ``"single"``.

    Returns
    -------
    dict
        ``forward_ulp``, ``relative``, ``backward_eps`` and ``cause`` as in a record.
    """
    known = model.quantities
    symbols = [entry.symbol for group in GROUPS for entry in getattr(known, group)]
    enclosed = [truth(model.equations, symbols).at(values)]
    (found,) = figures_at(enclosed, {model.form: model}, np.array([values]), precision)
    return {name: each[0] for name, each in _columns(found).items()}
