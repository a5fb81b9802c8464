"""The derivation of the truth, piece by piece.

row_k = sum of pieces = 0        every right equation of motion is a combination of such rows
T = sum of T_b                   V = sum of V_load
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from sympy import Expr, S, Symbol

from mechanics.blame.groups import COEFFICIENT, Meanings, meanings
from mechanics.blame.pieces import Kind, Momentum, Origin, Piece, momenta
from mechanics.blame.rows import Moment, Row, free_rows, generalized_rows, moving_rows
from mechanics.blame.terms import terms_of, written
from mechanics.equations import Equations
from mechanics.kinematics.symbolic import BodyMotion
from mechanics.scene import Gravity, Scene
from mechanics.scene.loads import CONSERVATIVE
from mechanics.scene.potential import load_potential
from mechanics.symbolic import collect_linear


@dataclass(frozen=True, eq=False, repr=False)
class Derivation:
    """What derived equations are made of; each piece is derived once, when it is first asked for.

    Attributes
    ----------
    truth : Equations
        With reactions.
    """

    truth: Equations

    @property
    def scene(self) -> Scene:
        """The scene."""
        return self.truth.scene

    @property
    def bodies(self) -> Mapping[str, BodyMotion]:
        """How the bodies move."""
        return self.truth.kinematics.bodies

    @cached_property
    def meanings(self) -> Meanings:
        """What the symbols of the scene mean in a term."""
        return meanings(self.scene)

    @cached_property
    def momenta(self) -> tuple[Momentum, ...]:
        """Every free-body equation."""
        return momenta(self.truth.kinematics)

    @cached_property
    def generalized_rows(self) -> tuple[Row, ...]:
        """Kane's and Lagrange's equation of each speed."""
        return generalized_rows(self.scene, self.momenta)

    @cached_property
    def moving_rows(self) -> tuple[Moment, ...]:
        """Momentum principles of outboard parts without reactions of joints."""
        return moving_rows(self.truth)

    @cached_property
    def free_rows(self) -> tuple[Row, ...]:
        """Free-body equations, and linear momentum of outboard parts."""
        return free_rows(self.scene, self.momenta)

    @cached_property
    def kinetic(self) -> tuple[Piece, ...]:
        """Kinetic energy of each body, of translation and of rotation, in q and u, in J."""
        pieces = []
        for name, motion in self.bodies.items():
            pieces.append(Piece(Origin(Kind.TRANSLATION, name), motion.translation))
            if motion.turns:
                pieces.append(Piece(Origin(Kind.ROTATION, name), motion.turning))
        return tuple(pieces)

    @cached_property
    def potential(self) -> tuple[Piece, ...]:
        """Potential energy of each conservative load, in J; of gravity, body by body."""
        scene, pieces = self.scene, []
        for load in scene.loads:
            if isinstance(load, Gravity):
                field = scene.vector(load.field, load.name)
                for body in scene.bodies:
                    height = -scene.position(body.centre).dot(field)
                    origin = Origin(Kind.LOAD, body.name, "gravity")
                    pieces.append(Piece(origin, body.mass * height))
            elif isinstance(load, CONSERVATIVE):
                origin = Origin(Kind.LOAD, "", load.name)
                pieces.append(Piece(origin, load_potential(scene, load)))
        return tuple(pieces)

    @property
    def unknowns(self) -> tuple[Symbol, ...]:
        """Accelerations and reactions."""
        return (*self.scene.ud, *(reaction.symbol for reaction in self.scene.reactions))

    @cached_property
    def _independent(self) -> tuple[tuple[Piece, ...], ...]:
        """Free-body equations piece by piece, and the constraints, differentiated down to u'."""
        truth, scene = self.truth, self.scene
        rows = [momentum.pieces for momentum in self.momenta]
        for index, constraint in enumerate(scene.constraints):
            ud = zip(truth.constraint_matrix[index, :], scene.ud, strict=True)
            value = sum((c * s for c, s in ud), S.Zero) - truth.constraint_bias[index]
            rows.append((Piece(Origin(Kind.CONSTRAINT, "", constraint.name), value),))
        return tuple(rows)

    @cached_property
    def basis(self) -> tuple[tuple[Expr, ...], ...]:
        """Factors of the unknowns in each free-body equation and constraint."""
        return tuple(
            tuple(collect_linear(sum((p.value for p in pieces), S.Zero), self.unknowns)[0])
            for pieces in self._independent
        )

    @cached_property
    def parts(self) -> Mapping[tuple[str, str], tuple[tuple[int, Expr], ...]]:
        """For each group and origin: which of these equations holds what of it."""
        symbols = {f"{COEFFICIENT}{symbol.name}": symbol for symbol in self.scene.ud}
        parts: dict[tuple[str, str], list[tuple[int, Expr]]] = {}
        for index, pieces in enumerate(self._independent):
            terms = terms_of([piece.value for piece in pieces])
            for piece, part in zip(pieces, terms, strict=True):
                for group, own in self.meanings.grouped(part).items():
                    value = written(own)
                    if group.startswith(COEFFICIENT):
                        value *= symbols[group]
                    parts.setdefault((group, piece.origin.words), []).append((index, value))
        return {key: tuple(held) for key, held in parts.items()}
