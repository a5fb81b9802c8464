"""The solution of K x = k at a point, enclosed: what every error is measured against.

    K_ij = sum of terms,  |K|_ij = sum of their magnitudes         in normal form

Terms that cancel identically are gone, so a sum of magnitudes holds what is really added up.

The precision is raised until each unknown is known to 2^-80 of its value. An unknown that is zero
there would never be: what the normal form proves zero is zero. Where neither comes to an end, 2^-80
of the sum of the magnitudes of its terms, (|K^-1| |k|)_i, has to do.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TypeVar

import sympy
from flint import arb, arb_mat

from mechanics.compiled.quantities import angles
from mechanics.equations import Equations
from mechanics.kernel import Statement
from mechanics.kernel.balls import Balls, precision
from mechanics.kernel.normal import proves
from mechanics.program import Builder, Node, Program, interpret
from mechanics.program.interpret import include
from mechanics.program.operations import ADD, NEGATE, SUBTRACT
from mechanics.program.sympy_reader import read
from mechanics.routes.rows import acceleration_forms, coefficients, remainder
from mechanics.symbolic import Arithmetic, canonical

BITS = 192
LAST_BITS = 192 * 2**6
PROOF_BITS = 192 * 2**3
ENOUGH = 80
Rows = list[list[arb]]
T = TypeVar("T")


@dataclass(frozen=True, eq=False)
class Enclosed:
    """The linear system and its solution at one point.

    Attributes
    ----------
    rows, sizes : n rows of n + 1 balls
        K and k; sums of the magnitudes of the terms of each entry.
    solution : tuple of arb, or None where K is singular
    spread : tuple of arb
        (|K^-1| (|K| |x| + |k|))_i: how much a relative change of the terms moves each unknown.
    condition : arb
        |K| |K^-1|, largest row sums, in the SI units of the rows.
    proved_zero : tuple of bool
        Unknowns whose value is zero by the normal form.
    bits : int
        Precision that was needed.
    """

    rows: Rows
    sizes: Rows
    solution: tuple[arb, ...] | None
    spread: tuple[arb, ...]
    condition: arb
    proved_zero: tuple[bool, ...]
    bits: int


@dataclass(frozen=True, eq=False)
class Truth:
    """Encloses the solution of one set of equations at any point.

    Attributes
    ----------
    size : int
        Number of unknowns n.
    names : tuple of str
        Inputs of the program, in the order of the values of a point.
    program : Program
        The terms of each entry of K and k as an output of its own, row by row; what is k stands in
        column n.
    turning : frozenset of str
        Names of what stands under a sine or cosine.
    """

    size: int
    names: tuple[str, ...]
    program: Program
    turning: frozenset[str]

    def at(self, values: Sequence[float]) -> Enclosed:
        """The system and its solution where the symbols have these values, exactly."""
        bits = BITS
        found = self._at(values, bits)
        zeros: tuple[bool, ...] = (False,) * self.size
        while bits < LAST_BITS and not _known(found, zeros):
            if bits == PROOF_BITS:
                if found.solution is None and self._singular(values):
                    return found
                zeros = self._zeros(values, found)
            bits *= 2
            found = self._at(values, bits)
        return _settled(found, zeros)

    def _at(self, values: Sequence[float], bits: int) -> Enclosed:
        with precision(bits):
            rows, sizes = self._system(values)
            n = self.size
            left, right = arb_mat([row[:n] for row in rows]), arb_mat([row[n:] for row in rows])
            nothing = (False,) * n
            if not all(entry.is_finite() for row in rows for entry in row):
                return Enclosed(rows, sizes, None, (), arb.nan(), nothing, bits)
            try:
                inverse = left.inv()
            except ZeroDivisionError:
                return Enclosed(rows, sizes, None, (), arb.pos_inf(), nothing, bits)
            x = (inverse * right).entries()
            magnitudes = [
                sum((abs(v) * s for v, s in zip(x, row[:n], strict=True)), row[n]) for row in sizes
            ]
            spread = tuple(
                sum((abs(inverse[i, j]) * magnitudes[j] for j in range(n)), arb(0))
                for i in range(n)
            )
            condition = _norm(left) * _norm(inverse)
            return Enclosed(rows, sizes, tuple(x), spread, condition, nothing, bits)

    def _system(self, values: Sequence[float]) -> tuple[Rows, Rows]:
        balls = {name: arb(value) for name, value in zip(self.names, values, strict=True)}
        found = interpret(self.program, Balls(), balls, release=False)
        totals = [sum(terms, arb(0)) for terms in found.values()]
        sizes = [sum(map(abs, terms), arb(0)) for terms in found.values()]
        return _rows(totals, self.size + 1), _rows(sizes, self.size + 1)

    def _exactly(self, builder: Builder, values: Sequence[float]) -> list[list[Node]]:
        """K and k with exact rationals in place of the symbols, angles left open.

        What vanishes at every angle does so at these; equal angles stay equal.
        """
        table = {}
        for name, value in zip(self.names, values, strict=True):
            number = builder.constant(Fraction(value))
            if name in self.turning and value:
                angle = builder.input(f"angle {abs(value)!r}")
                number = angle if value > 0 else -angle
            table[name] = number
        found = include(builder, self.program, table)
        return _rows([sum(terms, builder.zero) for terms in found.values()], self.size + 1)

    def _zeros(self, values: Sequence[float], found: Enclosed) -> tuple[bool, ...]:
        """Which unknowns the normal form proves zero."""
        if found.solution is None:
            return found.proved_zero
        builder, n = Builder(), self.size
        rows = self._exactly(builder, values)
        unknowns = builder.solve([row[:n] for row in rows], [row[n] for row in rows])

        def proved(unknown: Node) -> bool:
            sides = builder.program({"left": [unknown], "right": [builder.zero]})
            return proves(Statement("the unknown is zero", sides))

        return tuple(
            not x.is_zero() and bool(x.contains(0)) and proved(unknown)
            for x, unknown in zip(found.solution, unknowns, strict=True)
        )

    def _singular(self, values: Sequence[float]) -> bool:
        field, n = Arithmetic(), self.size
        rows = self._exactly(field.builder, values)
        return field.rank([row[:n] for row in rows]) < n


def truth(equations: Equations, symbols: Sequence[sympy.Symbol]) -> Truth:
    """Enclosures for the linear system of a set of equations.

    Parameters
    ----------
    symbols : sequence of Symbol
        Everything that has a value: q, u, inputs, parameters.

    Raises
    ------
    ExpressionError
        If an operation has no meaning in programs; it is named.
    TooLarge
        If the normal form is.
    """
    if equations.textbook is None:
        return _truth_of_program(equations, symbols)
    left, right = equations.system
    builder = Builder()
    inputs = {symbol: builder.input(symbol.name) for symbol in symbols}
    terms = {
        str(place): read(builder, sympy.Add.make_args(canonical(entry)), inputs)
        for place, entry in enumerate(left.row_join(right))
    }
    waves = left.row_join(right).atoms(sympy.sin, sympy.cos)
    turning = frozenset(symbol.name for wave in waves for symbol in wave.free_symbols)
    names = tuple(symbol.name for symbol in symbols)
    return Truth(left.rows, names, builder.program(terms, names), turning)


def _truth_of_program(equations: Equations, symbols: Sequence[sympy.Symbol]) -> Truth:
    """The same where the terms are what the program adds up, nothing expanded."""
    mechanism, route = equations.program
    build, unknowns = mechanism.builder, (*mechanism.ud, *route.multipliers)
    rows = [*route.values, *acceleration_forms(mechanism)]
    right = [-entry for entry in remainder(build, rows, unknowns)]
    entries = [
        entry
        for row, side in zip(coefficients(rows, unknowns), right, strict=True)
        for entry in (*row, side)
    ]
    terms = {str(place): _summands(entry) for place, entry in enumerate(entries)}
    names = tuple(symbol.name for symbol in symbols)
    return Truth(len(rows), names, build.program(terms, names), frozenset(angles(mechanism)))


def _summands(node: Node) -> list[Node]:
    """What a node adds up, with its signs."""
    build, found, stack = node.builder, [], [(node, 1)]
    first, second, _ = build.operands
    while stack:
        part, sign = stack.pop()
        code, n = build.operations[part.number], part.number
        if code in (ADD, SUBTRACT):
            stack.append((Node(build, second[n]), -sign if code == SUBTRACT else sign))
            stack.append((Node(build, first[n]), sign))
        elif code == NEGATE:
            stack.append((Node(build, first[n]), -sign))
        else:
            found.append(part if sign == 1 else -part)
    return found


def _rows(entries: Sequence[T], columns: int) -> list[list[T]]:
    return [list(entries[i : i + columns]) for i in range(0, len(entries), columns)]


def _known(found: Enclosed, zeros: Sequence[bool]) -> bool:
    if found.solution is None:
        return _surely_singular(found)
    return all(
        zero or x.is_zero() or x.rel_accuracy_bits() >= ENOUGH
        for x, zero in zip(found.solution, zeros, strict=True)
    )


def _surely_singular(found: Enclosed) -> bool:
    """Whether the determinant is zero without any rounding, or entries are not finite."""
    n = len(found.rows)
    left = [row[:n] for row in found.rows]
    if any(not entry.is_finite() for row in left for entry in row):
        return True
    with precision(found.bits):
        return bool(arb_mat(left).det().is_zero())


def _settled(found: Enclosed, zeros: tuple[bool, ...]) -> Enclosed:
    if found.solution is None or not any(zeros):
        return found
    solution = tuple(arb(0) if zero else x for x, zero in zip(found.solution, zeros, strict=True))
    return Enclosed(
        found.rows, found.sizes, solution, found.spread, found.condition, zeros, found.bits
    )


def _norm(matrix: arb_mat) -> arb:
    n, m = matrix.nrows(), matrix.ncols()
    sums = [sum((abs(matrix[i, j]) for j in range(m)), arb(0)) for i in range(n)]
    largest = sums[0]
    for total in sums[1:]:
        largest = largest.max(total)
    return largest
