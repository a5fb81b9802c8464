"""Saddle-point systems written out: constraints with a pivot that is not 0 go first.

    [[M, A^T], [A, 0]] (x, y) = (f, b)                                                   (1)

An entry c = A_ij that is not 0 wherever the system is asked for, a number or a radius, makes

    [[m, c], [c, 0]],     g = A_i / c,     S = K - k_j g^T - g (k_j - m g)^T              (2)

a pivot of two rows and columns, m = M_jj, k_j the column of M: x_j is put out of the constraint,
and M stays positive definite where it was (S = Z^T M Z on the rest, Z spans the null space of the
row). Of several, the pair goes first that fills the fewest entries. What is left is eliminated M
first, `mechanics.program.elimination`.

Source: Benzi, Golub and Liesen, Numerical solution of saddle point problems, Acta Numerica 14,
2005, sections 3.3 and 6.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from mechanics.program.builder import Node
from mechanics.program.elimination import solve_symmetric

Row = dict[int, Node]


@dataclass(frozen=True)
class _Pair:
    """A pivot (2): unknown and constraint, c, m, g, k_j, and their right sides."""

    unknown: int
    constraint: int
    pivot: Node
    diagonal: Node
    factors: Row
    column: Row
    right: Node
    fixed: Node


def solve_saddle_point(
    matrix: Sequence[Sequence[Node]],
    constraints: Sequence[Sequence[Node]],
    right: Sequence[Node],
    nonzero: Callable[[Node], bool],
) -> list[Node]:
    """(x, y) of equation (1).

    Parameters
    ----------
    matrix : n x n
        M, positive definite.
    constraints : c x n
        A, of full rank.
    right : n + c
    nonzero : callable
        Whether an entry is known not to be 0.

    Raises
    ------
    ExpressionError
        If a pivot is the constant 0.
    """
    system = _System(matrix, constraints, right)
    pairs = []
    while (place := system.pair(nonzero)) is not None:
        pairs.append(system.eliminate(*place))
    rest = sorted(system.left)
    found = solve_symmetric(
        [[system.entry(p, q) for q in rest] for p in rest], [system.right[p] for p in rest]
    )
    z = dict(zip(rest, found, strict=True))
    for pair in reversed(pairs):
        x = pair.fixed
        for q, factor in pair.factors.items():
            x = x - factor * z[q]
        force = pair.right - pair.diagonal * x
        for q, entry in pair.column.items():
            force = force - entry * z[q]
        z[pair.unknown], z[pair.constraint] = x, force / pair.pivot
    return [z[i] for i in range(len(right))]


class _System:
    """Rows and columns that are left; entries that are not kept are 0."""

    def __init__(
        self,
        matrix: Sequence[Sequence[Node]],
        constraints: Sequence[Sequence[Node]],
        right: Sequence[Node],
    ) -> None:
        self.size = len(matrix)
        self.right = list(right)
        self.left = set(range(len(right)))
        self.zero = right[0].builder.zero
        self.rows: list[Row] = [{} for _ in right]
        for p, row in enumerate([*matrix, *constraints]):
            for q, entry in enumerate(row):
                self.put(p, q, entry)

    def entry(self, p: int, q: int) -> Node:
        return self.rows[p].get(q, self.zero)

    def put(self, p: int, q: int, entry: Node) -> None:
        for one, other in ((p, q), (q, p)):
            if entry.is_zero:
                self.rows[one].pop(other, None)
            else:
                self.rows[one][other] = entry

    def pair(self, nonzero: Callable[[Node], bool]) -> tuple[int, int] | None:
        """The constraint and the unknown that fill the fewest entries."""

        def fill(place: tuple[int, int]) -> tuple[int, int, int]:
            i, j = place
            held, beside = len(self.rows[i].keys() - {j}), len(self.rows[j].keys() - {i, j})
            return (held * (held + beside), i, j)

        places = [
            (i, j)
            for i in self.left
            if i >= self.size
            for j, entry in self.rows[i].items()
            if j < self.size and nonzero(entry)
        ]
        return min(places, key=fill, default=None)

    def eliminate(self, i: int, j: int) -> _Pair:
        """Equation (2)."""
        pivot, diagonal = self.entry(i, j), self.entry(j, j)
        self.left -= {i, j}
        column = {q: e for q, e in sorted(self.rows[j].items()) if q in self.left}
        factors = {q: e / pivot for q, e in sorted(self.rows[i].items()) if q in self.left}
        for other in self.left:
            self.rows[other].pop(i, None)
            self.rows[other].pop(j, None)
        fixed = self.right[i] / pivot
        pair = _Pair(j, i, pivot, diagonal, factors, column, self.right[j], fixed)
        moved = self.right[j] - diagonal * fixed
        shifted = {
            q: column.get(q, self.zero) - diagonal * factors.get(q, self.zero)
            for q in sorted({*column, *factors})
        }
        for p in shifted:
            if p in column:
                self.right[p] = self.right[p] - column[p] * fixed
            if p in factors:
                self.right[p] = self.right[p] - factors[p] * moved
            for q in shifted:
                if q < p:
                    continue
                entry = self.entry(p, q)
                if p in column and q in factors:
                    entry = entry - column[p] * factors[q]
                if p in factors:
                    entry = entry - factors[p] * shifted[q]
                self.put(p, q, entry)
        return pair
