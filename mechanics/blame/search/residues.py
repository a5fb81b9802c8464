"""Residues modulo a prime: the small fraction that one is, one over each of many.

A residue is a small fraction when the half-way remainder of Euclid's algorithm is.
"""

from collections.abc import Sequence
from fractions import Fraction
from functools import reduce

BOUND = 1 << 20
"""Of numerators and denominators: 2**41 of them among 2**127 residues are hardly met by chance."""


def rational(residue: int, p: int) -> Fraction | None:
    """The fraction n / d with n and d below the bound that a residue is, if it is one."""
    before, here = p, residue % p
    d_before, d = 0, 1
    while here >= BOUND:
        q = before // here
        before, here = here, before - q * here
        d_before, d = d, d_before - q * d
    if here == 0 or abs(d) >= BOUND:
        return Fraction(0) if residue % p == 0 else None
    return Fraction(here, d)


def others_of(values: Sequence[int], p: int) -> list[int]:
    """For every residue the product of the others."""
    before, found = 1, []
    for value in values:
        found.append(before)
        before = before * value % p
    after = 1
    for i in reversed(range(len(values))):
        found[i] = found[i] * after % p
        after = after * values[i] % p
    return found


def inverses(values: Sequence[int], p: int) -> list[int]:
    """One over each of many residues, by one division for all of them."""
    whole = pow(reduce(lambda a, b: a * b % p, values, 1), -1, p)
    return [whole * others % p for others in others_of(values, p)]
