"""Points are drawn until the chance of error is below the target, or a point says no.

A false statement left = right is a fraction E = N / D whose numerator is not the zero polynomial in
what is drawn. Sampling misses that with a probability of at most

    P  <=  R C (2 deg N / |S|  +  h / ((b - 1) |primes|))                                      (1)

First term, Schwartz and Zippel: variables are sampled from S, at least the (p - 1)/2 squares, and N
has at most deg zeros in each. On a circle a polynomial of degree m in (c, s) is a Laurent
polynomial z**-m ... z**m in z = c + i s, so it has at most 2 m zeros among its points; splitting
off the leading coefficient variable by variable gives 2 deg N / |S| in all. Second term: if N is
not zero over the rationals but zero mod p, then p divides all coefficients; an integer below 2**h
has at most h / (b - 1) prime divisors of b bits. R is the largest number of points that may be
drawn until one is admissible: the union bound over them. C is the number of branches of all roots,
and of embeddings of the multiples of pi: N is replaced by its norm. deg and h include everything
that is looked up by its residue (`sizes`): two different arguments meet with such a chance.

Roots. Radicands that are squares of polynomials are rewritten first (`squares`). If the radicand x
of a square root is no square in the field of fractions, both branches are alike, and the norm
speaks for both. If x = y**2, the real root is |y|, but the field takes y or -y, whichever is a
square modulo p. At a random point and prime the quadratic characters of s such y take every
combination that is consistent, with a chance of at least 2**-s (Weil's bound for character sums;
Chebotarev for constants), among them the combination of the real signs. So a false statement
survives k points with a chance of at most

    (1 - 2**-s + 2**-30)**k.                                                                  (2)

Which radicands are squares need not be known: one that is seen to be a non-residue, all earlier
ones being residues, is none, because then y would have to exist at that point. *Probes*, where
positive inputs and signs of roots are free, expose nearly all of them. s counts the roots from the
first one that is left: those behind it may have been exposed by its wrong sign.

|x| and comparisons are first taken for unknown functions of x, which needs one point only but knows
no more than |-x| = |x|. If that says no, |x| is read as sqrt(x**2), and ``x < y`` as
|x - y| = y - x; each such x, and then every root, counts in s. Boundaries of cases (x = y) are not
looked at then.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from enum import Enum
from fractions import Fraction
from math import ceil, inf, isfinite, log2
from typing import Any

from flint import fmpz

from mechanics.kernel.angles import base_angles, is_cut, turns_of
from mechanics.kernel.draws import Draws
from mechanics.kernel.field import DivisionHere, Inadmissible, Residues
from mechanics.kernel.primes import SIZES, common_modulus, draw_prime, log2_count
from mechanics.kernel.sizes import Sizes
from mechanics.kernel.squares import roots_of_squares
from mechanics.kernel.statement import LEFT, POSITIVE, RIGHT, Range, Statement
from mechanics.program import Builder, Node, Program, interpret

MOST_DRAWS = 4096
"""Most points that may be drawn until one is admissible: R of the bound."""

HOPELESS = 16
"""Points at which a division may fail before it counts as failing everywhere."""

PROBES = 24
"""Probes that reach a root and find no residue that is no square, until its radicand is left."""

MOST_POINTS = 1000
MOST_STEPS = 40_000_000
"""Operations that may be carried out in fields for one statement."""

PRIMES = 64
"""Different primes that are tried for one statement, unless each point has its own."""

WEIL = 40
"""Bits by which the root of the prime exceeds the degree, so that (2) holds with its 2**-30."""

KINKS = {"abs", "sign", "less", "not_greater", "equal"}
UNKNOWN = {"log", "asin", "acos", "atan", "atan2", "asinh", "acosh", "atanh", "floor", "erf",
           "power"}  # fmt: skip


class Answer(Enum):
    """What the field says."""

    ZERO = "zero"
    NONZERO = "not zero"
    PROVED = "zero by other means"
    FAILED = "no admissible point"


@dataclass(frozen=True)
class Trial:
    """Outcome: the answer, log2 of its bound, words for it.

    Attributes
    ----------
    unknown : tuple of str
        Operations that are known by congruence only.
    off_boundaries : bool
        Whether nothing was looked at where the cases of |x| and comparisons meet.
    """

    answer: Answer
    log2_bound: float
    words: str
    unknown: tuple[str, ...] = ()
    off_boundaries: bool = False


class FailedError(Exception):
    """No admissible point was found, or a budget is used up; carries the reason."""


@dataclass(frozen=True)
class Experiment:
    """A statement made ready: in base angles, with the length of its primes."""

    statement: Statement
    program: Program
    turns: tuple[Fraction, ...]
    modulus: int
    bits: int
    log2_bound: float

    @property
    def unknown(self) -> tuple[str, ...]:
        """Operations that are known by congruence only."""
        return tuple(sorted((KINKS | UNKNOWN).intersection(self.program.counts())))

    @property
    def has_kinks(self) -> bool:
        """Whether |x| or a comparison stands in it."""
        return not KINKS.isdisjoint(self.program.counts())


def prepare(
    statement: Statement, sizes: tuple[int, ...] = SIZES, angles: Program | None = None
) -> Experiment:
    """Measure a statement and choose its primes by equation (1).

    Parameters
    ----------
    angles : Program, optional
        The statement's program in base angles, where it is known.

    Raises
    ------
    FailedError
        If the degree bound is beyond the longest primes.
    """
    program = base_angles(statement.program) if angles is None else angles
    program = roots_of_squares(program, statement.signs)
    turns = turns_of(program)
    modulus = common_modulus(turns)
    domain = Sizes()
    inputs = {name: domain.variable() for name in program.inputs}
    outputs = interpret(program, domain, inputs, release=False)
    differences = [
        domain.operations["subtract"](x, y)
        for x, y in zip(outputs[LEFT], outputs[RIGHT], strict=True)
    ]
    degree, height = domain.total(differences)
    conjugates = domain.log2_conjugates
    if turns:
        conjugates += log2(int(fmpz(modulus).euler_phi()))
    kinks = not KINKS.isdisjoint(program.counts())
    for bits in sizes:
        bound = log2_bound(bits, modulus, degree, height, conjugates)
        short = (conjugates or kinks) and log2(degree) + WEIL > bits / 2
        if isfinite(bound) and bound <= log2(statement.target) - 1 and not short:
            return Experiment(statement, program, turns, modulus, bits, bound)
    raise FailedError("the degree bound is beyond the longest primes in use")


def log2_bound(
    bits: int, modulus: int, degree: float, height: float, log2_conjugates: float
) -> float:
    """log2 of P, equation (1)."""
    schwartz_zippel = 1 + log2(degree) - (bits - 2)
    unlucky_prime = log2(height / (bits - 1)) - log2_count(bits, modulus)
    return log2(MOST_DRAWS) + log2_conjugates + log2_sum(schwartz_zippel, unlucky_prime)


def log2_sum(one: float, two: float) -> float:
    """log2(2**one + 2**two)."""
    high, low = max(one, two), min(one, two)
    return high + log2(1 + 2.0 ** max(low - high, -1000.0))


@dataclass
class Session:
    """The points of one experiment, one after the other, within its budget."""

    experiment: Experiment
    signs: bool = False
    draws: Draws = field(init=False)
    not_squares: set[int] = field(default_factory=set)
    _primes: dict[int, int] = field(default_factory=dict)
    _steps: int = 0

    def __post_init__(self) -> None:
        self.draws = Draws(self.experiment.statement.seed, "signs" if self.signs else "values")

    def _prime(self, index: int, fresh: bool = False) -> int:
        if fresh or index not in self._primes:
            e = self.experiment
            self._primes[index] = draw_prime(e.bits, e.modulus, self.draws)
        return self._primes[index]

    def _evaluated(self, domain: Residues) -> dict[str, tuple[Any, ...]]:
        statement, program = self.experiment.statement, self.experiment.program
        self._steps += len(program)
        if self._steps > MOST_STEPS:
            raise FailedError(f"more than {MOST_STEPS} operations in fields")
        inputs = {name: domain.input(statement.range_of(name)) for name in program.inputs}
        return interpret(program, domain, inputs, release=False)

    def point(self, fresh: bool = False) -> tuple[list[bool], Residues]:
        """Which entries of both sides are equal at the first admissible point.

        Raises
        ------
        FailedError
            If none of MOST_DRAWS is admissible.
        """
        e = self.experiment
        failures: dict[str, int] = {}
        for index in range(MOST_DRAWS):
            prime = self._prime(index % PRIMES, fresh)
            domain = Residues(prime, e.modulus, self.draws, e.turns, signs=self.signs)
            try:
                outputs = self._evaluated(domain)
                # Rational functions that are equal on an open set are equal everywhere.
                if domain.square_roots or domain.kinks:
                    for entry in outputs.get(POSITIVE, ()):
                        domain.positive(entry)
            except Inadmissible as reason:
                if domain.not_square is not None:
                    self.not_squares.add(domain.not_square)
                failures[str(reason)] = failures.get(str(reason), 0) + 1
                if isinstance(reason, DivisionHere) and failures[str(reason)] >= HOPELESS:
                    raise FailedError(f"{reason} at every one of {HOPELESS} points") from reason
                continue
            sides = zip(outputs[LEFT], outputs[RIGHT], strict=True)
            return [(x - y) % prime == 0 for x, y in sides], domain
        worst = max(failures, key=lambda reason: failures[reason])
        raise FailedError(f"no admissible point among {MOST_DRAWS}: {worst}")

    def unsure(self, point: Residues) -> int:
        """s of (2), after probing; what comes after an unsure sign is unsure itself."""
        e, roots = self.experiment, point.square_roots
        if point.kinks:
            return len(point.kinks) + roots
        first = tried = 0
        for index in range(2 * MOST_DRAWS):
            # The first that is left is reached at one probe of 2**first.
            if first == roots or tried > PROBES * 2**first or self._steps > MOST_STEPS // 4:
                break
            prime = self._prime(index % PRIMES)
            domain = Residues(prime, e.modulus, self.draws, e.turns, squares=False)
            try:
                self._evaluated(domain)
            except Inadmissible:
                if domain.not_square is not None:
                    self.not_squares.add(domain.not_square)
            before, tried = first, tried + 1
            first = next((i for i in range(roots) if i not in self.not_squares), roots)
            tried = tried if first == before else 0
        return roots - first

    def outcome(self, is_proved: Callable[[], bool]) -> Trial:
        """Evaluate a point, and as many as are needed after a first that was zero.

        Raises
        ------
        FailedError
            If no point is admissible, or the budget does not suffice.
        """
        e, (equal, first) = self.experiment, self.point()
        not_zero = Trial(Answer.NONZERO, -inf, f"not zero in a field of {e.bits} bits")
        if not all(equal):
            return not_zero
        if is_proved():
            return Trial(Answer.PROVED, -inf, "")
        unsure = self.unsure(first)
        if not unsure:
            words = f"zero at a random point modulo a random {e.bits}-bit prime"
            return Trial(Answer.ZERO, e.log2_bound, words)
        survival = log2(1 - 2.0**-unsure + 2.0**-30)
        count = ceil((log2(e.statement.target) - 1) / survival) if survival < 0 else MOST_POINTS + 1
        if count > MOST_POINTS:
            raise FailedError(f"the signs of {unsure} roots or absolute values cannot be told")
        for _ in range(count):
            if not all(self.point(fresh=True)[0]):
                return not_zero
        total = log2_sum(e.log2_bound, count * survival)
        words = f"zero at {count} random points modulo random {e.bits}-bit primes"
        where = ", off the boundaries of cases" if self.signs else ""
        return Trial(Answer.ZERO, total, words + where, off_boundaries=self.signs)


def zeros(builder: Builder, nodes: Sequence[Node], signs: Mapping[str, Range]) -> list[bool]:
    """Which nodes are zero at a random point: chooses constraints and pivots, makes no verdict.

    Raises
    ------
    FailedError
        If no point is admissible.
    """
    sides = builder.program({LEFT: nodes, RIGHT: [0] * len(nodes)})
    return Session(prepare(Statement("some are zero", sides, signs))).point()[0]


def trial(statement: Statement, is_proved: Callable[[], bool]) -> Trial:
    """Evaluate a statement at random points of finite fields until it is certain or doubtful.

    Parameters
    ----------
    is_proved : callable
        Asked once the first point is zero; if it says yes, no more points are needed.

    Raises
    ------
    ExpressionError
        If an operation has no meaning in a field.
    """
    angles = base_angles(statement.program)
    outcome = _tried(statement, angles, is_proved)
    if outcome.answer is Answer.NONZERO and is_cut(angles):
        # Two ways to write a long argument may be cut at other places: whole, they have one value.
        whole = _tried(statement, base_angles(statement.program, 1), is_proved)
        outcome = whole if whole.answer in (Answer.ZERO, Answer.PROVED) else outcome
    return outcome


def _tried(statement: Statement, angles: Program, is_proved: Callable[[], bool]) -> Trial:
    try:
        experiment = prepare(statement, angles=angles)
    except FailedError as reason:
        return Trial(Answer.FAILED, inf, str(reason))
    outcome = _attempt(experiment, False, is_proved)
    if outcome.answer is Answer.NONZERO and experiment.has_kinks:
        second = _attempt(experiment, True, is_proved)
        outcome = second if second.answer in (Answer.ZERO, Answer.PROVED) else outcome
    return replace(outcome, unknown=experiment.unknown)


def _attempt(experiment: Experiment, signs: bool, is_proved: Callable[[], bool]) -> Trial:
    try:
        return Session(experiment, signs).outcome(is_proved)
    except FailedError as failure:
        return Trial(Answer.FAILED, inf, str(failure))
