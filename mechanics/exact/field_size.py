"""What is counted, and what is learnt, while one statement is evaluated in fields."""

from __future__ import annotations

from dataclasses import dataclass, field

from mechanics.exact.field_number import FieldNumber


@dataclass
class Memory:
    """What one statement has learnt over its runs; atoms and roots are counted in order.

    Attributes
    ----------
    denominators : dict
        For every angle (``"circle"``) or exponent atom: the common denominator of its factors.
    not_squares : set of int
        Square roots whose radicand was seen to be no square.
    opaque : dict
        Names of functions that are only known by congruence.
    numbers : int
        How many were computed: what a budget is counted in.
    """

    denominators: dict[tuple[str, int], int] = field(default_factory=dict)
    not_squares: set[int] = field(default_factory=set)
    opaque: dict[str, None] = field(default_factory=dict)
    numbers: int = 0


@dataclass
class Size:
    """Degree and log2 height of a product of numerators and denominators."""

    degree: float = 0.0
    height: float = 0.0

    def add(self, number: FieldNumber) -> None:
        """Count numerator and denominator of one more number."""
        self.degree += number.numerator + number.denominator
        self.height += 2 * number.height + 1
