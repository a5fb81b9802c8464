"""Constants on their way to double precision."""

from fractions import Fraction


def unit_fraction(value: Fraction) -> int | None:
    """The whole number n of 1/n, where x / n rounds once and x (1/n) would round twice."""
    divisor = value.denominator * value.numerator
    single = abs(value.numerator) == 1 and value.denominator & (value.denominator - 1)
    return divisor if single and abs(divisor) < 1 << 53 else None
