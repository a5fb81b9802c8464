"""What a check found out, and how sure it is.

A finding has no truth value: doubt must never pass for success, so callers compare verdicts. Others
get one from `decide`, or from a function of this module, which takes both sides and compares them:

    same        two pieces of data are equal                            PROVED or UNDECIDED
    enclosed    each enclosure lies between its bounds                  PROVED or UNDECIDED
    supported   each measured value lies in what is allowed             SUPPORTED or UNDECIDED
    refuted     two sides differ: disjoint enclosures, or other data    REFUTED or UNDECIDED
    follows     what findings together imply                            the weakest of theirs
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from enum import Enum
from fractions import Fraction
from math import isfinite
from typing import Any

from flint import arb

from mechanics.kernel.balls import ball, precision

Side = Any
"""A number, a text, or several: integers and floats are exact, balls enclose."""


class Verdict(Enum):
    """Outcome of a check; the value is the sentence that explains it."""

    PROVED = "zero in the normal form, or enclosed within half a unit of the last printed digit"
    CERTIFIED = (
        "zero at random points of a finite field, with a computed bound of the chance of error"
    )
    SUPPORTED = "supported by numbers only"
    REFUTED = "false: at the witness state the two sides have disjoint enclosures"
    UNDECIDED = "neither shown nor refuted"


NOTHING = "nothing was compared"
COMPONENT = ", on the component where the constraints give "
"""Ends the evidence of what is shown where constraints hold, and not off them."""


@dataclass(frozen=True)
class Witness:
    """A real, admissible state at which two sides differ.

    Attributes
    ----------
    state : tuple of (str, str)
        Name and exact decimal or rational value of each symbol that is chosen.
    left, right : str
        Enclosures of the two sides there, as ``midpoint +/- radius``; they are disjoint.
    solved : tuple of (str, str)
        What goes with it, as decimals: dependent quantities, accelerations, reactions.
    """

    state: tuple[tuple[str, str], ...]
    left: str
    right: str
    solved: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class Finding:
    """One checked statement.

    Attributes
    ----------
    subject : str
        What was checked, in words: ``"kane = lagrange"``.
    verdict : Verdict
    evidence : str
        How it was shown, or why it could not be: one sentence.
    error_bound : float or None
        For CERTIFIED: upper bound of the probability that the statement is false all the same.
    witness : Witness or None
        For REFUTED.
    domain : str
        Where it is shown, where that is not everywhere: ``"except where cos(theta) = 0"``,
        ``"PROVED WHERE r > 0"``; ``"undefined"`` for what has no value where it has to.
    """

    subject: str
    verdict: Verdict
    evidence: str = field(repr=False)
    error_bound: float | None = field(default=None, repr=False)
    witness: Witness | None = field(default=None, repr=False)
    domain: str = field(default="", repr=False)

    def __bool__(self) -> bool:
        raise TypeError("a Finding has no truth value: compare its verdict")

    @property
    def undefined(self) -> bool:
        """True when what was written has no value at a state where it has to have one."""
        return self.verdict is Verdict.REFUTED and bool(self.domain)

    @property
    def shown(self) -> bool:
        """True when the statement is PROVED or CERTIFIED."""
        return self.verdict in (Verdict.PROVED, Verdict.CERTIFIED)


def undecided(subject: str, reason: str, domain: str = "") -> Finding:
    """The finding on what is neither shown nor refuted: no state is admissible, say."""
    return Finding(subject, Verdict.UNDECIDED, reason, domain=domain)


def same(subject: str, left: object, right: object, words: str) -> Finding:
    """Whether two pieces of plain data are the same; other texts may say the same, too.

    Parameters
    ----------
    subject, words : str
        What is compared, and what it means that they are.
    left, right : str, int, float, Fraction, None, or sequences and mappings of these

    Raises
    ------
    TypeError
        If they are something else, whose equality its own class decides.
    """
    texts = _data(left), _data(right)
    if texts[0] != texts[1]:
        return undecided(subject, f"not the same: {texts[0]} and {texts[1]}")
    return Finding(subject, Verdict.PROVED, words) if left else undecided(subject, NOTHING)


def supported(subject: str, samples: Iterable[tuple[Side, Side]], words: str) -> Finding:
    """Whether each value that was measured lies within what is allowed.

    Parameters
    ----------
    subject, words : str
        What is measured, and what it means that they do.
    samples : iterable of (allowed, value)
        A finite ball and a number in it; or other data, and the same.
    """
    count = 0
    for allowed, value in samples:
        if not _within(allowed, value):
            one, other = in_words(allowed, value)
            return undecided(subject, f"{other} was measured, not known to lie within {one}")
        count += 1
    return Finding(subject, Verdict.SUPPORTED, words) if count else undecided(subject, NOTHING)


def refuted(
    subject: str, words: str, left: Side, right: Side, state: Iterable[tuple[str, str]] = ()
) -> Finding:
    """Whether two sides are apart at a state: disjoint enclosures, or other data.

    Parameters
    ----------
    subject, words : str
        What is refuted, and how.
    left, right : sides
        A float that is no number is apart from every number.
    state : iterable of (str, str)
        As in `Witness`; empty for what holds at every state.
    """
    one, other = in_words(left, right)
    if not _apart(left, right):
        return undecided(subject, f"{words}: not known, {one} and {other} may be the same")
    return Finding(subject, Verdict.REFUTED, words, witness=Witness(tuple(state), one, other))


def enclosed(
    subject: str, values: Sequence[tuple[Fraction, arb, Fraction]], words: str
) -> Finding:  # fmt: skip
    """Whether each value lies between its bounds, the bounds included.

    Parameters
    ----------
    subject, words : str
        What is bounded, and what it means that they do.
    values : sequence of (Fraction, flint.arb, Fraction)
        Lower bound, enclosure of the value, upper bound.
    """
    for low, value, high in values:
        if not value.is_finite():
            return undecided(subject, f"nothing bounds the value {value}")
        middle, radius = exact(value.mid()), exact(value.rad())
        if not low <= middle - radius <= middle + radius <= high:
            return undecided(subject, f"{value} is not known to lie between {low} and {high}")
    return Finding(subject, Verdict.PROVED, words) if values else undecided(subject, NOTHING)


def follows(subject: str, premises: Sequence[Finding]) -> Finding:
    """What follows from other findings, as a = c from a = b and b = c.

    The weakest of their verdicts, with the sum of their bounds; UNDECIDED from nothing, and from
    what is not shown.
    """
    verdicts = {premise.verdict for premise in premises}
    doubts = [p.subject for p in premises if p.verdict in (Verdict.UNDECIDED, Verdict.REFUTED)]
    if doubts or not premises:
        return undecided(subject, f"it cannot follow from {' and '.join(doubts) or NOTHING}")
    words = "follows from " + " and ".join(premise.subject for premise in premises)
    places = [premise.evidence.partition(COMPONENT) for premise in premises]
    words += "".join(dict.fromkeys(COMPONENT + where for _, found, where in places if found))
    if Verdict.SUPPORTED in verdicts or Verdict.CERTIFIED not in verdicts:
        weakest = Verdict.SUPPORTED if Verdict.SUPPORTED in verdicts else Verdict.PROVED
        return Finding(subject, weakest, words)
    bounds = [premise.error_bound for premise in premises if premise.error_bound is not None]
    return Finding(subject, Verdict.CERTIFIED, words, error_bound=sum(bounds))


def _data(side: object) -> str:
    """Plain data as text; 1, True and "1" have different ones."""
    if type(side) in (str, int, bool, float, Fraction, type(None)):
        return repr(side)
    if isinstance(side, Mapping):
        return "{" + ", ".join(f"{_data(k)}: {_data(v)}" for k, v in side.items()) + "}"
    if isinstance(side, tuple | list):
        return f"({', '.join(map(_data, side))})"
    raise TypeError(f"{type(side).__name__} is no plain data: pass texts, numbers, tables of them")


def _number(side: Side) -> arb | None:
    """A number as a ball, or None where a float is none."""
    if isinstance(side, arb):
        return side
    if isinstance(side, float):
        return arb(side) if isfinite(side) else None
    if isinstance(side, int | Fraction):
        return ball(side)
    raise TypeError(f"{type(side).__name__} is no number to be compared with one")


def _apart(left: Side, right: Side) -> bool:
    if isinstance(left, tuple) and isinstance(right, tuple):
        return len(left) != len(right) or any(map(_apart, left, right))
    if isinstance(left, str) and isinstance(right, str):
        return _data(left) != _data(right)
    x, y = _number(left), _number(right)
    if x is None or y is None:
        return any(number is not None and number.is_finite() for number in (x, y))
    return x.is_finite() and y.is_finite() and not x.overlaps(y)


def _within(allowed: Side, value: Side) -> bool:
    if not (isinstance(allowed, arb) or isinstance(value, arb)):
        return _data(allowed) == _data(value)
    x, y = _number(allowed), _number(value)
    return x is not None and y is not None and x.is_finite() and bool(x.contains(y))


def in_words(left: Side, right: Side) -> tuple[str, str]:
    """Both sides as texts; of balls, with so many digits that these are disjoint if they are."""
    for digits in (20, 40, 80, 160, 320, 640):
        one, other = (s.str(digits) if isinstance(s, arb) else str(s) for s in (left, right))
        if not (isinstance(left, arb) and isinstance(right, arb)):
            break
        with precision(5 * digits):
            if not arb(one).overlaps(arb(other)):
                break
    return one, other


def exact(dyadic: arb) -> Fraction:
    """The value of a ball of radius zero, so that a value on its bound lies within."""
    mantissa, exponent = dyadic.man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
