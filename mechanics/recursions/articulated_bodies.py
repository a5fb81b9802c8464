"""Forward dynamics by articulated bodies, and its derivatives.

A link and what it carries, joints free to move, answers motion of its root as one body would:

    N = A alpha + B a + n,    F = B^T alpha + C a + f                                   (1)

Its joint takes  D u' = tau - e . (n or f) - U . (alpha, a), U the column of (1) along e. It leaves

    A - U_N U_N^T / D,    B - U_N U_F^T / D,    C - U_F U_F^T / D                       (2)

which moves to the parent's root at -c:  N + c x F,  a = a_parent + alpha_parent x c. Each D is a
Schur complement of the mass matrix, positive where masses and inertias are; the division records it
as an obligation. Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 7.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from mechanics.mechanism import GROUND, Mechanism
from mechanics.program.builder import Node
from mechanics.program.vectors import (
    Matrix,
    Vector,
    add,
    cross,
    dot,
    product,
    scale,
    times,
    transpose,
    zeros,
)
from mechanics.recursions.composite_bodies import inertia
from mechanics.recursions.frames import express, negated
from mechanics.recursions.joints import Link, rotated

Motion = tuple[Vector, Vector]
"""An angular and a linear acceleration, or a couple and a force."""


@dataclass(frozen=True)
class Step:
    """U_N, U_F and 1/D of a joint, and the blocks (2) that it leaves."""

    turning: Vector
    sliding: Vector
    inverse: Node
    left: tuple[Matrix, Matrix, Matrix]


class Articulated:
    """The articulated bodies of a tree at q, and solutions of its equations."""

    def __init__(self, mechanism: Mechanism, links: Sequence[Link]) -> None:
        self.mechanism, self.links = mechanism, links
        self.none = zeros(mechanism.builder)
        self.homes = self.home()
        self.axes = [self.to_home(k, link.axis) for k, link in enumerate(links)]
        self.firsts = [self.to_home(k, link.first) for k, link in enumerate(links)]
        self.inertias = [
            rotated(mechanism, inertia(link.second), link.frame, home)
            for link, home in zip(links, self.homes, strict=True)
        ]
        self.steps = self.factorize()

    def home(self) -> list[int]:
        """Frame of the components of each link: its own, or the ground's for angles from there."""
        lone = {link.parent for link in self.links if not link.carried}
        homes: list[int] = []
        for k, link in enumerate(self.links):
            outer = 0 if link.parent == GROUND else homes[link.parent]
            if not link.turning:
                homes.append(outer)
            elif not link.carried or (k in lone and outer == 0):
                homes.append(0)
            else:
                homes.append(link.frame)
        return homes

    def to_home(self, k: int, vector: Vector) -> Vector:
        """Components of a vector of link k in its home."""
        return express(self.mechanism, vector, self.links[k].frame, self.homes[k])

    def arm(self, k: int) -> Vector:
        """Offset of a root from that of the parent, in the parent's home."""
        link = self.links[k]
        if link.parent == GROUND:
            return link.offset
        return self.to_home(link.parent, link.offset)

    def outwards(self, k: int, motion: Motion) -> Motion:
        """Motion of the root of a link where its own joint is at rest, from that of its parent."""
        link, outer = self.links[k], self.outer(k)
        alpha, a = motion
        a = express(self.mechanism, add(a, cross(alpha, self.arm(k))), outer, self.homes[k])
        carried = express(self.mechanism, alpha, outer, self.homes[k])
        return (carried if link.carried else self.none), a

    def inwards(self, k: int, load: Motion) -> Motion:
        """Couple and force of a link on its parent, about the parent's root."""
        link, outer = self.links[k], self.outer(k)
        couple, force = load
        force = express(self.mechanism, force, self.homes[k], outer)
        moment = cross(self.arm(k), force)
        if link.carried:
            moment = add(express(self.mechanism, couple, self.homes[k], outer), moment)
        return moment, force

    def outer(self, k: int) -> int:
        """Home of the parent."""
        parent = self.links[k].parent
        return 0 if parent == GROUND else self.homes[parent]

    def factorize(self) -> list[Step]:
        """Equations (1) and (2), from the leaves to the root."""
        blocks: list[tuple[Matrix, Matrix, Matrix]] = []
        zero = self.mechanism.builder.zero
        for k, link in enumerate(self.links):
            mass = tuple(tuple(link.mass if i == j else zero for j in range(3)) for i in range(3))
            blocks.append((self.inertias[k], skew(self.firsts[k]), mass))
        steps: list[Step] = []
        for k in reversed(range(len(self.links))):
            link, e, (A, B, C) = self.links[k], self.axes[k], blocks[k]
            if link.turning:
                couple, force = times(A, e), times(transpose(B), e)
                pivot = dot(e, couple)
            else:
                couple, force = times(B, e), times(C, e)
                pivot = dot(e, force)
            inverse = 1 / pivot
            left = (
                symmetric(less(A, couple, couple, inverse)),
                less(B, couple, force, inverse),
                symmetric(less(C, force, force, inverse)),
            )
            steps.append(Step(couple, force, inverse, left))
            if link.parent != GROUND:
                moved = self.shifted(k, left)
                pairs = zip(blocks[link.parent], moved, strict=True)
                A, B, C = (plus(a, b) for a, b in pairs)
                blocks[link.parent] = (A, B, C)
        return steps[::-1]

    def shifted(self, k: int, blocks: tuple[Matrix, Matrix, Matrix]) -> tuple[Matrix, ...]:
        """The blocks about the root of the parent."""
        source, target = self.homes[k], self.outer(k)
        A, B, C = blocks
        C = rotated(self.mechanism, C, source, target)
        arm = skew(self.arm(k))
        bent = [negated(row) for row in product(C, arm)]
        if self.links[k].carried:
            B = transformed(self.mechanism, B, source, target)
            A = rotated(self.mechanism, A, source, target)
            bent = [add(a, b) for a, b in zip(bent, transpose(B), strict=True)]
            A = plus(A, [negated(row) for row in product(B, arm)])
            A = plus(A, product(arm, bent))
        else:
            A = product(arm, bent)
        return symmetric(A), transpose(bent), C

    def solve(
        self, tau: Sequence[Node], moved: Sequence[Motion], loads: Sequence[Motion]
    ) -> tuple[list[Node], list[Motion]]:
        """u' by links, and the motion of each link.

        Parameters
        ----------
        tau : sequence of Node
            Generalized forces, by links.
        moved : sequence of Motion
            What is added to the motion of each root.
        loads : sequence of Motion
            Couple and force on each link with the opposite sign, about its root.
        """
        waiting = list(loads)
        free: list[Node] = [self.mechanism.builder.zero] * len(self.links)
        for k in reversed(range(len(self.links))):
            link, step = self.links[k], self.steps[k]
            couple, force = waiting[k]
            own = dot(self.axes[k], couple if link.turning else force)
            free[k] = tau[k] - own
            if link.parent != GROUND:
                answer = self.answer(k, moved[k])
                load = (
                    add(couple, scale(free[k], scale(step.inverse, step.turning)), answer[0]),
                    add(force, scale(free[k], scale(step.inverse, step.sliding)), answer[1]),
                )
                waiting[link.parent] = total(waiting[link.parent], self.inwards(k, load))
        accelerations: list[Node] = []
        final: list[Motion] = []
        for k, link in enumerate(self.links):
            outer = (self.none, self.none) if link.parent == GROUND else final[link.parent]
            alpha, a = total(self.outwards(k, outer), moved[k])
            step = self.steps[k]
            carried = dot(step.turning, alpha) + dot(step.sliding, a)
            rate = (free[k] - carried) * step.inverse
            accelerations.append(rate)
            added = scale(rate, self.axes[k])
            final.append((add(alpha, added), a) if link.turning else (alpha, add(a, added)))
        return accelerations, final

    def body(self, k: int, motion: Motion) -> Motion:
        """Load of the link alone for a motion of its root."""
        alpha, a = motion
        first, own = self.firsts[k], self.inertias[k]
        return (
            add(times(own, alpha), cross(first, a)),
            add(cross(alpha, first), scale(self.links[k].mass, a)),
        )

    def answer(self, k: int, motion: Motion) -> Motion:
        """Load (1) of a link whose joint is free, for a motion of its root."""
        A, B, C = self.steps[k].left
        alpha, a = motion
        return (
            add(times(A, alpha), times(B, a)),
            add(times(transpose(B), alpha), times(C, a)),
        )


def total(*motions: Motion) -> Motion:
    """Sum of motions, or of loads."""
    return add(*(angular for angular, _ in motions)), add(*(linear for _, linear in motions))


def skew(v: Vector) -> Matrix:
    """[v] with [v] x = v x x."""
    zero = v[0].builder.zero
    return ((zero, -v[2], v[1]), (v[2], zero, -v[0]), (-v[1], v[0], zero))


def symmetric(matrix: Matrix) -> Matrix:
    """Its upper half on both sides, so that equal entries are one node."""
    return tuple(tuple(matrix[min(i, j)][max(i, j)] for j in range(3)) for i in range(3))


def plus(a: Sequence[Vector], b: Sequence[Vector]) -> Matrix:
    """a + b."""
    return tuple(add(x, y) for x, y in zip(a, b, strict=True))


def less(matrix: Matrix, column: Vector, row: Vector, factor: Node) -> Matrix:
    """matrix - factor column row^T."""
    scaled = scale(factor, column)
    return tuple(
        tuple(entry - x * y for entry, y in zip(line, row, strict=True))
        for line, x in zip(matrix, scaled, strict=True)
    )


def transformed(mechanism: Mechanism, matrix: Matrix, source: int, target: int) -> Matrix:
    """R matrix R^T of any matrix."""
    columns = transpose([express(mechanism, row, source, target) for row in matrix])
    return transpose([express(mechanism, column, source, target) for column in columns])


def forward_dynamics(
    mechanism: Mechanism, links: Sequence[Link], bias: Sequence[Node]
) -> tuple[Node, ...]:
    """u' in q, u and inputs, from the rows of Newton and Euler.

    Parameters
    ----------
    bias : sequence of Node
        The rows at u' = 0.
    """
    system = Articulated(mechanism, links)
    none = (system.none, system.none)
    quiet = [none] * len(links)
    rates, _ = system.solve([-bias[link.coordinate] for link in links], quiet, quiet)
    found = dict(zip((link.coordinate for link in links), rates, strict=True))
    return tuple(found[i] for i in range(len(links)))
