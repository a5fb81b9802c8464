"""The normal form: fractions of polynomials, where zero is a proof.

Generators are inputs, cosine and sine of angles (s**2 = 1 - c**2), exponentials, roots
(w**k = radicand), truth values (h**2 = h) and values of other functions. A difference whose reduced
numerator is the zero polynomial is zero wherever it has a value, with no chance of error. The
converse is not used: what is not zero here may still be zero for a reason that the relations do not
know.

The denominator of a fraction stays factored: two fractions are added over the least common multiple
of factors that are recognised, so no greatest common divisor is ever computed.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any

from flint import fmpq, fmpq_mpoly

from mechanics.errors import ExpressionError
from mechanics.kernel import radicals
from mechanics.kernel.angles import base_angles
from mechanics.kernel.ring import MOST_GENERATORS, Ring, TooLarge, content
from mechanics.kernel.sizes import is_algebraic
from mechanics.kernel.statement import LEFT, RIGHT, Range, Statement
from mechanics.program import Program, interpret
from mechanics.program.operations import (
    ARITY,
    CONSTANT,
    COS,
    ENTRY,
    INPUT,
    PI,
    SELECT,
    SIN,
    SOLVE,
    TAN,
)

MOST_NODES = 20_000
MOST_UNKNOWNS = 6

Powers = dict[int, int]
"""Power of each factor of a denominator, by its number."""


class NoValue(ArithmeticError):
    """A divisor or determinant is zero everywhere."""


@dataclass(frozen=True)
class Quotient:
    """A fraction: numerator, and the powers of the factors of its denominator."""

    numerator: fmpq_mpoly
    powers: Powers


class Fractions:
    """The domain of fractions of polynomials.

    Parameters
    ----------
    capacity : int
        Number of generators of the ring.
    """

    def __init__(self, capacity: int) -> None:
        self.ring = Ring(capacity)
        self.factors: list[fmpq_mpoly] = []
        unknown = ("log", "asin", "acos", "atan", "asinh", "acosh", "atanh", "floor", "erf",
                   "atan2")  # fmt: skip
        self.operations: Mapping[str, Callable[..., Quotient]] = {
            "add": self.add, "subtract": lambda x, y: self.add(x, self.negate(y)),
            "negate": self.negate, "multiply": self.multiply,
            "divide": lambda x, y: self.multiply(x, self.inverse(y)),
            "sqrt": lambda x: radicals.root(self, x, 2), "power": self._power,
            "sin": lambda x: self._circle(x)[1], "cos": lambda x: self._circle(x)[0],
            "tan": lambda x: self._divide(*reversed(self._circle(x))),
            "exp": self._exponential, "sinh": lambda x: self._hyperbolic(x)[1],
            "cosh": lambda x: self._hyperbolic(x)[0],
            "tanh": lambda x: self._divide(*reversed(self._hyperbolic(x))),
            "abs": lambda x: radicals.absolute(self, x),
            "sign": lambda x: self._divide(radicals.absolute(self, x), x),
            "less": lambda x, y: self._truth("less", self._difference(x, y)),
            "not_greater": lambda x, y: self._not(self._truth("less", self._difference(y, x))),
            "equal": self._equal,
            "and": self.multiply, "or": lambda x, y: self._not(
                self.multiply(self._not(x), self._not(y))),
            "not": self._not, "select": self._select,
            **{name: self._function(name) for name in unknown},
        }  # fmt: skip

    # ------------------------------------------------------------------ leaves

    def constant(self, value: Fraction) -> Quotient:
        """A rational."""
        return Quotient(self.ring.constant(value), {})

    def pi(self) -> Quotient:
        """A positive generator."""
        return self.generator("pi", positive=True)

    def generator(self, key: Hashable, positive: bool = False) -> Quotient:
        """The generator of a key."""
        return Quotient(self.ring.generator(key, positive), {})

    # ------------------------------------------------------------------ arithmetic

    def add(self, x: Quotient, y: Quotient) -> Quotient:
        """x + y, over the least common multiple of the factors that are recognised."""
        if x.powers == y.powers:
            return Quotient(x.numerator + y.numerator, x.powers)
        common = dict(x.powers)
        for factor, power in y.powers.items():
            common[factor] = max(common.get(factor, 0), power)
        return Quotient(self._over(x, common) + self._over(y, common), common)

    def negate(self, x: Quotient) -> Quotient:
        """-x."""
        return Quotient(-x.numerator, x.powers)

    def multiply(self, x: Quotient, y: Quotient) -> Quotient:
        """x y."""
        numerator = self.ring.product(x.numerator, y.numerator)
        if not (x.powers or y.powers):
            return Quotient(numerator, {})
        powers = dict(x.powers)
        for factor, power in y.powers.items():
            powers[factor] = powers.get(factor, 0) + power
        return self._cancelled(numerator, powers)

    def inverse(self, x: Quotient) -> Quotient:
        """1 / x.

        Raises
        ------
        NoValue
            If x is zero everywhere.
        """
        numerator = self.ring.reduced(x.numerator)
        if numerator == 0:
            raise NoValue("division by zero")
        unit, powers = self._factored(numerator)
        return self._cancelled(self.denominator(x.powers) / unit, powers)

    def is_zero(self, x: Quotient) -> bool:
        """Whether it is zero wherever it has a value."""
        return bool(self.ring.reduced(x.numerator) == 0)

    def denominator(self, powers: Powers) -> fmpq_mpoly:
        """A denominator multiplied out."""
        result = self.ring.constant(1)
        for factor, power in powers.items():
            result = self.ring.product(result, self.ring.power(self.factors[factor], power))
        return result

    def _divide(self, x: Quotient, y: Quotient) -> Quotient:
        return self.multiply(x, self.inverse(y))

    def _difference(self, x: Quotient, y: Quotient) -> Quotient:
        return self.add(x, self.negate(y))

    def _not(self, x: Quotient) -> Quotient:
        return self._difference(self.constant(Fraction(1)), x)

    def _over(self, x: Quotient, common: Powers) -> fmpq_mpoly:
        """The numerator of x over a common denominator."""
        missing = {f: n - x.powers.get(f, 0) for f, n in common.items() if n > x.powers.get(f, 0)}
        return self.ring.product(x.numerator, self.denominator(missing)) if missing else x.numerator

    def _factored(self, x: fmpq_mpoly) -> tuple[fmpq, Powers]:
        """A polynomial as constant times known factors: generators and one remainder."""
        powers: Powers = {}
        monomial = x.term_content()
        for place, power in enumerate(monomial.degrees()):
            if power > 0:
                powers[self._factor(self.ring.gen(place))] = int(power)
        rest = x / (monomial / monomial.leading_coefficient())
        unit = rest.leading_coefficient()
        if not rest.is_constant():
            powers[self._factor(rest / unit)] = 1
        return unit, powers

    def _factor(self, polynomial: fmpq_mpoly) -> int:
        for number, known in enumerate(self.factors):
            if known == polynomial:
                return number
        self.factors.append(polynomial)
        return len(self.factors) - 1

    def _cancelled(self, numerator: fmpq_mpoly, powers: Powers) -> Quotient:
        """A fraction without the factors that divide the numerator as it stands."""
        left = {}
        for factor, power in powers.items():
            divisor = self.factors[factor]
            self.ring.spend(len(numerator))
            while power:
                quotient, remainder = divmod(numerator, divisor)
                if remainder != 0:
                    break
                numerator, power = quotient, power - 1
            if power:
                left[factor] = power
        return Quotient(numerator, left)

    # ------------------------------------------------------------------ functions

    def _key(self, x: Quotient) -> tuple[str, str]:
        return str(self.ring.reduced(x.numerator)), str(sorted(x.powers.items()))

    def _sided(self, x: Quotient) -> tuple[tuple[str, str], int]:
        """Key of x or -x, and which: opposite numbers have one key; 0 for zero."""
        numerator = self.ring.reduced(x.numerator)
        if numerator == 0:
            return self._key(x), 0
        if numerator.leading_coefficient() < 0:
            return self._key(self.negate(x)), -1
        return self._key(x), 1

    def _circle(self, x: Quotient) -> tuple[Quotient, Quotient]:
        key, side = self._sided(x)
        if not side:
            return self.constant(Fraction(1)), self.constant(Fraction(0))
        c, s = self.ring.circle(key)
        return Quotient(c, {}), Quotient(side * s, {})

    def _exponential(self, x: Quotient) -> Quotient:
        key, side = self._sided(x)
        if not side:
            return self.constant(Fraction(1))
        grown = self.generator(("exp", key), positive=True)
        return grown if side > 0 else self.inverse(grown)

    def _hyperbolic(self, x: Quotient) -> tuple[Quotient, Quotient]:
        grown, half = self._exponential(x), self.constant(Fraction(1, 2))
        shrunk = self.inverse(grown)
        c, s = self.add(grown, shrunk), self._difference(grown, shrunk)
        return self.multiply(c, half), self.multiply(s, half)

    def _power(self, x: Quotient, y: Quotient) -> Quotient:
        if y.powers or not y.numerator.is_constant():
            return self._function("power")(x, y)
        value = y.numerator.leading_coefficient() if y.numerator != 0 else fmpq(0)
        exponent = Fraction(int(value.p), int(value.q))
        if not is_algebraic(exponent):
            return self._function("power")(x, y)
        result = radicals.root(self, x, exponent.denominator)
        if exponent < 0:
            result = self.inverse(result)
        times = abs(exponent.numerator)
        numerator = self.ring.power(result.numerator, times)
        powers = {factor: power * times for factor, power in result.powers.items() if times}
        return self._cancelled(numerator, powers)

    def _function(self, name: str) -> Callable[..., Quotient]:
        """A generator for each normal form of the operands."""
        return lambda *operands: self.generator((name, *(self._key(x) for x in operands)))

    def _truth(self, name: str, x: Quotient) -> Quotient:
        """A generator h with h**2 = h for each normal form, up to a positive factor."""
        numerator = self.ring.reduced(x.numerator)
        if numerator != 0:
            unit = content(numerator)
            x = Quotient(numerator / fmpq(unit.numerator, unit.denominator), x.powers)
        place, new = self.ring.place((name, self._key(x)))
        h = self.ring.gen(place)
        if new:
            self.ring.relate(place, 2, h**2 - h)
        return Quotient(h, {})

    def _equal(self, x: Quotient, y: Quotient) -> Quotient:
        difference = self._difference(x, y)
        _, side = self._sided(difference)
        if not side:
            return self.constant(Fraction(1))
        return self._truth("equal", difference if side > 0 else self.negate(difference))

    def _select(self, condition: Quotient, x: Quotient, y: Quotient) -> Quotient:
        """h x + (1 - h) y."""
        return self.add(y, self.multiply(condition, self._difference(x, y)))

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
        full = [[*row, side] for row, side in zip(matrix, right, strict=True)]

        @cache
        def minor(top: int, columns: tuple[int, ...]) -> Quotient:
            """Determinant of the rows from `top` on, by the first of them (Laplace)."""
            total = self.constant(Fraction(0 if columns else 1))
            for position, column in enumerate(columns):
                entry = full[top][column]
                if not self.is_zero(entry):
                    rest = columns[:position] + columns[position + 1 :]
                    term = self.multiply(entry, minor(top + 1, rest))
                    total = self.add(total, self.negate(term) if position % 2 else term)
            return total

        determinant = minor(0, tuple(range(size)))
        inverse = self.inverse(determinant)
        replaced = (tuple(size if c == j else c for c in range(size)) for j in range(size))
        return [self.multiply(minor(0, columns), inverse) for columns in replaced]


_PLAIN = frozenset({CONSTANT, INPUT, PI, SELECT, SOLVE, ENTRY})


def capacity(program: Program) -> int:
    """Most generators that a program can ask for: two for an angle, some for a root."""
    count = len(program.inputs) + 1
    for code in program.operations:
        if code in (SIN, COS, TAN):
            count += 2
        elif ARITY[code] and code not in _PLAIN and code not in _ARITHMETIC:
            count += 4
    return count


_ARITHMETIC = frozenset(range(CONSTANT, 8))


def proves(statement: Statement) -> bool:
    """Whether both sides have the same normal form, entry by entry.

    False says nothing: too large, an operation without normal form, or really different. Angles are
    first kept whole, which is shorter and enough where both sides were built on the same angles.
    """
    program = statement.program
    if len(program) > MOST_NODES:
        return False
    if _attempt(statement, program):
        return True
    expanded = base_angles(program)
    return expanded is not program and _attempt(statement, expanded)


def _attempt(statement: Statement, program: Program) -> bool:
    try:
        domain = Fractions(min(capacity(program), MOST_GENERATORS))
        inputs: dict[str, Any] = {
            name: _input(domain, name, statement.range_of(name)) for name in program.inputs
        }
        outputs = interpret(program, domain, inputs)
        return all(
            domain.is_zero(domain.operations["subtract"](x, y))
            for x, y in zip(outputs[LEFT], outputs[RIGHT], strict=True)
        )
    except (TooLarge, NoValue, ExpressionError):
        return False  # the field's answer stands


def _input(domain: Fractions, name: str, known: Range) -> Quotient:
    if known is Range.NEGATIVE:
        return domain.negate(domain.generator(("input", name), positive=True))
    return domain.generator(("input", name), positive=known is not Range.FREE)
