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

import casadi as ca
import numpy as np
from scipy.integrate import DOP853

from mechanics.compiled.programs.program import DIVISIONS, Program
from mechanics.errors import ExpressionError
from mechanics.simulate.ensembles.recurrences import Recurrences
from mechanics.simulate.ensembles.taylor import order

PAIR, DIVISION = 40, 10
SLOPES = sum(np.count_nonzero(a) for a in (DOP853.A, DOP853.B, DOP853.E3, DOP853.E5))
CACHE, BYTES = 48 * 1024, 128
MORE_STEPS, AT = 2.3, 1e-12


@lru_cache(maxsize=64)
def best(code: Program, share: float) -> str:
    """``"taylor"`` or ``"dop853"``.

    Parameters
    ----------
    code : Program
        The right-hand side.
    share : float
        Relative error that a step may make.
    """
    try:
        rules = Recurrences(code)
    except ExpressionError:
        return "dop853"
    n = order(share)
    series = rules.convolutions * n * (n + 1) / 2 + 2 * n * code.operations
    if rules.rows * (n + 1) * BYTES > CACHE:
        series *= 2
    ratio = MORE_STEPS * (AT / share) ** (1 / 9)
    return "taylor" if series < ratio * _dop853(code) else "dop853"


def _dop853(code: Program) -> float:
    angles = {n.operands for n in code.nodes if n.operation in (ca.OP_SIN, ca.OP_COS)}
    divisions = sum(node.operation in DIVISIONS for node in code.nodes)
    one = code.operations + PAIR * len(angles) + DIVISION * divisions
    return DOP853.n_stages * one + SLOPES * len(code.outputs[0])
