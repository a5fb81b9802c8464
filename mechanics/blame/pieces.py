"""Every momentum equation as a sum of pieces, each with where in the derivation it comes from.

    dp/dt . e - sum F . e - sum R . e = 0        of each isolated body along each direction
    dH_C/dt . e - sum tau_C . e - sum (BC x R) . e = 0

Every right equation of motion is a combination of these, so that its terms come from these pieces.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum
from functools import lru_cache

from sympy import Add, Expr, Matrix, Symbol

from mechanics.equations import FreeBodyRow
from mechanics.kinematics.textbook import differentiate
from mechanics.kinematics.textbook.motion import BodyMotion
from mechanics.routes.free_body_terms import free_body_rows
from mechanics.scene import Gravity, Scene
from mechanics.scene.actions import Action, load_actions, moment, unit_reactions
from mechanics.scene.topology import tree


class Kind(Enum):
    """What a piece is; the value is its name."""

    LINEAR = "rate of linear momentum"
    ANGULAR = "rate of angular momentum"
    MOVING = "v_B x P"
    LOAD = "load"
    REACTION = "reaction"
    CONSTRAINT = "constraint"
    TRANSLATION = "kinetic energy of translation"
    ROTATION = "kinetic energy of rotation"


@dataclass(frozen=True)
class Origin:
    """Where a piece comes from.

    Attributes
    ----------
    kind : Kind
    body : str
        On which the piece acts, or whose momentum it is; empty for a constraint.
    name : str
        Of the load, reaction or constraint.
    about : str
        Of which point, where that is not the mass centre.
    """

    kind: Kind
    body: str
    name: str = ""
    about: str = ""

    @property
    def words(self) -> str:
        """For people: ``"pole: rate of linear momentum"``, ``"load k on carriage"``."""
        if self.kind is Kind.CONSTRAINT:
            return f"constraint {self.name}"
        on = f" on {self.body}" if self.body else ""
        if self.kind is Kind.LOAD:
            return f"{self.name}{on}" if self.name == "gravity" else f"load {self.name}{on}"
        if self.kind is Kind.REACTION:
            return f"reaction {self.name}{on}"
        about = f" about {self.about}" if self.about and self.kind is Kind.ANGULAR else ""
        where = f", B = {self.about}" if self.about and self.kind is Kind.MOVING else ""
        return f"{self.body}: {self.kind.value}{about}{where}"


@dataclass(frozen=True)
class Piece:
    """One addend of an equation whose pieces sum to zero."""

    origin: Origin
    value: Expr


@dataclass(frozen=True)
class Momentum:
    """One momentum equation of one isolated body, piece by piece.

    Attributes
    ----------
    row : FreeBodyRow
    pieces : tuple of Piece
        They sum to zero along every motion.
    """

    row: FreeBodyRow
    pieces: tuple[Piece, ...]


@lru_cache(maxsize=16)
def motions_of(scene: Scene) -> dict[str, BodyMotion]:
    """Motions of the bodies by name."""
    return {motion.body.name: motion for motion in differentiate.body_motions(scene)}


@lru_cache(maxsize=16)
def momenta(scene: Scene) -> tuple[Momentum, ...]:
    """Every free-body equation of a scene in pieces."""
    motions = motions_of(scene)
    actions = [
        (isinstance(load, Gravity), action)
        for load in scene.loads
        for action in load_actions(scene, load)
    ]
    units = [(symbol, unit) for symbol, pair in unit_reactions(scene).items() for unit in pair]
    return tuple(
        Momentum(row, tuple(_pieces(row, motions[row.body], actions, units)))
        for row in free_body_rows(scene, tree(scene), motions)
    )


def _pieces(
    row: FreeBodyRow,
    motion: BodyMotion,
    actions: Iterable[tuple[bool, Action]],
    units: Iterable[tuple[Symbol, Action]],
) -> list[Piece]:
    kind = Kind.LINEAR if row.kind == "linear" else Kind.ANGULAR
    found = [Piece(Origin(kind, row.body), row.rate)]
    for heavy, action in actions:
        if action.body == row.body:
            name = "gravity" if heavy else action.name
            value = -_along(action, motion, row)
            found.append(Piece(Origin(Kind.LOAD, row.body, name), value))
    for symbol, unit in units:
        if unit.body == row.body:
            value = -symbol * _along(unit, motion, row)
            found.append(Piece(Origin(Kind.REACTION, "", symbol.name), value))
    return [piece for piece in found if piece.value != 0]


def _along(action: Action, motion: BodyMotion, row: FreeBodyRow) -> Expr:
    """The component of a force, or of its moment about the mass centre, that a row holds."""
    if row.kind == "linear":
        return inner(action.force, row.direction)
    return inner(moment(action, motion.centre.position), row.direction)


def inner(one: Matrix, two: Matrix) -> Expr:
    """Scalar product without the terms that are zero."""
    return Add(*(x * y for x, y in zip(one, two, strict=True) if x != 0 and y != 0))


def merged(pieces: Iterable[tuple[Expr, Piece]]) -> tuple[Piece, ...]:
    """Weighted pieces, those of one origin added up, in order of their first appearance."""
    sums: dict[Origin, list[Expr]] = {}
    for weight, piece in pieces:
        if weight != 0 and piece.value != 0:
            sums.setdefault(piece.origin, []).append(weight * piece.value)
    return tuple(Piece(origin, Add(*terms)) for origin, terms in sums.items())
