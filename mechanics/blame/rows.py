"""Right equations, as people write them: each a combination of the free-body equations.

Kane, Lagrange     sum_k (e_k . v_r) row_k,   v_r = dv/du_r of the body, dw/du_r for its turning
moving point       dH_B/dt + v_B x P - sum tau_B
free body          row_k itself, or summed over an outboard part of the tree along one direction
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

from sympy import Add, Expr, Matrix, S, Symbol

from mechanics.blame.origin import holds
from mechanics.blame.pieces import Kind, Momentum, Origin, Piece, inner, merged, momenta, motions_of
from mechanics.equations import Equations
from mechanics.kinematics.textbook.motion import BodyMotion
from mechanics.routes.balance import Balance, dot, triple
from mechanics.routes.moving_point_terms import candidates
from mechanics.scene import Gravity, Scene
from mechanics.scene.actions import moment
from mechanics.scene.topology import tree


@dataclass(frozen=True)
class Row:
    """A right equation: its pieces sum to zero along every motion.

    Attributes
    ----------
    words : str
        Which one it is.
    pieces : tuple of Piece
    """

    words: str
    pieces: tuple[Piece, ...]

    @property
    def value(self) -> Expr:
        """Sum of the pieces."""
        return Add(*(piece.value for piece in self.pieces))


@lru_cache(maxsize=16)
def generalized_rows(scene: Scene) -> tuple[Row, ...]:
    """Kane's and Lagrange's equation of each speed, with the reactions of constraints in it."""
    found = []
    for u in scene.u:
        weighted = [
            (weight, piece)
            for momentum in momenta(scene)
            if (weight := _partial(momentum, motions_of(scene)[momentum.row.body], u)) != 0
            for piece in momentum.pieces
        ]
        found.append(Row(f"Lagrange's equation of {u.name}", merged(weighted)))
    return tuple(found)


def _partial(momentum: Momentum, motion: BodyMotion, u: Symbol) -> Expr:
    """Partial velocity of the body along the direction of a row."""
    linear = momentum.row.kind == "linear"
    velocity = motion.centre.velocity if linear else motion.angular_velocity
    return inner(velocity.diff(u), momentum.row.direction)


@lru_cache(maxsize=16)
def moving_rows(truth: Equations) -> tuple[tuple[Balance, Row], ...]:
    """Momentum principles of outboard parts of the tree in which no reaction of a joint enters.

    One that the route has no use for may not hold: the moment of a body that cannot turn has a
    reaction in it that nobody declared.
    """
    heavy = {load.name for load in truth.scene.loads if isinstance(load, Gravity)}
    rows = (
        (balance, Row(balance.principle.words, tuple(_balanced(balance, heavy))))
        for balance in candidates(truth.scene)
    )
    return tuple((balance, row) for balance, row in rows if holds(truth, row.value))


def _balanced(balance: Balance, heavy: set[str]) -> Iterator[Piece]:
    """dH_B/dt and v_B x P of each body, less the loads, along the principle's directions."""
    axis, along, centre = balance.principle.axis, balance.principle.along, balance.centre
    turning = axis != Matrix([0, 0, 0])
    about = balance.principle.point.name if turning else ""
    found = []
    for part in balance.parts:
        body, c = part.motion.body, part.motion.centre
        arm, slip = c.position - centre.position, c.velocity - centre.velocity
        turned = body.mass * (triple(axis, arm, c.acceleration) + triple(axis, slip, c.velocity))
        moved = body.mass * triple(axis, centre.velocity, c.velocity)
        found += [
            Piece(Origin(Kind.ANGULAR, body.name, about=about), dot(axis, part.spin_rate) + turned),
            Piece(Origin(Kind.MOVING, body.name, about=about), moved),
            Piece(Origin(Kind.LINEAR, body.name), body.mass * dot(along, c.acceleration)),
        ]
    for load in balance.loads:
        name = "gravity" if load.name in heavy else load.name
        value = dot(axis, moment(load, centre.position)) + dot(along, load.force)
        found.append(Piece(Origin(Kind.LOAD, load.body, name), -value))
    for symbol, factor in balance.coefficients.items():
        found.append(Piece(Origin(Kind.REACTION, "", symbol.name), -factor * symbol))
    yield from merged((S.One, piece) for piece in found)


@lru_cache(maxsize=16)
def free_rows(scene: Scene) -> tuple[Row, ...]:
    """Free-body equations, and linear momentum of outboard parts; reactions stand in them."""
    found = [
        Row(f"{m.row.body}: {m.row.kind} momentum along {m.row.axis}", m.pieces)
        for m in momenta(scene)
    ]
    bodies = tree(scene)
    for name in bodies.order:
        inside = bodies.subtree(name)
        if len(inside) > 1:
            found += _together(scene, inside)
    return tuple(found)


def _together(scene: Scene, inside: tuple[str, ...]) -> Iterator[Row]:
    """Linear momentum of several bodies along each direction that all of them use."""
    own = [m for m in momenta(scene) if m.row.body in inside and m.row.kind == "linear"]
    for axis in dict.fromkeys(m.row.axis for m in own):
        group = [m for m in own if m.row.axis == axis]
        if len(group) == len(inside):
            pieces = merged((S.One, piece) for m in group for piece in m.pieces)
            yield Row(f"{' + '.join(inside)}: linear momentum along {axis}", pieces)
