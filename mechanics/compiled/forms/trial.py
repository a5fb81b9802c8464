"""Pivots for one linear system, and how well a solution of it rounds, tried at random states.

Half of the states are ordinary ones, half as wild as those of the residual checks.
"""

from functools import lru_cache

import casadi as ca
import numpy as np
from sympy import Add, Symbol

from mechanics.compiled.forms.order import Array, Order, pivot_order
from mechanics.compiled.programs.program import Program, program, run
from mechanics.compiled.quantities import Quantities
from mechanics.compiled.sampling import DECADES, sample
from mechanics.compiled.terms import ExtendedTerms, extended_terms
from mechanics.equations import Equations
from mechanics.exact import canonical

TRIALS = 64
SEED = 2

WILD = 20_000
"""Wild states at which a form has to give numbers at all: few of them show what is missing."""

LOST = 1e8
"""Roundings that a number counts for which single precision cannot give."""

RANGE = float(np.finfo(np.float32).max)


def chosen_pivots(system: ca.Function, quantities: Quantities) -> Order:
    """The order of elimination for a function that gives a square matrix and a column.

    Raises
    ------
    SingularError
        When no order solves the system at any of the states.
    """
    n, _ = system.size_out(0)
    left, right = run(program(system), _states(quantities), np.float64)
    filler = np.zeros(2 * TRIALS)
    stacked = [np.stack(np.broadcast_arrays(*e, filler)[:-1], 1) for e in (left, right)]
    # Entries come column by column.
    return pivot_order(stacked[0].reshape(-1, n, n).swapaxes(1, 2).copy(), stacked[1])


def largest_error(solution: ca.Function, equations: Equations, quantities: Quantities) -> float:
    """Largest residual of a row of K x = k at the states that are tried, for a function x.

    In units of epsilon times the sum of the magnitudes of the row's terms, in normal form; at least
    `LOST` where a precision has no number for what is in its range, at many more states.
    """
    states, code = _states(quantities), program(solution)
    (x,) = run(code, states, np.float64)
    entries = (quantities.q, quantities.u, quantities.inputs, quantities.p)
    symbols = [entry.symbol for group in entries for entry in group]
    columns = [*(column for group in states for column in group), *x]
    columns = list(np.broadcast_arrays(*columns, np.zeros(2 * TRIALS)))[:-1]
    eps = float(np.finfo(float).eps)
    error = max(float(row.ratios(columns, eps).max()) for row in _rows(equations, tuple(symbols)))
    return max(error, LOST) if error < LOST and _lost(code, quantities) else error


def _lost(code: Program, quantities: Quantities) -> bool:
    """Whether a number is missing at a state where none is out of the range of the precision."""
    drawn = sample(quantities, WILD, SEED).rounded(np.float32)
    states = [list(group.T) for group in drawn.groups]
    with np.errstate(all="ignore"):
        (double,) = run(code, states, np.float64)
        (single,) = run(code, states, np.float32)
    missing, absent = (
        np.any([~np.isfinite(np.broadcast_to(entry, WILD)) for entry in group], axis=0)
        for group in (single, double)
    )
    within = np.all([np.abs(np.broadcast_to(entry, WILD)) < RANGE for entry in double], axis=0)
    return bool(np.any(absent | (missing & within)))


@lru_cache(maxsize=4)
def _rows(equations: Equations, symbols: tuple[Symbol, ...]) -> list[ExtendedTerms]:
    """Terms of K x - k, row by row, in normal form."""
    left, right = equations.system
    found = []
    for i in range(left.rows):
        row = [
            term * x
            for entry, x in zip(left[i, :], equations.unknowns, strict=True)
            for term in Add.make_args(canonical(entry))
            if term != 0
        ]
        row += [-term for term in Add.make_args(canonical(right[i])) if term != 0]
        found.append(extended_terms(row, [*symbols, *equations.unknowns]))
    return found


def _states(quantities: Quantities) -> list[list[Array]]:
    """For every group of the state, for every entry, its values."""
    drawn = [sample(quantities, TRIALS, SEED, decades) for decades in (1.0, DECADES)]
    groups = (np.vstack(pair) for pair in zip(*(d.groups for d in drawn), strict=True))
    return [list(group.T) for group in groups]
