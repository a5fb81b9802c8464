"""Linear systems of a program written out: straight-line code for printers that have no `solve`.

    symmetric   M = L D L^T with diagonal pivots,                          (1)
                y = L^-1 f,   x = L^-T D^-1 y
    otherwise   Gauss's elimination, rows A_i <- A_i - (a_ik / a_kk) A_k   (2)

Symmetric means positive definite, or bordered by constraints: [[M, A^T], [A, 0]] with M positive
definite and A of full rank. Then no diagonal pivot is 0, if rows with a nought on the diagonal come
last; among the others the one with the fewest neighbours comes first (minimum degree), which
follows a tree from its leaves to its root without fill-in.

Which pivot of (2) is safe is seen at run time only, and straight-line code cannot choose. Safe
without looking: a constant; the only entry of its row or column that is not the constant 0; and, by
Cramer's rule, up to three rows that hold no more columns than they are, as those of a loop do once
the loops are solved that it hangs on. What then remains needs the caller's order of the rows.

Source: Golub and Van Loan, Matrix Computations, 4th edition, sections 3.4 and 4.1; George and Liu,
The evolution of the minimum degree ordering algorithm, SIAM Review 31, 1989.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from mechanics.errors import ExpressionError
from mechanics.program.builder import Builder, Node
from mechanics.program.interpret import Nodes, interpret
from mechanics.program.program import Program

Matrix = list[list[Node]]

CRAMER = 3
"""Up to so many rows, determinants are written out."""


def expand_solves(program: Program, pivots: Mapping[int, Sequence[int]] | None = None) -> Program:
    """The same program, each linear system written out.

    Parameters
    ----------
    pivots : mapping of int to sequence of int, optional
        For a system, by its place in `program.systems`: the row that holds the pivot of each
        column. The caller knows that these pivots are not 0.

    Raises
    ------
    ExpressionError
        If the pivots of a system have to be chosen at run time, or one is the constant 0.
    """
    if not program.systems:
        return program
    builder = Builder()
    given = {name: builder.input(name) for name in program.inputs}
    outputs = interpret(program, _Eliminating(Nodes(builder), dict(pivots or {})), given)
    return builder.program(outputs, program.inputs)


@dataclass
class _Eliminating:
    """Nodes of a builder; systems are counted as they come."""

    nodes: Nodes
    pivots: dict[int, Sequence[int]]
    count: int = field(default=0, init=False)

    @property
    def operations(self) -> Mapping[str, Callable[..., Any]]:
        return self.nodes.operations

    def constant(self, value: Fraction) -> Node:
        return self.nodes.constant(value)

    def pi(self) -> Node:
        return self.nodes.pi()

    def solve(self, matrix: Matrix, right: list[Node], symmetric: bool) -> Sequence[Node]:
        place = self.count
        self.count += 1
        if place in self.pivots:
            return solve_with_rows(matrix, right, self.pivots[place])
        return solve_symmetric(matrix, right) if symmetric else solve_by_structure(matrix, right)


def solve_symmetric(matrix: Sequence[Sequence[Node]], right: Sequence[Node]) -> list[Node]:
    """x of matrix x = right, equation (1).

    Raises
    ------
    ExpressionError
        If a pivot is the constant 0.
    """
    a = [list(row) for row in matrix]
    x = list(right)
    order: list[int] = []
    left = set(range(len(x)))
    bordered = {i for i in left if a[i][i].is_zero}
    factors: dict[tuple[int, int], Node] = {}
    while left:
        k = min(left, key=lambda i: (i in bordered, _degree(a[i], left), i))
        _refuse_zero(a[k][k], len(x))
        left.remove(k)
        order.append(k)
        below = [i for i in sorted(left) if not a[i][k].is_zero]
        for i in below:
            factors[i, k] = a[i][k] / a[k][k]
            x[i] = x[i] - factors[i, k] * x[k]
        for i in below:
            for j in below:
                if j <= i:
                    a[i][j] = a[j][i] = a[i][j] - factors[i, k] * a[j][k]
    for k in order:
        x[k] = x[k] / a[k][k]
    for place, k in reversed(list(enumerate(order))):
        for i in order[place + 1 :]:
            if (i, k) in factors:
                x[k] = x[k] - factors[i, k] * x[i]
    return x


def _degree(row: Sequence[Node], left: set[int]) -> int:
    return sum(not row[j].is_zero for j in left)


def _refuse_zero(pivot: Node, size: int) -> None:
    if pivot.is_zero:
        raise ExpressionError(
            f"a linear system of {size} rows has the pivot 0, whatever the inputs are:"
            " it is singular, or needs another order of its rows"
        )


def solve_with_rows(
    matrix: Sequence[Sequence[Node]], right: Sequence[Node], rows: Sequence[int]
) -> list[Node]:
    """x of matrix x = right, equation (2), the pivot of column k in row `rows[k]`.

    Raises
    ------
    ExpressionError
        If the rows are no order of all rows, or a pivot is the constant 0.
    """
    size = len(right)
    if sorted(rows) != list(range(size)):
        raise ExpressionError(f"pivots {list(rows)}: each of the {size} rows is needed once")
    return solve_with_pivots(matrix, right, [(row, column) for column, row in enumerate(rows)])


def solve_with_pivots(
    matrix: Sequence[Sequence[Node]], right: Sequence[Node], pivots: Sequence[tuple[int, int]]
) -> list[Node]:
    """x of matrix x = right, equation (2), with pivots (row, column) in that order.

    Raises
    ------
    ExpressionError
        If a pivot is the constant 0.
    """
    system = _System(matrix, right)
    for row, column in pivots:
        system.eliminate(row, column)
    return system.back()


def solve_by_structure(matrix: Sequence[Sequence[Node]], right: Sequence[Node]) -> list[Node]:
    """x of matrix x = right, equation (2), with pivots that are safe by structure.

    Raises
    ------
    ExpressionError
        If there is none, or one is the constant 0.
    """
    system = _System(matrix, right)
    while len(system.rows) > 0:
        pivot = system.safe()
        if pivot is not None:
            system.eliminate(*pivot)
        elif (block := system.block()) is not None:
            system.cramer(*block)
        else:
            raise ExpressionError(
                f"a linear system of {len(right)} rows needs pivots that are chosen at run time:"
                " pass an order of its rows, or make it symmetric"
            )
    return system.back()


class _System:
    """Rows and columns that are left, and the pivots of those that are not."""

    def __init__(self, matrix: Sequence[Sequence[Node]], right: Sequence[Node]) -> None:
        self.a = [list(row) for row in matrix]
        self.f = list(right)
        self.rows = list(range(len(right)))
        self.columns = list(range(len(right)))
        self.pivots: list[tuple[int, int]] = []
        self.x: dict[int, Node] = {}

    def safe(self) -> tuple[int, int] | None:
        """The place of a pivot that is not 0 if the matrix is regular."""
        entries = [(i, j) for i in self.rows for j in self.columns if not self.a[i][j].is_zero]
        by_row, by_column = _count(i for i, _ in entries), _count(j for _, j in entries)

        def fill(place: tuple[int, int]) -> tuple[int, int, int]:
            return ((by_row[place[0]] - 1) * (by_column[place[1]] - 1), *place)

        found = [
            (i, j) for i, j in entries
            if by_row[i] == 1 or by_column[j] == 1 or self.a[i][j].constant is not None
        ]  # fmt: skip
        return min(found, key=fill, default=None)

    def eliminate(self, row: int, column: int) -> None:
        """Take a column out of the other rows."""
        a, f = self.a, self.f
        self.rows.remove(row)
        self.columns.remove(column)
        self.pivots.append((row, column))
        for i in self.rows:
            if not a[i][column].is_zero:
                factor = a[i][column] / a[row][column]
                f[i] = f[i] - factor * f[row]
                for j in self.columns:
                    a[i][j] = a[i][j] - factor * a[row][j]

    def block(self) -> tuple[list[int], list[int]] | None:
        """As many rows as columns that they hold, few: a loop after those that it hangs on."""
        held = {i: {j for j in self.columns if not self.a[i][j].is_zero} for i in self.rows}
        for columns in held.values():
            rows = [i for i in self.rows if held[i] <= columns]
            if len(columns) <= CRAMER and len(rows) == len(columns):
                return rows, sorted(columns)
        return (self.rows, self.columns) if len(self.rows) <= CRAMER else None

    def cramer(self, rows: Sequence[int], columns: Sequence[int]) -> None:
        """What a block determines, by determinants: its own is not 0 if the matrix is regular."""
        a, f = self.a, self.f
        matrix = [[a[i][j] for j in columns] for i in rows]
        right = [f[i] for i in rows]
        whole = determinant(matrix)
        _refuse_zero(whole, len(f))
        self.rows = [i for i in self.rows if i not in rows]
        self.columns = [j for j in self.columns if j not in columns]
        for k, column in enumerate(columns):
            exchanged = [
                [*row[:k], side, *row[k + 1 :]] for row, side in zip(matrix, right, strict=True)
            ]
            self.x[column] = determinant(exchanged) / whole
            for i in self.rows:
                if not a[i][column].is_zero:
                    f[i] = f[i] - a[i][column] * self.x[column]
                    a[i][column] = f[i].builder.zero

    def back(self) -> list[Node]:
        """The solution, the last pivot first."""
        for row, column in reversed(self.pivots):
            side = self.f[row]
            for j, value in sorted(self.x.items()):
                side = side - self.a[row][j] * value
            self.x[column] = side / self.a[row][column]
        return [self.x[j] for j in range(len(self.f))]


def _count(places: Any) -> dict[int, int]:
    found: dict[int, int] = {}
    for place in places:
        found[place] = found.get(place, 0) + 1
    return found


def determinant(matrix: Sequence[Sequence[Node]]) -> Node:
    """Expanded along the first row; for a few rows."""
    if len(matrix) == 1:
        return matrix[0][0]
    total = matrix[0][0].builder.zero
    for k, entry in enumerate(matrix[0]):
        if not entry.is_zero:
            minor = determinant([[*row[:k], *row[k + 1 :]] for row in matrix[1:]])
            total = total - entry * minor if k % 2 else total + entry * minor
    return total
