"""Values of the nodes of a builder at one random point of a finite field, each computed once.

    z(sum_i r_i m_i) = prod_i z(m_i / D)^(D r_i)        z = (cos, sin) on the unit circle, or exp

What is zero there is zero everywhere but for a chance below 2^-90 for degrees up to 2^20, and what
is not zero there is not zero: this chooses rows, pivots and candidates. It makes no verdict.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property

from mechanics.kernel.angles import Forms, Monomial
from mechanics.kernel.draws import Draws
from mechanics.kernel.field import DivisionHere, Residues
from mechanics.kernel.primes import MODULUS, draw_prime
from mechanics.kernel.statement import Range
from mechanics.program import OPERATIONS, Builder, Node
from mechanics.program.operations import (
    ARITY,
    CONSTANT,
    COS,
    COSH,
    ENTRY,
    EXP,
    INPUT,
    PI,
    SIN,
    SINH,
    SOLVE,
    TAN,
    TANH,
)
from mechanics.program.postorder import postorder

BITS = 127
PARTS = MODULUS
"""D: an angle is so many times its base, and its fractions are multiples of the base, too."""

TURN = Fraction(2, MODULUS)
"""Of pi: the finest that has a point on the circle for each prime that is -1 modulo MODULUS."""

Pair = tuple[int, int]


def random_field(*seed: str) -> Residues:
    """The field of a random prime, at a random point of it; |x| is one variable for x and -x.

    Parameters
    ----------
    *seed : str
        The same seed gives the same point in each run.
    """
    draws = Draws(*seed)
    return Residues(draw_prime(BITS, MODULUS, draws), MODULUS, draws)


@dataclass(eq=False)
class Point:
    """Values of the nodes of a builder.

    Parameters
    ----------
    builder : Builder
        It may grow.
    domain : Residues
    input_value : callable
        Residue of an input, by its name; asked for once.

    Raises
    ------
    Inadmissible
        From `value`: where a divisor is zero here, or a radicand negative.
    """

    builder: Builder
    domain: Residues
    input_value: Callable[[str], int]
    prime: int = field(init=False)
    _values: dict[int, int] = field(default_factory=dict)
    _solutions: dict[int, list[int]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.prime = self.domain.prime

    def value(self, node: Node) -> int:
        """Residue of a node."""
        return self._evaluated(node.number)

    @cached_property
    def _forms(self) -> Forms:
        return Forms(self.builder)

    @cached_property
    def _pi(self) -> int:
        """Pi; from now on its multiples have their points on the circle."""
        self.domain.turn((TURN,), MODULUS)
        return self.domain.pi()

    def _evaluated(self, number: int) -> int:
        """Evaluate a node after what it needs; nothing is recursive but angles in angles."""
        values, operations = self._values, self.builder.operations
        for last in postorder(number, self._operands, values):
            if operations[last] == SOLVE:
                self._solutions[last], values[last] = self._solved(last), 0
            else:
                values[last] = self._computed(last, operations[last]) % self.prime
        return values[number]

    def _operands(self, number: int) -> Iterable[int]:
        code = self.builder.operations[number]
        if code == SOLVE:
            return self.builder.systems[self.builder.operands[0][number]][2:]
        return [column[number] for column in self.builder.operands[: ARITY[code]]]

    def _computed(self, number: int, code: int) -> int:
        first = self.builder.operands[0][number]
        if code == CONSTANT:
            return self.domain.constant(self.builder.constants[first])
        if code == INPUT:
            return self.input_value(self.builder.inputs[first])
        if code == PI:
            return self._pi
        if code == ENTRY:
            return self._solutions[first][self.builder.operands[1][number]]
        if code in (SIN, COS, TAN):
            c, s = self._circle(first)
            return s if code == SIN else c if code == COS else self._divided(s, c)
        if code in (EXP, SINH, COSH, TANH):
            return self._hyperbolic(first, code)
        operands = [self._values[n] for n in self._operands(number)]
        return self.domain.operations[OPERATIONS[code].name](*operands)

    def _divided(self, x: int, y: int) -> int:
        return self.domain.operations["divide"](x, y)

    def _solved(self, number: int) -> list[int]:
        size, symmetric, *entries = self.builder.systems[self.builder.operands[0][number]]
        numbers = [self._values[entry] for entry in entries]
        rows = [numbers[size * i : size * (i + 1)] for i in range(size)]
        return self.domain.solve(rows, numbers[size * size :], bool(symmetric)) if size else []

    # ------------------------------------------------------------------ angles and exponents

    def _base(self, monomial: Monomial, above: int, below: int) -> int:
        """A rational multiple of a product of nodes."""
        result = above * pow(below, -1, self.prime)
        for number, power in monomial:
            factor = self._evaluated(number)
            if power < 0 and not factor:
                raise DivisionHere("division by zero")
            result = result * pow(factor, power, self.prime) % self.prime
        return result

    def _circle(self, number: int) -> Pair:
        c, s = 1, 0
        for monomial, factor in self._forms.of(number).items():
            x, y = self._multiple(monomial, factor)
            c, s = (c * x - s * y) % self.prime, (s * x + c * y) % self.prime
        return c, s

    def _multiple(self, monomial: Monomial, factor: Fraction) -> Pair:
        if len(monomial) == 1 and monomial[0][1] == 1 and self._is_pi(monomial[0][0]):
            parts, base = factor / TURN, self._base(monomial, TURN.numerator, TURN.denominator)
        else:
            parts, base = factor * PARTS, self._base(monomial, 1, PARTS)
        if parts.denominator > 1:
            parts, base = Fraction(1), self._base(monomial, factor.numerator, factor.denominator)
        operations = self.domain.operations
        x, y = operations["cos"](base), operations["sin"](base)
        c, s, times = 1, 0, abs(int(parts))
        if parts < 0:
            y = -y
        while times:
            if times & 1:
                c, s = (c * x - s * y) % self.prime, (s * x + c * y) % self.prime
            x, y, times = (x * x - y * y) % self.prime, 2 * x * y % self.prime, times >> 1
        return c, s

    def _is_pi(self, number: int) -> bool:
        return self.builder.operations[number] == PI

    def _hyperbolic(self, number: int, code: int) -> int:
        grown = 1
        for monomial, factor in self._forms.of(number).items():
            parts, base = factor * PARTS, self._base(monomial, 1, PARTS)
            if parts.denominator > 1:
                parts = Fraction(1)
                base = self._base(monomial, factor.numerator, factor.denominator)
            grown = grown * pow(self._exponential(base), int(parts), self.prime) % self.prime
        if code == EXP:
            return grown
        square, half = grown * grown, pow(2 * grown, -1, self.prime)
        if code == SINH:
            return (square - 1) * half
        if code == COSH:
            return (square + 1) * half
        return self._divided(square - 1, square + 1)

    def _exponential(self, base: int) -> int:
        """Opposite exponents are one, so that exp(x) exp(-x) = 1."""
        base %= self.prime
        opposite = self.prime - base
        if base > opposite:
            return self._divided(1, self.domain.operations["exp"](opposite))
        return self.domain.operations["exp"](base)


def drawn_inputs(domain: Residues, signs: Callable[[str], Range]) -> Callable[[str], int]:
    """Inputs that are drawn from the field, by what is known of them."""
    return lambda name: domain.input(signs(name))
