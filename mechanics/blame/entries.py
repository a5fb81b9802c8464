"""Energies, momenta and mass matrices, entry by entry, against what the engine derives.

T = sum (m v . v + w . I w) / 2        V = -sum m g . r + sum k d^2 / 2        M_ij = d2T/du_i du_j
"""

from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache

from sympy import Expr
from sympy.matrices import MatrixBase

from mechanics.blame.groups import COEFFICIENT
from mechanics.blame.pieces import Kind, Origin, motions_of
from mechanics.blame.terms import Monomial, Terms, symbols_in, terms_of, total
from mechanics.blame.terms import written as to_expression
from mechanics.scene import Gravity, Scene
from mechanics.scene import quantities as q
from mechanics.scene.loads import CONSERVATIVE
from mechanics.scene.potential import load_potential
from mechanics.scene.published import Published
from mechanics.scene.rates import speeds_in_rates

Pieces = tuple[tuple[Origin, Expr], ...]
Parts = tuple[tuple[Origin, Terms], ...]
Entry = tuple[str, Expr | None, Terms, Terms, Parts]
"""Group, what it is the coefficient of, what is written, what is right, the pieces of that."""

SIGNS = {q.KineticEnergy: (1, 0), q.PotentialEnergy: (0, 1), q.TotalEnergy: (1, 1),
         q.Lagrangian: (1, -1)}  # fmt: skip
"""How often the kinetic and the potential energy are in each."""


@lru_cache(maxsize=16)
def kinetic_pieces(scene: Scene) -> Pieces:
    """Kinetic energy of each body, of translation and of rotation, in q and u."""
    found = []
    for name, motion in motions_of(scene).bodies.items():
        found.append((Origin(Kind.TRANSLATION, name), motion.translation))
        if motion.turns:
            found.append((Origin(Kind.ROTATION, name), motion.turning))
    return tuple(found)


@lru_cache(maxsize=16)
def potential_pieces(scene: Scene) -> Pieces:
    """Potential energy of each conservative load; of gravity, body by body."""
    found = []
    for load in scene.loads:
        if isinstance(load, Gravity):
            field = scene.vector(load.field, load.name)
            for body in scene.bodies:
                height = -scene.position(body.centre).dot(field)
                found.append((Origin(Kind.LOAD, body.name, "gravity"), body.mass * height))
        elif isinstance(load, CONSERVATIVE):
            found.append((Origin(Kind.LOAD, "", load.name), load_potential(scene, load)))
    return tuple(found)


def entries_of(scene: Scene, row: Published) -> Iterator[Entry]:
    """The entries of an energy, momentum or mass matrix that differ; none for other quantities.

    The scene and the row are in the same symbols, as `folded` gives them.
    """
    if isinstance(row.quantity, q.MassMatrix):
        size = len(scene.u)
        if row.sides[-1].shape == (size, size):
            yield from _matrix(scene, row.sides[-1])
    elif type(row.quantity) in SIGNS:
        for side in row.sides:
            yield from _compared(scene, side, energy_pieces(scene, row), row)
    elif isinstance(row.quantity, q.GeneralizedMomentum):
        for side in row.sides:
            yield from _compared(scene, side, _momentum(scene, row.quantity.coordinate), row)


def energy_pieces(scene: Scene, row: Published) -> Pieces:
    """The derived energy that a row is about, piece by piece."""
    kinetic, potential = SIGNS[type(row.quantity)]
    found = [(origin, kinetic * value) for origin, value in kinetic_pieces(scene) if kinetic]
    found += [(origin, potential * value) for origin, value in potential_pieces(scene) if potential]
    return tuple(found)


def _momentum(scene: Scene, coordinate: str) -> Pieces:
    """dT/dq' of each piece of the kinetic energy; u may be other than q'."""
    qd = next(qd for c, qd in zip(scene.q, scene.qd, strict=True) if c.name == coordinate)
    table = speeds_in_rates(scene)
    return tuple(
        (origin, scene.plain(value.xreplace(table).diff(qd)))
        for origin, value in kinetic_pieces(scene)
    )


def _compared(scene: Scene, side: Expr, pieces: Pieces, row: Published) -> Iterator[Entry]:
    written, *others = terms_of([side, *(value for _, value in pieces)])
    parts = tuple((o, part) for (o, _), part in zip(pieces, others, strict=True))
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


def _matrix(scene: Scene, side: MatrixBase) -> Iterator[Entry]:
    pieces = kinetic_pieces(scene)
    for i, one in enumerate(scene.u):
        for j, two in enumerate(scene.u):
            slopes = tuple((origin, value.diff(one).diff(two)) for origin, value in pieces)
            written, *others = terms_of([side[i, j], *(value for _, value in slopes)])
            parts = tuple((o, part) for (o, _), part in zip(slopes, others, strict=True))
            right = total(part for _, part in parts)
            if written != right:
                yield f"entry ({i + 1}, {j + 1})", None, written, right, parts
