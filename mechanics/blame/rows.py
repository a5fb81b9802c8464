"""Right equations, as people write them: each a combination of the free-body equations.

Kane, Lagrange     sum_k (e_k . v_r) row_k,   v_r = dv/du_r of the body, dw/du_r for its turning
moving point       dH_B/dt + v_B x P - sum tau_B
free body          row_k itself, or summed over an outboard part of the tree along one direction
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from sympy import Add, Expr, S

from mechanics.blame.motion import holds
from mechanics.blame.pieces import (
    Kind,
    Momentum,
    Origin,
    Piece,
    load_origin,
    merged,
    printed,
)
from mechanics.equations import Equations
from mechanics.kinematics.symbolic import Kinematics
from mechanics.program.builder import Node
from mechanics.program.residues import Residues
from mechanics.routes.moving_point import Balance, Candidates, candidates
from mechanics.routes.moving_point_terms import body_terms, load_terms
from mechanics.scene import Scene
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


def generalized_rows(scene: Scene, momenta: Sequence[Momentum]) -> tuple[Row, ...]:
    """Kane's and Lagrange's equation of each speed, with the reactions of constraints in it."""
    rows = []
    for index, u in enumerate(scene.u):
        weighted = ((m.partials[index], piece) for m in momenta for piece in m.pieces)
        rows.append(Row(f"Lagrange's equation of {u.name}", merged(weighted)))
    return tuple(rows)


@dataclass(frozen=True)
class Moment:
    """A momentum principle of an outboard part of the tree.

    Attributes
    ----------
    about : str
        The moment centre, or what it is beside; empty for linear momentum.
    carried : Expr
        BC x m a_B along the axis, a part of the row.
    """

    about: str
    row: Row
    carried: Expr


def moving_rows(truth: Equations) -> tuple[Moment, ...]:
    """Momentum principles of outboard parts of the tree in which no reaction of a joint enters.

    One that the route has no use for may not hold: the moment of a body that cannot turn has a
    reaction in it that nobody declared.
    """
    kinematics = truth.kinematics
    filters = kinematics.mechanism.filters
    principles = candidates(kinematics.mechanism, filters)
    moments = (_balanced(kinematics, filters[0], principles, each) for each in principles.balances)
    return tuple(moment for moment in moments if holds(truth, moment.row.value))


def _balanced(
    kinematics: Kinematics, filter_: Residues, principles: Candidates, balance: Balance
) -> Moment:
    """dH_B/dt and v_B x P of each body, less the loads, along the principle's directions."""
    mechanism, build = kinematics.mechanism, kinematics.mechanism.builder
    about = ""
    if not balance.principle.linear:
        about = mechanism.points[principles.subtrees[balance.principle.root].point].name
    parts: list[tuple[Origin, Node]] = []
    carried = build.zero
    for terms in body_terms(mechanism, principles, balance):
        body = mechanism.bodies[terms.body].name
        carried = carried + terms.carried
        parts += [
            (Origin(Kind.ANGULAR, body, about=about), terms.turning),
            (Origin(Kind.MOVING, body, about=about), terms.moving),
            (Origin(Kind.LINEAR, body), terms.linear),
        ]
    for name, index, value in load_terms(mechanism, principles, balance):
        parts.append((load_origin(mechanism, name, mechanism.bodies[index].name), -value))
    for reaction, factor in balance.coefficients.items():
        name = mechanism.reactions[reaction].name
        parts.append((Origin(Kind.REACTION, "", name), -factor * principles.let_in[reaction]))
    pieces = merged((S.One, piece) for piece in printed(kinematics, filter_, parts))
    return Moment(about, Row(balance.words, pieces), *kinematics.printer([carried]))


def free_rows(scene: Scene, momenta: Sequence[Momentum]) -> tuple[Row, ...]:
    """Free-body equations, and linear momentum of outboard parts; reactions stand in them."""
    rows = [Row(f"{m.body}: {m.kind} momentum along {m.axis}", m.pieces) for m in momenta]
    bodies = tree(scene)
    for name in bodies.order:
        inside = bodies.subtree(name)
        if len(inside) > 1:
            rows += _together(momenta, inside)
    return tuple(rows)


def _together(momenta: Sequence[Momentum], inside: tuple[str, ...]) -> Iterator[Row]:
    """Linear momentum of several bodies along each direction that all of them use."""
    own = [m for m in momenta if m.body in inside and m.kind == "linear"]
    for axis in dict.fromkeys(m.axis for m in own):
        group = [m for m in own if m.axis == axis]
        if len(group) == len(inside):
            pieces = merged((S.One, piece) for m in group for piece in m.pieces)
            yield Row(f"{' + '.join(inside)}: linear momentum along {axis}", pieces)
