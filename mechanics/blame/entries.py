"""Energies, momenta and mass matrices, entry by entry, against what the engine derives.

T = sum (m v . v + w . I w) / 2        V = -sum m g . r + sum k d^2 / 2        M_ij = d2T/du_i du_j
"""

from collections.abc import Iterator, Sequence
from fractions import Fraction

from sympy import Expr
from sympy.matrices import MatrixBase

from mechanics.blame.derivation import Derivation
from mechanics.blame.groups import COEFFICIENT
from mechanics.blame.pieces import Origin, Piece
from mechanics.blame.terms import Monomial, Terms, symbols_in, terms_of, total
from mechanics.blame.terms import written as to_expression
from mechanics.scene import Scene
from mechanics.scene import quantities as q
from mechanics.scene.published import Published
from mechanics.scene.rates import speeds_in_rates

Parts = tuple[tuple[Origin, Terms], ...]
Entry = tuple[str, Expr | None, Terms, Terms, Parts]
"""Group, what it is the coefficient of, what is written, what is right, the pieces of that."""

SIGNS = {q.KineticEnergy: (1, 0), q.PotentialEnergy: (0, 1), q.TotalEnergy: (1, 1),
         q.Lagrangian: (1, -1)}  # fmt: skip
"""How often the kinetic and the potential energy are in each."""


def entries_of(derivation: Derivation, row: Published) -> Iterator[Entry]:
    """The entries of an energy, momentum or mass matrix that differ; none for other quantities.

    The derivation and the row are in the same symbols, as `folded` gives them.
    """
    scene = derivation.scene
    if isinstance(row.quantity, q.MassMatrix):
        size = len(scene.u)
        if row.sides[-1].shape == (size, size):
            yield from _matrix(derivation, row.sides[-1])
    elif type(row.quantity) in SIGNS:
        for side in row.sides:
            yield from _compared(scene, side, energy_pieces(derivation, row), row)
    elif isinstance(row.quantity, q.GeneralizedMomentum):
        for side in row.sides:
            yield from _compared(scene, side, _momentum(derivation, row.quantity.coordinate), row)


def energy_pieces(derivation: Derivation, row: Published) -> list[Piece]:
    """The derived energy that a row is about, piece by piece."""
    kinetic, potential = SIGNS[type(row.quantity)]
    pieces = [Piece(p.origin, kinetic * p.value) for p in derivation.kinetic if kinetic]
    pieces += [Piece(p.origin, potential * p.value) for p in derivation.potential if potential]
    return pieces


def _momentum(derivation: Derivation, coordinate: str) -> list[Piece]:
    """dT/dq' of each piece of the kinetic energy; u may be other than q'."""
    scene = derivation.scene
    qd = next(qd for c, qd in zip(scene.q, scene.qd, strict=True) if c.name == coordinate)
    table = speeds_in_rates(scene)
    return [
        Piece(piece.origin, scene.plain(piece.value.xreplace(table).diff(qd)))
        for piece in derivation.kinetic
    ]


def _compared(scene: Scene, side: Expr, pieces: Sequence[Piece], row: Published) -> Iterator[Entry]:
    written, *others = terms_of([side, *(piece.value for piece in pieces)])
    parts = tuple((p.origin, part) for p, part in zip(pieces, others, strict=True))
    constant = SIGNS.get(type(row.quantity), (1, 0))[1] != 0
    sides = _split(scene, written), _split(scene, total(part for _, part in parts))
    for speeds in dict.fromkeys((*sides[0], *sides[1])):
        left, right = (side.get(speeds, {}) for side in sides)
        if constant and not speeds:
            left, right = _moving(scene, left), _moving(scene, right)
        if left != right:
            own = tuple((o, _split(scene, part).get(speeds, {})) for o, part in parts)
            about = to_expression({speeds: Fraction(1)})
            name = f"{COEFFICIENT}{about}" if speeds else "terms without speeds"
            yield name, about if speeds else None, left, right, own


def _split(scene: Scene, terms: Terms) -> dict[Monomial, Terms]:
    """Terms by the product of speeds that they hold, which is left out of them."""
    speeds, found = {*scene.u, *scene.qd}, dict[Monomial, Terms]()
    for monomial, value in terms.items():
        moved = frozenset(pair for pair in monomial if pair[0] in speeds)
        found.setdefault(moved, {})[monomial - moved] = value
    return found


def _moving(scene: Scene, terms: Terms) -> Terms:
    """Terms that are no constants."""
    moving = {*scene.q, *scene.input_symbols}
    return {m: value for m, value in terms.items() if symbols_in(m) & moving}


def _matrix(derivation: Derivation, side: MatrixBase) -> Iterator[Entry]:
    speeds = derivation.scene.u
    for i, one in enumerate(speeds):
        for j, two in enumerate(speeds):
            slopes = [Piece(p.origin, p.value.diff(one).diff(two)) for p in derivation.kinetic]
            written, *others = terms_of([side[i, j], *(piece.value for piece in slopes)])
            parts = tuple((p.origin, part) for p, part in zip(slopes, others, strict=True))
            right = total(part for _, part in parts)
            if written != right:
                yield f"entry ({i + 1}, {j + 1})", None, written, right, parts
