"""What the kernel decides: left = right wherever the conditions hold."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from fractions import Fraction

from mechanics.program import Program

LEFT, RIGHT, POSITIVE, ZERO, RATES = "left", "right", "positive", "zero", "rates"
"""Outputs of a statement's program that have a meaning; others are shown with a witness."""

TARGET = 2.0**-80


class Range(Enum):
    """What is known of an input; the value is for people."""

    FREE = "any real number"
    POSITIVE = "positive"
    NONNEGATIVE = "not negative"
    NEGATIVE = "negative"


@dataclass(frozen=True)
class Statement:
    """Two lists of expressions that should be equal, entry by entry.

    Attributes
    ----------
    subject : str
        What is stated, in words: ``"kane = lagrange"``.
    program : Program
        Outputs ``"left"`` and ``"right"`` of equal length. An output ``"positive"`` lists
        conditions: the statement is about the states at which all its entries are positive. An
        output ``"zero"`` lists constraints: it is about the states at which all of them are zero.
        So does ``"rates"``, constraints that are solved after those, on speeds.
        Whatever else it computes is shown with a witness, under the name of the output.
    signs : mapping of str to Range
        What is known of the inputs; an input that is not listed is any real number.
    typical : mapping of str to Fraction
        Values of inputs at which the conditions hold, where simple numbers may not meet them. If
        they are a state on the constraints, it is about the component and branch of that state.
    dependent : tuple of str
        Inputs for which the constraints may be solved, those to be tried first at the beginning.
    auxiliary : frozenset of str
        Inputs that only choose a point, as the sign of a root does: no witness lists them.
    target : float
        Largest chance of error that a CERTIFIED finding may have.

    Raises
    ------
    ValueError
        If it compares nothing or lists of unequal length, or the target is no probability.
    """

    subject: str
    program: Program
    signs: Mapping[str, Range] = field(default_factory=dict)
    typical: Mapping[str, Fraction] = field(default_factory=dict)
    dependent: tuple[str, ...] = ()
    auxiliary: frozenset[str] = frozenset()
    target: float = TARGET

    def __post_init__(self) -> None:
        left = len(self.program.outputs.get(LEFT, ()))
        right = len(self.program.outputs.get(RIGHT, ()))
        if left != right:
            raise ValueError(
                f"{self.subject}: {left} entries on the left, {right} on the right:"
                " compare equally many"
            )
        if not left:
            raise ValueError(f"{self.subject}: nothing to compare: give at least one entry")
        if not 0 < self.target < 1:
            raise ValueError(f"target {self.target} is no probability between 0 and 1")

    def range_of(self, name: str) -> Range:
        """What is known of an input."""
        return self.signs.get(name, Range.FREE)

    @property
    def seed(self) -> str:
        """A digest of all that the points depend on; the words of the subject are no part of it."""
        signs = [f"{name}: {self.range_of(name).value}" for name in self.program.inputs]
        return "\n".join((*signs, self.program.digest))
