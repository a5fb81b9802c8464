"""States at which a binary is looked at: ordinary, wide, beside quarter turns, extreme, no numbers.

    ordinary    +-[0.1, 10]                          wide      +-10^e,  e in [-6, 6]
    turns       k pi/2 +- 10^e,  e in [-15, -1]      extreme   +-10^e,  e to the ends of the type
    zeros       some entries 0                       wild      some entries infinite or no number

Quantities that are declared positive are positive, but for zeros. An ordinary step of time is a
thousandth of that: a long one turns angles by thousands of radians, where nothing is enclosed.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from sympy import Symbol

SEED = 11
ORDINARY = {"h": 1e-3}
"""Ordinary size of a group, where it is not 1."""
ENDS = {"double": 307.0, "float": 37.0}
TYPES: dict[str, type[np.floating]] = {"double": np.float64, "float": np.float32}

STRATA = ("ordinary", "wide", "turns", "extreme", "zeros", "wild")
FINITE = 5
"""Of the strata, the first ones hold numbers only."""

Columns = dict[str, NDArray[np.floating]]


@dataclass(frozen=True)
class States:
    """N states.

    Attributes
    ----------
    columns : mapping of str to array
        N x entries, by name of the input.
    stratum : array of int
        Place among `STRATA`.
    """

    columns: Columns
    stratum: NDArray[np.int64]


def states(
    groups: Sequence[tuple[str, int]],
    symbols: dict[str, Sequence[Symbol]],
    kind: str,
    each: int,
) -> States:
    """The same states every time.

    Parameters
    ----------
    groups : sequence of (str, int)
        Names and sizes of the inputs.
    symbols : mapping of str to sequence of Symbol
        Their signs; inputs without symbols have any.
    kind : ``"double"`` or ``"float"``
    each : int
        States of each stratum.
    """
    random = np.random.default_rng(SEED)
    stratum = np.repeat(np.arange(len(STRATA)), each)
    columns: Columns = {}
    for name, size in groups:
        signs = [bool(symbol.is_nonnegative) for symbol in symbols.get(name, ())]
        entries = [
            _entry(random, stratum, kind, i < len(signs) and signs[i], ORDINARY.get(name, 1.0))
            for i in range(size)
        ]
        columns[name] = np.stack(entries, axis=1) if entries else np.zeros((len(stratum), 0))
    return States(columns, stratum)


def _entry(
    random: np.random.Generator, stratum: NDArray[np.int64], kind: str, positive: bool, size: float
) -> NDArray[np.floating]:
    n = len(stratum)
    end = ENDS[kind]
    sign = np.ones(n) if positive else random.choice((-1.0, 1.0), n)
    ordinary = sign * size * 10 ** random.uniform(-1, 1, n)
    wide = sign * 10 ** random.uniform(-6, 6, n)
    offset = 10 ** random.uniform(-15 if kind == "double" else -7, -1, n)
    turns = sign * (random.integers(0, 9, n) * (np.pi / 2) + random.choice((-1.0, 1.0), n) * offset)
    turns = np.abs(turns) if positive else turns
    extreme = sign * 10 ** (random.uniform(-end, end, n) * random.choice((0.1, 0.5, 1.0), n))
    extreme = np.where(random.random(n) < 0.5, extreme, ordinary)
    zeros = np.where(random.random(n) < 0.4, 0.0, ordinary)
    odd = random.choice((np.inf, -np.inf, np.nan), n)
    wild = np.where(random.random(n) < 0.2, odd, ordinary)
    with np.errstate(over="ignore"):
        chosen = np.choose(stratum, (ordinary, wide, turns, extreme, zeros, wild))
        result: NDArray[np.floating] = chosen.astype(TYPES[kind])
    return result
