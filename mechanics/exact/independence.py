"""The first rows of a matrix that are linearly independent as functions.

The pivot columns of the transposed matrix at a random point of a finite field. Rows independent at
one point are independent as functions, so what is returned is certain; that no more are is certain
but for the chance of an unlucky point, which is below 2^-90 for degrees up to 2^20.
"""

from collections.abc import Callable, Sequence
from random import Random

import sympy

from mechanics.exact.arithmetic import Arithmetic
from mechanics.exact.field import FieldArithmetic
from mechanics.exact.field_linear import echelon
from mechanics.exact.field_size import Memory
from mechanics.exact.primes import pooled_prime
from mechanics.exact.signals import Inadmissible, Restart, SingularHere

BITS = 127
MOST_POINTS = 64


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
    if not rows or not len(rows[0]):
        return []
    source, memory = Random("independent rows"), Memory()
    for index in range(MOST_POINTS):
        prime = pooled_prime(BITS, index)
        a = FieldArithmetic(prime, source, memory)
        try:
            if prepare is not None:
                prepare(a)
            residues = [
                [(a.rational(0) + a.value(row[j])).residue for row in rows]
                for j in range(len(rows[0]))
            ]
        except (Restart, Inadmissible, SingularHere):
            continue
        return echelon(residues, prime)[1]
    raise Inadmissible(f"no admissible point among {MOST_POINTS} for a matrix of {len(rows)} rows")


def generic_rank(rows: Sequence[Sequence[sympy.Expr]], prepare: Prepare | None = None) -> int:
    """Rank of a matrix of expressions at almost every state, or at those that `prepare` admits."""
    return len(independent_rows(rows, prepare))
