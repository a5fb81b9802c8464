"""Every momentum equation as a sum of pieces, each with where in the derivation it comes from.

    dp/dt . e - sum F . e - sum R . e = 0        of each isolated body along each direction
    dH_C/dt . e - sum tau_C . e - sum (BC x R) . e = 0

Every right equation of motion is a combination of these, so that its terms come from these pieces.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum

from sympy import Add, Expr, Matrix

from mechanics.kinematics.symbolic import Kinematics
from mechanics.mechanism import Mechanism
from mechanics.program.builder import Node
from mechanics.program.derivatives import gradient
from mechanics.program.residues import Residues
from mechanics.routes.free_body import FreeBodyRow, free_body_rows


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
    body : str
    kind : str
        ``"linear"``, or ``"angular"`` about the mass centre.
    axis : str
        Its direction, for people.
    direction : Matrix
        3 x 1 unit vector, inertial components.
    partials : tuple of Expr
        Derivative by each speed of the velocity of the mass centre along the direction, or of the
        angular velocity.
    pieces : tuple of Piece
        They sum to zero along every motion.
    """

    body: str
    kind: str
    axis: str
    direction: Matrix
    partials: tuple[Expr, ...]
    pieces: tuple[Piece, ...]


def momenta(kinematics: Kinematics) -> tuple[Momentum, ...]:
    """Every free-body equation of a scene in pieces, printed from procedure (i)."""
    filter_, _ = kinematics.mechanism.filters
    rows = free_body_rows(kinematics.mechanism, filter_, kinematics.motions)
    return tuple(_momentum(kinematics, filter_, row) for row in rows)


def _momentum(kinematics: Kinematics, filter_: Residues, row: FreeBodyRow) -> Momentum:
    mechanism, build = kinematics.mechanism, kinematics.mechanism.builder
    body = mechanism.bodies[row.body].name
    names = [reaction.name for reaction in mechanism.reactions]
    kind = Kind.LINEAR if row.kind == "linear" else Kind.ANGULAR
    found = [(Origin(kind, body), row.rate)]
    for name, part in row.loads:
        found.append((load_origin(mechanism, name, body), -part))
    units = dict(row.coefficients)
    for name, reaction, part in row.frictions:
        found.append((Origin(Kind.LOAD, body, name), -part * build.input(names[reaction])))
        units[reaction] = units.get(reaction, build.zero) - part
    for reaction, part in units.items():
        value = -part * build.input(names[reaction])
        found.append((Origin(Kind.REACTION, "", names[reaction]), value))
    partials = gradient([row.velocity], [1], mechanism.u)
    return Momentum(
        body,
        row.kind,
        row.axis,
        Matrix(kinematics.printer(row.along)),
        kinematics.printer(partials),
        printed(kinematics, filter_, found),
    )


def load_origin(mechanism: Mechanism, name: str, body: str) -> Origin:
    """Of a load on a body; gravity goes by that name, whatever its field is called."""
    heavy = {field.name for field in mechanism.fields}
    return Origin(Kind.LOAD, body, "gravity" if name in heavy else name)


def printed(
    kinematics: Kinematics, filter_: Residues, parts: Iterable[tuple[Origin, Node]]
) -> tuple[Piece, ...]:
    """Pieces that are not zero, in SymPy."""
    kept = [(origin, filter_.tidy(node)) for origin, node in parts]
    kept = [(origin, node) for origin, node in kept if not node.is_zero]
    values = kinematics.printer([node for _, node in kept])
    return tuple(Piece(origin, value) for (origin, _), value in zip(kept, values, strict=True))


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
