"""Masses, first and second moments, and how they are grouped over the joints.

    m = sum dm,    h = sum r dm,    E = sum r r^T dm                                    (1)
    E = tr(I)/2 - I                      about the mass centre, where h = 0             (2)
    o + c in the place of o:    h + m c,    E + c h^T + h c^T + m c c^T                 (3)
    R h,    R E R^T                      in the parent of a frame that is fixed in it   (4)
    e (e . h),    (e . E e) e e^T        in the parent of a frame that turns about e    (5)

(5): mass on the axis of a turn moves in the same way whether it turns or not. What moves over turns
and fixed steps until it rests on the ground has no part in the equations; what is left are fewer
parameters in fewer products: the grouped inertial parameters of Khalil and Kleinfinger, Minimum
operations and minimum parameters of the dynamic models of tree structure robots, IEEE J. Robotics
and Automation 3 (1987), found on the tree itself. (2): Wensing, Kim and Slotine, IEEE Robotics and
Automation Letters 3 (2018).
"""

from dataclasses import dataclass, field

from mechanics.mechanism import Mechanism, inputs_of
from mechanics.program.builder import Node
from mechanics.program.vectors import (
    Matrix,
    Vector,
    add,
    product,
    scale,
    times,
    transpose,
)
from mechanics.recursions.frames import lineage, rigid_steps


@dataclass
class Moments:
    """Moments of the mass of a mechanism, equation (1).

    Attributes
    ----------
    mass : dict
        Of each point that carries some, in kg.
    first : dict
        In each frame, about each point, in kg m.
    second : dict
        In each frame, in kg m^2, about the points of the first moments.
    """

    mass: dict[int, Node] = field(default_factory=dict)
    first: dict[tuple[int, int], Vector] = field(default_factory=dict)
    second: dict[int, Matrix] = field(default_factory=dict)

    def add_mass(self, point: int, mass: Node) -> None:
        """Mass at a point."""
        if not mass.is_zero:
            self.mass[point] = self.mass[point] + mass if point in self.mass else mass

    def add_first(self, frame: int, point: int, first: Vector) -> None:
        """First moment about a point, in a frame; what does not turn has none."""
        if frame != 0 and not _is_zero(first):
            old = self.first.get((frame, point))
            self.first[frame, point] = first if old is None else add(old, first)

    def add_second(self, frame: int, second: Matrix) -> None:
        """Second moment in a frame."""
        if frame != 0 and not all(_is_zero(row) for row in second):
            old = self.second.get(frame)
            if old is not None:
                second = tuple(add(a, b) for a, b in zip(old, second, strict=True))
            self.second[frame] = second


def moments(mechanism: Mechanism) -> Moments:
    """Mass of each body at its centre, and its second moment, equation (2)."""
    found = Moments()
    for body in mechanism.bodies:
        found.add_mass(body.centre, body.mass)
        if body.frame is not None and body.inertia is not None:
            found.add_second(body.frame, second_moment(body.inertia))
    return found


def second_moment(inertia: Matrix) -> Matrix:
    """tr(I)/2 - I, equation (2)."""
    build = inertia[0][0].builder
    if all(
        entry == inertia[0][0] if i == j else entry.is_zero
        for i, row in enumerate(inertia)
        for j, entry in enumerate(row)
    ):
        half = inertia[0][0] / 2
        return tuple(tuple(half if i == j else build.zero for j in range(3)) for i in range(3))
    half = (inertia[0][0] + inertia[1][1] + inertia[2][2]) / 2
    return tuple(
        tuple(half - entry if i == j else -entry for j, entry in enumerate(row))
        for i, row in enumerate(inertia)
    )


def grouped(mechanism: Mechanism) -> Moments:
    """The same motion from fewer parameters, equations (3) to (5).

    Returns
    -------
    Moments
        The rows of Newton and Euler are the same with these and with those of `moments`.
    """
    mechanism = rigid_steps(mechanism)
    found, moving = moments(mechanism), set(mechanism.rates)
    for point in reversed(range(1, len(mechanism.points))):
        place = mechanism.points[point]
        if point not in found.mass or len(place.step) > 1:
            continue
        if any(inputs_of(column) & moving for _, column in place.step):
            continue
        mass = found.mass.pop(point)
        found.add_mass(place.parent, mass)
        for frame, column in place.step:
            found.add_first(frame, place.parent, scale(mass, column))
            found.add_second(frame, outer(scale(mass, column), column))
    for frame in reversed(range(1, len(mechanism.frames))):
        _group(mechanism, found, frame, moving)
    found.mass.pop(0, None)
    return found


def _group(mechanism: Mechanism, found: Moments, frame: int, moving: set[Node]) -> None:
    """Move the moments of one frame towards the root, and to its parent."""
    own = mechanism.frames[frame]
    for point in reversed(range(1, len(mechanism.points))):
        place = mechanism.points[point]
        if (frame, point) not in found.first or [f for f, _ in place.step] not in ([frame], []):
            continue
        if any(inputs_of(column) & moving for _, column in place.step):
            continue
        first = found.first.pop((frame, point))
        found.add_first(frame, place.parent, first)
        for _, column in place.step:
            found.add_second(frame, outer(column, first))
            found.add_second(frame, outer(first, column))
    if not inputs_of([entry for row in own.rotation for entry in row]) & moving:
        for of_frame, point in [key for key in found.first if key[0] == frame]:
            first = found.first.pop((of_frame, point))
            found.add_first(own.parent, point, times(own.rotation, first))
        if frame in found.second:
            second = product(own.rotation, found.second.pop(frame))
            found.add_second(own.parent, product(second, transpose(own.rotation)))
    elif own.turn is not None:
        _over_turn(mechanism, found, frame)


def _over_turn(mechanism: Mechanism, found: Moments, frame: int) -> None:
    """Equation (5)."""
    own, zero = mechanism.frames[frame], mechanism.builder.zero
    assert own.turn is not None
    axis = next(k for k in range(3) if not own.turn.axis[k].is_zero)
    for of_frame, point in [key for key in found.first if key[0] == frame]:
        if _carries(mechanism, frame, point):
            continue  # a slide lies between: the parent frame knows nothing of that point
        first = found.first.pop((of_frame, point))
        along = tuple(entry if k == axis else zero for k, entry in enumerate(first))
        found.add_first(own.parent, point, along)
        across = tuple(zero if k == axis else entry for k, entry in enumerate(first))
        found.add_first(frame, point, across)
    if frame in found.second:
        second = found.second.pop(frame)
        alone = [[zero] * 3 for _ in range(3)]
        rest = [list(row) for row in second]
        alone[axis][axis], rest[axis][axis] = second[axis][axis], zero
        found.add_second(own.parent, tuple(map(tuple, alone)))
        found.add_second(frame, tuple(map(tuple, rest)))


def _carries(mechanism: Mechanism, frame: int, point: int) -> bool:
    """Whether a step on the way to a point is given in the frame or in one that stands on it."""
    while point != 0:
        steps = mechanism.points[point].step
        if any(frame in lineage(mechanism, given) for given, _ in steps):
            return True
        point = mechanism.points[point].parent
    return False


def outer(a: Vector, b: Vector) -> Matrix:
    """a b^T."""
    return tuple(tuple(x * y for y in b) for x in a)


def _is_zero(vector: Vector) -> bool:
    return all(entry.is_zero for entry in vector)


def spin(U: Matrix, omega: Vector, alpha: Vector, E: Matrix) -> Vector:
    """Rate of angular momentum about the point of E, sum r x (U r) dm.

    N_k = (U E)_ji - (U E)_ij,   i, j, k cyclic; the products of omega are in U already.
    """
    found = []
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        across = omega[i] * omega[j]
        if across.is_zero:
            total = alpha[k] * (E[i][i] + E[j][j])
        elif E[i][i] == E[j][j]:
            total = alpha[k] * (E[i][i] * 2)
        elif alpha[k].is_zero:
            total = across * (E[i][i] - E[j][j])
        else:
            total = U[j][i] * E[i][i] - U[i][j] * E[j][j]
        if not E[i][j].is_zero:
            total = total + (U[j][j] - U[i][i]) * E[i][j]
        total = total + U[j][k] * E[i][k] - U[i][k] * E[j][k]
        found.append(total)
    return tuple(found)
