"""Which adaptive method is faster for a program, by counted operations on vectors.

    Taylor    s n (n + 1) / 2 + 2 n a           a step of order n: s sums of products, a operations
    DOP853    12 (a + 40 w + 10 d) + 74 m       12 evaluations with w pairs of sine and cosine and
                                                d divisions, and sums of slopes for m entries

For the same error DOP853 takes more steps, the more so the smaller the error. The counts of sums
are those of its tableau; the others were measured: a pair of sines costs as much as 40 operations,
a division as 10; series that do not fit into the first cache take twice as long; and at an error of
1e-12 in a step DOP853 takes 2.3 times the steps, as the error to the power -1/9.
"""

from functools import lru_cache

import numpy as np
from scipy.integrate import DOP853

from mechanics.errors import ExpressionError
from mechanics.program import Program
from mechanics.program.operations import COS, DIVIDE, SIN
from mechanics.program.taylor import recurrences
from mechanics.simulate.ensembles.taylor import kept, order

PAIR, DIVISION = 40, 10
SLOPES = sum(np.count_nonzero(a) for a in (DOP853.A, DOP853.B, DOP853.E3, DOP853.E5))
CACHE, BYTES = 48 * 1024, 128
MORE_STEPS, AT = 2.3, 1e-12


@lru_cache(maxsize=64)
def best(program: Program, state: tuple[str, ...], share: float) -> str:
    """``"taylor"`` or ``"dop853"``.

    Parameters
    ----------
    program : Program
        The right-hand side.
    state : tuple of str
        Its inputs that move.
    share : float
        Relative error that a step may make.
    """
    try:
        rules = recurrences(program, state)
    except ExpressionError:
        return "dop853"
    n = order(share)
    series = rules.convolutions * n * (n + 1) / 2 + 2 * n * program.count
    if sum(map(len, kept(rules.steps, len(state)))) * (n + 1) * BYTES > CACHE:
        series *= 2
    ratio = MORE_STEPS * (AT / share) ** (1 / 9)
    return "taylor" if series < ratio * _dop853(program) else "dop853"


def _dop853(program: Program) -> float:
    waves = (k for k, code in enumerate(program.operations) if code in (SIN, COS))
    angles = {program.operands_of(k) for k in waves}
    divisions = program.operations.count(DIVIDE)
    one = program.count + PAIR * len(angles) + DIVISION * divisions
    return DOP853.n_stages * one + SLOPES * len([*program.roots])
