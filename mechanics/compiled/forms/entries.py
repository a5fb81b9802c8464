"""Entries of a linear system as polynomials that are nested together, ready for elimination.

    K = [[M + m, M L c / 2], [M L c / 2, M L^2 / 3]]     ->     v = M L,  K_12 = v (c / 2),  ...

What cancels has cancelled in the normal form, and what entries share is computed once, also where
the expressions of a route do not show it.
"""

from functools import lru_cache

from sympy import ImmutableMatrix

from mechanics.compiled.forms.closed import Polynomial, numbered
from mechanics.compiled.forms.graph import Decide, Written, search, written
from mechanics.compiled.forms.horner import ONE, Choice, Nest, Table
from mechanics.kernel.ring import TooLarge
from mechanics.symbolic.canonical_poly import reader

LARGEST = 3000
"""Terms of all entries up to which it pays."""

WORK = 3000
"""Terms that a search may write down, all trials together."""

STARTS = 3


@lru_cache(maxsize=64)
def nested_entries(left: ImmutableMatrix, right: ImmutableMatrix) -> Written:
    """The entries of (K | k) that are not zero, by their places (i, j).

    Raises
    ------
    TooLarge
        If they have too many terms.
    """
    polynomials = entry_polynomials(left, right)
    columns = left.cols + right.cols
    size = sum(map(len, polynomials))
    table = Table()
    terms = {
        divmod(place, columns): table.terms(polynomial)
        for place, polynomial in enumerate(polynomials)
        if polynomial
    }
    unit = ((1, ONE, ()),)

    def write(decide: Decide) -> Written:
        nest = Nest(table, Choice(lambda factor: decide("rank", factor), lambda number: False))
        return written(
            nest, {at: nest.quotient(above, unit, ONE, False) for at, above in terms.items()}
        )

    trials = WORK // (STARTS * (size + 1))
    return min(
        (search(write, seed, trials, trials) for seed in range(STARTS)), key=lambda way: way.cost
    )


@lru_cache(maxsize=64)
def entry_polynomials(left: ImmutableMatrix, right: ImmutableMatrix) -> tuple[Polynomial, ...]:
    """The entries of (K | k), row by row, as polynomials.

    Raises
    ------
    TooLarge
        If they have too many terms.
    """
    read, polynomials = reader([*left.row_join(right)])
    reduced = [read.ring.reduced(polynomial) for polynomial in polynomials]
    if sum(map(len, reduced)) > LARGEST:
        raise TooLarge(f"{sum(map(len, reduced))} terms")
    return tuple(numbered(read, polynomial) for polynomial in reduced)
