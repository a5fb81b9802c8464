"""The points that are visited: along lines, over pairs, along paths, and anywhere.

line    one quantity by decades, the rest as usual
pair    two quantities over a grid
path    several parameters at once, as a system's file asks for
mixed   every quantity at random among its values
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from math import ceil, prod, sqrt

import numpy as np
from numpy.typing import NDArray
from sympy import Expr, Rational, Symbol

from mechanics.compiled.quantities import DIGITS, Quantities
from mechanics.errors import ValueMissingError
from mechanics.extremes.axes import Axis, axes
from mechanics.scene.system import Path

Array = NDArray[np.float64]

PAIRED = 12_000
"""About how many points all the pairs of a system may take together."""
SIDES = (3, 19)
MIXED = 2_000
SEED = 4

USUAL = {"q": 0.45, "u": 0.75, "inputs": 0.5}
SPREAD = 0.21


@dataclass(frozen=True, eq=False)
class Walk:
    """Points that belong together.

    Attributes
    ----------
    kind : str
        ``"line"``, ``"pair"``, ``"path"`` or ``"mixed"``.
    names : tuple of str
        What is varied: one name, two, the label of a path, or nothing.
    values : tuple of tuple of float
        For a line or pair the values of each name; the last one varies fastest.
    points : array, N x quantities
    """

    kind: str
    names: tuple[str, ...]
    values: tuple[tuple[float, ...], ...]
    points: Array

    def __len__(self) -> int:
        return len(self.points)

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of values of each name."""
        return tuple(map(len, self.values))


def usual(quantities: Quantities) -> Array:
    """An ordinary state and the typical parameters, rounded to single precision."""
    state = [
        USUAL[group] + SPREAD * i
        for group in ("q", "u", "inputs")
        for i in range(len(getattr(quantities, group)))
    ]
    state += [_typical(quantities, i) for i in range(len(quantities.p))]
    return np.array(state, dtype=np.float32).astype(np.float64)


def _typical(quantities: Quantities, index: int) -> float:
    try:
        return quantities.typical[index]
    except ValueMissingError:
        return 1.0


def walks(
    quantities: Quantities, paths: Sequence[Path] = (), paired: int = PAIRED
) -> tuple[Walk, ...]:
    """Every walk through the values of a model's quantities, pairs in about `paired` points."""
    base, every = usual(quantities), axes(quantities)
    side = _side(len(every), paired)
    return (
        *(_grid("line", base, (axis,), (axis.walked,)) for axis in every),
        *(
            _grid("pair", base, pair, tuple(axis.thinned(side) for axis in pair))
            for pair in combinations(every, 2)
        ),
        *_paths(quantities, base, paths),
        _mixed(base, every),
    )


def _side(count: int, paired: int) -> int:
    pairs = max(1, count * (count - 1) // 2)
    return min(max(ceil(sqrt(paired / pairs)), SIDES[0]), SIDES[1])


def _grid(
    kind: str, base: Array, varied: Sequence[Axis], values: Sequence[tuple[float, ...]]
) -> Walk:
    points = np.tile(base, (prod(map(len, values)), 1))
    for axis, grid in zip(varied, np.meshgrid(*values, indexing="ij"), strict=True):
        points[:, axis.column] = grid.ravel()
    return Walk(kind, tuple(axis.name for axis in varied), tuple(values), points)


def _mixed(base: Array, every: Sequence[Axis]) -> Walk:
    random = np.random.default_rng(SEED)
    columns = [random.choice(axis.paired, MIXED) for axis in every]
    return Walk("mixed", (), (), np.stack(columns, axis=1) if every else base[None, :])


def _paths(quantities: Quantities, base: Array, paths: Sequence[Path]) -> Iterator[Walk]:
    groups = (quantities.q, quantities.u, quantities.inputs, quantities.p)
    symbols = [entry.symbol for group in groups for entry in group]
    columns = {symbol.name: i for i, symbol in enumerate(symbols)}
    for path in paths:
        points = np.tile(base, (len(path.values), 1))
        for row, value in zip(points, path.values, strict=True):
            known = dict(zip(symbols, base.tolist(), strict=True)) | {path.along: value}
            for name, expression in path.sets:
                row[columns[name]] = _number(expression.xreplace(_exact(known)))
        yield Walk("path", (path.label,), (tuple(map(float, path.values)),), points)


def _exact(known: dict[Symbol, float]) -> dict[Symbol, Expr]:
    return {s: Rational(*float(v).as_integer_ratio()) for s, v in known.items()}


def _number(expression: Expr) -> float:
    return float(expression.evalf(DIGITS))
