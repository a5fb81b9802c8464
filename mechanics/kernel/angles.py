"""Sines and cosines of sums and multiples, written in those of base angles.

An argument is expanded into sum_i r_i a_i + r pi with rationals r_i and monomials a_i of what it is
made of. With D the common denominator of all r_i of a program, and z = (cos, sin) a point of the
unit circle,

    z(sum_i r_i a_i + r pi) = prod_i z(a_i / D)^(D r_i)  z(r pi)                              (1)
    (c1, s1) (c2, s2) = (c1 c2 - s1 s2, s1 c2 + c1 s2)                                        (2)
    exp(sum_i r_i a_i) = prod_i exp(a_i / E)^(E r_i)                                          (3)

so that sine, cosine and exponential stand before base angles only. Even multiples of pi times
something that is an integer (floor, sign, truth values) fall out. Hyperbolic functions are written
in exponentials, tangents as quotients, sin(asin x) and the like in roots. All of it is true of real
numbers: the program that comes out computes the same.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import lcm

from mechanics.program import Builder, Node, Program
from mechanics.program import operations as op
from mechanics.program.interpret import include
from mechanics.program.postorder import postorder

Monomial = tuple[tuple[int, int], ...]
"""Node numbers with their powers, sorted; the empty one is 1."""

Form = dict[Monomial, Fraction]
"""A sum of rational multiples of monomials."""

MOST_TERMS = 128
MOST_PRODUCTS = 64
"""Beyond these an argument stays whole, known by its value: the angles of a Runge-Kutta step are
polynomials of hundreds of terms, and a point for each of them would fill the program."""

_CIRCULAR = frozenset({op.SIN, op.COS, op.TAN})
_EXPONENTIAL = frozenset({op.EXP, op.SINH, op.COSH, op.TANH})
_PLAIN = frozenset({op.SIN, op.COS, op.EXP})
_INVERSE = frozenset({op.ASIN, op.ACOS, op.ATAN, op.ATAN2})

_CONDITIONS = frozenset({op.SELECT, op.NOT, op.AND, op.OR})
_TRUTH = frozenset(row.code for row in op.OPERATIONS if row.boolean)


@dataclass
class Forms:
    """Expansions of the nodes of a program or of a builder, each made once.

    Attributes
    ----------
    most : int
        Terms beyond which a node is a monomial of its own.
    cut : bool
        Whether there was such a node.
    """

    nodes: Program | Builder
    made: dict[int, Form] = field(default_factory=dict)
    most: int = MOST_TERMS
    cut: bool = False

    def of(self, root: int) -> Form:
        """The expansion of a node; a node that has none is a monomial of its own."""
        for number in postorder(root, self._operands, self.made):
            operands = self._operands(number)
            form = self._form(number, [self.made[operand] for operand in operands])
            if form is None or len(form) > self.most:
                self.cut = self.cut or bool(operands)
                form = _whole(number)
            self.made[number] = form
        return self.made[root]

    def _operands(self, number: int) -> Sequence[int]:
        polynomial = self.nodes.operations[number] in _POLYNOMIAL
        return self.nodes.operands_of(number) if polynomial else ()

    def _form(self, number: int, parts: list[Form]) -> Form | None:
        code = self.nodes.operations[number]
        if code == op.CONSTANT:
            value = self.nodes.constants[self.nodes.operands[0][number]]
            return {(): value} if value else {}
        if code in (op.ADD, op.SUBTRACT):
            return _added(parts[0], parts[1], 1 if code == op.ADD else -1)
        if code == op.NEGATE:
            return _added({}, parts[0], -1)
        if code == op.MULTIPLY:
            return _multiplied(parts[0], parts[1])
        if code == op.DIVIDE:
            return _divided(parts[0], parts[1], self.nodes.operands[1][number])
        if code == op.SELECT:
            # h x + (1 - h) y, with the truth value h of the condition.
            chosen = _multiplied(
                _whole(self.nodes.operands[0][number]), _added(parts[1], parts[2], -1)
            )
            return None if chosen is None else _added(parts[2], chosen, 1)
        return None

    def is_integer(self, monomial: Monomial) -> bool:
        """Whether a product of nodes is an integer wherever it has a value."""
        return all(
            power > 0 and self.nodes.operations[number] in _INTEGER for number, power in monomial
        )


_POLYNOMIAL = frozenset({op.ADD, op.SUBTRACT, op.MULTIPLY, op.NEGATE, op.DIVIDE, op.SELECT})
_INTEGER = _TRUTH | {op.FLOOR, op.SIGN}


def _whole(number: int) -> Form:
    return {((number, 1),): Fraction(1)}


def _added(left: Form, right: Form, factor: int) -> Form:
    if not left and factor == 1:
        return right
    result = dict(left)
    for monomial, value in right.items():
        accumulate(result, monomial, factor * value)
    return result


def accumulate(form: Form, monomial: Monomial, value: Fraction) -> None:
    """Add a term to a form in its place."""
    total = form.get(monomial, 0) + value
    if total:
        form[monomial] = total
    else:
        form.pop(monomial, None)


def _multiplied(left: Form, right: Form) -> Form | None:
    if len(left) * len(right) > MOST_PRODUCTS:
        return None
    result: Form = {}
    for one, factor in left.items():
        for other, value in right.items():
            accumulate(result, _product(one, other), factor * value)
    return result


def _product(one: Monomial, other: Monomial, sign: int = 1) -> Monomial:
    powers = dict(one)
    for number, power in other:
        powers[number] = powers.get(number, 0) + sign * power
    return tuple(sorted((number, power) for number, power in powers.items() if power))


def _divided(above: Form, below: Form, divisor: int) -> Form:
    """A quotient by a single monomial, or by a node as a whole."""
    if len(below) == 1:
        (monomial, value), *_ = below.items()
    else:
        monomial, value = ((divisor, 1),), Fraction(1)
    return {_product(m, monomial, -1): factor / value for m, factor in above.items()}


def node_of(builder: Builder, form: Form) -> Node:
    """A form as a node."""
    total = builder.zero
    for monomial, factor in sorted(form.items()):
        above = below = builder.one
        for number, power in monomial:
            part = Node(builder, number).power(abs(power))
            above, below = (above * part, below) if power > 0 else (above, below * part)
        total = total + above / below * factor
    return total


# ---------------------------------------------------------------------- a program in base angles


def base_angles(program: Program, most: int = MOST_TERMS) -> Program:
    """The same program, with sines, cosines and exponentials of base angles only.

    A program that has no others comes out equal. Arguments of more than `most` terms stay whole.
    """
    arguments, codes = _arguments(program), program.operations
    whole = all(codes[x] == op.INPUT and code in _PLAIN for code, x in arguments)
    if whole and _CONDITIONS.isdisjoint(codes):
        return program
    forms = Forms(program, most=most)
    common = {"angle": 1, "exponent": 1}
    for code, operand in arguments:
        kind = "angle" if code in _CIRCULAR else "exponent"
        for monomial, factor in forms.of(operand).items():
            if kind == "exponent" or not _is_pi(program, monomial):
                common[kind] = lcm(common[kind], factor.denominator)
    builder = Builder()
    domain = _Rewriting(builder, common["angle"], common["exponent"], most)
    outputs = include(builder, program, operations=domain.operations)
    return builder.program(outputs, inputs=program.inputs)


def is_cut(program: Program) -> bool:
    """Whether an argument of a sine, cosine or exponential is too long to be expanded."""
    forms = Forms(program)
    for _, operand in _arguments(program):
        forms.of(operand)
    return forms.cut


def _arguments(program: Program) -> list[tuple[int, int]]:
    """Codes and operands of sines, cosines, exponentials and what is written in them."""
    codes = zip(program.operations, program.operands[0], strict=True)
    return [(code, x) for code, x in codes if code in _CIRCULAR or code in _EXPONENTIAL]


def is_truth(nodes: Program | Builder, number: int) -> bool:
    """Whether a node is 0 or 1."""
    code = nodes.operations[number]
    if code == op.CONSTANT:
        return nodes.constants[nodes.operands[0][number]] in (0, 1)
    return code in _TRUTH


def _is_pi(nodes: Program | Builder, monomial: Monomial) -> bool:
    return len(monomial) == 1 and monomial[0][1] == 1 and nodes.operations[monomial[0][0]] == op.PI


Point = tuple[Node, Node]
"""Cosine and sine."""


class _Rewriting:
    """Operations on nodes by equations (1) to (3)."""

    def __init__(self, builder: Builder, angle: int, exponent: int, most: int) -> None:
        self.operations: Mapping[str, Callable[..., Node]] = {
            "sin": lambda x: self._point(x)[1],
            "cos": lambda x: self._point(x)[0],
            "tan": lambda x: self._point(x)[1] / self._point(x)[0],
            "exp": self._exponential,
            "sinh": lambda x: (self._exponential(x) - self._exponential(-x)) / 2,
            "cosh": lambda x: (self._exponential(x) + self._exponential(-x)) / 2,
            "tanh": self._tanh,
            "and": lambda x, y: builder.call("and", self._truth(x), self._truth(y)),
            "or": lambda x, y: builder.call("or", self._truth(x), self._truth(y)),
            "not": lambda x: builder.call("not", self._truth(x)),
            "select": lambda c, x, y: builder.call("select", self._truth(c), x, y),
        }
        self._builder, self._forms = builder, Forms(builder, most=most)
        self._angle, self._exponent = angle, exponent
        self._points: dict[tuple[tuple[Monomial, Fraction], ...], Point] = {}

    def _point(self, x: Node) -> Point:
        """Cosine and sine of a node, by equation (1)."""
        form = dict(self._forms.of(x.number))
        turns = Fraction(0)
        for monomial, factor in list(form.items()):
            if _is_pi(self._builder, monomial):
                turns += form.pop(monomial)
            elif factor.denominator == 1 and factor % 2 == 0 and self._is_winding(monomial):
                del form[monomial]
        terms = sorted(form.items())
        if not terms:
            return self._turn(turns)
        # cos(-a) = cos(a): opposite arguments share their points.
        mirrored = terms[0][1] < 0
        if mirrored:
            terms = [(monomial, -factor) for monomial, factor in terms]
        c, s = self._sum(tuple(terms))
        if mirrored:
            s = -s
        return self._rotated((c, s), self._turn(turns)) if turns else (c, s)

    def _is_winding(self, monomial: Monomial) -> bool:
        """Whether it is pi times an integer."""
        rest = tuple(pair for pair in monomial if not _is_pi(self._builder, (pair,)))
        return len(rest) == len(monomial) - 1 and self._forms.is_integer(rest)

    def _sum(self, terms: tuple[tuple[Monomial, Fraction], ...]) -> Point:
        """Point of a sum; beginnings are shared with other sums."""
        if terms not in self._points:
            last = self._multiple(*self._base(*terms[-1], self._angle))
            before = terms[:-1]
            self._points[terms] = self._rotated(self._sum(before), last) if before else last
        return self._points[terms]

    def _base(self, monomial: Monomial, factor: Fraction, common: int) -> tuple[Node, int]:
        """The base that a term is a multiple of, and the multiple: over the common denominator."""
        times = factor * common
        base = Fraction(1, common * times.denominator)
        return node_of(self._builder, {monomial: base}), times.numerator

    def _multiple(self, base: Node, times: int) -> Point:
        """Point of a multiple, by doubling."""
        if times < 0:
            c, s = self._multiple(base, -times)
            return c, -s
        if times == 1:
            return self._of_base(base)
        half = self._multiple(base, times // 2)
        whole = self._rotated(half, half)
        return self._rotated(whole, self._of_base(base)) if times % 2 else whole

    def _of_base(self, base: Node) -> Point:
        """Point of a base angle; in roots where it is an inverse function."""
        b = self._builder
        code = b.operations[base.number]
        if code in _INVERSE:
            x = Node(b, b.operands[0][base.number])
            if code == op.ASIN:
                return (1 - x * x).sqrt(), x
            if code == op.ACOS:
                return x, (1 - x * x).sqrt()
            below = Node(b, b.operands[1][base.number]) if code == op.ATAN2 else b.one
            radius = (x * x + below * below).sqrt()
            return below / radius, x / radius
        return b.call("cos", base), b.call("sin", base)

    def _rotated(self, one: Point, two: Point) -> Point:
        """Equation (2)."""
        (c1, s1), (c2, s2) = one, two
        return c1 * c2 - s1 * s2, s1 * c2 + c1 * s2

    def _turn(self, turns: Fraction) -> Point:
        """Point of a multiple of pi, brought to the first eighth of the circle."""
        b = self._builder
        turns %= 2
        if turns > 1:
            c, s = self._turn(2 - turns)
            return c, -s
        if 2 * turns > 1:
            c, s = self._turn(1 - turns)
            return -c, s
        if 4 * turns > 1:
            c, s = self._turn(Fraction(1, 2) - turns)
            return s, c
        if not turns:
            return b.one, b.zero
        if turns == Fraction(1, 6):
            return b.constant(3).sqrt() / 2, b.constant(Fraction(1, 2))
        if turns == Fraction(1, 4):
            half = b.constant(2).sqrt() / 2
            return half, half
        return b.call("cos", b.pi * turns), b.call("sin", b.pi * turns)

    def _exponential(self, x: Node) -> Node:
        """Equation (3)."""
        result = self._builder.one
        for monomial, factor in sorted(self._forms.of(x.number).items()):
            base, times = self._base(monomial, factor, self._exponent)
            grown = self._builder.product(self._builder.call("exp", base), abs(times))
            result = result * grown if times > 0 else result / grown
        return result

    def _truth(self, x: Node) -> Node:
        """A truth value as 0 or 1: whether x is not 0."""
        if is_truth(self._builder, x.number):
            return x
        return self._builder.call("not", self._builder.call("equal", x, 0))

    def _tanh(self, x: Node) -> Node:
        square = self._exponential(2 * x)
        return (square - 1) / (square + 1)


def turns_of(program: Program) -> tuple[Fraction, ...]:
    """Multiples of pi whose sine or cosine a program takes, as they stand after `base_angles`."""
    found: set[Fraction] = set()
    first = program.operands[0]
    for number, code in enumerate(program.operations):
        if code in (op.SIN, op.COS) and program.operations[first[number]] == op.MULTIPLY:
            factors = program.operands_of(first[number])
            if op.PI in (program.operations[factor] for factor in factors):
                found.update(program.constants[first[factor]] for factor in factors
                             if program.operations[factor] == op.CONSTANT)  # fmt: skip
    return tuple(sorted(found))
