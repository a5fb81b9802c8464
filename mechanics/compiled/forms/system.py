"""What a form of forward dynamics starts from: K x = k, and what tries a solution of it."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import casadi as ca

from mechanics.compiled.forms.factor import Pivots, solve_general, solve_symmetric
from mechanics.compiled.forms.primitive import Primitive, primitive
from mechanics.compiled.forms.trial import (
    Reference,
    chosen_pivots,
    largest_error,
    reference,
    terms,
)
from mechanics.compiled.quantities import Quantities
from mechanics.compiled.terms import Terms
from mechanics.compiled.translate import Translator
from mechanics.equations import FEW, Equations
from mechanics.kinematics.printer import Printer
from mechanics.routes.rows import acceleration_forms


@dataclass(frozen=True, eq=False)
class System:
    """What a form starts from.

    Attributes
    ----------
    equations : Equations
    translate : Translator
    quantities : Quantities
    function : callable
        From graphs, and from the graph of what is put in place of x, to a function of the state.
    from_bodies : callable
        From the name of a form to graphs of x that start from the bodies, shown to be solutions.
    """

    equations: Equations
    translate: Translator
    quantities: Quantities
    function: Callable[..., ca.Function]
    from_bodies: Callable[[str], list[ca.SX]]

    def choose(self, left: ca.SX, right: ca.SX) -> Pivots:
        """The pivots that suit a square matrix and a column."""
        return chosen_pivots(self.function(left, right), self.quantities)

    def error(self, solution: ca.SX) -> float:
        """The largest backward error of a solution at states that are tried, in roundings."""
        return largest_error(self.function(solution), self.terms, self.quantities)

    @cached_property
    def terms(self) -> list[Terms]:
        """Terms of K x - k, row by row."""
        return terms(self.equations, self.quantities)

    def solved_by(self, graph: ca.SX) -> bool:
        """Whether a graph is a solution at states that are drawn: no other may be chosen."""
        return self.reference.solved_by(self.function(graph))

    @cached_property
    def reference(self) -> Reference:
        """K and k in numbers."""
        x = ca.SX.sym("x", len(self.equations.unknowns))
        return reference(self.function(self.residual(x), x=x), x.numel(), self.quantities)

    @property
    def small(self) -> bool:
        """Whether forms are weighed by their errors, too, and not by operations alone."""
        return self.equations.rows is None or len(self.equations.unknowns) <= FEW

    @cached_property
    def graphs(self) -> tuple[ca.SX, ca.SX]:
        """K and k."""
        left, right = self.equations.system
        return self.translate.matrix(left), self.translate.matrix(right)

    def residual(self, x: ca.SX) -> ca.SX:
        """K x - k, by the rows as they were derived: what cancels in K and k has rounded there."""
        equations = self.equations
        if equations.rows is None or (equations.fixed and equations.textbook is not None):
            left, right = self.graphs
            return left @ x - right
        mechanism, route = equations.program
        nodes = (*route.values, *acceleration_forms(mechanism))
        printed = Printer(equations.scene, mechanism)(nodes)
        rows = [row.xreplace(dict(equations.fixed)) for row in printed]
        given = ca.vertcat(*map(self.translate, equations.unknowns))
        return ca.substitute(self.translate.column(rows), given, x)

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
            return solve_symmetric(matrix, rhs, self.translate.exact)
        return solve_general(matrix, rhs, self.pivots, self.translate.exact)

    @cached_property
    def regular(self) -> list[ca.SX]:
        """Graphs of x with pivots that vanish at singular states only, where constraints hold."""
        equations = self.equations
        if equations.rows is None or not equations.scene.constraints:
            return []
        return self.from_bodies("elimination")

    @cached_property
    def primitive(self) -> Primitive:
        """The system without common factors."""
        return primitive(*self.equations.system)


def is_symmetric(equations: Equations) -> bool:
    """Whether K is a symmetric positive definite mass matrix."""
    free = not equations.multipliers and not equations.constraint_matrix.rows
    return equations.conjugate and free
