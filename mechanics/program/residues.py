"""A Schwartz-Zippel filter: nodes at one fixed point modulo a prime, to propose zeros and pivots.

What is zero everywhere is zero here; what is zero here is zero everywhere but for a chance of
degree / 2^61. It decides nothing: whoever picks rows or pivots by it has the result shown by the
kernel. Angles are points on the unit circle, so that sums and multiples of angles are those of
their parts; functions that the field does not know are any numbers, equal for equal arguments.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from mechanics.program.builder import Builder, Node
from mechanics.program.operations import (
    ADD,
    ARITY,
    ATAN2,
    CONSTANT,
    COS,
    DIVIDE,
    ENTRY,
    INPUT,
    MULTIPLY,
    NEGATE,
    OPERATIONS,
    PI,
    SIN,
    SOLVE,
    SQRT,
    SUBTRACT,
    TAN,
)

PRIME = (1 << 61) - 1
PARTS = 840
"""An angle is this many times its base, so that its fractions are multiples of the base, too."""

ODD_PARTS = 105

Point = tuple[int, int]


class NoRoot(Exception):
    """The point of an angle has no half in the field."""


_SMALL = {0: 0, 1: 1, PRIME - 1: -1}


def _draw(*words: object) -> int:
    text = " ".join(map(str, words)).encode()
    return int.from_bytes(hashlib.shake_256(text).digest(16), "big") % (PRIME - 2) + 1


def _turned(one: Point, two: Point) -> Point:
    (a, b), (c, d) = one, two
    return (a * c - b * d) % PRIME, (a * d + b * c) % PRIME


def _times(point: Point, count: int) -> Point:
    if count < 0:
        point, count = (point[0], -point[1] % PRIME), -count
    result: Point = (1, 0)
    while count:
        if count & 1:
            result = _turned(result, point)
        point = _turned(point, point)
        count >>= 1
    return result


def _root(point: Point, parts: int) -> Point:
    """The point of an angle over `parts`: the circle has 2^61 points, so that odd roots exist.

    Raises
    ------
    NoRoot
        Where the angle cannot be halved as often.
    """
    odd = parts
    while odd % 2 == 0:
        odd //= 2
    whole = _times(point, pow(odd, -1, PRIME + 1))
    halved = _halved(whole, parts // odd)
    if halved is None:
        raise NoRoot
    return halved


def _halved(point: Point, parts: int) -> Point | None:
    """One of the points that `parts`, a power of two, take to a point."""
    if parts == 1:
        return point
    c, s = point
    square = (1 + c) * pow(2, -1, PRIME) % PRIME
    x = pow(square, (PRIME + 1) // 4, PRIME)
    if not x or x * x % PRIME != square:
        return point if point == (1, 0) else None
    y = s * pow(2 * x, -1, PRIME) % PRIME
    for half in ((x, y), (-x % PRIME, -y % PRIME)):
        found = _halved(half, parts // 2)
        if found is not None:
            return found
    return None


@dataclass
class Residues:
    """Values of nodes of one builder, each computed once.

    Parameters
    ----------
    builder : Builder
    replaced : mapping of Node to Node, optional
        What takes the place of inputs: what constraints give.
    point : int
        Another point for every number.
    parts : int
        `PARTS`, or `ODD_PARTS` where an angle that is replaced has no half in the field.
    """

    builder: Builder
    replaced: Mapping[Node, Node] = field(default_factory=dict)
    point: int = 0
    parts: int = PARTS
    _values: dict[int, int] = field(default_factory=dict)
    _bases: dict[int, Point] = field(default_factory=dict)
    _solutions: dict[int, list[int]] = field(default_factory=dict)

    def is_zero(self, node: Node) -> bool:
        """Whether a node is zero at the point."""
        return node.is_zero or self.values([node])[0] == 0

    def tidy(self, node: Node) -> Node:
        """0, 1 or -1 where a node is that at the point: sin^2 + cos^2 hides it; else the node."""
        if node.constant is not None:
            return node
        (residue,) = self.values([node])
        return self.builder.node(_SMALL[residue]) if residue in _SMALL else node

    def values(self, nodes: Sequence[Node]) -> list[int]:
        """Residues of nodes."""
        for node in nodes:
            if node.number not in self._values:
                self._evaluate_with_operands(node.number)
        return [self._values[node.number] for node in nodes]

    def _evaluate_with_operands(self, number: int) -> None:
        """Evaluate a node after what it needs; what has a value is not looked into again."""
        operations, values, solutions = self.builder.operations, self._values, self._solutions
        waiting = [number]
        while waiting:
            last = waiting[-1]
            if last in values or last in solutions:
                waiting.pop()
                continue
            code = operations[last]
            if code == SOLVE:
                operands: Sequence[int] = self.builder.systems[self.builder.operands[0][last]][2:]
            elif code == INPUT:
                value = self.replaced.get(Node(self.builder, last))
                operands = [] if value is None else [value.number]
            else:
                operands = [column[last] for column in self.builder.operands[: ARITY[code]]]
            missing = [n for n in operands if n not in values and n not in solutions]
            if missing:
                waiting.extend(missing)
            else:
                self._evaluate(last)
                waiting.pop()

    def _evaluate(self, number: int) -> None:
        build, values = self.builder, self._values
        code, (first, second, _) = build.operations[number], build.operands
        a, b = first[number], second[number]
        if code == MULTIPLY:
            values[number] = values[a] * values[b] % PRIME
        elif code == ADD:
            values[number] = (values[a] + values[b]) % PRIME
        elif code == SUBTRACT:
            values[number] = (values[a] - values[b]) % PRIME
        elif code == NEGATE:
            values[number] = -values[a] % PRIME
        elif code in (SIN, COS, TAN):
            c, s = _times(self._base(a), self.parts)
            values[number] = s if code == SIN else c if code == COS else s * pow(c, -1, PRIME)
        elif code == CONSTANT:
            ratio = build.constants[a]
            values[number] = ratio.numerator * pow(ratio.denominator, -1, PRIME) % PRIME
        elif code == INPUT:
            value = self.replaced.get(Node(build, number))
            words = ("input", build.inputs[a], *([self.point] if self.point else []))
            values[number] = _draw(*words) if value is None else values[value.number]
        elif code == DIVIDE and values[b]:
            values[number] = values[a] * pow(values[b], -1, PRIME) % PRIME
        elif code == SOLVE:
            self._solutions[number] = self._solved(number)
        elif code == ENTRY:
            values[number] = self._solutions[a][b]
        elif code == SQRT and pow(values[a], (PRIME - 1) // 2, PRIME) <= 1:
            values[number] = pow(values[a], (PRIME + 1) // 4, PRIME)
        elif code == PI:
            values[number] = _draw("pi")
        else:
            operands = [values[column[number]] for column in build.operands[: ARITY[code]]]
            values[number] = _draw(OPERATIONS[code].name, *operands)

    def _base(self, number: int) -> Point:
        """The point of an angle over its parts: linear in angles that are not looked into."""
        if number in self._bases:
            return self._bases[number]
        code, (first, second, _) = self.builder.operations[number], self.builder.operands
        a, b = first[number], second[number]
        factor = self.builder.constant_at(a) if code == MULTIPLY else None
        value = self.replaced.get(Node(self.builder, number)) if code == INPUT else None
        if value is not None:
            point = self._base(value.number)
        elif code == ADD:
            point = _turned(self._base(a), self._base(b))
        elif code == SUBTRACT:
            point = _turned(self._base(a), _times(self._base(b), -1))
        elif code == NEGATE:
            point = _times(self._base(a), -1)
        elif factor is not None and (factor * self.parts).denominator == 1:
            whole = factor.denominator
            point = _times(self._fraction(b, whole), factor.numerator)
        else:
            point = self._fraction(number, 1)
        self._bases[number] = point
        return point

    def _direction(self, y: int, x: int) -> Point:
        """(x, y) / sqrt(x^2 + y^2)."""
        c, s = self._values[x], self._values[y]
        radius = pow((c * c + s * s) % PRIME, (PRIME + 1) // 4, PRIME)
        below = pow(radius, -1, PRIME) if radius else 0
        return c * below % PRIME, s * below % PRIME

    def _fraction(self, number: int, parts: int) -> Point:
        """The point of an angle over its parts, as the multiple of one over `parts`."""
        value = self.replaced.get(Node(self.builder, number))
        if value is not None:
            number = value.number
        if self.builder.operations[number] == ATAN2:
            y, x, _ = (column[number] for column in self.builder.operands)
            try:
                return _root(self._direction(y, x), self.parts * parts)
            except NoRoot:
                # A part of an angle is less than the angle: known by its value alone.
                if parts == 1:
                    raise
        t = _draw("angle", self._values[number])
        below = pow(1 + t * t, -1, PRIME)
        finest: Point = ((1 - t * t) * below % PRIME, 2 * t * below % PRIME)
        return _times(finest, self.parts // parts)

    def _solved(self, number: int) -> list[int]:
        size, _, *entries = self.builder.systems[self.builder.operands[0][number]]
        known = [self._values[entry] for entry in entries]
        rows = [[*known[size * i : size * (i + 1)], known[size * size + i]] for i in range(size)]
        pivots = eliminate(rows, size)
        if len(pivots) < size:
            return [_draw("singular", number, i) for i in range(size)]
        place = {column: row for row, column in pivots}
        return [rows[place[i]][size] for i in range(size)]


def eliminate(rows: list[list[int]], columns: int) -> list[tuple[int, int]]:
    """Gauss-Jordan elimination modulo the prime, in place, rows taken in order.

    Returns
    -------
    list of (int, int)
        (row, column) of each pivot; the rows are independent ones, earlier rows first.
    """
    pivots: list[tuple[int, int]] = []
    for i, row in enumerate(rows):
        for r, c in pivots:
            if factor := row[c]:
                other = rows[r]
                row[:] = [(x - factor * y) % PRIME for x, y in zip(row, other, strict=True)]
        column = next((c for c in range(columns) if row[c]), None)
        if column is None:
            continue
        scale = pow(row[column], -1, PRIME)
        row[:] = [x * scale % PRIME for x in row]
        for r, _ in pivots:
            if factor := rows[r][column]:
                rows[r] = [(x - factor * y) % PRIME for x, y in zip(rows[r], row, strict=True)]
        pivots.append((i, column))
    return pivots
