"""A Schwartz-Zippel filter: nodes at one fixed point modulo a prime, to propose zeros and pivots.

What is zero everywhere is zero here; what is zero here is zero everywhere but for a chance of
degree / 2^60. It decides nothing: whoever picks rows or pivots by it has the result shown by the
kernel. Angles are points on the unit circle, so that sums and multiples of angles are those of
their parts; the prime is one that has the roots of numbers, as sqrt(3) of a turn by pi / 6;
functions that the field does not know are any numbers, equal for equal arguments.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import islice

from flint import fmpz

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
ARITHMETIC = frozenset({ADD, SUBTRACT, MULTIPLY, NEGATE, DIVIDE, SQRT})

PARTS = 840
"""An angle is this many times its base, so that its fractions are multiples of the base, too."""

ODD_PARTS = 105
EVEN_PARTS = 8
WHOLE = 1
"""Where the field of another prime than `PRIME` has no thirds, fifths and sevenths."""

TRIED_PRIMES = 1024
"""Each root of a number that is independent of the others halves the primes that have it."""

Point = tuple[int, int]


class NoRoot(Exception):
    """The point of an angle has no half in the field."""


def _draw(*words: object) -> int:
    text = " ".join(map(str, words)).encode()
    return int.from_bytes(hashlib.shake_256(text).digest(16), "big") % (PRIME - 2) + 1


def _turned(one: Point, two: Point, prime: int) -> Point:
    (a, b), (c, d) = one, two
    return (a * c - b * d) % prime, (a * d + b * c) % prime


def _times(point: Point, count: int, prime: int) -> Point:
    if count < 0:
        point, count = (point[0], -point[1] % prime), -count
    result: Point = (1, 0)
    while count:
        if count & 1:
            result = _turned(result, point, prime)
        point = _turned(point, point, prime)
        count >>= 1
    return result


def _root(point: Point, parts: int, prime: int) -> Point:
    """The point of an angle over `parts`.

    Modulo `PRIME` the circle has 2^61 points, so that odd roots exist.

    Raises
    ------
    NoRoot
        Where the angle cannot be halved as often, or an odd part divides the number of points.
    """
    odd = parts
    while odd % 2 == 0:
        odd //= 2
    if math.gcd(odd, prime + 1) > 1:
        raise NoRoot
    whole = _times(point, pow(odd, -1, prime + 1), prime)
    halved = _halved(whole, parts // odd, prime)
    if halved is None:
        raise NoRoot
    return halved


def _halved(point: Point, parts: int, prime: int) -> Point | None:
    """One of the points that `parts`, a power of two, take to a point."""
    if parts == 1:
        return point
    c, s = point
    square = (1 + c) * pow(2, -1, prime) % prime
    x = pow(square, (prime + 1) // 4, prime)
    if not x or x * x % prime != square:
        return point if point == (1, 0) else None
    y = s * pow(2 * x, -1, prime) % prime
    for half in ((x, y), (-x % prime, -y % prime)):
        found = _halved(half, parts // 2, prime)
        if found is not None:
            return found
    return None


def _primes() -> Iterator[int]:
    """`PRIME`, then primes of as many bits that are -1 modulo 840: see `kernel.primes`."""
    yield PRIME
    candidate = PRIME - (PRIME + 1) % 840
    while True:
        if fmpz(candidate).is_probable_prime():
            yield candidate
        candidate -= 840


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

    @cached_property
    def prime(self) -> int:
        """The first prime with all roots of numbers that the builder has at the first question.

        Modulo one prime half of all numbers have no root, so that sqrt(3)^2 would not be 3, and
        no prime has sqrt(3) and a third of every angle. `PRIME` where none of the first has all.
        """
        roots = _roots_of_numbers(self.builder)
        for prime in islice(_primes(), TRIED_PRIMES if roots else 1):
            field_ = Residues(self.builder)
            field_.prime = prime
            if all(field_._is_square(radicand) for radicand in roots):
                return prime
        return PRIME

    def _is_square(self, node: Node) -> bool:
        return pow(self.values([node])[0], (self.prime - 1) // 2, self.prime) <= 1

    def eliminate(self, rows: list[list[int]], columns: int) -> list[tuple[int, int]]:
        """Gauss-Jordan elimination of values of this filter: see the function `eliminate`."""
        return eliminate(rows, columns, self.prime)

    def is_zero(self, node: Node) -> bool:
        """Whether a node is zero at the point."""
        return node.is_zero or self.values([node])[0] == 0

    def tidy(self, node: Node) -> Node:
        """0, 1 or -1 where a node is that at the point: sin^2 + cos^2 hides it; else the node."""
        if node.constant is not None:
            return node
        (residue,) = self.values([node])
        small = {0: 0, 1: 1, self.prime - 1: -1}
        return self.builder.node(small[residue]) if residue in small else node

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
            values[number] = values[a] * values[b] % self.prime
        elif code == ADD:
            values[number] = (values[a] + values[b]) % self.prime
        elif code == SUBTRACT:
            values[number] = (values[a] - values[b]) % self.prime
        elif code == NEGATE:
            values[number] = -values[a] % self.prime
        elif code in (SIN, COS, TAN):
            c, s = _times(self._base(a), self.parts, self.prime)
            values[number] = s if code == SIN else c if code == COS else s * pow(c, -1, self.prime)
        elif code == CONSTANT:
            ratio = build.constants[a]
            values[number] = ratio.numerator * pow(ratio.denominator, -1, self.prime) % self.prime
        elif code == INPUT:
            value = self.replaced.get(Node(build, number))
            words = ("input", build.inputs[a], *([self.point] if self.point else []))
            values[number] = _draw(*words) if value is None else values[value.number]
        elif code == DIVIDE and values[b]:
            values[number] = values[a] * pow(values[b], -1, self.prime) % self.prime
        elif code == SOLVE:
            self._solutions[number] = self._solved(number)
        elif code == ENTRY:
            values[number] = self._solutions[a][b]
        elif code == SQRT and pow(values[a], (self.prime - 1) // 2, self.prime) <= 1:
            values[number] = pow(values[a], (self.prime + 1) // 4, self.prime)
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
            point = _turned(self._base(a), self._base(b), self.prime)
        elif code == SUBTRACT:
            point = _turned(self._base(a), _times(self._base(b), -1, self.prime), self.prime)
        elif code == NEGATE:
            point = _times(self._base(a), -1, self.prime)
        elif factor is not None and (factor * self.parts).denominator == 1:
            whole = factor.denominator
            point = _times(self._fraction(b, whole), factor.numerator, self.prime)
        else:
            point = self._fraction(number, 1)
        self._bases[number] = point
        return point

    def _direction(self, y: int, x: int) -> Point:
        """(x, y) / sqrt(x^2 + y^2)."""
        c, s = self._values[x], self._values[y]
        radius = pow((c * c + s * s) % self.prime, (self.prime + 1) // 4, self.prime)
        below = pow(radius, -1, self.prime) if radius else 0
        return c * below % self.prime, s * below % self.prime

    def _fraction(self, number: int, parts: int) -> Point:
        """The point of an angle over its parts, as the multiple of one over `parts`."""
        value = self.replaced.get(Node(self.builder, number))
        if value is not None:
            number = value.number
        if self.builder.operations[number] == ATAN2:
            y, x, _ = (column[number] for column in self.builder.operands)
            try:
                return _root(self._direction(y, x), self.parts * parts, self.prime)
            except NoRoot:
                # A part of an angle is less than the angle: known by its value alone.
                if parts == 1:
                    raise
        t = _draw("angle", self._values[number])
        below = pow(1 + t * t, -1, self.prime)
        finest: Point = ((1 - t * t) * below % self.prime, 2 * t * below % self.prime)
        return _times(finest, self.parts // parts, self.prime)

    def _solved(self, number: int) -> list[int]:
        size, _, *entries = self.builder.systems[self.builder.operands[0][number]]
        known = [self._values[entry] for entry in entries]
        rows = [[*known[size * i : size * (i + 1)], known[size * size + i]] for i in range(size)]
        pivots = self.eliminate(rows, size)
        if len(pivots) < size:
            return [_draw("singular", number, i) for i in range(size)]
        place = {column: row for row, column in pivots}
        return [rows[place[i]][size] for i in range(size)]


def _roots_of_numbers(builder: Builder) -> list[Node]:
    """Radicands without inputs, in the order of the builder: sqrt(3), sqrt(5 - sqrt(5))."""
    operations, operands = builder.operations, builder.operands
    if SQRT not in operations:
        return []
    known: set[int] = set()
    found = []
    for number, code in enumerate(operations):
        below = [column[number] for column in operands[: ARITY[code]]]
        if code == CONSTANT or (code in ARITHMETIC and known.issuperset(below)):
            known.add(number)
            if code == SQRT:
                found.append(Node(builder, below[0]))
    return found


def eliminate(rows: list[list[int]], columns: int, prime: int) -> list[tuple[int, int]]:
    """Gauss-Jordan elimination modulo a prime, in place, rows taken in order.

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
                row[:] = [(x - factor * y) % prime for x, y in zip(row, other, strict=True)]
        column = next((c for c in range(columns) if row[c]), None)
        if column is None:
            continue
        scale = pow(row[column], -1, prime)
        row[:] = [x * scale % prime for x in row]
        for r, _ in pivots:
            if factor := rows[r][column]:
                rows[r] = [(x - factor * y) % prime for x, y in zip(rows[r], row, strict=True)]
        pivots.append((i, column))
    return pivots
