"""Which columns of a matrix over a field are linearly independent.

Columns that are independent at one point of a field are so as functions: what is returned is
certain. That no more are holds but for the chance of an unlucky point, below 2^-90 for degrees up
to 2^20. This chooses rows and pivots; it makes no verdict.
"""

from flint import fmpz_mod_ctx, fmpz_mod_mat


def pivot_columns(rows: list[list[int]], p: int) -> list[int]:
    """Pivot columns of a matrix of residues modulo p."""
    if not rows:
        return []
    reduced, rank = fmpz_mod_mat(rows, fmpz_mod_ctx(p)).rref()
    return [next(c for c in range(reduced.ncols()) if reduced[i, c] != 0) for i in range(rank)]
