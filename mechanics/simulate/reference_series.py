"""Taylor coefficients of y' = f(y) in fixed-point integers: numbers times 2^P, rounded down.

    c_j = y^(j)(t) h^j / j!

The rules are those of `mechanics.program.taylor`. Python's integers have as many digits as are
wanted; how many of them are right is found by comparing runs with different P. The orders above
zero, which cost the time, follow in C where there is a compiler.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from operator import add, mul, neg, sub

from flint import arb

from mechanics.errors import SingularError
from mechanics.kernel.balls import Balls, precision
from mechanics.program import interpret
from mechanics.program.taylor import Kind, Recurrences, expand
from mechanics.simulate.reference_native import Recurrence

# Bits that Arb works with beyond those of the number, so that what is rounded is the last one.
GUARD = 32


@dataclass(frozen=True)
class FixedPoint:
    """The domain of fixed-point integers; functions by Arb.

    Attributes
    ----------
    bits : int
        P.
    """

    bits: int

    @cached_property
    def operations(self) -> Mapping[str, Callable[..., int]]:
        """On numbers times 2^P; a division by zero raises ZeroDivisionError."""
        bits = self.bits
        return {name: self._by_arb(function) for name, function in Balls.operations.items()} | {
            "add": add, "subtract": sub, "negate": neg,
            "multiply": lambda a, b: a * b >> bits,
            "divide": lambda a, b: (a << bits) // b,
        }  # fmt: skip

    def constant(self, value: Fraction) -> int:
        """The rational, rounded down."""
        return (value.numerator << self.bits) // value.denominator

    def pi(self) -> int:
        """The number pi."""
        with precision(self.bits + GUARD):
            return self._fixed(arb.pi())

    def dot(self, u: Iterable[int], w: Iterable[int]) -> int:
        """The sum of products, rounded once."""
        return sum(map(mul, u, w)) >> self.bits

    def _by_arb(self, function: Callable[..., arb]) -> Callable[..., int]:
        def call(*operands: int) -> int:
            size = max(x.bit_length() for x in operands)
            with precision(self.bits + size + GUARD):
                return self._fixed(function(*(arb((x, -self.bits)) for x in operands)))

        return call

    def _fixed(self, value: arb) -> int:
        if not value.is_finite():
            raise SingularError("a function is undefined on the way")
        mantissa, exponent = (int(part) for part in value.mid().man_exp())
        shift = exponent + self.bits
        return mantissa << shift if shift >= 0 else mantissa >> -shift


class Taylor:
    """Series of the state of a motion.

    Parameters
    ----------
    rules : Recurrences
    state : sequence of str
        What moves.
    held : mapping of str to int
        What stays, times 2^P.
    bits : int
        P.
    compiler : str or None
        For the recurrences in C.

    Raises
    ------
    SingularError
        If a divisor that stays is zero.
    """

    def __init__(
        self,
        rules: Recurrences,
        state: Sequence[str],
        held: Mapping[str, int],
        bits: int,
        compiler: str | None = None,
    ) -> None:
        self._numbers, self._state = FixedPoint(bits), tuple(state)
        self._rules = rules
        try:
            constants = interpret(rules.constants, self._numbers, held)["constants"]
            for step in rules.steps:
                if step.kind is Kind.OVER:
                    self._numbers.operations["divide"](1, constants[-1 - step.b])
        except ZeroDivisionError as error:
            raise SingularError("the equations are singular everywhere: a divisor is zero") from (
                error
            )
        self._constants = constants
        self._held = {f"c{k}": value for k, value in enumerate(constants)}
        self._native = Recurrence(compiler, bits, rules, constants)

    def expand(self, start: Sequence[int], step: int, order: int) -> list[list[int]]:
        """Coefficients 0 to `order` of every entry of the state, for h = step / 2^P.

        Raises
        ------
        SingularError
            If a divisor is zero at the start.
        """
        given = {**dict(zip(self._state, start, strict=True)), **self._held}
        rules, numbers = self._rules, self._numbers
        try:
            first = interpret(rules.first, numbers, given, release=False)["first"]
        except ZeroDivisionError as error:
            raise SingularError("the equations are singular there: a divisor is zero") from error
        found = self._native.expand(order, first, step)
        return found or expand(rules, numbers, first, self._constants, step, order, numbers.dot)
