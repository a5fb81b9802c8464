"""Forward dynamics of bodies: the accelerations that make Gauss's function least.

    G = 1/2 sum m |a_C - g|^2 + 1/2 alpha . I alpha + (omega x I omega) . alpha - f . a

    [ Q  -A^T ] [ y  ]   [ f  ]
    [-A   0   ] [ mu ] = [ -b ]          A u' = b where something constrains

y are u' and the accelerations that G is written in. These are eliminated from the leaves to the
root, by which articulated inertias come about, and found again from the root to the leaves: the
articulated-body algorithm (Featherstone, Rigid Body Dynamics Algorithms, 7.3), without the zeros,
and with accelerations in place of joint coordinates wherever one unknown can stand for the other.
Q is positive definite; a multiplier is eliminated when every acceleration that its constraint holds
is gone, so that its pivot -A Q^-1 A^T is less than zero. The rest of the order is by counted
operations.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from mechanics.mechanism import GROUND, Mass, Mechanism
from mechanics.program.builder import Node
from mechanics.program.operations import CONSTANT, DIVIDE, INPUT, MULTIPLY, NEGATE
from mechanics.program.vectors import cross, scale, times
from mechanics.recursions.least_constraint.accelerations import Accelerations
from mechanics.recursions.least_constraint.affine import Affines
from mechanics.recursions.least_constraint.elimination import (
    Rule,
    eliminated,
    free_first,
    outermost,
    values,
)
from mechanics.recursions.least_constraint.gauss import Gauss
from mechanics.recursions.loads import loads


@dataclass(frozen=True)
class Way:
    """How Gauss's function is written and minimised.

    Attributes
    ----------
    rule : Rule
    squared : bool
        Whether squares are kept: see `Gauss`.
    inertial : bool
        Whether accelerations are found again in inertial components: see `Accelerations`.
    """

    rule: Rule
    squared: bool
    inertial: bool


WAYS: tuple[Way, ...] = (
    Way(free_first, squared=True, inertial=False),
    Way(free_first, squared=True, inertial=True),
    Way(outermost, squared=False, inertial=False),
)
"""Which is cheapest, and which rounds best, depends on the bodies."""


def forward_dynamics(
    mechanism: Mechanism,
    way: Way,
    matrix: Sequence[Sequence[Node]] = (),
    bias: Sequence[Node] = (),
) -> tuple[Node, ...]:
    """u' and mu.

    Parameters
    ----------
    mechanism : Mechanism
        Its constraints are left out.
    way : Way
    matrix, bias : m x n and m nodes
        A and b of what constrains.

    Raises
    ------
    SingularError
        If nothing has mass that moves with an acceleration.
    ExpressionError
        If an acceleration is found from itself in this way.
    """
    g = gauss_function(replace(mechanism, constraints=()), way)
    names = [("multiplier", i) for i in range(len(matrix))]
    for name, row, right in zip(names, matrix, bias, strict=True):
        g.add_force(name, -right)
        for symbol, entry in zip(mechanism.ud, row, strict=True):
            g.couple(name, symbol, -entry)
    unknowns = [*names, *mechanism.ud, *g.definitions]
    value = values(g, eliminated(g, unknowns, known_nonzero(mechanism), way.rule, names))
    return tuple(map(value, (*mechanism.ud, *names)))


def gauss_function(mechanism: Mechanism, way: Way) -> Gauss:
    """G of a mechanism, in u' and the accelerations that it takes to write it."""
    g = Gauss(mechanism.builder, way.squared)
    motion = Accelerations(mechanism, g, way.inertial)
    for body in mechanism.bodies:
        if not body.mass.is_zero:
            for entry in motion.acceleration(body.centre):
                g.add_square(body.mass, entry)
        _spin(motion, body)
    forces, couples = loads(mechanism)
    for force in forces:
        if not all(entry.is_zero for entry in force.vector):
            _work(g, motion.acceleration(force.point, force.frame), force.vector)
    for couple in couples:
        for frame, sign in ((couple.on, 1), (couple.by, -1)):
            if frame != GROUND:
                _work(g, motion.alpha(frame, couple.frame), scale(sign, couple.vector))
    return g


def _spin(motion: Accelerations, body: Mass) -> None:
    """Add 1/2 alpha . I alpha + (omega x I omega) . alpha, components in the body."""
    if body.frame is None or body.inertia is None:
        return
    if all(entry.is_zero for row in body.inertia for entry in row):
        return
    alpha, omega = motion.alpha(body.frame), motion.omega(body.frame)
    for i, row in enumerate(body.inertia):
        motion.g.add_square(row[i], alpha[i])
        for j in range(i):
            motion.g.add_product(row[j], alpha[i], alpha[j])
    # The moment of momentum of a multiple of the unit matrix is along omega.
    if not body.scalar:
        _work(motion.g, alpha, scale(-1, cross(omega, times(body.inertia, omega))))


def _work(g: Gauss, acceleration: Affines, force: Sequence[Node]) -> None:
    for entry, component in zip(acceleration, force, strict=True):
        for unknown, coefficient in entry.coefficients.items():
            g.add_force(unknown, coefficient * component)


def known_nonzero(mechanism: Mechanism) -> Callable[[Node], bool]:
    """Whether a node is known not to vanish: products and quotients of what is positive."""
    build = mechanism.builder
    first, second, _ = build.operands

    def nonzero(number: int) -> bool:
        code = build.operations[number]
        if code == CONSTANT:
            return number != build.zero_number
        if code == INPUT:
            return mechanism.signs.get(build.inputs[first[number]]) == "positive"
        if code == NEGATE:
            return nonzero(first[number])
        if code in (MULTIPLY, DIVIDE):
            return nonzero(first[number]) and nonzero(second[number])
        return False

    return lambda node: nonzero(node.number)
