"""What a form of forward dynamics starts from: K x = k, and what tries a solution of it."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import casadi as ca

from mechanics.compiled.forms.factor import Pivots, solve_general, solve_symmetric
from mechanics.compiled.forms.primitive import Primitive, primitive
from mechanics.compiled.translate import Translator
from mechanics.equations import Equations


@dataclass(frozen=True, eq=False)
class System:
    """What a form starts from.

    Attributes
    ----------
    equations : Equations
    translate : Translator
    choose : callable
        From graphs of a square matrix and a column to the pivots that suit them.
    error : callable
        From the graph of a solution to its largest backward error at states that are tried, in
        roundings.
    """

    equations: Equations
    translate: Translator
    choose: Callable[[ca.SX, ca.SX], Pivots]
    error: Callable[[ca.SX], float]

    @cached_property
    def graphs(self) -> tuple[ca.SX, ca.SX]:
        """K and k."""
        left, right = self.equations.system
        return self.translate.matrix(left), self.translate.matrix(right)

    @cached_property
    def symmetric(self) -> bool:
        """Whether K is the mass matrix of conjugate rows."""
        return is_symmetric(self.equations)

    @cached_property
    def pivots(self) -> Pivots:
        """Rows and columns in the order in which they are eliminated."""
        n = self.graphs[0].shape[0]
        if self.symmetric:
            return tuple((i, i) for i in reversed(range(n)))
        return self.choose(*self.graphs)

    def solve(self, rhs: ca.SX) -> ca.SX:
        """K^-1 of any columns, by the form that suits every system."""
        return self.eliminated(self.graphs[0], rhs)

    def eliminated(self, matrix: ca.SX, rhs: ca.SX) -> ca.SX:
        """K^-1 of any columns, where K may be written in another way."""
        if self.symmetric:
            return solve_symmetric(matrix, rhs)
        return solve_general(matrix, rhs, self.pivots)

    @cached_property
    def primitive(self) -> Primitive:
        """The system without common factors."""
        return primitive(*self.equations.system)


def is_symmetric(equations: Equations) -> bool:
    """Whether K is a symmetric positive definite mass matrix."""
    free = not equations.multipliers and not equations.constraint_matrix.rows
    return equations.conjugate and free
