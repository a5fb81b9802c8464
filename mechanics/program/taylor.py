"""Taylor coefficients of a motion y' = f(y), order by order: one set of rules.

    y_(j+1) = s f_j / (j + 1)      coefficients of powers of t / s                            (1)
    v = u w      v_j = sum_(i<=j) u_i w_(j-i)                                                 (2)
    v = u / w    v_j = (u_j - sum_(i<j) v_i w_(j-i)) / w_0                                    (3)
    v = h(u)     j v_j = sum_(0<i<=j) i u_i g_(j-i),   g = h'(u)                              (4)

h' is that of the table of operations, and its nodes have series of their own: what is needed of g
are lower orders only, so g may depend on v. Comparisons, magnitudes and roundings have no series: a
motion that passes a kink is not analytic there, and a method of order forty is one of order one.

Rules are data. Who carries them out in numbers of his own (integers, vectors of doubles in C) reads
the steps; `expand` does it in any domain.

Source: Griewank and Walther, Evaluating Derivatives, 2nd edition, SIAM 2008, section 13.2: table
13.1 for (2) and (3), proposition 13.1 for (4).
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import IntEnum
from fractions import Fraction
from functools import reduce
from typing import Any, NamedTuple

from mechanics.errors import ExpressionError
from mechanics.program.builder import Builder, Node
from mechanics.program.elimination import expand_solves
from mechanics.program.interpret import Domain, Nodes, interpret
from mechanics.program.operations import (
    ADD,
    ARITY,
    CONSTANT,
    DIVIDE,
    MULTIPLY,
    NEGATE,
    OPERATIONS,
    POWER,
    SQRT,
    SUBTRACT,
)
from mechanics.program.program import Program, reachable

JUMPING = frozenset({"abs", "sign", "floor", "select"})


class Kind(IntEnum):
    """What a step computes at an order above 0; s is its sign, c a constant."""

    COPY = 0  # s a
    SUM = 1  # a + s b
    TIMES = 2  # a c
    OVER = 3  # a / c
    PRODUCT = 4  # equation (2)
    QUOTIENT = 5  # equation (3); the order above 0 of a constant a is 0
    CHAIN = 6  # equation (4), s times


class Step(NamedTuple):
    """The order j > 0 of one series, from earlier ones.

    Attributes
    ----------
    out : int
        Number of the series.
    a, b : int
        Numbers of series; -1 - k for the k-th constant.
    """

    kind: Kind
    out: int
    a: int
    b: int
    sign: int


@dataclass(frozen=True)
class Recurrences:
    """The rules for one program.

    Attributes
    ----------
    constants : Program
        What does not move, output ``"constants"``: to be computed once for a motion.
    first : Program
        Order 0 of every series, output ``"first"``, from the state and the constants, inputs
        ``"c0"`` and so on. The series of the state are the first ones.
    steps : tuple of Step
        In an order in which each finds what it needs.
    rates : tuple of int
        For each entry of the state the series, or -1 - k for the constant, that is its rate.
    """

    constants: Program
    first: Program
    steps: tuple[Step, ...]
    rates: tuple[int, ...]

    @property
    def convolutions(self) -> float:
        """Sums of products in an order, that of a square counted as half of one."""
        long = [s for s in self.steps if s.kind in (Kind.PRODUCT, Kind.QUOTIENT, Kind.CHAIN)]
        return sum(0.5 if s.kind is Kind.PRODUCT and s.a == s.b else 1.0 for s in long)


def recurrences(program: Program, state: Sequence[str]) -> Recurrences:
    """The rules that extend all series of a program by one order.

    Parameters
    ----------
    program : Program
        Of one output, the rates of the entries of the state.
    state : sequence of str
        The inputs that move; all others stay.

    Raises
    ------
    ValueError
        If there is not one rate for each entry of the state.
    ExpressionError
        If something that moves has no Taylor series; the operation is named.

    Examples
    --------
    >>> from mechanics.program.numpy_domain import Arrays
    >>> b = Builder()
    >>> rules = recurrences(b.program({"rate": [b.input("x")]}), ["x"])
    >>> (series,) = expand(rules, Arrays(), [1.0], (), 1.0, 3)
    >>> [round(float(coefficient), 4) for coefficient in series]
    [1.0, 1.0, 0.5, 0.1667]
    """
    return _Rules(expand_solves(program), state).finished()


class _Rules:
    """Takes a program apart into series; derivatives are built where rules ask for them."""

    def __init__(self, program: Program, state: Sequence[str]) -> None:
        self.builder = b = Builder()
        self.inputs, self.state = program.inputs, tuple(state)
        self.nodes = [b.input(name).number for name in state]
        self.place = {number: k for k, number in enumerate(self.nodes)}
        self.constants: dict[int, int] = {}
        self.steps: list[Step] = []
        self._moving = bytearray()
        given = {name: b.input(name) for name in program.inputs}
        (rates,) = interpret(program, _Analytic(Nodes(b), self.moves), given).values()
        if len(rates) != len(state):
            raise ValueError(f"{len(rates)} rates for {len(state)} entries of the state")
        self.visit([rate.number for rate in rates])
        self.rates = tuple(self.at(rate.number) for rate in rates)

    def moves(self, number: int) -> bool:
        """Whether a node depends on the state."""
        b = self.builder
        for n in range(len(self._moving), number + 1):
            operands = (b.operands[k][n] for k in range(ARITY[b.operations[n]]))
            self._moving.append(n in self.place or any(self._moving[k] for k in operands))
        return bool(self._moving[number])

    def visit(self, roots: Sequence[int]) -> None:
        """Series of all that moves among what the roots need."""
        for number in reachable(self.builder, roots):
            if self.moves(number) and number not in self.place:
                self.rule(number)

    def at(self, number: int) -> int:
        """The number of a node's series, or -1 - k for the k-th constant."""
        if self.moves(number):
            return self.place[number]
        return -1 - self.constants.setdefault(number, len(self.constants))

    def rule(self, number: int) -> None:
        """The series of a node whose operands have theirs."""
        b, code = self.builder, self.builder.operations[number]
        operands = [b.operands[k][number] for k in range(ARITY[code])]
        if code not in _LINEAR:
            self.chain(number, [operand for operand in operands if self.moves(operand)])
            return
        x, y = (*operands, operands[0])[:2]
        if code in (MULTIPLY, ADD) and not self.moves(x):
            x, y = y, x
        a, c = self.at(x), self.at(y)
        sign = -1 if code in (SUBTRACT, NEGATE) else 1
        if code == NEGATE or (code in (ADD, SUBTRACT) and c < 0):
            self.add(number, Kind.COPY, a, 0, sign if code == NEGATE else 1)
        elif code == SUBTRACT and a < 0:
            self.add(number, Kind.COPY, c, 0, -1)
        elif code in (ADD, SUBTRACT):
            self.add(number, Kind.SUM, a, c, sign)
        elif code == MULTIPLY:
            self.add(number, Kind.TIMES if c < 0 else Kind.PRODUCT, a, c)
        else:
            self.add(number, Kind.OVER if c < 0 else Kind.QUOTIENT, a, c)

    def chain(self, number: int, moving: Sequence[int]) -> None:
        """Equation (4), for each of the operands that move."""
        b, row = self.builder, OPERATIONS[self.builder.operations[number]]
        if row.boolean or row.name in JUMPING or row.partials is None:
            raise ExpressionError(
                f"operation {row.name} has no Taylor series: write the equations without it,"
                " or take a method without series"
            )
        operands = [Node(b, b.operands[k][number]) for k in range(row.arity)]
        partials = _SLOPES.get(row.code, row.partials)(*operands, Node(b, number))
        slopes = [(operand, slope) for operand, slope in zip(operands, partials, strict=True)
                  if operand.number in moving]  # fmt: skip
        # The result is the sum of a chain for each operand; its series is known to its slopes.
        terms = [self.series(number if k == 0 else b.zero_number) for k in range(len(slopes))]
        self.place[number] = terms[0]
        for out, (operand, slope) in zip(terms, slopes, strict=True):
            at, g, sign = len(self.steps), slope.number, 1
            if b.operations[g] == NEGATE:
                g, sign = b.operands[0][g], -1
            self.visit([g])
            a = self.place[operand.number]
            self.steps.insert(at, Step(Kind.CHAIN, out, a, self.place[g], sign))
        for other in terms[1:]:
            self.add(number, Kind.SUM, self.place[number], other)

    def add(self, number: int, kind: Kind, a: int, b: int, sign: int = 1) -> None:
        """A new series for a node, and its step."""
        self.place[number] = self.series(number)
        self.steps.append(Step(kind, self.place[number], a, b, sign))

    def series(self, number: int) -> int:
        """A new series that begins with the value of a node."""
        self.nodes.append(number)
        return len(self.nodes) - 1

    def finished(self) -> Recurrences:
        """The rules, and programs of constants and of order 0."""
        b, first = self.builder, Builder()
        values = {b.zero_number: first.zero}
        values |= {self.nodes[k]: first.input(name) for k, name in enumerate(self.state)}

        def value(number: int) -> Node:
            if number in values:
                return values[number]
            if b.operations[number] == CONSTANT:
                return first.constant(b.constants[b.operands[0][number]])
            return first.input(f"c{-1 - self.at(number)}")

        for number in self.nodes:
            if number not in values:
                code = b.operations[number]
                operands = [value(b.operands[k][number]) for k in range(ARITY[code])]
                values[number] = first.call(OPERATIONS[code].name, *operands)
        outputs = {"first": [values[number] for number in self.nodes]}
        names = (*self.state, *(f"c{k}" for k in range(len(self.constants))))
        held = tuple(name for name in self.inputs if name not in self.state)
        constants = [Node(b, number) for number in self.constants]
        return Recurrences(
            b.program({"constants": constants}, held),
            first.program(outputs, names),
            tuple(self.steps),
            self.rates,
        )


_LINEAR = frozenset({ADD, SUBTRACT, MULTIPLY, DIVIDE, NEGATE})

_SLOPES: dict[int, Callable[..., tuple[Any, ...]]] = {
    SQRT: lambda x, r: (x.builder.constant(Fraction(1, 2)) / r,),
    POWER: lambda x, y, r: (y * r / x, None),
}
"""Where the table's partial derivative would need another series than that of the result."""


@dataclass(frozen=True)
class _Analytic:
    """Nodes of a builder, with what series have no rule for, or a dearer one, written otherwise."""

    nodes: Nodes
    moves: Callable[[int], bool]

    @property
    def operations(self) -> Mapping[str, Callable[..., Any]]:
        return {**self.nodes.operations, "multiply": self._product, "power": self._power}

    def _product(self, x: Node, y: Node) -> Node:
        """x y; a square in disguise, x (c x) = c (x x), costs half of a product."""
        b = self.nodes.builder
        for one, other in ((x, y), (y, x)):
            if b.operations[other.number] == MULTIPLY:
                factors = [b.operands[k][other.number] for k in (0, 1)]
                if one.number in factors:
                    factors.remove(one.number)
                    if self.moves(one.number) and not self.moves(factors[0]):
                        return Node(b, factors[0]) * (one * one)
        return x * y

    def _power(self, x: Node, y: Node) -> Node:
        """x^y, or exp(y log x) where the exponent moves."""
        return (y * x.log()).exp() if self.moves(y.number) else x.power(y)

    def constant(self, value: Fraction) -> Node:
        return self.nodes.constant(value)

    def pi(self) -> Node:
        return self.nodes.pi()

    def solve(self, matrix: list[list[Any]], right: list[Any], symmetric: bool) -> Sequence[Node]:
        return self.nodes.solve(matrix, right, symmetric)


Dot = Callable[[Iterable[Any], Iterable[Any]], Any]
Rule = Callable[[int], Any]


def expand(
    rules: Recurrences,
    numbers: Domain,
    first: Sequence[Any],
    constants: Sequence[Any],
    step: Any,
    order: int,
    dot: Dot | None = None,
) -> list[list[Any]]:
    """Coefficients of the state, equation (1), in any domain.

    Parameters
    ----------
    first, constants : sequence of values of the domain
        Outputs of the programs of the rules.
    step : value of the domain
        s.
    order : int
        Highest power.
    dot : callable, optional
        The sum of products of two sequences, as long as the shorter one, where the domain has a
        better one than the sum of its products.

    Returns
    -------
    list of list
        For each entry of the state the coefficients 0 to `order`.
    """
    multiply, divide = (numbers.operations[name] for name in ("multiply", "divide"))
    zero = numbers.constant(Fraction(0))
    whole = [numbers.constant(Fraction(j)) for j in range(order + 1)]
    series = [[value] for value in first]
    carried = _Carried(numbers, series, constants, whole, dot or _dot(numbers))
    todo = [(series[s.out], carried.rule(s)) for s in rules.steps]
    rates = [(series[k], rate) for k, rate in enumerate(rules.rates)]
    for j in range(1, order + 1):
        share = divide(step, whole[j])
        for entry, rate in rates:
            slope = series[rate][j - 1] if rate >= 0 else constants[-1 - rate] if j == 1 else zero
            entry.append(multiply(slope, share))
        for out, rule in todo:
            out.append(rule(j))
    return [entry for entry, _ in rates]


def _dot(numbers: Domain) -> Dot:
    """The sum of products in a domain."""
    add, multiply = numbers.operations["add"], numbers.operations["multiply"]
    zero = numbers.constant(Fraction(0))
    return lambda u, w: reduce(add, map(multiply, u, w), zero)


@dataclass
class _Carried:
    """Steps as functions of the order j; series hold all lower orders."""

    numbers: Domain
    series: list[list[Any]]
    constants: Sequence[Any]
    whole: Sequence[Any]
    dot: Dot

    def rule(self, step: Step) -> Rule:
        """What a step computes."""
        kind, out, a, b, sign = step
        call, dot = self.numbers.operations, self.dot
        u = self.series[a] if a >= 0 else []
        w = self.series[b] if b >= 0 else []
        if kind is Kind.COPY:
            negate = call["negate"]
            return (lambda j: u[j]) if sign > 0 else lambda j: negate(u[j])
        if kind is Kind.SUM:
            combine = call["add" if sign > 0 else "subtract"]
            return lambda j: combine(u[j], w[j])
        if kind in (Kind.TIMES, Kind.OVER):
            combine = call["multiply" if kind is Kind.TIMES else "divide"]
            constant = self.constants[-1 - b]
            return lambda j: combine(u[j], constant)
        if kind is Kind.PRODUCT:
            return lambda j: dot(u, reversed(w))
        if kind is Kind.QUOTIENT:
            return self.quotient(u, w, self.series[out])
        return self.chain(u, w, sign)

    def quotient(self, u: list[Any], w: list[Any], v: list[Any]) -> Rule:
        """Equation (3)."""
        subtract, divide = (self.numbers.operations[name] for name in ("subtract", "divide"))
        zero, dot = self.whole[0], self.dot
        if u:
            return lambda j: divide(subtract(u[j], dot(v, reversed(w))), w[0])
        return lambda j: divide(subtract(zero, dot(v, reversed(w))), w[0])

    def chain(self, u: list[Any], g: list[Any], sign: int) -> Rule:
        """Equation (4); the numbers i u_i are kept."""
        slopes: list[Any] = []
        multiply, divide, negate = (
            self.numbers.operations[name] for name in ("multiply", "divide", "negate")
        )
        whole, dot = self.whole, self.dot

        def rule(j: int) -> Any:
            slopes.append(multiply(whole[j], u[j]))
            value = divide(dot(slopes, g[j - 1 :: -1]), whole[j])
            return value if sign > 0 else negate(value)

        return rule
