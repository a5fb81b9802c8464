"""Points are drawn until the chance of error is below the target, or a point says no.

The bound is that of `field`, equation (1). One point is enough if the prime is long enough; the
first run measures degree and height, and the prime is chosen by them.

Square roots need one more thought. If a radicand x is a square y**2 of the field of fractions, the
real root is |y|, but the field takes y or -y, whichever is a square modulo p. At a random point and
prime the quadratic characters of s such y take every combination that is consistent, with a chance
of at least 2**-s (Weil's bound for character sums; Chebotarev for constants), among them the
combination of the real signs. So a false statement survives k points with a chance of at most

    (1 - 2**-s + 2**-30)**k.                                                                  (1)

Which radicands are squares need not be known: one that is seen to be a non-residue, all earlier
ones being residues, is none, because then y would have to exist at that point. Probes, where
positive symbols and signs of roots are free, expose nearly all of them. s counts the roots from the
first one that is left, mostly none: those behind it may have been exposed by its wrong sign.

|x| and comparisons are first taken for unknown functions of x, which needs one point only but knows
no more than |-x| = |x|. If that says no, |x| is read as sqrt(x**2), and ``x < 0`` as |x| = -x; each
such x, and then every root, counts in s. Boundaries of cases (x = 0) are not looked at then.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from math import ceil, inf, isfinite, log, log2
from typing import Any

from mechanics.exact.arithmetic import Arithmetic
from mechanics.exact.field import FieldArithmetic
from mechanics.exact.field_size import Memory
from mechanics.exact.primes import SIZES, draw_prime, log2_count, pooled_prime
from mechanics.exact.signals import DivisionHere, Inadmissible, Restart, SingularHere

Pair = tuple[Any, Any]
Experiment = Callable[[Arithmetic], Sequence[Pair]]

DRAWS = 4096
"""Most points that may be drawn until one is admissible: R of the bound."""

HOPELESS = 16
"""Points at which the same division or matrix may fail before it counts as failing everywhere."""

MOST_POINTS = 1000
MOST_NUMBERS = 10_000_000
"""Numbers that may be computed for one statement, beyond its first point: some minutes at most."""

POOL = 16

KINKS = {"absolute value", "comparison"}
"""Operations that have a case on either side of a boundary."""


class Answer(Enum):
    """What the field says."""

    ZERO = "zero"
    NONZERO = "not zero"
    FAILED = "no admissible point"


@dataclass(frozen=True)
class Trial:
    """Outcome: the answer, its bound and words for it, and functions known by congruence only."""

    answer: Answer
    log2_bound: float
    words: str
    opaque: tuple[str, ...] = ()


@dataclass(frozen=True)
class _Point:
    """One evaluated point."""

    zero: bool
    log2_bound: float
    square_roots: int
    kinks: int


class _FailedError(Exception):
    """No admissible point was found; carries the reason."""


def trial(experiment: Experiment, log2_target: float) -> Trial:
    """Evaluate an experiment at random points of finite fields until it is certain or refuted.

    Raises
    ------
    ValueError
        If the experiment compares nothing.
    ExpressionError
        If an operation has no meaning in a field.
    """
    session = _Session(experiment, random.Random("trial"), Memory())
    first = session.attempt(log2_target)
    if first.answer is Answer.NONZERO and KINKS & set(first.opaque):
        second = replace(session, signs=True).attempt(log2_target)
        return second if second.answer is Answer.ZERO else first
    return first


def look(experiment: Experiment) -> bool:
    """Run an experiment at one admissible point, for what it notes itself; roots may be either.

    Returns
    -------
    bool
        Whether there was such a point.

    Raises
    ------
    ExpressionError
        If an operation has no meaning in a field.
    """
    try:
        _Session(experiment, random.Random("look"), Memory()).point(SIZES[0])
    except _FailedError:
        return False
    return True


@dataclass(frozen=True)
class _Session:
    """One statement: what is evaluated, where chance comes from, what has been learnt."""

    experiment: Experiment
    source: random.Random
    memory: Memory
    signs: bool = False

    def attempt(self, log2_target: float) -> Trial:
        """Run, and say so where no point is admissible or no bound is reached."""
        try:
            return self.run(log2_target)
        except _FailedError as failure:
            return Trial(Answer.FAILED, inf, str(failure), tuple(self.memory.opaque))

    def run(self, log2_target: float) -> Trial:
        """Choose the prime, look at the roots, evaluate as many points as needed."""
        bits, point = SIZES[0], self.point(SIZES[0])
        while point.zero and point.log2_bound > log2_target - 1:
            bits = _longer(bits, point.log2_bound, log2_target - 1)
            point = self.point(bits)
        opaque = tuple(self.memory.opaque)
        if not point.zero:
            return Trial(Answer.NONZERO, -inf, f"not zero in a field of {bits} bits", opaque)
        unsure = self.unsure(bits, point)
        if not unsure:
            words = f"zero at a random point modulo a random {bits}-bit prime"
            return Trial(Answer.ZERO, point.log2_bound, words, opaque)
        return self.repeated(bits, unsure, log2_target, opaque)

    def prime(self, bits: int, index: int) -> int:
        """Return one of the primes that statements share."""
        return pooled_prime(bits, index % POOL)

    def evaluated(self, a: FieldArithmetic) -> Sequence[Pair]:
        """Run the experiment, and count the numbers that it took."""
        try:
            return list(self.experiment(a))
        finally:
            self.memory.numbers += a.numbers

    def spent(self, share: float = 1.0) -> bool:
        """Whether a share of the numbers that may be computed have been."""
        return self.memory.numbers > share * MOST_NUMBERS

    def point(self, bits: int, fresh: bool = False) -> _Point:
        """Return the first admissible point of at most DRAWS."""
        failures: dict[str, int] = {}
        for index in range(DRAWS):
            if index and self.spent():
                break
            prime = draw_prime(bits, self.source) if fresh else self.prime(bits, index)
            a = FieldArithmetic(prime, self.source, self.memory, signs=self.signs)
            try:
                return _measured(a, self.evaluated(a), bits)
            except Restart:
                continue
            except Inadmissible as reason:
                failures[str(reason)] = failures.get(str(reason), 0) + 1
                everywhere = isinstance(reason, SingularHere | DivisionHere)
                if everywhere and failures[str(reason)] >= HOPELESS:
                    raise _FailedError(f"{reason} at every one of {HOPELESS} points") from reason
        worst = max(failures, key=lambda reason: failures[reason], default="no run completed")
        raise _FailedError(f"no admissible point among {sum(failures.values())}: {worst}")

    def unsure(self, bits: int, point: _Point) -> int:
        """Return s of (1), after probing; what comes after an unsure sign is unsure itself."""
        roots = point.square_roots
        if point.kinks:
            return point.kinks + roots
        for index in range(min(16 * 2**roots, 2 * DRAWS)):
            if len(self.memory.not_squares) >= roots or self.spent(1 / 4):
                break
            a = FieldArithmetic(self.prime(bits, index), self.source, self.memory, real=False)
            try:
                self.evaluated(a)
            except (Restart, Inadmissible):
                continue  # a probe that ends early has told what it could
        first = next((i for i in range(roots) if i not in self.memory.not_squares), roots)
        return roots - first

    def repeated(
        self, bits: int, unsure: int, log2_target: float, opaque: tuple[str, ...]
    ) -> Trial:
        """Evaluate k points, each with a prime of its own, by (1)."""
        survival = 1 - 2.0**-unsure + 2.0**-30
        count = ceil((1 - log2_target) * log(2) / -log(survival))
        blame = f"the signs of {unsure} roots or absolute values cannot be told"
        if count > MOST_POINTS:
            raise _FailedError(blame)
        bound = -inf
        for _ in range(count):
            point = self.point(bits, fresh=True)
            if not point.zero:
                return Trial(Answer.NONZERO, -inf, f"not zero in a field of {bits} bits", opaque)
            if self.spent():
                raise _FailedError(blame)
            bound = max(bound, point.log2_bound)
        total = _log2_sum(bound, count * log2(survival))
        words = f"zero at {count} random points modulo random {bits}-bit primes"
        where = ", off the boundaries of cases" if self.signs else ""
        return Trial(Answer.ZERO, total, words + where, opaque)


def _measured(a: FieldArithmetic, pairs: Sequence[Pair], bits: int) -> _Point:
    """Return a point with its bound, `field` equation (1)."""
    if not pairs:
        raise ValueError("the experiment compares nothing: return at least one pair")
    differences = [a.rational(0) + left - right for left, right in pairs]
    size = a.total_size(differences)
    degree = max(size.degree, 1.0) * 1.001  # floats are rounded: stay above
    height = max(size.height, 1.0) * 1.001
    schwartz_zippel = 1 + log2(degree) - (bits - 2)
    unlucky_prime = log2(height / (bits - 1)) - log2_count(bits)
    bound = log2(DRAWS) + a.log2_conjugates + _log2_sum(schwartz_zippel, unlucky_prime)
    zero = all(number.residue == 0 for number in differences)
    return _Point(zero, bound, a.square_roots, len(a.kinks))


def _log2_sum(one: float, two: float) -> float:
    """Return log2(2**one + 2**two)."""
    high, low = max(one, two), min(one, two)
    return high + log2(1 + 2.0 ** max(low - high, -1000.0))


def _longer(bits: int, log2_bound: float, log2_target: float) -> int:
    """Return a length of prime that brings the bound below the target."""
    if isfinite(log2_bound):
        for size in SIZES:
            if size > bits and log2_bound - 0.97 * (size - bits) <= log2_target:
                return size
    raise _FailedError("the degree bound is beyond the longest primes in use")
