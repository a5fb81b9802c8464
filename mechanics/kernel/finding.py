"""What a check found out, and how sure it is.

A finding has no truth value: doubt must never pass for success, so callers compare verdicts.
"""

from dataclasses import dataclass
from enum import Enum


class Verdict(Enum):
    """Outcome of a check; the value is the sentence that explains it."""

    PROVED = "zero in the normal form, or enclosed within half a unit of the last printed digit"
    CERTIFIED = (
        "zero at random points of a finite field, with a computed bound of the chance of error"
    )
    SUPPORTED = "supported by numbers only"
    REFUTED = "false: at the witness state the two sides have disjoint enclosures"
    UNDECIDED = "neither shown nor refuted"


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
