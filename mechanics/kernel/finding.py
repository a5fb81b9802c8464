"""What a check found out, and how sure it is.

A finding has no truth value: doubt must never pass for success, so callers compare verdicts. Others
get one from `decide`, or from a function of this module: what shows a statement here is looked at.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction

from flint import arb


class Verdict(Enum):
    """Outcome of a check; the value is the sentence that explains it."""

    PROVED = "zero in the normal form, or enclosed within half a unit of the last printed digit"
    CERTIFIED = (
        "zero at random points of a finite field, with a computed bound of the chance of error"
    )
    SUPPORTED = "supported by numbers only"
    REFUTED = "false: at the witness state the two sides have disjoint enclosures"
    UNDECIDED = "neither shown nor refuted"


COMPONENT = ", on the component where the constraints give "
"""Ends the evidence of what is shown where constraints hold, and not off them."""


@dataclass(frozen=True)
class Witness:
    """A real, admissible state at which two sides differ.

    Attributes
    ----------
    state : tuple of (str, str)
        Name and exact decimal or rational value of each symbol.
    left, right : str
        Enclosures of the two sides there, as ``midpoint +/- radius``; they are disjoint.
    solved : tuple of (str, str)
        What follows from the state, as decimals: dependent quantities, accelerations, reactions.
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
    evidence: str
    error_bound: float | None = None
    witness: Witness | None = None
    domain: str = ""

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


def supported(subject: str, measured: str) -> Finding:
    """The finding on what was measured at some states, and holds at these."""
    return Finding(subject, Verdict.SUPPORTED, measured)


def refuted(
    subject: str, words: str, witness: Witness | None = None, domain: str = ""
) -> Finding:  # fmt: skip
    """The finding on what is false: at a witness, or as the words name it."""
    return Finding(subject, Verdict.REFUTED, words, witness=witness, domain=domain)


def same(
    subject: str, left: object, right: object, words: str, log2_bound: float | None = None
) -> Finding:
    """Whether two pieces of data are the same: texts, tables, words, values at a random point.

    Parameters
    ----------
    subject : str
        What is compared, in words.
    left, right : object
        Plain data, compared by ``==``.
    words : str
        What it means that they are.
    log2_bound : float, optional
        Of the chance that data of different things are the same, where it was drawn.

    Returns
    -------
    Finding
        PROVED, or CERTIFIED with the bound; UNDECIDED where they differ.
    """
    if left != right:
        return undecided(subject, f"not the same: {left} and {right}")
    if log2_bound is None:
        return Finding(subject, Verdict.PROVED, words)
    return Finding(subject, Verdict.CERTIFIED, words, error_bound=2.0**log2_bound)


def enclosed(
    subject: str, values: Sequence[tuple[Fraction, arb, Fraction]], words: str
) -> Finding:  # fmt: skip
    """Whether each value lies between its bounds, the bounds included.

    Parameters
    ----------
    subject : str
        What is bounded, in words.
    values : sequence of (Fraction, flint.arb, Fraction)
        Lower bound, enclosure of the value, upper bound.
    words : str
        What it means that they do.

    Returns
    -------
    Finding
        PROVED, or UNDECIDED with the first enclosure that leaves its bounds.
    """
    for low, value, high in values:
        if not value.is_finite():
            return undecided(subject, f"nothing bounds the value {value}")
        middle, radius = _exact(value.mid()), _exact(value.rad())
        if not low <= middle - radius <= middle + radius <= high:
            return undecided(subject, f"{value} is not known to lie between {low} and {high}")
    return Finding(subject, Verdict.PROVED, words)


def _exact(dyadic: arb) -> Fraction:
    """The value of a ball of radius zero, so that a value on its bound lies within."""
    mantissa, exponent = dyadic.man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def follows(subject: str, premises: Sequence[Finding]) -> Finding:
    """What follows from statements that were shown, as a = c from a = b and b = c.

    Parameters
    ----------
    subject : str
        What follows, in words.
    premises : sequence of Finding
        All of them shown.

    Returns
    -------
    Finding
        PROVED if all of them are; else CERTIFIED, with the sum of their bounds.

    Raises
    ------
    ValueError
        If there is none, or one is not shown: nothing follows from a doubt.
    """
    doubts = [premise.subject for premise in premises if not premise.shown]
    if doubts or not premises:
        raise ValueError(f"{subject}: it cannot follow from {doubts or 'nothing'}")
    words = "follows from " + " and ".join(premise.subject for premise in premises)
    places = [premise.evidence.partition(COMPONENT) for premise in premises]
    words += "".join(dict.fromkeys(COMPONENT + where for _, found, where in places if found))
    bounds = [premise.error_bound for premise in premises if premise.error_bound is not None]
    if not bounds:
        return Finding(subject, Verdict.PROVED, words)
    return Finding(subject, Verdict.CERTIFIED, words, error_bound=sum(bounds))
