"""The normal form: fractions of polynomials, where zero is a proof.

Generators are inputs, cosine and sine of angles (s**2 = 1 - c**2), exponentials, roots
(w**k = radicand), truth values (h**2 = h) and values of other functions. A difference whose reduced
numerator is the zero polynomial is zero wherever it has a value, with no chance of error. The
converse is not used: what is not zero here may still be zero for a reason that the relations do not
know.
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import cache
from typing import Any

from flint import fmpq, fmpz

from mechanics.errors import ExpressionError
from mechanics.kernel import radicals
from mechanics.kernel.angles import base_angles
from mechanics.kernel.quotients import NoValue, Quotient, Quotients
from mechanics.kernel.radicals import LARGEST_CONTENT
from mechanics.kernel.ring import MOST_GENERATORS, TooLarge, primitive_part
from mechanics.kernel.sizes import is_algebraic
from mechanics.kernel.statement import LEFT, RIGHT, Range, Statement
from mechanics.program import Program, interpret
from mechanics.program import operations as op

MOST_NODES = 20_000
MOST_UNKNOWNS = 6


class Fractions:
    """The domain of fractions of polynomials.

    Parameters
    ----------
    capacity : int
        Number of generators of the ring.
    """

    def __init__(self, capacity: int) -> None:
        self.quotients = a = Quotients(capacity)
        self._ring = a.ring
        unknown = ("asin", "acos", "atan", "asinh", "acosh", "atanh", "floor", "erf",
                   "atan2")  # fmt: skip
        self.operations: Mapping[str, Callable[..., Quotient]] = {
            "add": a.add, "subtract": a.subtract,
            "negate": a.negate, "multiply": a.multiply,
            "divide": a.divide,
            "sqrt": lambda x: radicals.root(a, x, 2), "power": self._power,
            "sin": lambda x: self._circle(x)[1], "cos": lambda x: self._circle(x)[0],
            "exp": self._exponential, "log": self._logarithm,
            "abs": lambda x: radicals.absolute(a, x),
            "sign": lambda x: radicals.sign(a, x),
            "less": lambda x, y: self._truth("less", a.subtract(x, y)),
            "not_greater": lambda x, y: self._not(self._truth("less", a.subtract(y, x))),
            "equal": self._equal,
            "and": a.multiply, "or": lambda x, y: self._not(
                a.multiply(self._not(x), self._not(y))),
            "not": self._not, "select": self._select,
            **{name: self._function(name) for name in unknown},
        }  # fmt: skip

    def constant(self, value: Fraction) -> Quotient:
        """A rational."""
        return self.quotients.constant(value)

    def pi(self) -> Quotient:
        """A positive generator."""
        return self.quotients.generator("pi", positive=True)

    def _not(self, x: Quotient) -> Quotient:
        return self.quotients.subtract(self.constant(Fraction(1)), x)

    # ------------------------------------------------------------------ functions

    def _key(self, x: Quotient) -> tuple[str, str]:
        return str(self._ring.reduced(x.numerator)), str(sorted(x.powers.items()))

    def _sided(self, x: Quotient) -> tuple[tuple[str, str], int]:
        """Key of x or -x, and which: opposite numbers have one key; 0 for zero."""
        numerator = self._ring.reduced(x.numerator)
        if numerator == 0:
            return self._key(x), 0
        if numerator.leading_coefficient() < 0:
            return self._key(self.quotients.negate(x)), -1
        return self._key(x), 1

    def _circle(self, x: Quotient) -> tuple[Quotient, Quotient]:
        key, side = self._sided(x)
        if not side:
            return self.constant(Fraction(1)), self.constant(Fraction(0))
        c, s = self._ring.circle(key)
        return Quotient(c, {}), Quotient(side * s, {})

    def _exponential(self, x: Quotient) -> Quotient:
        key, side = self._sided(x)
        if not side:
            return self.constant(Fraction(1))
        grown = self.quotients.generator(("exp", key), positive=True)
        return grown if side > 0 else self.quotients.inverse(grown)

    def _logarithm(self, x: Quotient) -> Quotient:
        """log(p**m q**n) = m log p + n log q for a rational; else a generator."""
        ratio = _rational(x)
        if ratio is None or not 0 < ratio <= LARGEST_CONTENT or ratio.denominator > LARGEST_CONTENT:
            return self._function("log")(x)
        total = self.constant(Fraction(0))
        for number, side in ((ratio.numerator, 1), (ratio.denominator, -1)):
            for prime, times in fmpz(number).factor():
                log = self.quotients.generator(("log", int(prime)))
                factor = self.constant(Fraction(side * int(times)))
                total = self.quotients.add(total, self.quotients.multiply(factor, log))
        return total

    def _power(self, x: Quotient, y: Quotient) -> Quotient:
        exponent = _rational(y)
        if exponent is None or not is_algebraic(exponent):
            return self._function("power")(x, y)
        result = radicals.root(self.quotients, x, exponent.denominator)
        if exponent < 0:
            result = self.quotients.inverse(result)
        times = abs(exponent.numerator)
        numerator = self._ring.power(result.numerator, times)
        powers = {factor: power * times for factor, power in result.powers.items() if times}
        return self.quotients.cancelled(numerator, powers)

    def _function(self, name: str) -> Callable[..., Quotient]:
        """A generator for each normal form of the operands."""
        return lambda *operands: self.quotients.generator((name, *(self._key(x) for x in operands)))

    def _truth(self, name: str, x: Quotient) -> Quotient:
        """A generator h with h**2 = h for each normal form, up to a positive factor."""
        numerator = self._ring.reduced(x.numerator)
        if numerator != 0:
            x = Quotient(primitive_part(numerator)[1], x.powers)
        key = (name, self._key(x))
        return Quotient(self._ring.root(key, 2, self._ring.generator(key)), {})

    def _equal(self, x: Quotient, y: Quotient) -> Quotient:
        difference = self.quotients.subtract(x, y)
        _, side = self._sided(difference)
        if not side:
            return self.constant(Fraction(1))
        return self._truth("equal", difference if side > 0 else self.quotients.negate(difference))

    def _select(self, condition: Quotient, x: Quotient, y: Quotient) -> Quotient:
        """h x + (1 - h) y."""
        return self.quotients.add(
            y, self.quotients.multiply(condition, self.quotients.subtract(x, y))
        )

    # ------------------------------------------------------------------ linear systems

    def solve(
        self, matrix: Sequence[Sequence[Quotient]], right: Sequence[Quotient], symmetric: bool
    ) -> list[Quotient]:
        """Cramer's rule: explicit determinants, so for few unknowns.

        Raises
        ------
        NoValue
            If the determinant is zero everywhere.
        TooLarge
            If there are more than a few unknowns.
        """
        size = len(right)
        if size > MOST_UNKNOWNS:
            raise TooLarge(f"{size} unknowns")
        a = self.quotients
        full = [[*row, side] for row, side in zip(matrix, right, strict=True)]

        @cache
        def minor(top: int, columns: tuple[int, ...]) -> Quotient:
            """Determinant of the rows from `top` on, by the first of them (Laplace)."""
            total = self.constant(Fraction(0 if columns else 1))
            for position, column in enumerate(columns):
                entry = full[top][column]
                if not a.is_zero(entry):
                    rest = columns[:position] + columns[position + 1 :]
                    term = a.multiply(entry, minor(top + 1, rest))
                    total = a.add(total, a.negate(term) if position % 2 else term)
            return total

        determinant = minor(0, tuple(range(size)))
        inverse = a.inverse(determinant)
        replaced = (tuple(size if c == j else c for c in range(size)) for j in range(size))
        return [a.multiply(minor(0, columns), inverse) for columns in replaced]


def _rational(x: Quotient) -> Fraction | None:
    """The rational that a fraction is as it stands, or None."""
    if x.powers or not x.numerator.is_constant():
        return None
    value = x.numerator.leading_coefficient() if x.numerator != 0 else fmpq(0)
    return Fraction(int(value.p), int(value.q))


_FREE = frozenset({*range(8), op.SELECT, op.SOLVE, op.ENTRY})
"""Leaves, arithmetic, and what is written in it."""


def capacity(program: Program) -> int:
    """Most generators that a program can ask for: two for an angle, some for a root."""
    needs = (2 if code in (op.SIN, op.COS) else 4 for code in program.operations
             if code not in _FREE)  # fmt: skip
    return len(program.inputs) + 1 + sum(needs)


def proves(statement: Statement) -> bool:
    """Whether both sides have the same normal form, entry by entry.

    False says nothing: too large, an operation without normal form, or really different. Angles are
    first kept whole, which is shorter and enough where both sides were built on the same angles.
    """
    program = statement.program
    unknowns = max((system[0] for system in program.systems), default=0)
    if len(program) > MOST_NODES or unknowns > MOST_UNKNOWNS:
        return False
    whole, expanded = base_angles(program, 0), base_angles(program)
    return _attempt(statement, whole) or (expanded != whole and _attempt(statement, expanded))


def _attempt(statement: Statement, program: Program) -> bool:
    try:
        domain = Fractions(min(capacity(program), MOST_GENERATORS))
        inputs: dict[str, Any] = {
            name: _input(domain, name, statement.range_of(name)) for name in program.inputs
        }
        outputs = interpret(program, domain, inputs)
        return all(
            domain.quotients.is_zero(domain.operations["subtract"](x, y))
            for x, y in zip(outputs[LEFT], outputs[RIGHT], strict=True)
        )
    except (TooLarge, NoValue, ExpressionError):
        return False  # the field's answer stands


def _input(domain: Fractions, name: str, known: Range) -> Quotient:
    if known is Range.NEGATIVE:
        return domain.quotients.negate(domain.quotients.generator(("input", name), positive=True))
    return domain.quotients.generator(("input", name), positive=known is not Range.FREE)
