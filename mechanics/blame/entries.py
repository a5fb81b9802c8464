"""Energies and mass matrices, entry by entry, against what the engine derives.

T = sum (m v . v + w . I w) / 2        V = -sum m g . r + sum k d^2 / 2        M_ij = d2T/du_i du_j
"""

from collections.abc import Iterator
from functools import lru_cache

from sympy import Expr, Rational
from sympy.matrices import MatrixBase

from mechanics.blame.pieces import Kind, Origin, motions_of
from mechanics.blame.terms import Monomial, Terms, symbols_in, terms_of, total
from mechanics.kinematics.motion import inertia_matrix
from mechanics.scene import Gravity, Scene
from mechanics.scene import quantities as q
from mechanics.scene.loads import CONSERVATIVE
from mechanics.scene.potential import load_potential
from mechanics.scene.published import Published

Pieces = tuple[tuple[Origin, Expr], ...]
Parts = tuple[tuple[Origin, Terms], ...]
Entry = tuple[str, Terms, Terms, Parts]
"""Group, what is written, what is right, and the pieces of that."""

SIGNS = {q.KineticEnergy: (1, 0), q.PotentialEnergy: (0, 1), q.TotalEnergy: (1, 1),
         q.Lagrangian: (1, -1)}  # fmt: skip
"""How often the kinetic and the potential energy are in each."""


@lru_cache(maxsize=16)
def kinetic_pieces(scene: Scene) -> Pieces:
    """Kinetic energy of each body, of translation and of rotation, in q and u."""
    half, found = Rational(1, 2), []
    for name, motion in motions_of(scene).items():
        velocity = motion.centre.velocity
        found.append(
            (Origin(Kind.TRANSLATION, name), half * motion.body.mass * velocity.dot(velocity))
        )
        if motion.turns:
            omega = motion.angular_velocity
            spin = inertia_matrix(scene, motion.body, motion.rotation) * omega
            found.append((Origin(Kind.ROTATION, name), half * omega.dot(spin)))
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
    """The entries of an energy or mass matrix that differ; none for other quantities.

    The scene and the row are in the same symbols, as `folded` gives them.
    """
    if isinstance(row.quantity, q.MassMatrix):
        yield from _matrix(scene, row.sides[-1])
    elif type(row.quantity) in SIGNS:
        yield from _energy(scene, row)


def energy_pieces(scene: Scene, row: Published) -> Pieces:
    """The derived energy that a row is about, piece by piece."""
    kinetic, potential = SIGNS[type(row.quantity)]
    found = [(origin, kinetic * value) for origin, value in kinetic_pieces(scene) if kinetic]
    found += [(origin, potential * value) for origin, value in potential_pieces(scene) if potential]
    return tuple(found)


def _energy(scene: Scene, row: Published) -> Iterator[Entry]:
    pieces = energy_pieces(scene, row)
    for side in row.sides:
        yield from _compared(scene, side, pieces, row)


def _compared(scene: Scene, side: Expr, pieces: Pieces, row: Published) -> Iterator[Entry]:
    written, *others = terms_of([side, *(value for _, value in pieces)])
    parts = tuple((o, part) for (o, _), part in zip(pieces, others, strict=True))
    constant = not isinstance(row.quantity, q.KineticEnergy)
    moving = {*scene.q, *scene.u, *scene.qd, *scene.input_symbols}
    by_group: dict[str, tuple[Terms, Terms]] = {}
    for index, terms in enumerate((written, total(part for _, part in parts))):
        for monomial, value in terms.items():
            if constant and not symbols_in(monomial) & moving:
                continue
            group = _speeds(scene, monomial)
            by_group.setdefault(group, ({}, {}))[index][monomial] = value
    for group, (left, right) in by_group.items():
        if left != right:
            yield group, left, right, parts


def _speeds(scene: Scene, monomial: Monomial) -> str:
    powers = dict(monomial)
    held = [(s, powers[s]) for s in dict.fromkeys((*scene.u, *scene.qd)) if s in powers]
    if not held:
        return "potential energy"
    words = [s.name if n == 1 else f"{s.name}**{n}" for s, n in held]
    return f"terms with {'*'.join(words)}"


def _matrix(scene: Scene, side: MatrixBase) -> Iterator[Entry]:
    pieces = kinetic_pieces(scene)
    for i, one in enumerate(scene.u):
        for j, two in enumerate(scene.u):
            slopes = tuple((origin, value.diff(one).diff(two)) for origin, value in pieces)
            written, *others = terms_of([side[i, j], *(value for _, value in slopes)])
            parts = tuple((o, part) for (o, _), part in zip(slopes, others, strict=True))
            right = total(part for _, part in parts)
            if written != right:
                yield f"entry ({i + 1}, {j + 1})", written, right, parts
