"""Where programs are built: equal nodes are one node.

A node is an operation on earlier nodes, kept as integers in arrays and found again by one packed
integer, so that common subexpressions are shared from the beginning. Nothing is expanded; what is
folded is exact: arithmetic of rationals, x + 0, 1 x, 0 x, double negation.

What an operation demands of its operands is recorded when the node is asked for, before anything
is folded or shared: ``0 * sqrt(x)`` is 0, and has no value for x < 0 all the same.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction
from math import isfinite, isqrt

from mechanics.errors import ExpressionError, ZeroDivisorError
from mechanics.program.operations import (
    ADD,
    BY_NAME,
    CONSTANT,
    DIVIDE,
    ENTRY,
    EQUAL,
    INPUT,
    MULTIPLY,
    NEGATE,
    NOT,
    OPERATIONS,
    PI,
    POWER,
    SELECT,
    SOLVE,
    SQRT,
    SUBTRACT,
    Sign,
)
from mechanics.program.program import Nodes, Program, freeze

Number = int | Fraction
Condition = tuple[int, bool]
Fold = Callable[..., int | None]

_ARITHMETIC = frozenset({"add", "subtract", "multiply", "divide", "negate"})
"""Operations that a builder has as methods, which another builder may fold otherwise."""

LARGEST_EXPONENT = 64
"""Integer powers up to this one are products; larger ones stay powers."""


@dataclass(frozen=True)
class Obligation:
    """A sign that an expression must have where a program has a value.

    Attributes
    ----------
    sign : Sign
    node : int
        The expression, by its number in the builder.
    operation : str
        What demands it: ``"divide"``, ``"sqrt"``.
    conditions : tuple of (int, bool)
        The conditions of the branch it stands in: nodes and the truth values that lead there.
    """

    sign: Sign
    node: int
    operation: str
    conditions: tuple[Condition, ...] = ()


class Node:
    """A handle on one node, with Python's arithmetic; it has no truth value."""

    __array_ufunc__ = None
    __slots__ = ("builder", "number")

    def __init__(self, builder: Builder, number: int) -> None:
        self.builder, self.number = builder, number

    def __repr__(self) -> str:
        name = OPERATIONS[self.builder.operations[self.number]].name
        return f"<node {self.number}: {name}>"

    def __bool__(self) -> bool:
        raise TypeError("a node has no truth value: use less, not_greater, equal and choose")

    def __hash__(self) -> int:
        return hash((id(self.builder), self.number))

    def __eq__(self, other: object) -> bool:
        """Whether it is the same node, which is enough for being equal but not needed."""
        mine = self.builder, self.number
        return isinstance(other, Node) and mine == (other.builder, other.number)

    @property
    def constant(self) -> Fraction | None:
        """The rational that it is, or None."""
        return self.builder.constant_at(self.number)

    @property
    def is_zero(self) -> bool:
        """Whether it is the constant 0."""
        return self.number == self.builder.zero_number

    def __add__(self, other: Node | Number) -> Node:
        b = self.builder
        return Node(b, b.add(self.number, b.number_of(other)))

    __radd__ = __add__

    def __sub__(self, other: Node | Number) -> Node:
        b = self.builder
        return Node(b, b.subtract(self.number, b.number_of(other)))

    def __rsub__(self, other: Node | Number) -> Node:
        b = self.builder
        return Node(b, b.subtract(b.number_of(other), self.number))

    def __mul__(self, other: Node | Number) -> Node:
        b = self.builder
        return Node(b, b.multiply(self.number, b.number_of(other)))

    __rmul__ = __mul__

    def __truediv__(self, other: Node | Number) -> Node:
        b = self.builder
        return Node(b, b.divide(self.number, b.number_of(other)))

    def __rtruediv__(self, other: Node | Number) -> Node:
        b = self.builder
        return Node(b, b.divide(b.number_of(other), self.number))

    def __neg__(self) -> Node:
        return Node(self.builder, self.builder.negate(self.number))

    def __abs__(self) -> Node:
        return self.builder.call("abs", self)

    def power(self, exponent: Node | Number) -> Node:
        """self ** exponent, for a positive base where the exponent is no integer."""
        return self.builder.power(self, exponent)

    __pow__ = power

    def sqrt(self) -> Node:
        """Its principal square root."""
        return self.builder.call("sqrt", self)

    def exp(self) -> Node:
        """e to its power."""
        return self.builder.call("exp", self)

    def log(self) -> Node:
        """Its natural logarithm."""
        return self.builder.call("log", self)

    def sin(self) -> Node:
        """Its sine."""
        return self.builder.call("sin", self)

    def cos(self) -> Node:
        """Its cosine."""
        return self.builder.call("cos", self)

    def sinh(self) -> Node:
        """Its hyperbolic sine."""
        return self.builder.call("sinh", self)

    def cosh(self) -> Node:
        """Its hyperbolic cosine."""
        return self.builder.call("cosh", self)

    def sign(self) -> Node:
        """-1, 0 or 1."""
        return self.builder.call("sign", self)

    def choose(self, if_true: Node | Number, if_false: Node | Number) -> Node:
        """One value where it is true, another where it is 0."""
        return self.builder.call("select", self, if_true, if_false)


class Builder(Nodes):
    """A growing table of nodes; whoever makes it drops it when the programs are frozen."""

    def __init__(self) -> None:
        self.operations: array[int] = array("B")
        self.operands: tuple[array[int], array[int], array[int]] = (
            array("i"), array("i"), array("i"),
        )  # fmt: skip
        self.constants: list[Fraction] = []
        self.inputs: list[str] = []
        self.systems: list[tuple[int, ...]] = []
        self.obligations: dict[Obligation, None] = {}
        self._numbers: dict[int, int] = {}
        self._of_constant: dict[Fraction, int] = {}
        self._of_input: dict[str, int] = {}
        self._of_system: dict[tuple[int, ...], int] = {}
        self._conditions: tuple[Condition, ...] = ()
        self.zero_number = self._constant(Fraction(0))
        self.one_number = self._constant(Fraction(1))

    def __len__(self) -> int:
        return len(self.operations)

    # ------------------------------------------------------------------ leaves

    @property
    def zero(self) -> Node:
        """The constant 0."""
        return Node(self, self.zero_number)

    @property
    def one(self) -> Node:
        """The constant 1."""
        return Node(self, self.one_number)

    @property
    def pi(self) -> Node:
        """The number pi, exactly."""
        return Node(self, self._node(PI))

    def input(self, name: str) -> Node:
        """The input of that name."""
        if name not in self._of_input:
            self._of_input[name] = self._append(INPUT, len(self.inputs), 0, 0)
            self.inputs.append(name)
        return Node(self, self._of_input[name])

    def constant(self, value: Number | float) -> Node:
        """A rational; a float is the dyadic rational that it is.

        Raises
        ------
        ExpressionError
            For infinity or nan.
        """
        if isinstance(value, float) and not isfinite(value):
            raise ExpressionError(f"constant {value}: a finite number is needed")
        return Node(self, self._constant(Fraction(value)))

    def node(self, value: Node | Number) -> Node:
        """The value as a node of this builder."""
        return Node(self, self.number_of(value))

    def number_of(self, value: Node | Number) -> int:
        """The number of a node of this builder, or of a constant."""
        if isinstance(value, Node):
            if value.builder is not self:
                raise ValueError("nodes of two builders cannot be combined: include the program")
            return value.number
        return self._constant(Fraction(value))

    def constant_at(self, number: int) -> Fraction | None:
        """The rational at a node, or None."""
        if self.operations[number] != CONSTANT:
            return None
        return self.constants[self.operands[0][number]]

    # ------------------------------------------------------------------ arithmetic, on numbers

    def add(self, a: int, b: int) -> int:
        """a + b."""
        if a == self.zero_number:
            return b
        if b == self.zero_number:
            return a
        operations, first = self.operations, self.operands[0]
        if operations[b] == NEGATE:
            return self.subtract(a, first[b])
        if operations[a] == NEGATE:
            return self.subtract(b, first[a])
        if operations[a] == CONSTANT and operations[b] == CONSTANT:
            return self._constant(self.constants[first[a]] + self.constants[first[b]])
        return self._node(ADD, a, b) if a < b else self._node(ADD, b, a)

    def subtract(self, a: int, b: int) -> int:
        """a - b."""
        if a == b:
            return self.zero_number
        if b == self.zero_number:
            return a
        if a == self.zero_number:
            return self.negate(b)
        operations, first = self.operations, self.operands[0]
        if operations[b] == NEGATE:
            return self.add(a, first[b])
        if operations[a] == NEGATE:
            return self.negate(self.add(first[a], b))
        if operations[a] == CONSTANT and operations[b] == CONSTANT:
            return self._constant(self.constants[first[a]] - self.constants[first[b]])
        if a == self.one_number and OPERATIONS[operations[b]].boolean:
            return self._folded(NOT, [b])
        return self._node(SUBTRACT, a, b)

    def negate(self, a: int) -> int:
        """-a."""
        operation, first = self.operations[a], self.operands[0]
        if operation == NEGATE:
            return first[a]
        if operation == SUBTRACT:
            return self._node(SUBTRACT, self.operands[1][a], first[a])
        if operation == CONSTANT:
            return self._constant(-self.constants[first[a]])
        return self._node(NEGATE, a)

    def multiply(self, a: int, b: int) -> int:
        """a b."""
        zero, one = self.zero_number, self.one_number
        if a == zero or b == zero:
            return zero
        if a == one:
            return b
        if b == one:
            return a
        operations, first = self.operations, self.operands[0]
        if operations[a] == NEGATE:
            return self.negate(self.multiply(first[a], b))
        if operations[b] == NEGATE:
            return self.negate(self.multiply(a, first[b]))
        if operations[b] == CONSTANT:
            a, b = b, a
        if operations[a] == CONSTANT:
            return self._scale(a, b)
        return self._node(MULTIPLY, a, b) if a < b else self._node(MULTIPLY, b, a)

    def _scale(self, a: int, b: int) -> int:
        """A constant times what is neither 0 nor 1."""
        operations, (first, second, _) = self.operations, self.operands
        factor = self.constants[first[a]]
        if operations[b] == CONSTANT:
            return self._constant(factor * self.constants[first[b]])
        if operations[b] == MULTIPLY and operations[first[b]] == CONSTANT:
            # The constant of a product is its first operand: see below.
            return self.multiply(
                self._constant(factor * self.constants[first[first[b]]]), second[b]
            )
        if factor < 0:
            return self.negate(self.multiply(self._constant(-factor), b))
        return self._node(MULTIPLY, a, b)

    def divide(self, a: int, b: int) -> int:
        """a / b, where b is not zero.

        Raises
        ------
        ZeroDivisorError
            If b is the constant 0.
        """
        divisor = self.constant_at(b)
        if divisor is not None:
            if divisor == 0:
                raise ZeroDivisorError("division by the constant 0")
            return self.multiply(self._constant(1 / divisor), a)
        self._demand("divide", Node(self, a), Node(self, b))
        if a == self.zero_number:
            return a
        if a == b:
            return self.one_number
        operations, first = self.operations, self.operands[0]
        if operations[b] == NEGATE:
            return self.negate(self._node(DIVIDE, a, first[b]))
        if operations[a] == NEGATE:
            return self.negate(self._node(DIVIDE, first[a], b))
        return self._node(DIVIDE, a, b)

    # ------------------------------------------------------------------ everything else

    def call(self, name: str, *operands: Node | Number) -> Node:
        """Any operation of the table by its name.

        Raises
        ------
        ExpressionError
            If there is no such operation, or not of so many operands.
        """
        row = BY_NAME.get(name)
        if row is None or not row.arity or row.arity != len(operands) or name == "entry":
            raise ExpressionError(f"operation {name} of {len(operands)} operands: there is none")
        numbers = [self.number_of(operand) for operand in operands]
        if name in _ARITHMETIC:
            return Node(self, getattr(self, name)(*numbers))
        if row.code == POWER:
            return self.power(Node(self, numbers[0]), Node(self, numbers[1]))
        self._demand(name, *(Node(self, number) for number in numbers))
        return Node(self, self._folded(row.code, numbers))

    def _folded(self, code: int, numbers: list[int]) -> int:
        row = OPERATIONS[code]
        values = [self.constant_at(number) for number in numbers]
        if row.exact is not None and None not in values:
            return self._constant(row.exact(*values))
        if code in _SPECIAL:
            special = _SPECIAL[code](self, *numbers)
            if special is not None:
                return special
        if row.commutative:
            numbers = sorted(numbers)
        return self._node(code, *numbers)

    def power(self, base: Node, exponent: Node | Number) -> Node:
        """base ** exponent; small integer powers are products, halves are roots.

        Raises
        ------
        ZeroDivisorError
            If it is the constant 0 to a negative power.
        """
        exponent = self.node(exponent)
        value = exponent.constant
        if value is not None and value.denominator <= 2 and abs(value) <= LARGEST_EXPONENT:
            if value < 0:
                return 1 / self.power(base, -value)
            whole = self.product(base, value.numerator // value.denominator)
            return whole if value.denominator == 1 else whole * base.sqrt()
        if value is None or value.denominator > 1:
            self._demand("power", base, exponent)
        elif value < 0:
            return 1 / self.power(base, -value)
        return Node(self, self._node(POWER, base.number, exponent.number))

    def product(self, base: Node, exponent: int) -> Node:
        """base ** exponent for a natural exponent, however large, by repeated squaring."""
        result, square = self.one, base
        while exponent:
            if exponent & 1:
                result = result * square
            exponent >>= 1
            if exponent:
                square = square * square
        return result

    def less(self, a: Node | Number, b: Node | Number) -> Node:
        """Whether a < b, as 0 or 1."""
        return self.call("less", a, b)

    def solve(
        self,
        matrix: Sequence[Sequence[Node | Number]],
        right: Sequence[Node | Number],
        *,
        symmetric: bool = False,
    ) -> tuple[Node, ...]:
        """x of matrix x = right, as one operation.

        Parameters
        ----------
        matrix : n rows of n
        right : n
        symmetric : bool
            Whether the matrix is symmetric, which printers make use of.

        Raises
        ------
        ValueError
            If the shapes do not fit.
        """
        size = len(right)
        if len(matrix) != size or any(len(row) != size for row in matrix):
            raise ValueError(f"solve: a square matrix of {size} rows is needed")
        entries = [self.number_of(entry) for row in matrix for entry in row]
        key = (size, int(symmetric), *entries, *(self.number_of(entry) for entry in right))
        if key not in self._of_system:
            self._of_system[key] = self._append(SOLVE, len(self.systems), 0, 0)
            self.systems.append(key)
        number = self._of_system[key]
        return tuple(Node(self, self._node(ENTRY, number, i)) for i in range(size))

    # ------------------------------------------------------------------ where it has a value

    @contextmanager
    def under(self, condition: Node, truth: bool) -> Iterator[None]:
        """Build a branch: demands inside hold where the condition has that truth."""
        before = self._conditions
        if (condition.number, truth) not in before:
            self._conditions = (*before, (condition.number, truth))
        try:
            yield
        finally:
            self._conditions = before

    def demand(self, sign: Sign, value: Node | Number, operation: str) -> None:
        """Record that a value must have a sign, under the conditions of the branch.

        Parameters
        ----------
        operation : str
            What demands it, for people.
        """
        number = self.number_of(value)
        known = self.constant_at(number)
        if known is None or not _has_sign(known, sign):
            self.obligations[Obligation(sign, number, operation, self._conditions)] = None

    def _demand(self, name: str, *operands: Node) -> None:
        row = BY_NAME[name]
        for sign, value in row.demands(*operands):
            self.demand(sign, value, name)

    # ------------------------------------------------------------------ the table of nodes

    def _constant(self, value: Fraction) -> int:
        number = self._of_constant.get(value)
        if number is None:
            number = self._of_constant[value] = self._append(CONSTANT, len(self.constants), 0, 0)
            self.constants.append(value)
        return number

    def _node(self, operation: int, a: int = 0, b: int = 0, c: int = 0) -> int:
        key = (((c << 32 | b) << 32) | a) << 8 | operation
        number = self._numbers.get(key)
        if number is None:
            number = self._numbers[key] = self._append(operation, a, b, c)
        return number

    def _append(self, operation: int, a: int, b: int, c: int) -> int:
        number = len(self.operations)
        self.operations.append(operation)
        first, second, third = self.operands
        first.append(a)
        second.append(b)
        third.append(c)
        return number

    def program(
        self,
        outputs: Mapping[str, Sequence[Node | Number]],
        inputs: Sequence[str] | None = None,
    ) -> Program:
        """Freeze what the outputs need.

        Parameters
        ----------
        outputs : mapping of str to sequences of nodes
        inputs : sequence of str, optional
            Their order; by default those that are used, by name.

        Raises
        ------
        ValueError
            If an output uses an input that is not among them.
        """
        numbers = {name: tuple(map(self.number_of, nodes)) for name, nodes in outputs.items()}
        return freeze(self, numbers, inputs)


def _has_sign(value: Fraction, sign: Sign) -> bool:
    if sign is Sign.NONZERO:
        return value != 0
    return value > 0 if sign is Sign.POSITIVE else value >= 0


def _exact_root(builder: Builder, a: int) -> int | None:
    """The root of a rational that is a square of one."""
    value = builder.constant_at(a)
    if value is None or value < 0:
        return None
    above, below = isqrt(value.numerator), isqrt(value.denominator)
    if above * above == value.numerator and below * below == value.denominator:
        return builder.number_of(Fraction(above, below))
    return None


def _symmetric(name: str, at_zero: int, side: int) -> Fold:
    """A function of a known value at 0; f(-x) = side f(x) unless that is 0."""

    def fold(builder: Builder, a: int) -> int | None:
        if a == builder.zero_number:
            return builder.number_of(at_zero)
        if side and builder.operations[a] == NEGATE:
            mirrored = builder.call(name, -Node(builder, a))
            return (mirrored if side > 0 else -mirrored).number
        return None

    return fold


def _not(builder: Builder, a: int) -> int | None:
    """A truth value denied twice is itself."""
    if builder.operations[a] != NOT:
        return None
    denied = builder.operands[0][a]
    return denied if OPERATIONS[builder.operations[denied]].boolean else None


def _equal(builder: Builder, a: int, b: int) -> int | None:
    """A truth value that equals 0 is denied; one that equals 1 is itself."""
    for truth, number in ((a, b), (b, a)):
        if OPERATIONS[builder.operations[truth]].boolean:
            if number == builder.zero_number:
                return builder.call("not", Node(builder, truth)).number
            if number == builder.one_number:
                return truth
    return None


def _select(builder: Builder, condition: int, x: int, y: int) -> int | None:
    known = builder.constant_at(condition)
    if known is not None:
        return x if known != 0 else y
    return x if x == y else None


_ODD = ("sin", "tan", "asin", "atan", "sinh", "tanh", "asinh", "atanh", "sign", "erf")
_SYMMETRIC = (("abs", 0, 1), ("exp", 1, 0), ("cos", 1, 1), ("cosh", 1, 1),
              *((name, 0, -1) for name in _ODD))  # fmt: skip

_SPECIAL: dict[int, Fold] = {
    SQRT: _exact_root, SELECT: _select, NOT: _not, EQUAL: _equal,
    **{BY_NAME[row[0]].code: _symmetric(*row) for row in _SYMMETRIC},
}  # fmt: skip
