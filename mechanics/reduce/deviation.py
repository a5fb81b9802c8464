"""What edits of a program do to its outputs, enclosed over boxes of inputs.

    after - before  =  sum over edits j of  C_j delta_j                                        (1)

delta_j is what edit j changes where it is made, C_j how much of that arrives. Along the program,
with ' for values after the edits,

    x y     C = x C_y + y' C_x              x / y    C = (C_x - (x / y) C_y) / y'              (2)
    sqrt x  C = C_x / (sqrt x + sqrt x')    sin x    C = cos z C_x,  z between x and x'        (3)

which is exact, so that what did not change cancels, and so does what arrives twice with opposite
signs. Two more rules keep rotations from growing, and small angles small:

    |c x + s y| <= sqrt(x x + y y)  where c c + s s = 1,       x - sin x grows with x          (4)
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from mechanics.kernel.balls import Balls
from mechanics.program import Builder, Program
from mechanics.program import operations as op
from mechanics.reduce import intervals as on
from mechanics.reduce.edits import Edits, Kind, nodes
from mechanics.reduce.intervals import ZERO, Interval

ONE = on.number(Fraction(1))

Shares = dict[int, Interval]
"""C_j by edit; one that is left out is 0."""


@dataclass(frozen=True)
class Plan:
    """A program, its edits, and what is known of its nodes whatever the box.

    Attributes
    ----------
    program : Program
        Without linear systems.
    edits : mapping of int to Kind
    numbers : mapping of str to Fraction
        Inputs that have one value: what these alone decide is exact.
    before, after : list
        The rational that a node is without and with the edits, or None.
    same : list of bool
        Whether it is the same with the edits: both programs are built in one builder.
    turning : list
        Nodes (c, x, s, y) of sums c x + s y or c x - s y with sine and cosine of one angle, or
        None.
    """

    program: Program
    edits: Edits
    numbers: Mapping[str, Fraction]
    before: list[Fraction | None]
    after: list[Fraction | None]
    same: list[bool]
    turning: list[tuple[int, int, int, int] | None]


def plan(program: Program, edits: Edits, numbers: Mapping[str, Fraction]) -> Plan:
    """See `Plan`."""
    builder = Builder()
    known = {name: builder.constant(value) for name, value in numbers.items()}
    before, after = (nodes(program, builder, known, some) for some in ({}, edits))
    return Plan(
        program, edits, numbers, [x.constant for x in before], [x.constant for x in after],
        [x == y for x, y in zip(before, after, strict=True)],
        [_turning(program, number) for number in range(len(program))],
    )  # fmt: skip


def deviations(of: Plan, box: Mapping[str, Interval]) -> list[Interval]:
    """Enclosures of what the edits add to each output, equation (1), over boxes.

    Parameters
    ----------
    box : mapping of str to Interval
        Of each input without a number: two numbers, or arrays of one entry a box.
    """
    walk = _Walk(of, box)
    for number in range(len(of.program)):
        walk.append(number)
    return [walk.total(k) for k in of.program.roots]


class _Walk:
    """Values before and after, and shares, of the nodes in order."""

    def __init__(self, of: Plan, box: Mapping[str, Interval]) -> None:
        self.of, self.box = of, box
        self.x: list[Interval] = []
        self.y: list[Interval] = []
        self.shares: list[Shares] = []
        self.deltas: dict[int, Interval] = {}

    def append(self, number: int) -> None:
        """The next node."""
        of = self.of
        x = self._value(number, self.x, of.before[number])
        self.x.append(x)
        kind = of.edits.get(number)
        if of.same[number]:
            self.y.append(x)
            self.shares.append({})
        elif kind is not None:
            self.y.append(self._edited(number, kind))
        else:
            self.y.append(self._value(number, self.y, of.after[number]))
            self.shares.append(self._arriving(number))

    def total(self, number: int) -> Interval:
        """Equation (1) at a node."""
        found = ZERO
        for j, share in self.shares[number].items():
            found = on.add(found, on.multiply(share, self.deltas[j]))
        return found

    def _value(
        self, number: int, values: Sequence[Interval], constant: Fraction | None
    ) -> Interval:  # fmt: skip
        program = self.of.program
        code, operands = program.operations[number], program.operands_of(number)
        if constant is not None:
            return on.number(constant)
        if code == op.INPUT:
            return self.box[program.inputs[program.operands[0][number]]]
        if code == op.PI:
            return on.PI
        x = [values[k] for k in operands]
        if code == op.MULTIPLY and operands[0] == operands[1]:
            return on.square(x[0])
        if code not in _RULES:
            return on.by_balls(Balls.operations[op.OPERATIONS[code].name], *x)
        value, turning = _RULES[code](*x), self.of.turning[number]
        if turning is None or any(k in self.of.edits for k in turning[::2]):
            return value
        return on.meet(value, on.hypotenuse(values[turning[1]], values[turning[3]]))

    def _edited(self, number: int, kind: Kind) -> Interval:
        """The value after an edit; its share and what it changes are noted."""
        program, x = self.of.program, self.x[number]
        operands, difference = program.operands_of(number), False
        shares: Shares = {}
        if kind in (Kind.ZERO, Kind.ONE):
            y = ONE if kind is Kind.ONE else on.number(Fraction(0))
            delta = on.subtract(y, x)
        elif kind is Kind.ANGLE:
            y = self.y[operands[0]]
            shares, delta = self._arriving(number), _beyond_sine(y)
        else:
            difference = program.operations[number] == op.SUBTRACT
            kept, lost = operands if kind is Kind.FIRST else operands[::-1]
            y, shares, delta = self.y[kept], self.shares[kept], self.x[lost]
            if difference and kind is Kind.SECOND:
                y, shares = on.negate(y), {j: on.negate(c) for j, c in shares.items()}
            if not (difference and kind is Kind.FIRST):
                delta = on.negate(delta)
        self.deltas[number] = delta
        self.shares.append({**shares, number: ONE})
        return y

    def _arriving(self, number: int) -> Shares:
        """Equations (2) and (3), share by share."""
        program, x, y = self.of.program, self.x, self.y
        code, operands = program.operations[number], program.operands_of(number)
        given = [self.shares[k] for k in operands]
        if not any(given):
            return {}
        if code in (op.ADD, op.SUBTRACT, op.NEGATE, op.MULTIPLY, op.DIVIDE):
            own = self._slopes(number, code, operands)
        elif code == op.SQRT:
            own = [on.divide(ONE, on.add(x[number], y[number]))]
        elif code in (op.SIN, op.COS):
            slope = on.sine(on.hull(x[operands[0]], y[operands[0]]), int(code == op.SIN))
            own = [slope if code == op.SIN else on.negate(slope)]
        else:
            # Nothing is known of it but its values: what it changes is a source by itself.
            self.deltas[number] = on.subtract(y[number], x[number])
            return {number: ONE}
        shares: Shares = {}
        for slope, some in zip(own, given, strict=True):
            for j, share in some.items():
                part = share if slope is ONE else on.multiply(slope, share)
                shares[j] = on.add(shares[j], part) if j in shares else part
        return self._turned(number, shares)

    def _slopes(self, number: int, code: int, operands: Sequence[int]) -> list[Interval]:
        x, y = self.x, self.y
        if code in (op.ADD, op.SUBTRACT):
            return [ONE, ONE if code == op.ADD else on.negate(ONE)]
        if code == op.NEGATE:
            return [on.negate(ONE)]
        a, b = operands
        if code == op.MULTIPLY:
            return [y[b], x[a]]
        return [on.divide(ONE, y[b]), on.negate(on.divide(x[number], y[b]))]

    def _turned(self, number: int, shares: Shares) -> Shares:
        """Equation (4), where sine and cosine did not change."""
        turning = self.of.turning[number]
        if turning is None:
            return shares
        c, x, s, y = turning
        products = self.of.program.operands_of(number)
        if self.shares[c] or self.shares[s] or any(k in self.of.edits for k in products):
            return shares
        return {
            j: on.meet(
                share, on.hypotenuse(self.shares[x].get(j, ZERO), self.shares[y].get(j, ZERO))
            )
            for j, share in shares.items()
        }


_RULES: dict[int, Callable[..., Interval]] = {
    op.ADD: on.add, op.SUBTRACT: on.subtract, op.MULTIPLY: on.multiply, op.DIVIDE: on.divide,
    op.NEGATE: on.negate, op.SQRT: on.sqrt, op.SIN: on.sine, op.COS: lambda x: on.sine(x, 1),
}  # fmt: skip


def _turning(program: Program, number: int) -> tuple[int, int, int, int] | None:
    codes, first = program.operations, program.operands[0]
    if codes[number] not in (op.ADD, op.SUBTRACT):
        return None
    one, two = program.operands_of(number)
    if codes[one] != op.MULTIPLY or codes[two] != op.MULTIPLY:
        return None
    for c, x in _circular(program, one):
        for s, y in _circular(program, two):
            if codes[c] != codes[s] and first[c] == first[s]:
                return c, x, s, y
    return None


def _circular(program: Program, product: int) -> list[tuple[int, int]]:
    """A factor that is a sine or cosine, and the other factor."""
    a, b = program.operands_of(product)
    circular = (op.SIN, op.COS)
    return [pair for pair in ((a, b), (b, a)) if program.operations[pair[0]] in circular]


def _beyond_sine(x: Interval) -> Interval:
    """x - sin x, equation (4)."""
    low, high = (on.subtract(end, on.sine(end)) for end in (Interval(e, e) for e in x))
    return on.hull(low, high)
