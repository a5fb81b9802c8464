"""Accelerations and multipliers of rows with constraints, by one linear system.

    [[M, -B], [A, 0]] (u', lambda) = (f, b)                              (1)
    [[M, A^T], [A, 0]] (u', -mu) = (f, b),      B lambda = A^T mu        (2)

Rows that are power-conjugate to u have a symmetric M, and (2) is eliminated without a look at its
pivots, M first: none is 0 where M is regular and A of full rank. Where a reaction that maintains a
constraint is conjugate to it, its lambda is mu or -mu; else A B lambda = A A^T mu. Other rows, an M
that is singular by itself, and reactions that maintain a constraint only where it holds, take (1)
in an order of pivots that is tried at drawn states.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from sympy import Expr

from mechanics.compiled.forms.order import Order, pivot_order
from mechanics.compiled.quantities import STATE, Quantities
from mechanics.compiled.sampling import sample
from mechanics.mechanism import Mechanism
from mechanics.program import Program
from mechanics.program.builder import Builder, Node
from mechanics.program.elimination import solve_with_pivots
from mechanics.program.interpret import include, interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.program.residues import Residues
from mechanics.program.sympy_reader import read
from mechanics.program.vectors import dot, transpose
from mechanics.routes.rows import acceleration_forms, coefficients, remainder

Matrix = Sequence[Sequence[Node]]
Choose = Callable[[Matrix, Sequence[Node]], Order]
"""From a square matrix and a column to the order of pivots (row, column)."""

TRIALS = 64
SEED = 2
DECADES = 1.0
"""Sizes at which pivots are tried: from a tenth to ten."""


@dataclass(frozen=True, eq=False)
class Bordered:
    """Equation (1), as nodes.

    Attributes
    ----------
    mass : n x n
    forcing : n
    reaction_matrix : n x c
        B.
    constraint_matrix : c x n
        A.
    constraint_bias : c
        b.
    conjugate : bool
        Whether the rows are power-conjugate to u.
    choose : callable
    fixed : mapping of str to Expr
        Values of parameters.
    """

    mechanism: Mechanism
    mass: Matrix
    forcing: Sequence[Node]
    reaction_matrix: Matrix
    constraint_matrix: Matrix
    constraint_bias: Sequence[Node]
    conjugate: bool
    choose: Choose
    fixed: Mapping[str, Expr]

    @property
    def solution(self) -> tuple[Node, ...]:
        """(u', lambda)."""
        return self.solve([*self.forcing, *self.constraint_bias])

    def solve(self, right: Sequence[Node]) -> tuple[Node, ...]:
        """(u', lambda) for another right side."""
        if not self.symmetric:
            return tuple(solve_with_pivots(self._general, right, self._pivots))
        n, a = len(self.mass), self.constraint_matrix
        build = self.mechanism.builder
        zero = [build.zero] * len(a)
        upper = [(*row, *column) for row, column in zip(self.mass, self._columns, strict=True)]
        x = build.solve([*upper, *((*row, *zero) for row in a)], right, symmetric=True)
        return (*x[:n], *self.multipliers([-entry for entry in x[n:]]))

    @property
    def determined(self) -> bool:
        """Whether there are as many equations as unknowns, or (2) has multipliers of its own."""
        return self.symmetric or len(self.reaction_matrix[0]) == len(self.constraint_matrix)

    @cached_property
    def _columns(self) -> Matrix:
        """A^T, one row for each speed."""
        if not self.constraint_matrix:
            return [()] * len(self.mass)
        return transpose(self.constraint_matrix)

    @cached_property
    def symmetric(self) -> bool:
        """Whether equation (2) serves: M is regular by itself, and B lambda some A^T mu."""
        n, c = len(self.mass), len(self.constraint_matrix)
        if not self.conjugate or self._rank(self.mass) < n:
            return False
        if self._own is not None:
            return True
        return self._rank([*self.constraint_matrix, *transpose(self.reaction_matrix)]) == c

    def _rank(self, matrix: Matrix) -> int:
        """At the fixed values, at a point of a field, the constraints left out."""
        n, flat = len(matrix[0]), [entry for row in matrix for entry in row]
        build, found = bind(self.mechanism.builder.program({"entries": flat}), self.fixed)
        rows = [found["entries"][n * i : n * (i + 1)] for i in range(len(matrix))]
        return Residues(build).rank(rows)

    @property
    def _general(self) -> Matrix:
        """[[M, -B], [A, 0]]."""
        zero = [self.mechanism.builder.zero] * len(self.constraint_matrix)
        pairs = zip(self.mass, self.reaction_matrix, strict=True)
        upper = [(*row, *(-entry for entry in held)) for row, held in pairs]
        return [*upper, *((*row, *zero) for row in self.constraint_matrix)]

    @cached_property
    def _pivots(self) -> Order:
        return self.choose(self._general, [*self.forcing, *self.constraint_bias])

    def multipliers(self, mu: Sequence[Node]) -> list[Node]:
        """lambda of B lambda = A^T mu."""
        own = self._own
        if own is not None:
            return [mu[i] if sign == 1 else -mu[i] for i, sign in own]
        a, b = self.constraint_matrix, transpose(self.reaction_matrix)
        matrix = [[dot(row, column) for column in b] for row in a]
        right = [dot(row, [dot(column, mu) for column in self._columns]) for row in a]
        return solve_with_pivots(matrix, right, self.choose(matrix, right))

    @cached_property
    def _own(self) -> list[tuple[int, int]] | None:
        """The constraint and the sign of each multiplier that is conjugate to one; None else."""
        anywhere, _ = self.mechanism.filters
        places = {tuple(anywhere.values(row)): i for i, row in enumerate(self.constraint_matrix)}
        found = []
        for column in transpose(self.reaction_matrix):
            values = anywhere.values(column)
            opposite = tuple(-value % anywhere.prime for value in values)
            for signed, sign in ((tuple(values), 1), (opposite, -1)):
                if signed in places:
                    found.append((places[signed], sign))
                    break
            else:
                return None
        return found


def bordered(
    mechanism: Mechanism,
    rows: Sequence[Node],
    multipliers: Sequence[Node],
    conjugate: bool,
    choose: Choose,
    fixed: Mapping[str, Expr],
) -> Bordered:
    """The system of rows that are linear in u' and lambda, and the constraints of the mechanism."""
    build, ud = mechanism.builder, mechanism.ud
    unknowns = (*ud, *multipliers)
    matrix, closing = coefficients(rows, unknowns), acceleration_forms(mechanism)
    rests = remainder(build, [*rows, *closing], unknowns)
    n = len(ud)
    return Bordered(
        mechanism,
        mass=[row[:n] for row in matrix],
        forcing=[-entry for entry in rests[: len(rows)]],
        reaction_matrix=[[-entry for entry in row[n:]] for row in matrix],
        constraint_matrix=coefficients(closing, ud),
        constraint_bias=[-entry for entry in rests[len(rows) :]],
        conjugate=conjugate,
        choose=choose,
        fixed=fixed,
    )


def tried_pivots(quantities: Quantities, fixed: Mapping[str, Expr]) -> Choose:
    """What chooses pivots at drawn states of a model, some parameters being numbers."""
    drawn = sample(quantities, TRIALS, SEED, DECADES)
    columns = {
        entry.name: values
        for name, group in zip(STATE, drawn.groups, strict=True)
        for entry, values in zip(getattr(quantities, name), group.T, strict=True)
    }

    def choose(matrix: Matrix, right: Sequence[Node]) -> Order:
        n = len(right)
        whole = right[0].builder.program({"K": [e for row in matrix for e in row], "k": right})
        program = whole
        if fixed:
            build, nodes = bind(whole, fixed)
            program = build.program(nodes)
        inputs = {name: columns[name] for name in program.inputs}
        with np.errstate(all="ignore"):
            found = interpret(program, Arrays(), inputs)
        left, column = (
            np.array([np.broadcast_to(entry, TRIALS) for entry in found[name]]).T
            for name in ("K", "k")
        )
        # Where an entry has no value, no order of pivots gives one.
        defined = np.isfinite(left).all(axis=1) & np.isfinite(column).all(axis=1)
        if defined.any():
            left, column = left[defined], column[defined]
        return pivot_order(left.reshape(-1, n, n).copy(), column.copy())

    return choose


def bind(
    program: Program, numbers: Mapping[str, Expr]
) -> tuple[Builder, dict[str, tuple[Node, ...]]]:
    """A program with numbers in place of inputs, in a builder of its own.

    Raises
    ------
    ExpressionError
        If something is divided by zero.
    """
    build = Builder()
    nodes = dict(zip(numbers, read(build, tuple(numbers.values())), strict=True))
    given = {name: node for name, node in nodes.items() if name in program.inputs}
    return build, include(build, program, given)
