"""Unknowns of a small linear system, one after the other, as quotients of polynomials.

    x_j = det(K_j with its first column replaced by k_j) / det K_j,       K_j = K[j:, j:]
    k_j = k[j:] - sum_(i < j) K[j:, i] x_i

for an order of the unknowns; what numerator and denominator have in common is cancelled. Nothing is
eliminated that has to be computed: K_j and k_j hold the x_i before as symbols.
"""

from collections.abc import Hashable, Sequence
from dataclasses import dataclass

import sympy
from flint import fmpq_mpoly
from sympy import Expr, Matrix, Symbol

from mechanics.compiled.forms.coefficient import Coefficient, coefficient
from mechanics.kernel.ring import TooLarge
from mechanics.symbolic.canonical_back import generator_expression, terms
from mechanics.symbolic.canonical_poly import Reader, reader

MOST = 3
"""Unknowns up to which determinants are written out."""

LARGEST = 32
"""Terms of all quotients up to which it pays."""

CLOSE = 1.5
"""Orders with more terms than the shortest times this are not worth a search."""

Polynomial = tuple[tuple[tuple[Expr, ...], Coefficient], ...]
"""Factors, in which a power is repeated, and coefficient of each term."""


@dataclass(frozen=True)
class Quotient:
    """``unknown = above / below``, scaled and sorted so that equal ones look equal."""

    unknown: Symbol
    above: Polynomial
    below: Polynomial


def quotients(
    left: Matrix, right: Matrix, unknowns: Sequence[Symbol], definite: bool
) -> tuple[tuple[Quotient, ...], ...]:
    """K x = k solved in every order of the unknowns in which no pivot can vanish.

    Parameters
    ----------
    left, right : Matrix
        K, n x n, and k, n x 1.
    definite : bool
        Whether K is positive definite, so that every det K_j is positive.

    Raises
    ------
    TooLarge
        If there are too many unknowns, or terms in every order.
    """
    n = left.rows
    if n > MOST:
        raise TooLarge(f"{n} unknowns, determinants of at most {MOST} are written out")
    read, polynomials = reader([*left, *right, *unknowns])
    if sum(map(len, polynomials)) > LARGEST:
        raise TooLarge(f"more than {LARGEST} terms")
    system = _System(
        read,
        [polynomials[i * n : (i + 1) * n] for i in range(n)],
        polynomials[n * n : n * n + n],
        polynomials[n * n + n :],
    )
    if not all(_plain(key) for key in read.ring.keys.values()):
        raise TooLarge("roots or quotients inside")
    found = []
    for start in range(n):
        # Leaves first or last: each unknown in front once, the rest in their order.
        order = (start, *(i for i in range(n) if i != start))
        solved = system.solved(order, unknowns, definite)
        size = sum(len(q.above) + len(q.below) for q in solved)
        if solved and size <= LARGEST:
            found.append((size, solved))
    if not found:
        raise TooLarge(f"more than {LARGEST} terms, or pivots that may vanish")
    least = min(size for size, _ in found)
    return tuple(solved for size, solved in found if size <= CLOSE * least)


@dataclass(frozen=True)
class _System:
    """K x = k in polynomials of one ring, in which the x are generators too."""

    read: Reader
    left: list[list[fmpq_mpoly]]
    right: list[fmpq_mpoly]
    unknowns: list[fmpq_mpoly]

    def solved(
        self, order: Sequence[int], unknowns: Sequence[Symbol], definite: bool
    ) -> tuple[Quotient, ...]:
        """Quotients in this order; none where a pivot may vanish."""
        ring, found = self.read.ring, []
        for step, j in enumerate(order):
            rest, known = order[step:], order[:step]
            matrix = [[self.left[r][c] for c in rest] for r in rest]
            column = [
                self.right[r] - sum(ring.product(self.left[r][c], self.unknowns[c]) for c in known)
                for r in rest
            ]
            below = self._determinant(matrix)
            if below == 0:
                return ()
            replaced = [[value, *row[1:]] for value, row in zip(column, matrix, strict=True)]
            above = self._determinant(replaced)
            if not (step == 0 or definite or _certain(numbered(self.read, below))):
                return ()
            common = above.gcd(below) if above != 0 else below
            sides = (numbered(self.read, side // common) for side in (above, below))
            found.append(_monic(unknowns[j], *sides))
        return tuple(found)

    def _determinant(self, rows: list[list[fmpq_mpoly]]) -> fmpq_mpoly:
        ring = self.read.ring
        if not rows:
            return ring.constant(1)
        total = ring.constant(0)
        for i, row in enumerate(rows):
            minor = self._determinant([other[1:] for k, other in enumerate(rows) if k != i])
            total += (-1) ** i * ring.product(row[0], minor)
        return ring.reduced(total)


def numbered(read: Reader, polynomial: fmpq_mpoly) -> Polynomial:
    """Terms by their factors that are no numbers."""
    found: dict[tuple[Expr, ...], Expr] = {}
    for factors, number in terms(polynomial):
        parts: list[Expr] = []
        for place, power in factors:
            generator = generator_expression(read.ring, place)
            if generator.is_number:
                number = number * generator**power
            else:
                parts += [generator] * power
        key = tuple(sorted(parts, key=str))
        found[key] = found.get(key, sympy.S.Zero) + number
    kept = ((parts, coefficient(number)) for parts, number in found.items() if number != 0)
    return tuple(sorted(kept, key=lambda term: str(term[0])))


def _plain(key: Hashable) -> bool:
    """Whether a generator is a symbol, a sine or cosine, or another function: no power."""
    return not isinstance(key, Expr) or not key.has(sympy.Pow)


def _monic(unknown: Symbol, above: Polynomial, below: Polynomial) -> Quotient:
    lead = below[0][1]
    return Quotient(
        unknown,
        tuple((parts, value / lead) for parts, value in above),
        tuple((parts, value / lead) for parts, value in below),
    )


def _certain(polynomial: Polynomial) -> bool:
    """Whether a polynomial cannot vanish: terms of one sign, one of them of positive symbols."""
    signs = {value.positive for _, value in polynomial}
    positive = [all(part.is_positive for part in parts) for parts, _ in polynomial]
    even = [
        all(part.is_positive or parts.count(part) % 2 == 0 for part in parts)
        for parts, _ in polynomial
    ]
    return len(signs) == 1 and any(positive) and all(even)
