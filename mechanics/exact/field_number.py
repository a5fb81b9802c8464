"""A residue that carries the size of the fraction behind it: x = N / D with bounds of both.

With deg the total degree in everything that was drawn and h = log2 of the larger of sup |N| and
sup |D| while every drawn variable runs over the complex unit circle:

    x y:    deg N = n1 + n2,                 deg D = d1 + d2,   h = h1 + h2
    x + y:  deg N = max(n1 + d2, n2 + d1),   deg D = d1 + d2,   h = h1 + h2 + 1

and where D1 = D2 up to a constant, deg N = max(n1, n2), deg D = d1. A token tells that two
denominators are the same; token 0 is a constant denominator. The sup norm is submultiplicative and
bounds every coefficient (Cauchy's estimate), so h bounds the coefficients of the expanded fraction.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from mechanics.exact.signals import DivisionHere

if TYPE_CHECKING:
    from mechanics.exact.field import FieldArithmetic


class FieldNumber:
    """A residue with bounds: numerator degree, denominator degree, log2 height, token."""

    __slots__ = ("_inverse", "denominator", "field", "height", "numerator", "residue", "token")

    def __init__(
        self, field: FieldArithmetic, residue: int,
        numerator: float, denominator: float, height: float, token: int,
    ) -> None:  # fmt: skip
        self.field = field
        self.residue = residue
        field.numbers += 1
        self.numerator = numerator
        self.denominator = denominator
        self.height = height
        self.token = token
        self._inverse: FieldNumber | None = None

    def __repr__(self) -> str:
        return f"FieldNumber({self.residue} mod {self.field.prime})"

    def __add__(self, other: Any) -> FieldNumber:
        return self._plus(other, 1)

    __radd__ = __add__

    def __sub__(self, other: Any) -> FieldNumber:
        return self._plus(other, -1)

    def __rsub__(self, other: Any) -> FieldNumber:
        return (-self)._plus(other, 1)

    def _plus(self, other: Any, sign: int) -> FieldNumber:
        field = self.field
        if type(other) is not FieldNumber:
            other = field.rational(other)
        n1, d1, n2, d2 = self.numerator, self.denominator, other.numerator, other.denominator
        if self.token == other.token:
            n, d, token = (n1 if n1 > n2 else n2), d1, self.token
        elif other.token == 0:
            n, d, token = max(n1, n2 + d1), d1, self.token
        elif self.token == 0:
            n, d, token = max(n1 + d2, n2), d2, other.token
        else:
            n, d = max(n1 + d2, n2 + d1), d1 + d2
            token = field.common_token(self.token, other.token)
        residue = (self.residue + sign * other.residue) % field.prime
        return FieldNumber(field, residue, n, d, self.height + other.height + 1, token)

    def __neg__(self) -> FieldNumber:
        field = self.field
        return FieldNumber(
            field, -self.residue % field.prime,
            self.numerator, self.denominator, self.height, self.token,
        )  # fmt: skip

    def __mul__(self, other: Any) -> FieldNumber:
        field = self.field
        if type(other) is not FieldNumber:
            other = field.rational(other)
        if self.token == 0 or other.token == 0:
            token = self.token or other.token
        else:
            token = field.common_token(self.token, other.token)
        return FieldNumber(
            field, self.residue * other.residue % field.prime,
            self.numerator + other.numerator, self.denominator + other.denominator,
            self.height + other.height, token,
        )  # fmt: skip

    __rmul__ = __mul__

    def inverse(self) -> FieldNumber:
        """Return 1 / x, the same object every time, so that its denominator keeps its token.

        Raises
        ------
        DivisionHere
            If the residue is zero.
        """
        if self._inverse is None:
            if self.residue == 0:
                raise DivisionHere("division by zero")
            field = self.field
            self._inverse = FieldNumber(
                field, pow(self.residue, -1, field.prime),
                self.denominator, self.numerator, self.height,
                field.new_token() if self.numerator else 0,
            )  # fmt: skip
        return self._inverse

    def __truediv__(self, other: Any) -> FieldNumber:
        if type(other) is not FieldNumber:
            other = self.field.rational(other)
        return self * other.inverse()

    def __rtruediv__(self, other: Any) -> FieldNumber:
        return self.inverse() * other

    def __pow__(self, exponent: int) -> FieldNumber:
        if exponent < 0:
            return self.inverse() ** -exponent
        field = self.field
        token = self.token
        if token and exponent != 1:
            token = field.common_token(token, -exponent) if exponent else 0
        return FieldNumber(
            field, pow(self.residue, exponent, field.prime),
            self.numerator * exponent, self.denominator * exponent, self.height * exponent, token,
        )  # fmt: skip
