"""A derivation with a mistake in it: rows that sum to zero along a motion that is not the true one.

    sum over pieces (count * piece) = 0        true where every count is one

A statement that vanishes along that motion, for all states, is what the mistake would give.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache

from sympy import Add, Expr, Matrix, Rational, S, Symbol, zeros

from mechanics.blame.derivation import Derivation
from mechanics.blame.pieces import Kind, Piece
from mechanics.equations import Equations, Matrices
from mechanics.scene import Scene
from mechanics.scene.actions import frictions
from mechanics.scene.topology import multipliers
from mechanics.symbolic import collect_linear

Part = tuple[Rational, Piece]
"""How often a piece is counted."""

Rows = tuple[tuple[Part, ...], ...]
Change = Callable[[Piece], Sequence[Part]]
"""What stands in a wrong derivation for a piece of the right one."""


@dataclass(frozen=True)
class Fault:
    """One mistake.

    Attributes
    ----------
    words : str
        ``"gravity reversed"``.
    rows : tuple
        Pieces of each row, which sum to zero with the mistake.
    unknowns : tuple of Symbol
        Accelerations and reactions, as many as rows and `held` constraints.
    held : bool
        Whether the scene's constraints are kept.
    """

    words: str
    rows: Rows
    unknowns: tuple[Symbol, ...]
    held: bool = True


@dataclass(frozen=True)
class Right:
    """The right derivation.

    Attributes
    ----------
    rows : tuple
        Lagrange's equations, or all free-body equations.
    free : bool
        Whether the rows are free-body equations.
    """

    derivation: Derivation
    rows: Rows
    unknowns: tuple[Symbol, ...]
    free: bool

    @property
    def scene(self) -> Scene:
        """The scene."""
        return self.derivation.scene

    def fault(self, words: str, change: Change) -> Iterator[Fault]:
        """The derivation with a mistake in every piece that it concerns; none if there is none."""
        rows = tuple(
            tuple((count * factor, new) for count, piece in row for factor, new in change(piece))
            for row in self.rows
        )
        if rows != self.rows:
            yield Fault(words, rows, self.unknowns)


@lru_cache(maxsize=4096)
def split(expression: Expr, unknowns: tuple[Symbol, ...]) -> tuple[tuple[Expr, ...], Expr]:
    """Factors of the unknowns, and the rest."""
    factors, rest = collect_linear(expression, unknowns)
    return tuple(factors), rest


def right(derivation: Derivation, with_reactions: bool) -> Right:
    """Lagrange's equations, or where reactions are asked for, or friction is, all free bodies."""
    scene = derivation.scene
    if with_reactions or frictions(scene):
        rows = once(momentum.pieces for momentum in derivation.momenta)
        return Right(derivation, rows, derivation.unknowns, True)
    rows = once(_constrained(scene, [row.pieces for row in derivation.generalized_rows]))
    return Right(derivation, rows, (*scene.ud, *multipliers(scene)), False)


def _constrained(scene: Scene, rows: Iterable[Sequence[Piece]]) -> Iterator[list[Piece]]:
    """Rows without the reactions that drop out of them."""
    kept = {symbol.name for symbol in multipliers(scene)}
    for row in rows:
        yield [p for p in row if p.origin.kind is not Kind.REACTION or p.origin.name in kept]


def once(rows: Iterable[Sequence[Piece]]) -> Rows:
    """Every piece counted once."""
    return tuple(tuple((S.One, piece) for piece in row) for row in rows)


def of_load(name: str, factor: Rational) -> Change:
    """Counts the load of that name so often."""

    def change(piece: Piece) -> Sequence[Part]:
        own = piece.origin.kind is Kind.LOAD and piece.origin.name == name
        if not own:
            return ((S.One, piece),)
        return ((factor, piece),) if factor else ()

    return change


def equations(truth: Equations, fault: Fault) -> Equations:
    """The common form of a derivation with a mistake in it."""
    scene = truth.scene
    mass, forcing, reactions = [], [], []
    for row in fault.rows:
        factors, rest = _sum(row, fault.unknowns)
        mass.append(factors[: len(scene.ud)])
        reactions.append([-factor for factor in factors[len(scene.ud) :]])
        forcing.append(-rest)
    kept = fault.unknowns[len(scene.ud) :]
    size = len(scene.ud)
    matrices = Matrices(
        Matrix(mass),
        Matrix(forcing),
        Matrix(reactions) if kept else zeros(len(fault.rows), 0),
        truth.constraint_matrix if fault.held else zeros(0, size),
        truth.constraint_bias if fault.held else zeros(0, 1),
    )
    words = f"with a mistake: {fault.words}"
    return Equations(scene, words, kept, False, textbook=matrices)


def _sum(row: Sequence[Part], unknowns: tuple[Symbol, ...]) -> tuple[list[Expr], Expr]:
    parts = [(count, *split(piece.value, unknowns)) for count, piece in row]
    factors = [Add(*(count * of[i] for count, of, _ in parts)) for i in range(len(unknowns))]
    return factors, Add(*(count * rest for count, _, rest in parts))
