"""The common form of equations of motion, which every route returns.

    q' = N u + n
    M u' = f + B lambda        rows: any full-rank combination of the equations of motion
    A u' = b                   constraints, differentiated down to u'

B lambda are the reactions that maintain the constraints. A route that solves for dependent speeds
has no lambda, and fewer rows. A route derives them as a program; where a person can read them they
are written in SymPy, too.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TypeAlias

from sympy import Expr, Matrix, Symbol

from mechanics.errors import InputError
from mechanics.kinematics.symbolic import Kinematics
from mechanics.mechanism import Mechanism
from mechanics.nearest import plural
from mechanics.program.builder import Node
from mechanics.program.vectors import Vector
from mechanics.scene import Scene

FEW = 6
"""Unknowns up to which forms of forward dynamics are weighed by their errors, too."""


@dataclass(frozen=True)
class Term:
    """A term of a side.

    Attributes
    ----------
    source : str
        The load or reaction that it comes from.
    cancels : bool
        Whether the side has its opposite, too.
    """

    value: Expr
    source: str = ""
    cancels: bool = False


Side: TypeAlias = str | Expr | tuple[Term, ...]
"""LaTeX, in which <<theta_dot>> stands for a symbol of the scene; an expression; terms in order."""


@dataclass(frozen=True)
class Line:
    """One line of a derivation: ``left = right``, or ``left = between = right``.

    `number` is what other lines refer to it by: F3 is the third equation by free bodies.
    """

    left: Side
    right: Side
    label: str = ""
    number: str = ""
    between: str = ""


@dataclass(frozen=True)
class Diagram:
    """Bodies that are cut free together, with the loads and reactions that act on them.

    Attributes
    ----------
    centre : str
        Name of the moment centre, if there is one.
    place : Vector
        Where it is, inertial components, in m.
    """

    bodies: tuple[int, ...]
    title: str
    centre: str = ""
    place: Vector = ()


@dataclass(frozen=True)
class Step:
    """One step of a derivation, for people: a heading, a sentence, drawings, and lines."""

    title: str
    text: str
    lines: tuple[Line, ...]
    diagrams: tuple[Diagram, ...] = ()


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


@dataclass(frozen=True)
class Rows:
    """Equations of motion of one route, as nodes of the mechanism's builder.

    Attributes
    ----------
    route : str
    values : tuple of Node
        Each is zero along every motion; as many as speeds, but for those that the constraints take.
    multipliers : tuple of Node
        Unknown reactions that stay, as inputs.
    conjugate : bool
        Whether the rows are power-conjugate to u: the virtual power of each speed.
    reactions : mapping of str to Node
        Reactions that were eliminated, in q, u, u' and the multipliers.
    chosen : tuple of str
        What the route picked, in words.
    """

    route: str
    values: tuple[Node, ...]
    multipliers: tuple[Node, ...]
    conjugate: bool
    reactions: Mapping[str, Node] = field(default_factory=dict)
    chosen: tuple[str, ...] = ()

    def __repr__(self) -> str:
        return f"<{len(self.values)} rows by {self.route}>"


@dataclass(frozen=True, eq=False, repr=False)
class Equations:
    """Equations of motion of a scene: as one route derived them, or given as matrices.

    Attributes
    ----------
    scene : Scene
    route : str
    multipliers : tuple of Symbol
        lambda, m of them; empty where the route eliminates them.
    conjugate : bool
        Whether the rows are power-conjugate to u, so that M is symmetric and B = A^T up to the
        naming of the multipliers.
    mechanism : Mechanism or None
        The scene as nodes; None where somebody gave matrices.
    rows : Rows or None
        What the route derived, in the builder of the mechanism; None where somebody gave matrices.
    textbook : Matrices or None
        M, f, B, A and b in plain symbols; None for a scene that is too large to be written out.
    reactions : tuple of (Symbol, Expr)
        Eliminated reactions, linear in u' and lambda, in the order of the elimination, where they
        are written out.
    chosen : tuple of str
        What the route picked, in words: free bodies and moment centres.
    fixed : mapping of Symbol to Expr
        Parameters that stand as numbers in the matrices, while scene and program still name them.

    Examples
    --------
    >>> from systems import rod_pendulum
    >>> equations = derive(rod_pendulum.scene(), "kane")
    >>> equations.mass, equations.forcing, equations.unknowns
    (Matrix([[l**2*m/3]]), Matrix([[g*l*m*sin(theta)/2 + u]]), (theta_ddot,))
    >>> equations.residual
    Matrix([[-g*l*m*sin(theta)/2 + l**2*m*theta_ddot/3 - u]])
    >>> equations.system == (equations.mass, equations.forcing)
    True
    >>> equations.reaction_matrix.shape, equations.constraint_matrix.shape
    ((1, 0), (0, 1))
    >>> equations.with_matrices(forcing=0 * equations.forcing).forcing
    Matrix([[0]])
    """

    scene: Scene
    route: str
    multipliers: tuple[Symbol, ...]
    conjugate: bool
    mechanism: Mechanism | None = None
    rows: Rows | None = None
    textbook: Matrices | None = None
    reactions: tuple[tuple[Symbol, Expr], ...] = ()
    chosen: tuple[str, ...] = ()
    fixed: Mapping[Symbol, Expr] = field(default_factory=dict)

    def __repr__(self) -> str:
        count = plural(len(self.scene.u), "speed")
        return f"<equations of {self.scene.name} by {self.route}: {count}>"

    @cached_property
    def kinematics(self) -> Kinematics:
        """How the scene moves, for statements about it."""
        return Kinematics(self.scene, self.mechanism)

    @property
    def matrices(self) -> Matrices:
        """M, f, B, A and b.

        Raises
        ------
        InputError
            Where the scene is too large for that.
        """
        if self.textbook is None:
            raise InputError(
                f"{self.scene.name}: its equations{self._size} are too long to be written out as"
                " matrices M and f: call derive(scene, route), which gives them as a program; every"
                " command takes that"
            )
        return self.textbook

    @property
    def _size(self) -> str:
        if self.rows is None:
            return ""
        mechanism, rows = self.program
        return f" of {mechanism.builder.program({'rows': rows.values}).count} operations"

    @property
    def program(self) -> tuple[Mechanism, Rows]:
        """The scene as nodes, and the rows that the route derived.

        Raises
        ------
        InputError
            Where somebody gave matrices.
        """
        if self.mechanism is None or self.rows is None:
            raise InputError(f"{self!r} were given as matrices: derive them for a program")
        return self.mechanism, self.rows

    @property
    def tells_reactions(self) -> bool:
        """Whether reactions that the route eliminates can be had.

        Of a scene that is not written out by procedure (i), whatever the route.
        """
        return bool(self.reactions if self.textbook is not None else self.scene.reactions)

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

    @property
    def constraint_matrix(self) -> Matrix:
        """A, c x n."""
        return self.matrices.constraint_matrix

    @property
    def constraint_bias(self) -> Matrix:
        """b, c x 1."""
        return self.matrices.constraint_bias

    def with_matrices(self, **changed: Matrix) -> "Equations":
        """The same equations with other matrices, that no program stands for."""
        return replace(self, textbook=replace(self.matrices, **changed), mechanism=None, rows=None)

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
    def unknowns(self) -> tuple[Symbol, ...]:
        """(u', lambda) in the order of `system`."""
        return (*self.scene.ud, *self.multipliers)


def written_out(equations: Equations) -> Equations:
    """Equations of whom M and f are expressions.

    Raises
    ------
    InputError
        Where the scene is too large for that.
    """
    _ = equations.matrices
    return equations
