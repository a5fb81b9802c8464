"""Pivots for one linear system, and how well a solution of it rounds, tried at drawn states.

    |K x - k|_i / s_i < WRONG          for a solution x, s_i the sum of magnitudes in row i

Half of the states are ordinary ones, half as wild as those of the residual checks. Whether x is a
solution at all is asked at ordinary states only, with K and k in numbers as they were derived.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np
from sympy import Add, S

from mechanics.compiled.forms.order import Array, Order, pivot_order
from mechanics.compiled.quantities import Quantities
from mechanics.compiled.sampling import DECADES, ordinary, sample
from mechanics.compiled.terms import CHUNK, UNIT, Terms, read_terms
from mechanics.equations import Equations
from mechanics.errors import SingularError
from mechanics.kernel.ring import TooLarge
from mechanics.program import Builder
from mechanics.program import Program as Straight
from mechanics.program.casadi_reader import read, read_routine
from mechanics.program.routine import Routine, run
from mechanics.program.running_error_domain import enclose
from mechanics.symbolic import canonical

TRIALS = 64
SEED = 2

WILD = 20_000
"""Wild states at which a form has to give numbers at all: few of them show what is missing."""

LOST = 1e8
"""Roundings that a number counts for which single precision cannot give."""

ASKED = 8
"""Ordinary states at which a form has to solve the system before it may be chosen."""

WRONG = 2.0**-26
"""Half of the digits of a double, relative to what is added up in a row.

Every right form of every system here, and of arms in space with six joints, stays below 2^-43 of
|K| |x| + |k| at these states; a wrong term leaves a share of the row that has nothing to do with
rounding. What lies in between has lost half of its digits where numbers are ordinary: no form to
choose either.
"""

RANGE = float(np.finfo(np.float32).max)


def chosen_pivots(system: ca.Function, quantities: Quantities) -> Order:
    """The order of elimination for a function that gives a square matrix and a column.

    Raises
    ------
    SingularError
        When no order solves the system at any of the states.
    """
    n, _ = system.size_out(0)
    left, right = run(read_routine(system), _states(quantities), np.float64)
    filler = np.zeros(2 * TRIALS)
    stacked = [np.stack(np.broadcast_arrays(*e, filler)[:-1], 1) for e in (left, right)]
    # Entries come column by column.
    return pivot_order(stacked[0].reshape(-1, n, n).swapaxes(1, 2).copy(), stacked[1])


def largest_error(solution: ca.Function, rows: Sequence[Terms], quantities: Quantities) -> float:
    """Largest residual of a row of K x = k at the states that are tried, for a function x.

    In units of epsilon times the sum of the magnitudes of the row's terms; at least `LOST` where a
    precision has no number for what is in its range, at many more states.
    """
    states, code = _states(quantities), read_routine(solution)
    (x,) = run(code, states, np.float64)
    columns = [*(column for group in states for column in group), *x]
    columns = list(np.broadcast_arrays(*columns, np.zeros(2 * TRIALS)))[:-1]
    eps = float(np.finfo(float).eps)
    error = max(float(row.ratios(columns, eps).max()) for row in rows)
    return max(error, LOST) if error < LOST and _lost(code, quantities) else error


@dataclass(frozen=True)
class Reference:
    """K x = k in numbers at ordinary states.

    Attributes
    ----------
    states : list of arrays
        q, u, inputs and p, entries x states.
    left, right : array
        K, states x n x n, and k, states x n.
    residual : mechanics.program.Program
        K x - k, of q, u, inputs, p and x, as it was derived.
    """

    states: list[Array]
    left: Array
    right: Array
    residual: Straight

    def solved_by(self, solution: ca.Function) -> bool:
        """Whether what a function gives is a solution at every state."""
        x = np.array(solution(*self.states))
        entries = [entry for group in (*self.states, x) for entry in group]
        inputs = {name: entries[int(name)] for name in self.residual.inputs}
        rows = [row.absolute for row in enclose(self.residual, inputs)["rows"]]
        with np.errstate(all="ignore"):
            net = np.einsum("sij,js->is", np.abs(self.left), np.abs(x)) + np.abs(self.right.T)
            for row, plain in zip(rows, net, strict=True):
                # A bound of rounding errors is as many units as there are terms to add up, also
                # where these cancel; there is none for some functions, and none of x itself.
                error = 0 if row.error is None else row.error
                size = np.maximum(np.where(np.isfinite(error), error / UNIT, 0), plain)
                # Not "or more": what is no number is no solution.
                if not np.all((row.value == 0) | (np.abs(row.value) < WRONG * size)):
                    return False
        return True


def reference(residual: ca.Function, n: int, quantities: Quantities) -> Reference:
    """K and k from K x - k, a function of the state and x: its columns are those of unit vectors.

    Raises
    ------
    SingularError
        When K and k are numbers at none of the states.
    """
    drawn = ordinary(quantities, TRIALS, SEED)
    states = [group.T for group in drawn.groups]
    rest = np.array(residual(*states, np.zeros((n, TRIALS)))).T
    columns = [
        np.array(residual(*states, np.repeat(unit[:, None], TRIALS, axis=1))).T - rest
        for unit in np.eye(n)
    ]
    left = np.stack(columns, axis=2)
    finite = np.isfinite(left).all(axis=(1, 2)) & np.isfinite(rest).all(axis=1)
    asked = np.flatnonzero(finite)[:ASKED]
    if not asked.size:
        raise SingularError(
            f"M and f are numbers at none of {TRIALS} states: does something divide by zero?"
        )
    held = [group[:, asked] for group in states]
    return Reference(held, left[asked], -rest[asked], _straight(residual))


def _straight(residual: ca.Function) -> Straight:
    """The program of a function; its inputs are numbered through."""
    builder, arguments, count = Builder(), {}, 0
    for i in range(residual.n_in()):
        size = residual.numel_in(i)
        arguments[residual.name_in(i)] = [builder.input(str(count + k)) for k in range(size)]
        count += size
    (rows,) = read(builder, residual, arguments).values()
    return builder.program({"rows": rows})


def _lost(code: Routine, quantities: Quantities) -> bool:
    """Whether a number is missing at a state where none is out of the range of the precision."""
    drawn = sample(quantities, WILD, SEED).rounded(np.float32)
    return any(
        _missing(code, [list(group[i : i + CHUNK].T) for group in drawn.groups])
        for i in range(0, WILD, CHUNK)
    )


def _missing(code: Routine, states: list[list[Array]]) -> bool:
    count = max((len(entry) for group in states for entry in group), default=1)
    with np.errstate(all="ignore"):
        (double,) = run(code, states, np.float64)
        (single,) = run(code, states, np.float32)
    missing, absent = (
        np.any([~np.isfinite(np.broadcast_to(entry, count)) for entry in group], axis=0)
        for group in (single, double)
    )
    within = np.all([np.abs(np.broadcast_to(entry, count)) < RANGE for entry in double], axis=0)
    return bool(np.any(absent | (missing & within)))


def terms(equations: Equations, quantities: Quantities) -> list[Terms]:
    """Terms of K x - k, row by row, in normal form where that is small."""
    groups = (quantities.q, quantities.u, quantities.inputs, quantities.p)
    symbols = [entry.symbol for group in groups for entry in group]
    left, right = equations.system
    unknowns = (*equations.unknowns, S.NegativeOne)
    entries = [[*left[i, :], right[i]] for i in range(left.rows)]
    try:
        simple = [[canonical(entry) for entry in row] for row in entries]
    except TooLarge:
        # One that is too large tells that the others are: each of them takes as long to find out.
        simple = entries
    return [
        read_terms(
            [
                term * x
                for entry, x in zip(row, unknowns, strict=True)
                for term in Add.make_args(entry)
                if term != 0
            ],
            [*symbols, *equations.unknowns],
        )
        for row in simple
    ]


def _states(quantities: Quantities) -> list[list[Array]]:
    """For every group of the state, for every entry, its values."""
    drawn = [sample(quantities, TRIALS, SEED, decades) for decades in (1.0, DECADES)]
    groups = (np.vstack(pair) for pair in zip(*(d.groups for d in drawn), strict=True))
    return [list(group.T) for group in groups]
