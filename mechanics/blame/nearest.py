"""Which right equation was meant: the one that leaves the fewest different terms.

    written  ~  factor * row,      factor = rational * monomial

Every pair of a written and a right term with the same speeds and accelerations votes for the factor
that makes them equal; the factors with most votes are tried.
"""

from collections import Counter
from collections.abc import Collection, Iterable
from dataclasses import dataclass
from fractions import Fraction

from sympy import Expr, Symbol

from mechanics.blame.pieces import Origin
from mechanics.blame.terms import Monomial, Terms, difference, product, total

MOST_PAIRS = 60_000
"""Of terms that are compared; a row with more is not looked at."""

TRIED = 4
"""Factors that are tried of those with votes."""

ONE: Monomial = frozenset()


@dataclass(frozen=True)
class Candidate:
    """A right equation as terms, piece by piece.

    Attributes
    ----------
    words : str
    pieces : tuple of (Origin, Terms)
    """

    words: str
    pieces: tuple[tuple[Origin, Terms], ...]

    @property
    def terms(self) -> Terms:
        """Sum of the pieces."""
        return total(terms for _, terms in self.pieces)


@dataclass(frozen=True)
class Meant:
    """The right equation that is nearest to what is written.

    Attributes
    ----------
    words : str
        Which equation it is.
    written, right : Terms
        Both without denominators, and of the same scale.
    pieces : tuple of (Origin, Terms)
        They sum to `right`; none where they are not known.
    multiplied : bool
        Whether denominators of what was written were multiplied out.
    """

    words: str
    written: Terms
    right: Terms
    pieces: tuple[tuple[Origin, Terms], ...]
    multiplied: bool = False

    @property
    def different(self) -> Terms:
        """Written less right."""
        return difference(self.written, self.right)


Rank = tuple[int, int, int, int, bool]


def nearest(
    written: Terms, candidates: Iterable[Candidate], moving: Collection[Symbol],
    accelerations: Collection[Symbol],
) -> Meant | None:  # fmt: skip
    """The candidate and its factor that leave the fewest different terms; the first of equals.

    Parameters
    ----------
    written : Terms
    candidates : iterable of Candidate
    moving : collection of Symbol
        Speeds, accelerations and inputs, which no factor holds.
    accelerations : collection of Symbol
        Where two are equally near, the one with the accelerations as written is meant.

    Returns
    -------
    Meant or None
        None where no candidate shares a term with what is written.
    """
    best: tuple[Rank, Meant] | None = None
    for place, candidate in enumerate(candidates):
        right = candidate.terms
        for monomial, factor in _factors(written, right, set(moving)):
            scaled = product(right, monomial, factor)
            left = difference(written, scaled)
            if not _near(written, left, monomial):
                continue
            rank = (
                len(left), _held(left, accelerations), _odd(monomial, factor), place, factor < 0
            )  # fmt: skip
            if best is None or rank < best[0]:
                pieces = tuple((o, product(t, monomial, factor)) for o, t in candidate.pieces)
                best = rank, Meant(candidate.words, written, scaled, pieces)
    return None if best is None else best[1]


def _near(written: Terms, left: Terms, factor: Monomial) -> bool:
    """Whether enough terms agree: a single one says nothing about a factor with angles in it."""
    agreeing = sum(monomial not in left for monomial in written)
    plain = all(atom.is_Symbol for atom, _ in factor)
    return agreeing > 1 or (agreeing == 1 and plain)


def _held(terms: Terms, accelerations: Collection[Symbol]) -> int:
    return sum(any(atom in accelerations for atom, _ in monomial) for monomial in terms)


def _odd(monomial: Monomial, factor: Fraction) -> int:
    """How far a factor is from one; sides may be swapped."""
    return sum(abs(power) for _, power in monomial) + (abs(factor) != 1)


def _factors(written: Terms, right: Terms, moving: set[Symbol]) -> list[tuple[Monomial, Fraction]]:
    if len(written) * len(right) > MOST_PAIRS:
        return []
    by_motion: dict[Monomial, list[tuple[Monomial, Fraction]]] = {}
    for monomial, value in right.items():
        by_motion.setdefault(_motion(monomial, moving), []).append((monomial, value))
    votes: Counter[tuple[Monomial, Fraction]] = Counter()
    for monomial, value in written.items():
        for other, of_right in by_motion.get(_motion(monomial, moving), ()):
            votes[_ratio(monomial, other), value / of_right] += 1
    found = [factor for factor, _ in votes.most_common(TRIED)]
    # A sign that is wrong in one of two terms leaves one vote for either factor.
    found += [(ONE, Fraction(sign)) for sign in (1, -1) if (ONE, Fraction(sign)) in votes]
    return list(dict.fromkeys(found))


def _motion(monomial: Monomial, moving: set[Symbol]) -> Monomial:
    return frozenset(pair for pair in monomial if pair[0] in moving)


def _ratio(one: Monomial, two: Monomial) -> Monomial:
    powers: dict[Expr, int] = dict(one)
    for atom, power in two:
        powers[atom] = powers.get(atom, 0) - power
    return frozenset((atom, power) for atom, power in powers.items() if power)
