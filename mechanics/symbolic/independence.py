"""The first rows of a matrix that are linearly independent as functions.

Rows that are independent at one point of a field are so as functions: what is returned is certain;
that no more are, but for the chance of an unlucky point, below 2^-90 for degrees up to 2^20.
"""

from collections.abc import Callable, Sequence

import sympy

from mechanics.symbolic.arithmetic import Arithmetic

Prepare = Callable[[Arithmetic], None]


def independent_rows(
    rows: Sequence[Sequence[sympy.Expr]], prepare: Prepare | None = None
) -> list[int]:
    """Indices of the first maximal set of independent rows, in order.

    Parameters
    ----------
    rows : sequence of sequence of Expr
    prepare : callable, optional
        Told the arithmetic before anything is evaluated: puts the point onto a manifold.

    Raises
    ------
    Inadmissible
        When no admissible point is found.
    """
    a = Arithmetic()
    if prepare is not None:
        prepare(a)
    return a.independent_rows([[a.value(entry) for entry in row] for row in rows])


def generic_rank(rows: Sequence[Sequence[sympy.Expr]], prepare: Prepare | None = None) -> int:
    """Rank of a matrix of expressions at almost every state, or at those that `prepare` admits."""
    return len(independent_rows(rows, prepare))
