"""A Schwartz-Zippel filter: nodes at one fixed point modulo a prime, to propose zeros and pivots.

What is zero everywhere is zero here; what is zero here is zero everywhere but for a chance of
degree / 2^60. It decides nothing: whoever picks rows or pivots by it has the result shown by the
kernel. Angles are points on the unit circle, so that sums and multiples of angles are those of
their parts; functions that the field does not know are any numbers, equal for equal arguments.

Half of all numbers have no root modulo one prime. So the prime is one that has the roots of
numbers, as sqrt(3) of a turn by pi / 6; and inputs are drawn again, group by group, until what is
below a root of theirs has one, as a^2 + w^2 of a turn by atan2(w, a). Where loops close one after
the other that is found after many draws, so a filter may begin with what another one found.
"""

import hashlib
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from itertools import chain, islice
from typing import Any

from flint import fmpz, nmod_mat

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
from mechanics.program.postorder import postorder

PRIME = (1 << 61) - 1

PARTS = 840
"""An angle is this many times its base, so that its fractions are multiples of the base, too."""

MOST_PARTS = 10_000
"""A part of an angle that is smaller is an angle of its own."""

TRIED_PRIMES = 1024
"""Each root of a number that is independent of the others halves the primes that have it."""

TRIED_POINTS = 1024
"""Each root of inputs halves the points that have it."""

BEGIN = -1
"""The round whose inputs are those of another filter."""

FEW_ROOTS = 8
FLIPS = 4
"""Signs that are changed for each root before the inputs are drawn again."""

MOST_STEPS = 400_000
"""Nodes that are evaluated for the roots of one group of inputs."""

Point = tuple[int, int]


def _draw_residue(*words: object) -> int:
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


def _part(point: Point, parts: int, prime: int) -> Point | None:
    """A point that so many times is a point, where the circle has one."""
    even = parts & -parts
    odd, order = parts // even, prime + 1
    while (common := math.gcd(odd, order)) > 1:
        order //= common
    # Points of an order that is prime to the odd part have their part.
    if order <= prime and _times(point, order, prime) != (1, 0):
        return None
    return _halved(_times(point, pow(odd, -1, order), prime), even, prime)


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
    """`PRIME`, then primes 7 modulo 8 of as many bits: -1 is no square then, and 2 is one."""
    candidate = PRIME
    while True:
        if fmpz(candidate).is_probable_prime():
            yield candidate
        candidate -= 8


@dataclass(frozen=True)
class Choice:
    """The point of a filter, for other filters of the same builder to begin with.

    Attributes
    ----------
    prime : int
    inputs : mapping of int to int
        Residues of the inputs below roots, by their numbers.
    other : frozenset of int
        Roots that have the other sign.
    """

    prime: int
    inputs: Mapping[int, int]
    other: frozenset[int]


@dataclass
class Residues:
    """Values of nodes of one builder, each computed once.

    The prime and the point are chosen at the first question, by the roots and the fractions of
    angles that the builder has then.

    Parameters
    ----------
    replaced : mapping of Node to Node, optional
        What takes the place of inputs: what constraints give.
    begin : Choice, optional
        Tried first; where a root does not exist there, inputs are drawn as without it.
    """

    builder: Builder
    replaced: Mapping[Node, Node] = field(default_factory=dict)
    begin: Choice | None = None
    _values: dict[int, int] = field(default_factory=dict)
    _solutions: dict[int, list[int]] = field(default_factory=dict)
    _points: dict[tuple[int, Fraction], Point] = field(default_factory=dict)
    _other: set[int] = field(default_factory=set)
    _prime: int = 0
    _round: int = 0

    @cached_property
    def parts(self) -> int:
        """Parts of an angle that are looked at: all that the builder has, and some more."""
        needed = _denominator(self.builder, self.replaced)
        # An angle that is told by its sine and cosine has a half at every other point only.
        return needed if ATAN2 in self.builder.operations else math.lcm(PARTS, needed)

    @property
    def prime(self) -> int:
        """The first prime with all roots of numbers; `PRIME` where none of the first has all."""
        if not self._prime:
            self._choose()
        return self._prime

    def _choose(self) -> None:
        """Choose the prime, then the point."""
        groups = self._groups()
        numbers = groups.pop(0, [])
        first = [] if self.begin is None else [self.begin.prime]
        for self._prime in chain(first, islice(_primes(), TRIED_PRIMES), [PRIME]):
            self._forget((0, 0, 0))
            if self._count(numbers) == len(numbers):
                break
        for roots in groups.values():
            self._draw(roots)

    @property
    def choice(self) -> Choice:
        """What is chosen, with all inputs that have values by now."""
        prime, operations = self.prime, self.builder.operations
        inputs = {
            number: value
            for number, value in self._values.items()
            if operations[number] == INPUT and Node(self.builder, number) not in self.replaced
        }
        return Choice(prime, inputs, frozenset(self._other))

    def _draw(self, roots: Sequence[int]) -> None:
        """Draw the inputs of some roots until all of these exist, or as many as can be."""
        marks = len(self._values), len(self._solutions), len(self._points)
        best, steps, first = (-1, 0), 0, 0 if self.begin is None else BEGIN
        for self._round in range(first, TRIED_POINTS):
            count = self._count(roots)
            best = max(best, (count, -self._round))
            steps += len(self._values) - marks[0] + 1
            if count == len(roots) or steps > MOST_STEPS:
                break
            self._forget(marks)
        if best[0] < len(roots):
            self._forget(marks)
            self._round = -best[1]
            self._count(roots)
        self._round = 0

    def _forget(self, marks: tuple[int, int, int]) -> None:
        """Forget what was computed since there were so many."""
        _shorten(self._values, marks[0])
        _shorten(self._solutions, marks[1])
        _shorten(self._points, marks[2])

    def _count(self, roots: Sequence[int]) -> int:
        """How many of the first roots exist; of many, depth first over the signs of those before.

        Where a loop is closed after another, half of the points that close the first do not close
        it, so that drawing all again takes 2^n draws. Few are drawn again: that leaves sqrt(a b) =
        sqrt(a) sqrt(b), which signs break.
        """
        self._other.difference_update(roots)
        if self.begin is not None and self._round == BEGIN:
            self._other |= self.begin.other.intersection(roots)
        count = most = flips = 0
        allowed = FLIPS * len(roots) if len(roots) > FEW_ROOTS else 0
        trail: list[tuple[int, tuple[int, int, int]]] = []
        while count < len(roots):
            marks = len(self._values), len(self._solutions), len(self._points)
            if self._exists(roots[count]):
                trail.append((count, marks))
                count += 1
                most = max(most, count)
                continue
            flips += 1
            if flips > allowed:
                return most
            while trail:
                count, marks = trail.pop()
                if (
                    self.builder.operations[roots[count]] == SQRT
                    and roots[count] not in self._other
                ):
                    break
                self._other.discard(roots[count])
            else:
                return most
            self._forget(marks)
            self._other.add(roots[count])
        return count

    def _exists(self, number: int) -> bool:
        """Whether a root or the direction of a point is in the field."""
        y, x, _ = (column[number] for column in self.builder.operands)
        self._evaluate_with_operands(y)
        if self.builder.operations[number] == SQRT:
            return self._has_root(self._values[y])
        self._evaluate_with_operands(x)
        return self._direction(y, x) is not None

    def _has_root(self, value: int) -> bool:
        return pow(value, (self._prime - 1) // 2, self._prime) <= 1

    def _groups(self) -> dict[int, list[int]]:
        """Roots and angles of points, by the last input that they hold; 0 for those of numbers.

        An input is the later the later it is held for the first time, so that the groups can be
        drawn one after the other, each with inputs of its own.
        """
        operations, order = self.builder.operations, dict[int, int]()
        held: dict[int, int] = {}
        groups: dict[int, list[int]] = {}
        for number, code in enumerate(operations):
            if code not in (SQRT, ATAN2):
                continue
            for last in postorder(number, self._operands, held):
                operands, own = self._operands(last), 0
                if operations[last] == INPUT and not operands:
                    own = order.setdefault(last, len(order) + 1)
                held[last] = max([own, *(held[n] for n in operands)])
            groups.setdefault(held[number], []).append(number)
        return dict(sorted(groups.items()))

    def eliminate(self, rows: list[list[int]], columns: int) -> list[tuple[int, int]]:
        """Gauss-Jordan elimination of values of this filter: see the function `eliminate`."""
        return eliminate(rows, columns, self.prime)

    def rank(self, matrix: Sequence[Sequence[Node]]) -> int:
        """Rank of a matrix of nodes at the point."""
        entries = self.values([entry for row in matrix for entry in row])
        width = len(matrix[0]) if matrix else 0
        return int(nmod_mat(len(matrix), width, entries, self.prime).rank())

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
        if not self._prime:
            self._choose()
        for node in nodes:
            if node.number not in self._values:
                self._evaluate_with_operands(node.number)
        return [self._values[node.number] for node in nodes]

    def _operands(self, number: int) -> Sequence[int]:
        """What a node is computed from; what takes its place, for an input that is replaced."""
        code = self.builder.operations[number]
        if code == SOLVE:
            return self.builder.systems[self.builder.operands[0][number]][2:]
        if code == INPUT:
            value = self.replaced.get(Node(self.builder, number))
            return [] if value is None else [value.number]
        return [column[number] for column in self.builder.operands[: ARITY[code]]]

    def _evaluate_with_operands(self, number: int) -> None:
        """Evaluate a node after what it needs; what has a value is not looked into again."""
        for last in postorder(number, self._operands, self._values):
            self._evaluate(last)

    def _evaluate(self, number: int) -> None:
        build, values = self.builder, self._values
        code, (first, second, _) = build.operations[number], build.operands
        a, b = first[number], second[number]
        if code == MULTIPLY:
            values[number] = values[a] * values[b] % self._prime
        elif code == ADD:
            values[number] = (values[a] + values[b]) % self._prime
        elif code == SUBTRACT:
            values[number] = (values[a] - values[b]) % self._prime
        elif code == NEGATE:
            values[number] = -values[a] % self._prime
        elif code in (SIN, COS, TAN):
            c, s = self._point(a, Fraction(1))
            values[number] = s if code == SIN else c if code == COS else s * pow(c, -1, self._prime)
        elif code == CONSTANT:
            ratio = build.constants[a]
            values[number] = ratio.numerator * pow(ratio.denominator, -1, self._prime) % self._prime
        elif code == INPUT:
            value = self.replaced.get(Node(build, number))
            values[number] = self._input(number) if value is None else values[value.number]
        elif code == DIVIDE and values[b]:
            values[number] = values[a] * pow(values[b], -1, self._prime) % self._prime
        elif code == SOLVE:
            self._solutions[number], values[number] = self._solved(number), 0
        elif code == ENTRY:
            values[number] = self._solutions[a][b]
        elif code == SQRT and self._has_root(values[a]):
            root = pow(values[a], (self._prime + 1) // 4, self._prime)
            values[number] = -root % self._prime if number in self._other else root
        elif code == PI:
            values[number] = _draw_residue("pi")
        else:
            operands = [values[column[number]] for column in build.operands[: ARITY[code]]]
            values[number] = _draw_residue(OPERATIONS[code].name, *operands)

    def _input(self, number: int) -> int:
        if self.begin is not None and self._round == BEGIN and number in self.begin.inputs:
            return self.begin.inputs[number]
        name = self.builder.inputs[self.builder.operands[0][number]]
        return _draw_residue("input", name, *([self._round] if self._round else []))

    def _point(self, number: int, factor: Fraction) -> Point:
        """Cosine and sine of a multiple of an angle: linear in angles that are not looked into."""
        key = number, factor
        if key not in self._points:
            code, (a, b, _) = self.builder.operations[number], self._of(number)
            value = self.replaced.get(Node(self.builder, number)) if code == INPUT else None
            constant = self.builder.constant_at(a) if code == MULTIPLY else None
            if value is not None:
                point = self._point(value.number, factor)
            elif code in (ADD, SUBTRACT):
                other = self._point(b, factor if code == ADD else -factor)
                point = _turned(self._point(a, factor), other, self._prime)
            elif code == NEGATE:
                point = self._point(a, -factor)
            elif constant is not None and _is_part(factor * constant, self.parts):
                point = self._point(b, factor * constant)
            else:
                point = self._angle(number, factor)
            self._points[key] = point
        return self._points[key]

    def _of(self, number: int) -> tuple[int, int, int]:
        first, second, third = self.builder.operands
        return first[number], second[number], third[number]

    def _angle(self, number: int, factor: Fraction) -> Point:
        """A multiple of an angle of which a part is any point, or the part of a known one."""
        base = None
        if self.builder.operations[number] == ATAN2:
            base = self._direction(*self._of(number)[:2])
        if base is None:
            t = _draw_residue("angle", self._values[number])
            below = pow(1 + t * t, -1, self._prime)
            base = (1 - t * t) * below % self._prime, 2 * t * below % self._prime
        return _times(base, (factor * self.parts).numerator, self._prime)

    def _direction(self, y: int, x: int) -> Point | None:
        """The part of the angle of (x, y), if the field has the distance, and half of the angle."""
        c, s = self._values[x], self._values[y]
        square = (c * c + s * s) % self._prime
        if not square or not self._has_root(square):
            return None
        below = pow(square, -(self._prime + 1) // 4, self._prime)
        whole = c * below % self._prime, s * below % self._prime
        return _part(whole, self.parts, self._prime)

    def _solved(self, number: int) -> list[int]:
        size, _, *entries = self.builder.systems[self.builder.operands[0][number]]
        known = [self._values[entry] for entry in entries]
        rows = [[*known[size * i : size * (i + 1)], known[size * size + i]] for i in range(size)]
        pivots = self.eliminate(rows, size)
        if len(pivots) < size:
            return [_draw_residue("singular", number, i) for i in range(size)]
        place = {column: row for row, column in pivots}
        return [rows[place[i]][size] for i in range(size)]


def _shorten(table: dict[Any, Any], count: int) -> None:
    """Leave the first entries."""
    while len(table) > count:
        table.popitem()


def _is_part(factor: Fraction, parts: int) -> bool:
    return (factor * parts).denominator == 1


def _denominator(builder: Builder, replaced: Mapping[Node, Node]) -> int:
    """The common denominator of the fractions of angles that a builder has."""
    operations, (first, second, _) = builder.operations, builder.operands
    waiting = [
        (first[n], 1) for n, code in enumerate(operations) if code in (SIN, COS, TAN)
    ]  # fmt: skip
    seen = set(waiting)
    common = 1
    while waiting:
        number, below = waiting.pop()
        code = operations[number]
        common = math.lcm(common, below)
        following: list[tuple[int, int]] = []
        if code in (ADD, SUBTRACT, NEGATE):
            following.append((first[number], below))
        if code in (ADD, SUBTRACT):
            following.append((second[number], below))
        factor = builder.constant_at(first[number]) if code == MULTIPLY else None
        if factor is not None and below * factor.denominator <= MOST_PARTS:
            following.append((second[number], below * factor.denominator))
        if code == INPUT and Node(builder, number) in replaced:
            following.append((replaced[Node(builder, number)].number, below))
        waiting += [pair for pair in following if pair not in seen]
        seen.update(following)
    return common


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
