"""Which right equation was meant: the one with the fewest different terms.

    written  ~  factor * row,      factor = rational * monomial

Every pair of a written and a right term with the same speeds and accelerations votes for the factor
that makes them equal; the factors with most votes are tried.
"""

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property

from sympy import Expr, Symbol, sin

from mechanics.blame.pieces import Origin
from mechanics.blame.terms import Monomial, Terms, difference, product, total

MOST_PAIRS = 60_000
"""Of terms that are compared; a row with more is not looked at."""

TRIED = 4
"""Factors that are tried of those with votes."""

ONE: Monomial = frozenset()

ByMotion = dict[Monomial, list[tuple[Monomial, Fraction]]]
"""Terms of an equation by the speeds and accelerations that they hold."""


@dataclass(frozen=True, eq=False)
class Candidate:
    """A right equation as terms, piece by piece.

    Attributes
    ----------
    pieces : tuple of (Origin, Terms)
    known : bool
        Whether the pieces are those of the derivation.
    """

    words: str
    pieces: tuple[tuple[Origin, Terms], ...]
    known: bool = True
    _by_motion: dict[frozenset[Symbol], ByMotion] = field(default_factory=dict)

    @cached_property
    def terms(self) -> Terms:
        """Sum of the pieces."""
        return total(terms for _, terms in self.pieces)

    def by_motion(self, moving: frozenset[Symbol]) -> ByMotion:
        """Terms by the speeds and accelerations that they hold."""
        if moving not in self._by_motion:
            terms: ByMotion = {}
            for monomial, value in self.terms.items():
                terms.setdefault(_motion(monomial, moving), []).append((monomial, value))
            self._by_motion[moving] = terms
        return self._by_motion[moving]


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


Rank = tuple[bool, Fraction | int, bool, int, int, int, int, bool]
"""Whether it is no nearer than nothing at all; terms that differ, of these their share; whether
another factor than one stands in front; accelerations that nobody wrote, those in terms that
differ; how odd the factor is, the place, the sign."""

Found = tuple[Rank, Candidate, Monomial, Fraction]


def nearest(
    written: Terms, candidates: Iterable[Candidate], moving: Collection[Symbol],
    accelerations: Collection[Symbol], count: int = 1,
) -> list[Meant]:  # fmt: skip
    """The candidates, each with a factor, that leave the fewest different terms.

    Parameters
    ----------
    moving : collection of Symbol
        Speeds, accelerations and inputs, which no factor holds.
    accelerations : collection of Symbol
        Where two are equally near, the one with the accelerations as written is meant.
    count : int
        How many are wanted.

    Returns
    -------
    list of Meant
        The nearest first, the first of equals; empty where no candidate shares a term with what
        is written.
    """
    fast, lead = frozenset(moving), frozenset(accelerations)
    best: list[Found] = []
    for place, candidate in enumerate(candidates):
        if len(best) == count and _farther(_fewest(written, candidate, fast), best[-1]):
            continue
        found = _with_factors(written, candidate, fast, lead, place, best[count - 1 :])
        best = sorted((*best, *found), key=lambda each: each[0])[:count]
        if len(best) == count and best[-1][0][:4] <= (False, 1, False, 0):
            break  # nothing is nearer than one term
    return [_meant(written, *found) for found in best]


def _meant(
    written: Terms, _: Rank, candidate: Candidate, monomial: Monomial, factor: Fraction
) -> Meant:
    pieces = tuple((o, product(t, monomial, factor)) for o, t in candidate.pieces)
    pieces = pieces if candidate.known else ()
    return Meant(candidate.words, written, product(candidate.terms, monomial, factor), pieces)


def _farther(fewest: int, found: Found) -> bool:
    """Whether so many different terms are more than those of what was found."""
    useless, left, *_ = found[0]
    return not useless and fewest > left


def _with_factors(
    written: Terms, candidate: Candidate, moving: frozenset[Symbol],
    accelerations: frozenset[Symbol], place: int, worst: Sequence[Found],
) -> Iterator[Found]:  # fmt: skip
    """A candidate with each of its likely factors."""
    right = candidate.terms
    for monomial, factor, votes in _factors(written, candidate, moving):
        # So many terms are left at least: each vote is for one that agrees.
        fewest = max(len(written), len(right)) - votes
        if not _turns(monomial) and any(_farther(fewest, other) for other in worst):
            continue
        scaled = product(right, monomial, factor)
        left = difference(written, scaled)
        if not _near(written, left, monomial):
            continue
        useless = len(left) >= len(written)
        share = Fraction(len(left), len(written) + len(right)) if useless else len(left)
        odd = _odd(monomial, factor)
        unwritten = len(_held(scaled, accelerations) - _held(written, accelerations))
        differing = sum(bool(_held({one: value}, accelerations)) for one, value in left.items())
        rank = useless, share, odd > 0, unwritten, differing, odd, place, factor < 0
        yield rank, candidate, monomial, factor


def _turns(factor: Monomial) -> bool:
    """Whether terms become others when they are multiplied: sin^2 is 1 - cos^2."""
    return any(isinstance(atom, sin) for atom, _ in factor)


def _near(written: Terms, left: Terms, factor: Monomial) -> bool:
    """Whether enough terms agree: a single one says nothing about a factor with angles in it."""
    agreeing = sum(monomial not in left for monomial in written)
    plain = all(atom.is_Symbol for atom, _ in factor)
    return agreeing > 1 or (agreeing == 1 and plain)


def _held(terms: Terms, accelerations: frozenset[Symbol]) -> set[Expr]:
    """Accelerations that terms hold."""
    return {atom for monomial in terms for atom, _ in monomial if atom in accelerations}


def _odd(monomial: Monomial, factor: Fraction) -> int:
    """How far a factor is from one; sides may be swapped."""
    return sum(abs(power) for _, power in monomial) + (abs(factor) != 1)


def _fewest(written: Terms, candidate: Candidate, moving: frozenset[Symbol]) -> int:
    """A bound of the terms that are left: only those with the same motion can agree."""
    motions = Counter(_motion(monomial, moving) for monomial in written)
    of_right = candidate.by_motion(moving)
    agreeing = sum(min(n, len(of_right.get(motion, ()))) for motion, n in motions.items())
    return max(len(written), len(candidate.terms)) - agreeing


def _factors(
    written: Terms, candidate: Candidate, moving: frozenset[Symbol]
) -> list[tuple[Monomial, Fraction, int]]:
    """Factors with most votes, and how many."""
    if len(written) * len(candidate.terms) > MOST_PAIRS:
        return []
    by_motion = candidate.by_motion(moving)
    votes: Counter[tuple[Monomial, Fraction]] = Counter()
    for monomial, value in written.items():
        for other, of_right in by_motion.get(_motion(monomial, moving), ()):
            votes[_ratio(monomial, other), value / of_right] += 1
    found = dict(votes.most_common(TRIED))
    # A sign that is wrong in one of two terms leaves one vote for either factor.
    for sign in (1, -1):
        own = ONE, Fraction(sign)
        if own in votes:
            found[own] = votes[own]
    return [(monomial, factor, count) for (monomial, factor), count in found.items()]


def _motion(monomial: Monomial, moving: frozenset[Symbol]) -> Monomial:
    return frozenset(pair for pair in monomial if pair[0] in moving)


def _ratio(one: Monomial, two: Monomial) -> Monomial:
    powers: dict[Expr, int] = dict(one)
    for atom, power in two:
        powers[atom] = powers.get(atom, 0) - power
    return frozenset((atom, power) for atom, power in powers.items() if power)
