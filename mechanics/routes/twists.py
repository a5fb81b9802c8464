"""Which momentum principles of a free body hold no reaction.

The reactions that cross the boundary of the free body are wrenches (F_j, tau_j) about a point P. A
twist (v, w) with

    v . F_j + w . tau_j = 0        for every crossing reaction j                        (1)

does no work on any of them, and the principle projected on it holds none of them:

    w = 0          linear momentum along v
    w . v = 0      moment about the point P + w x v / w^2 of the axis of rotation
    otherwise      that moment, plus the pitch v . w / w^2 times the momentum along w (a screw)
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sympy import Expr, Matrix, Mul, S, Symbol, fraction, zeros
from sympy.physics.vector import Point

from mechanics.kinematics.textbook.directions import AXES, Directions
from mechanics.scene import Scene
from mechanics.scene.actions import Action, moment
from mechanics.symbolic import canonical


@dataclass(frozen=True)
class Principle:
    """A momentum principle of a free body.

    Attributes
    ----------
    bodies : tuple of str
        The free body.
    point : Point
    offset : Matrix
        3 x 1; the moment centre is point + offset.
    axis : Matrix
        3 x 1 axis of the moment; zero for linear momentum.
    along : Matrix
        3 x 1 direction of linear momentum (the pitch times the axis for a screw).
    words : str
        The choice, for people.
    """

    bodies: tuple[str, ...]
    point: Point
    offset: Matrix
    axis: Matrix
    along: Matrix
    words: str


def principles(
    scene: Scene,
    bodies: Sequence[str],
    crossing: Mapping[Symbol, Action],
    directions: Directions,
) -> list[Principle]:
    """Every principle of the free body in which no crossing reaction enters, translations first."""
    point = _reference(scene, bodies, crossing)
    about = scene.position(point)
    wrenches = []
    for unit in crossing.values():
        torque = moment(unit, about)
        row = [unit.force[i] for i in directions.translation]
        row += [torque[i] for i in directions.rotation]
        wrenches.append([canonical(entry) for entry in row])
    size = len(directions.translation) + len(directions.rotation)
    found = [
        _principle(scene, tuple(bodies), point, *_twist(vector, directions))
        for vector in null_space(wrenches, size)
    ]
    return sorted(found, key=lambda principle: principle.axis != zeros(3, 1))


def null_space(rows: Sequence[Sequence[Expr]], size: int) -> list[list[Expr]]:
    """Basis of the vectors that every row annihilates, by fraction-free elimination.

    Entries are in the normal form, so that zero means zero.
    """
    work = [list(row) for row in rows]
    pivots: list[tuple[int, int]] = []
    free_rows = list(range(len(work)))
    for _ in range(len(work)):
        choice = _simplest(work, free_rows, [c for _, c in pivots], size)
        if choice is None:
            break
        r, c = choice
        free_rows.remove(r)
        pivots.append((r, c))
        for i, row in enumerate(work):
            if i != r and row[c] != 0:
                head = row[c]
                work[i] = [canonical(work[r][c] * row[k] - head * work[r][k]) for k in range(size)]
    taken = {c: r for r, c in pivots}
    basis = []
    for free in (c for c in range(size) if c not in taken):
        vector = [S.Zero] * size
        vector[free] = S.One
        for c, r in taken.items():
            vector[c] = canonical(-work[r][free] / work[r][c])
        basis.append(vector)
    return basis


def whole(vector: Sequence[Expr]) -> list[Expr]:
    """A multiple of a vector without the divisors of its entries, which vanish at some states."""
    divisors = dict.fromkeys(fraction(entry)[1] for entry in vector)
    scale = Mul(*(divisor for divisor in divisors if not divisor.is_number))
    return [canonical(entry * scale) for entry in vector] if scale != 1 else list(vector)


def _simplest(
    work: Sequence[Sequence[Expr]], rows: Sequence[int], used: Sequence[int], size: int
) -> tuple[int, int] | None:
    """Pivot: a number where there is one; columns in order, so that translations are solved for."""
    candidates = [
        (not work[r][c].is_number, c, r)
        for r in rows
        for c in range(size)
        if c not in used and work[r][c] != 0
    ]
    if not candidates:
        return None
    _, c, r = min(candidates)
    return r, c


def _reference(scene: Scene, bodies: Sequence[str], crossing: Mapping[Symbol, Action]) -> Point:
    """Where the first crossing force acts, or the mass centre of the innermost body."""
    for reaction in scene.reactions:
        if reaction.symbol in crossing and reaction.at is not None:
            return reaction.at
    return scene.body(bodies[0]).centre


def _twist(vector: Sequence[Expr], directions: Directions) -> tuple[Matrix, Matrix]:
    v, w = zeros(3, 1), zeros(3, 1)
    count = len(directions.translation)
    for i, entry in zip(directions.translation, vector[:count], strict=True):
        v[i] = entry
    for i, entry in zip(directions.rotation, vector[count:], strict=True):
        w[i] = entry
    return v, w


def _principle(
    scene: Scene, bodies: tuple[str, ...], point: Point, v: Matrix, w: Matrix
) -> Principle:
    none = zeros(3, 1)
    free = "whole system" if len(bodies) == len(scene.bodies) else " + ".join(bodies)
    if w == none:
        v = Matrix(whole(v))
        words = f"{free}: linear momentum along {_words(scene, v)}"
        return Principle(bodies, point, none, none, v, words)
    square = w.dot(w)
    offset = (w.cross(v) / square).applyfunc(canonical)
    along = (w * (v.dot(w) / square)).applyfunc(canonical)
    where = point.name if offset == none else f"a point of the axis beside {point.name}"
    words = f"{free}: moment about {where}, axis {_words(scene, w)}"
    if along != none:
        words += f", plus pitch times momentum ({_words(scene, along)})"
    return Principle(bodies, point, offset, w, along, words)


def _words(scene: Scene, vector: Matrix) -> str:
    """A direction for people: an axis of the inertial frame where it is one."""
    used = [i for i in range(3) if vector[i] != 0]
    if len(used) == 1 and vector[used[0]] in (1, -1):
        sign = "-" if vector[used[0]] == -1 else ""
        return f"{sign}{scene.frame.name}.{AXES[used[0]]}"
    return "(" + ", ".join(str(entry) for entry in vector) + ")"
