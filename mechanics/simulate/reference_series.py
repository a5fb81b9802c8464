"""Taylor coefficients of y' = f(y) for a graph, order by order, in fixed-point integers.

    c_j = y^(j)(t) h^j / j!                    kept as c_j 2^P, rounded
    product    (a b)_j = sum_i a_i b_(j-i)
    quotient   (a/b)_j = (a_j - sum_(i<j) (a/b)_i b_(j-i)) / b_0
    chain      y' = x' g(x)   gives   j y_j = sum_(i>0) i x_i g_(j-i)

Griewank and Walther, Evaluating Derivatives, chapter 13. Python's integers have as many digits as
are wanted; how many of them are right is found by comparing runs with different P. Every rule is
written twice, as a function here and as a line for `reference_native`, which is faster.
"""

from collections.abc import Callable, Sequence
from operator import mul

import casadi as ca
from flint import arb

from mechanics.compiled.programs.program import Program
from mechanics.errors import SingularError
from mechanics.exact.balls import precision
from mechanics.simulate.reference_native import Line, Op, Recurrence, reciprocal
from mechanics.simulate.reference_operations import OPERATIONS, not_analytic

Rule = Callable[[int], None]


class Series(list[int]):
    """Coefficients of one value; a constant one has the first only.

    Attributes
    ----------
    place : int
        Among the series that move, or among the numbers.
    constant : bool
    slope : Series or None
        The numbers i x_i, i > 0, once they are needed.
    waves : mapping of bool to (Series, Series)
        Sine and cosine, or by False their hyperbolic sisters, once they are needed.
    """

    def __init__(self, place: int, entries: Sequence[int] = (), constant: bool = False) -> None:
        super().__init__(entries)
        self.place, self.constant = place, constant
        self.slope: Series | None = None
        self.waves: dict[bool, tuple[Series, Series]] = {}


class Taylor:
    """The rules that extend every value of a program by one order.

    Parameters
    ----------
    code : Program
        Of y' from the state, the first input, and numbers that stay, the other inputs.
    held : sequence of sequence of int
        These numbers, times 2^P.
    bits : int
        P.
    compiler : str or None
        For the recurrences in C.

    Raises
    ------
    ExpressionError
        If the program holds an operation that is not analytic; it is named.
    SingularError
        If a divisor that stays is zero.
    """

    def __init__(
        self,
        code: Program,
        held: Sequence[Sequence[int]],
        bits: int,
        compiler: str | None = None,
    ) -> None:
        self.bits = bits
        self._rules: list[tuple[Rule, Line]] = []
        self._moving: list[Series] = []
        self._numbers: list[int] = []
        self._shifts: list[int] = []
        self._divisors: list[tuple[int, Series]] = []
        self._state = [self._moved() for _ in range(code.inputs[0][1])]
        given = [self._state, *([self._fixed(value) for value in group] for group in held)]
        try:
            values = self._build(code, given)
        except ZeroDivisionError as error:
            raise SingularError("the equations are singular everywhere: a divisor is zero") from (
                error
            )
        self._rates = [values[k] for k in code.outputs[0]]
        places = [-1 - rate.place if rate.constant else rate.place for rate in self._rates]
        self._native = Recurrence(
            compiler,
            bits,
            [line for _, line in self._rules],
            [(y.place, place) for y, place in zip(self._state, places, strict=True)],
            len(self._moving),
        )

    def _build(self, code: Program, given: list[list[Series]]) -> list[Series]:
        values: list[Series] = []
        for operation, operands, constant in code.nodes:
            if constant is not None:
                values.append(self.number(constant))
            elif operation == ca.OP_INPUT:
                values.append(given[operands[0]][operands[1]])
            elif operation in OPERATIONS:
                values.append(OPERATIONS[operation](self, *(values[k] for k in operands)))
            else:
                raise not_analytic(operation)
        return values

    def expand(self, start: Sequence[int], step: int, order: int) -> list[list[int]]:
        """Coefficients 0 to `order` of every entry of the state, for h = step / 2^P.

        Raises
        ------
        SingularError
            If a divisor is zero at the start.
        """
        for series in self._moving:
            series.clear()
        for series, value in zip(self._state, start, strict=True):
            series.append(value)
        try:
            for rule, _ in self._rules:
                rule(0)
            for place, divisor in self._divisors:
                self._numbers[place], self._shifts[place] = reciprocal(divisor[0], self.bits)
        except ZeroDivisionError as error:
            raise SingularError("the equations are singular there: a divisor is zero") from error
        first = [series[0] if series else 0 for series in self._moving]
        found = self._native.expand(order, first, self._numbers, self._shifts, step)
        return found or self._expanded(step, order)

    def _expanded(self, step: int, order: int) -> list[list[int]]:
        """The orders above zero, in Python's integers."""
        for j in range(order):
            if j:
                for rule, _ in self._rules:
                    rule(j)
            for series, rate in zip(self._state, self._rates, strict=True):
                value = rate[j] if j < len(rate) else 0
                series.append((value * step >> self.bits) // (j + 1))
        return [list(series) for series in self._state]

    def number(self, value: float) -> Series:
        """A constant."""
        numerator, denominator = float(value).as_integer_ratio()
        return self._fixed((numerator << self.bits) // denominator)

    def _fixed(self, value: int) -> Series:
        return Series(self._held(value), [value], constant=True)

    def _held(self, value: int, shift: int = 0) -> int:
        """The place of a number that rules refer to."""
        self._numbers.append(value)
        self._shifts.append(shift)
        return len(self._numbers) - 1

    def _moved(self) -> Series:
        self._moving.append(Series(len(self._moving)))
        return self._moving[-1]

    def _made(
        self, rule_for: Callable[[Series], Rule], op: Op, *operands: Series, number: int = 0
    ) -> Series:
        """A new value; it is constant, and computed at once, where all operands are."""
        if all(operand.constant for operand in operands):
            out = Series(0)
            rule_for(out)(0)
            return self._fixed(out[0])
        out = self._moved()
        a, b = [*(-1 if x.constant else x.place for x in operands), 0][:2]
        self._rules.append((rule_for(out), Line(op, out.place, a, b, number)))
        return out

    def sum(self, a: Series, b: Series, sign: int = 1) -> Series:
        """A + b or a - b."""
        if b.constant:
            return self._made(
                lambda out: lambda j: out.append(a[j] + (0 if j else sign * b[0])), Op.COPY, a
            )
        if a.constant:
            return self._made(
                lambda out: lambda j: out.append((0 if j else a[0]) + sign * b[j]),
                Op.SCALED, b, number=sign,
            )  # fmt: skip
        if sign < 0:
            return self._made(lambda out: lambda j: out.append(a[j] - b[j]), Op.DIFFERENCE, a, b)
        return self._made(lambda out: lambda j: out.append(a[j] + b[j]), Op.SUM, a, b)

    def product(self, a: Series, b: Series) -> Series:
        """A b."""
        bits = self.bits
        if a.constant or b.constant:
            x, factor = (a, b) if b.constant else (b, a)
            return self._made(
                lambda out: lambda j: out.append(x[j] * factor[0] >> bits),
                Op.TIMES, x, number=factor.place,
            )  # fmt: skip
        return self._made(
            lambda out: lambda j: out.append(sum(map(mul, a, reversed(b))) >> bits),
            Op.PRODUCT, a, b,
        )  # fmt: skip

    def scaled(self, a: Series, factor: int) -> Series:
        """A times a small integer."""
        return self._made(
            lambda out: lambda j: out.append(factor * a[j]), Op.SCALED, a, number=factor
        )

    def quotient(self, a: Series, b: Series) -> Series:
        """A / b."""
        bits = self.bits
        if b.constant:
            place = self._held(*reciprocal(b[0], bits))
            return self._made(
                lambda out: lambda j: out.append((a[j] << bits) // b[0]), Op.OVER, a, number=place
            )

        def rule_for(out: Series) -> Rule:
            def rule(j: int) -> None:
                above = 0 if j and a.constant else a[j]
                out.append(((above << bits) - sum(map(mul, out, reversed(b)))) // b[0])

            return rule

        place = self._held(0)
        self._divisors.append((place, b))
        return self._made(rule_for, Op.QUOTIENT, a, b, number=place)

    def chain(
        self,
        x: Series,
        first: Callable[[arb], arb],
        factor: Callable[[Series], Series],
        sign: int = 1,
    ) -> Series:
        """y with y_0 = first(x_0) and y' = sign x' g, where g = factor(y)."""
        if x.constant:
            return self._fixed(self._first(x, first))
        self._slope(x)
        out, at = self._moved(), len(self._rules)
        # The rule for y needs lower orders of g only, and those for g may need this one of y.
        self._rules.insert(at, self._chained(out, x, factor(out), first, sign))
        return out

    def wave(self, x: Series, circular: bool) -> tuple[Series, Series]:
        """(sin x, cos x), or (sinh x, cosh x)."""
        if circular not in x.waves:
            functions = (arb.sin, arb.cos) if circular else (arb.sinh, arb.cosh)
            if x.constant:
                odd, even = (self._fixed(self._first(x, function)) for function in functions)
            else:
                odd, even = self._moved(), self._moved()
                self._rules.append(self._chained(odd, x, even, functions[0], 1))
                sign = -1 if circular else 1
                self._rules.append(self._chained(even, x, odd, functions[1], sign))
            x.waves[circular] = odd, even
        return x.waves[circular]

    def _chained(
        self, out: Series, x: Series, g: Series, first: Callable[[arb], arb], sign: int
    ) -> tuple[Rule, Line]:
        bits, slope = self.bits, self._slope(x)

        def rule(j: int) -> None:
            if j == 0:
                out.append(self._first(x, first))
            elif g.constant:
                out.append((sign * slope[-1] * g[0] >> bits) // j)
            else:
                out.append((sign * sum(map(mul, slope, g[j - 1 :: -1])) >> bits) // j)

        op = Op.CHAIN_CONSTANT if g.constant else Op.CHAIN
        return rule, Line(op, out.place, slope.place, g.place, sign)

    def _slope(self, x: Series) -> Series:
        if x.slope is None:
            slope = x.slope = self._moved()
            line = Line(Op.SLOPE, slope.place, x.place)
            self._rules.append((lambda j: slope.append(j * x[j]) if j else None, line))
        return x.slope

    def _first(self, x: Series, function: Callable[[arb], arb]) -> int:
        """A function of the first coefficient, by Arb."""
        with precision(self.bits + x[0].bit_length() + 32):
            value = function(arb(x[0]) / arb(2) ** self.bits)
            if not value.is_finite():
                raise SingularError(
                    f"a function is undefined on the way, at {x[0] / 2**self.bits:g}"
                )
            mantissa, exponent = (int(part) for part in value.mid().man_exp())
        shift = exponent + self.bits
        return mantissa << shift if shift >= 0 else mantissa >> -shift
