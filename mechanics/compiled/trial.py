"""Pivots for one linear system, tried at random states.

Half of the states are ordinary ones, half as wild as those of the residual checks.
"""

import casadi as ca
import numpy as np

from mechanics.compiled.order import Order, pivot_order
from mechanics.compiled.program import program, run
from mechanics.compiled.quantities import Quantities
from mechanics.compiled.sampling import DECADES, sample

TRIALS = 64
SEED = 2


def chosen_pivots(system: ca.Function, quantities: Quantities) -> Order:
    """The order of elimination for a function that gives a square matrix and a column.

    Raises
    ------
    SingularError
        When no order solves the system at any of the states.
    """
    n, _ = system.size_out(0)
    drawn = [sample(quantities, TRIALS, SEED, decades) for decades in (1.0, DECADES)]
    groups = (np.vstack(pair) for pair in zip(*(d.groups for d in drawn), strict=True))
    left, right = run(program(system), [list(group.T) for group in groups], np.float64)
    filler = np.zeros(2 * TRIALS)
    stacked = [np.stack(np.broadcast_arrays(*e, filler)[:-1], 1) for e in (left, right)]
    # Entries come column by column.
    return pivot_order(stacked[0].reshape(-1, n, n).swapaxes(1, 2).copy(), stacked[1])
