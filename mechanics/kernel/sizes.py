"""Degrees and heights: how often a value that is not zero everywhere is zero at a random point.

Every value is a fraction N / D in what is drawn. With deg the total degree and h = log2 of the
larger of sup |N| and sup |D| while every drawn variable runs over the complex unit circle:

    x y:    deg N = n1 + n2,                 deg D = d1 + d2,   h = h1 + h2                  (1)
    x + y:  deg N = max(n1 + d2, n2 + d1),   deg D = d1 + d2,   h = h1 + h2 + 1              (2)

and where D1 = D2 up to a constant, deg N = max(n1, n2), deg D = d1. A token tells that two
denominators are the same; token 0 is a constant denominator. The sup norm is submultiplicative and
bounds every coefficient (Cauchy's estimate), so h bounds the coefficients of the expanded fraction.

    M x = f:  x_j = det M_j / det M   (Cramer); rows are cleared of their denominators first  (3)
    sine and cosine of a base angle: degree 1, h = 1;  a k-th root of P / Q = (P Q^(k-1))^(1/k) / Q:
    degree (deg P + (k-1) deg Q) / k, whatever the branch                                    (4)

Sizes depend on the program alone, never on what is drawn: they say how long a prime has to be.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import log2
from typing import Any

from flint import fmpz

ROOTS = (2, 3, 5, 7)
"""Prime degrees of roots that exist in the fields of `primes`."""

LARGEST_ROOT = 64
LARGEST_POWER = 4096


@dataclass(slots=True, eq=False)
class Size:
    """Degrees of numerator and denominator, log2 height, token, the rational where it is one."""

    numerator: float
    denominator: float
    height: float
    token: int
    constant: Fraction | None = None
    inverse: Size | None = None


def is_algebraic(exponent: Fraction) -> bool:
    """Whether a power with that exponent is made of roots of degree 2, 3, 5 and 7."""
    if abs(exponent.numerator) > LARGEST_POWER or exponent.denominator > LARGEST_ROOT:
        return False
    return all(k in ROOTS for k in prime_factors(exponent.denominator))


def prime_factors(number: int) -> list[int]:
    """The primes whose product it is, in order."""
    return [int(prime) for prime, times in fmpz(number).factor() for _ in range(int(times))]


class Sizes:
    """The domain of sizes; it adds up what else can happen by chance.

    Attributes
    ----------
    degree, height : float
        Of the product of everything that is looked up or branched on.
    log2_conjugates : float
        log2 of the number of branches of all roots together: a norm over them is that much longer.
    """

    def __init__(self) -> None:
        self.log2_conjugates = 0.0
        self._last_token = 0
        self._tokens: dict[tuple[int, int], int] = {}
        self._looked_up: dict[int, Size] = {}
        self._lookups = 0
        opaque = ("log", "asin", "acos", "atan", "asinh", "acosh", "atanh", "floor", "erf")
        self.operations: Mapping[str, Callable[..., Size]] = {
            "add": self._sum, "subtract": self._sum, "multiply": self._product,
            "divide": self._quotient, "negate": lambda x: x,
            "sqrt": lambda x: self._root(x, 2), "power": self._power, "exp": self._variable,
            "sin": self._circle, "cos": self._circle, "atan2": self._variable,
            "abs": self._absolute, "sign": self._sign,
            "less": self._comparison, "not_greater": self._comparison, "equal": self._comparison,
            "and": self._product, "select": self._choice, "not": lambda x: self._sum(_ONE, x),
            "or": lambda x, y: self._sum(self._sum(x, y), self._product(x, y)),
            **dict.fromkeys(opaque, self._variable),
        }  # fmt: skip

    # ------------------------------------------------------------------ leaves

    def variable(self) -> Size:
        """Something that is drawn."""
        return Size(1.0, 0.0, 0.0, 0)

    def constant(self, value: Fraction) -> Size:
        """A rational."""
        return Size(0.0, 0.0, log2(max(abs(value.numerator), value.denominator)), 0, value)

    def pi(self) -> Size:
        """Pi is a variable: what holds for every value holds for its."""
        return self.variable()

    # ------------------------------------------------------------------ arithmetic

    def _common(self, one: int, two: int) -> int:
        """The token of a product of denominators."""
        if not one or not two:
            return one or two
        key = (one, two) if one < two else (two, one)
        if key not in self._tokens:
            self._tokens[key] = self._new()
        return self._tokens[key]

    def _new(self) -> int:
        self._last_token += 1
        return self._last_token

    def _sum(self, x: Size, y: Size) -> Size:
        """Equation (2)."""
        n1, d1, n2, d2 = x.numerator, x.denominator, y.numerator, y.denominator
        height = x.height + y.height + 1
        if x.token == y.token:
            return Size(n1 if n1 > n2 else n2, d1, height, x.token)
        return Size(max(n1 + d2, n2 + d1), d1 + d2, height, self._common(x.token, y.token))

    def _product(self, x: Size, y: Size) -> Size:
        """Equation (1)."""
        return Size(
            x.numerator + y.numerator, x.denominator + y.denominator, x.height + y.height,
            self._common(x.token, y.token),
        )  # fmt: skip

    def _quotient(self, x: Size, y: Size) -> Size:
        """A product with 1/y, which is the same object for the same y and so keeps its token."""
        if y.inverse is None:
            token = self._new() if y.numerator else 0
            y.inverse = Size(y.denominator, y.numerator, y.height, token)
        return self._product(x, y.inverse)

    def _choice(self, condition: Size, x: Size, y: Size) -> Size:
        """h x + (1 - h) y."""
        other = self._product(self._sum(_ONE, condition), y)
        return self._sum(self._product(condition, x), other)

    # ------------------------------------------------------------------ what is looked up

    def _look_up(self, *operands: Size) -> None:
        for operand in operands:
            self._lookups += 1
            self._looked_up[id(operand)] = operand

    def _variable(self, *operands: Size) -> Size:
        """A variable for each value of the operands."""
        self._look_up(*operands)
        return self.variable()

    def _circle(self, x: Size) -> Size:
        self._look_up(x)
        return Size(1.0, 0.0, 1.0, 0)

    def _absolute(self, x: Size) -> Size:
        """A variable, or x or -x: as large as either."""
        self._look_up(x)
        return Size(max(x.numerator, 1.0), x.denominator, x.height, x.token)

    def _sign(self, x: Size) -> Size:
        """|x| / x."""
        return self._quotient(self._absolute(x), x)

    def _comparison(self, x: Size, y: Size) -> Size:
        return self._sum(_ONE, self._variable(self._sum(x, y)))

    def _root(self, x: Size, k: int) -> Size:
        """Equation (4)."""
        self._look_up(x)
        self.log2_conjugates += log2(k)
        degree = (x.numerator + (k - 1) * x.denominator) / k
        return Size(degree, x.denominator, x.height, x.token)

    def _power(self, x: Size, y: Size) -> Size:
        exponent = y.constant
        if exponent is None or not is_algebraic(exponent):
            return self._variable(x, y)
        result = x
        for k in prime_factors(exponent.denominator):
            result = self._root(result, k)
        if exponent < 0:
            result = self._quotient(_ONE, result)
        times = abs(exponent.numerator)
        return Size(
            result.numerator * times, result.denominator * times, result.height * times,
            self._new() if result.token else 0,
        )  # fmt: skip

    def solve(
        self, matrix: Sequence[Sequence[Size]], right: Sequence[Size], symmetric: bool
    ) -> list[Size]:
        """Equation (3): all components share the determinant."""
        rows = [[*row, side] for row, side in zip(matrix, right, strict=True)]
        degree, height = determinant_size(rows)
        return [Size(degree, degree, height, self._new() if degree else 0)] * len(rows)

    # ------------------------------------------------------------------ the sum of all events

    def total(self, values: Sequence[Size]) -> tuple[float, float]:
        """Degree and height of the product of the values and of all that was looked up."""
        degree = height = 0.0
        for value in self._looked_up.values():
            degree += self._lookups * (value.numerator + value.denominator)
            height += self._lookups * (2 * value.height + 1)
        for value in values:
            degree += value.numerator + value.denominator
            height += 2 * value.height + 1
        # Sums of floats are rounded: stay above.
        return max(degree, 1.0) * 1.001, max(height, 1.0) * 1.001


_ONE = Size(0.0, 0.0, 0.0, 0)


def determinant_size(rows: Sequence[Sequence[Any]]) -> tuple[float, float]:
    """Degree and height of every minor of the rows, denominators cleared, by n! products."""
    spread = log2(len(rows)) if rows else 0.0
    degree = height = 0.0
    for row in rows:
        denominators = {entry.token: entry.denominator for entry in row}
        common = sum(denominators.values())
        top = max(entry.numerator - entry.denominator for entry in row) + common
        degree += max(top, common, 0.0)
        height += sum(entry.height for entry in row) + spread
    return degree, height
