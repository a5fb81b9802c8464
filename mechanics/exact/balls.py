"""Arb balls at a real, rational state: rigorous enclosures, hence witnesses.

A ball [m - r, m + r] contains the true value; disjoint balls prove that two values differ. What is
undefined at the state (a negative radicand, a division by zero, a comparison that cannot be told)
becomes a ball that is not finite, and the state is drawn again.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from fractions import Fraction
from typing import Any

import sympy
from flint import arb, arb_mat, ctx, fmpq

from mechanics.errors import ExpressionError
from mechanics.exact.arithmetic import Arithmetic, Term, as_fraction
from mechanics.exact.signals import Inadmissible, SingularHere

CONSTANTS = {
    sympy.S.Pi: arb.pi, sympy.S.Exp1: arb.const_e, sympy.S.EulerGamma: arb.const_euler,
    sympy.S.Catalan: arb.const_catalan,
}  # fmt: skip

FUNCTIONS = {
    "log": arb.log, "asin": arb.asin, "acos": arb.acos, "atan": arb.atan, "atan2": arb.atan2,
    "asinh": arb.asinh, "acosh": arb.acosh, "atanh": arb.atanh, "erf": arb.erf,
    "floor": arb.floor, "ceil": arb.ceil, "power": arb.__pow__,
}  # fmt: skip


@contextmanager
def precision(bits: int) -> Iterator[None]:
    """Work with `bits` binary digits; Arb keeps the precision in a global."""
    before = ctx.prec
    ctx.prec = bits
    try:
        yield
    finally:
        ctx.prec = before


def ball(number: Any) -> arb:
    """Return an exact rational, or a ball as it is, as an Arb ball."""
    if isinstance(number, arb):
        return number
    ratio = as_fraction(number)
    return arb(fmpq(ratio.numerator, ratio.denominator))


class Ball:
    """An Arb ball that mixes with Python and SymPy rationals."""

    __slots__ = ("arb",)

    def __init__(self, value: arb) -> None:
        self.arb = value

    def __repr__(self) -> str:
        return f"Ball({self.arb})"

    def __add__(self, other: Any) -> Ball:
        return Ball(self.arb + _arb(other))

    __radd__ = __add__

    def __sub__(self, other: Any) -> Ball:
        return Ball(self.arb - _arb(other))

    def __rsub__(self, other: Any) -> Ball:
        return Ball(_arb(other) - self.arb)

    def __mul__(self, other: Any) -> Ball:
        return Ball(self.arb * _arb(other))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Ball:
        return Ball(self.arb / _arb(other))

    def __rtruediv__(self, other: Any) -> Ball:
        return Ball(_arb(other) / self.arb)

    def __neg__(self) -> Ball:
        return Ball(-self.arb)

    def __pow__(self, exponent: int) -> Ball:
        return Ball(self.arb**exponent)


def _arb(number: Any) -> arb:
    return number.arb if isinstance(number, Ball) else ball(number)


class BallArithmetic(Arithmetic):
    """Arithmetic at one real state.

    Parameters
    ----------
    state : State
        Gives every symbol its value, drawing it when it is first asked for.
    """

    def __init__(self, state: State) -> None:
        super().__init__()
        self._state = state

    def rational(self, number: int | Fraction) -> Ball:
        """Return the enclosure of a rational."""
        return Ball(ball(number))

    def symbol(self, symbol: sympy.Symbol) -> Ball:
        """Return the value of the symbol at the state."""
        return Ball(ball(self._state.value(symbol)))

    def constant(self, constant: sympy.Expr) -> Ball:
        """Return the enclosure of pi, E, ..."""
        if constant is sympy.S.GoldenRatio:
            return Ball((1 + arb(5).sqrt()) / 2)
        if constant not in CONSTANTS:
            raise ExpressionError(f"constant {constant} has no enclosure: declare it as a symbol")
        return Ball(CONSTANTS[constant]())

    def _sum(self, terms: Sequence[Term]) -> arb:
        return sum((ball(factor) * number.arb for factor, number in terms), arb(0))

    def circle(self, terms: Sequence[Term]) -> tuple[Ball, Ball]:
        """Return cos and sin of the sum."""
        s, c = self._sum(terms).sin_cos()
        return Ball(c), Ball(s)

    def exponential(self, terms: Sequence[Term]) -> Ball:
        """Return exp of the sum."""
        return Ball(self._sum(terms).exp())

    def root_power(self, number: Ball, exponent: Fraction) -> Ball:
        """Return the positive root's power; not finite where the radicand is negative."""
        if number.arb < 0:
            return Ball(arb.nan())
        if exponent.denominator == 2:
            return Ball(number.arb.sqrt() ** exponent.numerator)
        return Ball(number.arb.root(exponent.denominator) ** exponent.numerator)

    def absolute(self, number: Ball) -> Ball:
        """Return the absolute value."""
        return Ball(abs(number.arb))

    def sign(self, number: Ball) -> Ball:
        """Return the sign, or [-1, 1] where it cannot be told."""
        return Ball(number.arb.sgn())

    def indicator(self, relation: str, difference: Ball) -> Ball:
        """Return 1 or 0, or a ball that is not finite where the comparison cannot be told."""
        x = difference.arb
        if relation == "==":
            known = (True,) if x.is_zero() else (() if x.contains(0) else (False,))
        else:
            strict = relation == "<"
            yes, no = (x < 0, x >= 0) if strict else (x <= 0, x > 0)
            known = (True,) if yes else ((False,) if no else ())
        return Ball(arb(int(known[0])) if known else arb.nan())

    def select(self, condition: Ball, yes: Ball, no: Ball) -> Ball:
        """Return the branch that the condition takes."""
        if condition.arb == 1:
            return yes
        return no if condition.arb == 0 else Ball(arb.nan())

    def function(self, name: str, arguments: Sequence[Ball]) -> Ball:
        """Return an elementary function, or what the state has chosen for an unknown one."""
        values = [argument.arb for argument in arguments]
        if name in FUNCTIONS:
            return Ball(FUNCTIONS[name](*values))
        result = ball(self._state.unknown(name, 0))
        for place, value in enumerate(values, 1):
            result = result + ball(self._state.unknown(name, place)) * value * value
        return Ball(result)

    def solve(self, rows: Sequence[Sequence[Ball]], rhs: Sequence[Ball]) -> list[Ball]:
        """Solve by Arb's certified elimination."""
        if not rows:
            return []
        matrix = arb_mat([[_arb(entry) for entry in row] for row in rows])
        try:
            solution = matrix.solve(arb_mat([[_arb(entry)] for entry in rhs]))
        except ZeroDivisionError as error:
            raise SingularHere("singular matrix") from error
        return [Ball(entry) for entry in solution.entries()]

    def rank(self, rows: Sequence[Sequence[Ball]]) -> int:
        """Return the number of pivots that are certainly not zero: a lower bound of the rank."""
        left = [[_arb(entry) for entry in row] for row in rows]
        count = 0
        for column in range(len(left[0]) if left else 0):
            sure = [i for i in range(count, len(left)) if not left[i][column].contains(0)]
            if not sure:
                continue
            best = max(sure, key=[float(row[column].abs_lower()) for row in left].__getitem__)
            left[count], left[best] = left[best], left[count]
            for i in range(count + 1, len(left)):
                factor = left[i][column] / left[count][column]
                left[i] = [x - factor * y for x, y in zip(left[i], left[count], strict=True)]
            count += 1
        return count

    def is_zero(self, number: Ball) -> bool:
        """Tell whether the ball contains zero."""
        return bool(_arb(number).contains(0))

    def require_positive(self, number: Ball) -> None:
        """Ask for another state unless the ball is positive."""
        if not number.arb > 0:
            raise Inadmissible("a quantity that must be positive is not")


class State:
    """Values of symbols: given, or drawn when first asked for.

    Positive symbols are drawn from (1/4, 4), others from (-3, 3), as multiples of 1/8 or finer, so
    that a person can type a witness into something else.
    """

    def __init__(self, given: Mapping[sympy.Symbol, Any], source: Any = None) -> None:
        self._values: dict[sympy.Symbol, Any] = dict(given)
        self._unknown: dict[tuple[str, int], Fraction] = {}
        self._source = source

    def value(self, symbol: sympy.Symbol) -> Any:
        """Return the value of a symbol.

        Raises
        ------
        ExpressionError
            If the state is a given one and has no value for it.
        """
        if symbol not in self._values:
            if self._source is None:
                raise ExpressionError(f"symbol {symbol} has no value: add it to the values")
            self._values[symbol] = self._drawn(symbol)
        return self._values[symbol]

    def _drawn(self, symbol: sympy.Symbol) -> Fraction:
        if symbol.is_nonnegative or symbol.is_negative:
            size = Fraction(self._source.randrange(17, 256), 64)
            return -size if symbol.is_negative else size
        size = Fraction(self._source.randrange(1, 192), 64)
        return size if self._source.random() < 0.5 else -size

    def unknown(self, name: str, place: int) -> Fraction:
        """Return a coefficient of the concrete function that an undefined one is taken for.

        Raises
        ------
        ExpressionError
            If the state is a given one.
        """
        if (name, place) not in self._unknown:
            if self._source is None:
                raise ExpressionError(f"{name} has no value: replace it by a symbol")
            self._unknown[name, place] = Fraction(self._source.randrange(1, 192), 64)
        return self._unknown[name, place]

    def items(self) -> tuple[tuple[str, str], ...]:
        """Return names and values in words, sorted, for a witness."""
        named = [(str(symbol), str(value)) for symbol, value in self._values.items()]
        for name in sorted({name for name, _ in self._unknown}):
            parts = [
                str(c)
                for (n, place), c in sorted(self._unknown.items())
                if n == name and place == 0
            ]
            parts += [
                f"{c}*x{place}**2"
                for (n, place), c in sorted(self._unknown.items())
                if n == name and place > 0
            ]
            named.append((name, " + ".join(parts)))
        return tuple(sorted(named))
