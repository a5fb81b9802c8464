"""The common form of equations of motion, which every route returns.

    q' = N u + n
    M u' = f + B lambda        rows: any full-rank combination of the equations of motion
    A u' = b                   constraints, differentiated down to u'

B lambda are the reactions that maintain the constraints. A route that solves for dependent speeds
has no lambda, and fewer rows.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

from sympy import Expr, Matrix, Symbol

from mechanics.errors import InputError
from mechanics.kernel.ring import TooLarge
from mechanics.mechanism import Mechanism
from mechanics.program import Program
from mechanics.program.builder import Node
from mechanics.scene import Scene

FEW = 6
"""Unknowns up to which M, f and B are written out even where rows could stand for them."""


@dataclass(frozen=True)
class Line:
    """One line of a derivation: ``left = right``; a `left` that is text is LaTeX."""

    left: str | Expr
    right: Expr
    label: str = ""


@dataclass(frozen=True)
class Step:
    """One step of a derivation, for people: a heading, a sentence, and lines."""

    title: str
    text: str
    lines: tuple[Line, ...]


@dataclass(frozen=True)
class FreeBodyRow:
    """One momentum equation of one isolated body, before any elimination.

        rate = applied + sum_j coefficients[R_j] R_j

    Attributes
    ----------
    body : str
    kind : str
        ``"linear"``, or ``"angular"`` about the mass centre.
    direction : Matrix
        3 x 1 unit vector, inertial components.
    axis : str
        Name of the direction, for people.
    momentum, rate, applied : Expr
        Momentum component, its time derivative, and the loads, in SI units.
    coefficients : tuple of (Symbol, Expr)
        What a unit of each reaction contributes.
    """

    body: str
    kind: str
    direction: Matrix
    axis: str
    momentum: Expr
    rate: Expr
    applied: Expr
    coefficients: tuple[tuple[Symbol, Expr], ...]


@dataclass(frozen=True)
class Matrices:
    """The common form in plain symbols; SI units follow from the rows.

    Attributes
    ----------
    mass : Matrix
        M, r x n.
    forcing : Matrix
        f, r x 1.
    reaction_matrix : Matrix
        B, r x m.
    constraint_matrix, constraint_bias : Matrix
        A, c x n, and b, c x 1, with A u' = b.
    """

    mass: Matrix
    forcing: Matrix
    reaction_matrix: Matrix
    constraint_matrix: Matrix
    constraint_bias: Matrix


@dataclass(frozen=True, eq=False, repr=False)
class Equations:
    """Equations of motion of a scene as one route derived them, in plain symbols.

    Attributes
    ----------
    scene : Scene
    route : str
    write : callable
        Makes the matrices; called when one of them is first read.
    multipliers : tuple of Symbol
        lambda, m of them; empty where the route eliminates them.
    conjugate : bool
        Whether the rows are power-conjugate to u, so that M is symmetric and B = A^T up to the
        naming of the multipliers.
    solve_reactions : callable or None
        Finds the eliminated reactions; called when they are first asked for. None where the route
        has none.
    chosen : tuple of str
        What the route picked, in words: free bodies and moment centres.
    explain : callable
        Makes the steps of the derivation before its result, for people; called when they are first
        asked for.
    fixed : mapping of Symbol to Expr
        Parameters that stand as numbers in these equations, while the scene still names them.
    of_bodies : bool
        Whether these are the scene's own equations, so that forms of forward dynamics may start
        from its bodies; not so where a model was simplified.
    write_rows : callable
        Makes M u' - f - B lambda row by row as it was derived, before it is split into M, f and B,
        where the route has that.
    write_constraints : callable or None
        Makes A and b alone, so that M and f need not be written out for them.
    """

    scene: Scene
    route: str
    write: Callable[[], Matrices]
    multipliers: tuple[Symbol, ...]
    conjugate: bool
    solve_reactions: Callable[[], tuple[tuple[Symbol, Expr], ...]] | None = None
    chosen: tuple[str, ...] = ()
    explain: Callable[[], tuple[Step, ...]] = tuple
    fixed: Mapping[Symbol, Expr] = field(default_factory=dict)
    of_bodies: bool = False
    write_rows: Callable[[], tuple[Expr, ...]] = tuple
    write_constraints: Callable[[], tuple[Matrix, Matrix]] | None = None

    def __repr__(self) -> str:
        return f"<equations of {self.scene.name} by {self.route}: {len(self.scene.u)} speeds>"

    @property
    def tells_reactions(self) -> bool:
        """Whether reactions that the route eliminates can be had."""
        return self.solve_reactions is not None

    @cached_property
    def matrices(self) -> Matrices:
        """M, f, B, A and b."""
        return self.write()

    @property
    def mass(self) -> Matrix:
        """M, r x n."""
        return self.matrices.mass

    @property
    def forcing(self) -> Matrix:
        """f, r x 1."""
        return self.matrices.forcing

    @property
    def reaction_matrix(self) -> Matrix:
        """B, r x m."""
        return self.matrices.reaction_matrix

    @cached_property
    def _constraints(self) -> tuple[Matrix, Matrix]:
        if self.write_constraints is not None:
            return self.write_constraints()
        return self.matrices.constraint_matrix, self.matrices.constraint_bias

    @property
    def constraint_matrix(self) -> Matrix:
        """A, c x n."""
        return self._constraints[0]

    @property
    def constraint_bias(self) -> Matrix:
        """b, c x 1."""
        return self._constraints[1]

    @cached_property
    def rows(self) -> tuple[Expr, ...]:
        """M u' - f - B lambda as it was derived; empty where the route does not have that.

        Where rows are not conjugate, a factor that M, f and B share may stand in a row here.
        """
        return self.write_rows()

    def with_matrices(self, **changed: Matrix) -> "Equations":
        """The same equations with other matrices, which no rows stand for."""
        matrices = replace(self.matrices, **changed)
        return replace(self, write=lambda: matrices, write_rows=tuple, write_constraints=None)

    @cached_property
    def reactions(self) -> tuple[tuple[Symbol, Expr], ...]:
        """Eliminated reactions, linear in u' and lambda, in the order of the elimination."""
        return () if self.solve_reactions is None else self.solve_reactions()

    @cached_property
    def steps(self) -> tuple[Step, ...]:
        """The derivation in steps, in the order in which it is carried out; the result is last."""
        return (*self.explain(), self.result)

    @property
    def result(self) -> Step:
        """M u' = f + B lambda and A u' = b line by line, for people."""
        ud = Matrix(self.scene.ud)
        right = self.forcing
        text = "Terms with accelerations on the left."
        if self.multipliers:
            right = right + self.reaction_matrix * Matrix(self.multipliers)
        rows = zip(self.mass * ud, right, strict=True)
        lines = [Line(left, side) for left, side in rows]
        if self.constraint_matrix.rows:
            text += " Then the constraints, differentiated down to the accelerations."
            held = zip(self.constraint_matrix * ud, self.constraint_bias, strict=True)
            names = [constraint.name for constraint in self.scene.constraints]
            lines += [Line(*sides, name) for sides, name in zip(held, names, strict=True)]
        return Step("Equations of motion", text, tuple(lines))

    @property
    def residual(self) -> Matrix:
        """M u' - f - B lambda, r x 1, in u' and lambda."""
        scene = self.scene
        residual = self.mass * Matrix(scene.ud) - self.forcing
        if self.multipliers:
            residual -= self.reaction_matrix * Matrix(self.multipliers)
        return residual

    @property
    def system(self) -> tuple[Matrix, Matrix]:
        """The square linear system for (u', lambda): ([[M, -B], [A, 0]], [f, b])."""
        left = self.mass.row_join(-self.reaction_matrix) if self.multipliers else self.mass
        rows = self.constraint_matrix.rows
        if rows:
            lower = self.constraint_matrix
            if self.multipliers:
                lower = lower.row_join(Matrix.zeros(rows, len(self.multipliers)))
            left = left.col_join(lower)
        right = self.forcing.col_join(self.constraint_bias) if rows else self.forcing
        return left, right

    @property
    def long(self) -> bool:
        """Whether `rows` stand for M, f and B, which are too long to be written out."""
        return bool(self.rows) and len(self.unknowns) > FEW

    @property
    def readable(self) -> bool:
        """Whether M, f and B can be written out: their normal form is not too large."""
        try:
            _ = self.system
        except TooLarge:
            return False
        return True

    @property
    def unknowns(self) -> tuple[Symbol, ...]:
        """(u', lambda) in the order of `system`."""
        return (*self.scene.ud, *self.multipliers)


@dataclass(frozen=True, eq=False, repr=False)
class ProgramEquations:
    """Equations of motion of a scene that is too large to be written out: rows of a program.

    Attributes
    ----------
    scene : Scene
    route : str
    mechanism : Mechanism
        The scene as nodes.
    values : tuple of Node
        Rows in q, u, u' and the multipliers that vanish along every motion, in their builder.
    multipliers : tuple of Node
    conjugate : bool
        Whether the rows are power-conjugate to u.
    reactions : mapping of str to Node
        Reactions that were eliminated, in q, u, u' and the multipliers.
    """

    scene: Scene
    route: str
    mechanism: Mechanism
    values: tuple[Node, ...]
    multipliers: tuple[Node, ...]
    conjugate: bool
    reactions: Mapping[str, Node]

    def __repr__(self) -> str:
        return (
            f"<equations of {self.scene.name} by {self.route}: {len(self.values)} rows of"
            f" {self.program.count} operations>"
        )

    @property
    def tells_reactions(self) -> bool:
        """Whether reactions can be had: by procedure (i), whatever the route."""
        return bool(self.mechanism.reactions)

    @property
    def program(self) -> Program:
        """The rows as a frozen program with the output ``"rows"``."""
        return self.mechanism.builder.program({"rows": self.values})


def written_out(equations: Equations | ProgramEquations) -> Equations:
    """Equations of whom M and f are expressions.

    Raises
    ------
    InputError
        Where the scene is too large for that.
    """
    if isinstance(equations, ProgramEquations):
        raise InputError(
            f"{equations.scene.name}: its equations of {equations.program.count} operations are too"
            " long to be written out as matrices M and f: call derive(scene, route), which gives"
            " them as a program; every command takes that"
        )
    return equations
