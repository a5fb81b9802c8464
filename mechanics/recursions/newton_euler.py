"""Inverse dynamics by the recursion of Newton and Euler, on the trees of frames and points.

Outwards, components in each frame itself (R: v_parent = R v_frame; c: a step given in the frame):

    omega = R^T omega_parent + omega_rel                                            (1)
    alpha = R^T alpha_parent + (R^T omega_parent) x omega_rel + omega_rel'          (2)
    a = a_parent + c'' + 2 omega x c' + U c,   U c = alpha x c + omega x (omega x c)  (3)

with -g for the acceleration of the origin, so that gravity is no load. Inwards:

    F = sum over what lies at or beyond a point of m a + U h - loads                (4)
    N = skew part of U E + h x a - couples + sum c x F + sum R N_child              (5)
    row of u_r = sum omega_rel . N / du_r + sum c' . F / du_r                       (6)

The rows are power-conjugate to u and equal Kane's. Luh, Walker and Paul, On-line computational
scheme for mechanical manipulators, ASME J. Dynamic Systems, Measurement and Control 102 (1980);
Featherstone, Rigid Body Dynamics Algorithms, 2008, section 5.3.
"""

from dataclasses import dataclass

from mechanics.kinematics.chain import relative_velocity
from mechanics.mechanism import GROUND, Mechanism
from mechanics.program.builder import Node
from mechanics.program.derivatives import gradient
from mechanics.program.forward import tangent
from mechanics.program.vectors import Matrix, Vector, add, cross, scale, times, transpose, zeros
from mechanics.recursions.frames import (
    acceleration_matrix,
    collect,
    common,
    express,
    lineage,
    negated,
    rigid_steps,
)
from mechanics.recursions.loads import loads
from mechanics.recursions.pseudo_inertia import Moments, spin


@dataclass(frozen=True)
class _Turning:
    """Motion of a frame: its own components."""

    relative: Vector
    omega: Vector
    alpha: Vector
    U: Matrix


def rows(mechanism: Mechanism, moments: Moments) -> tuple[Node, ...]:
    """Rows that vanish along every motion, one for each speed, power-conjugate to u.

    Parameters
    ----------
    moments : Moments
        Of its masses: as they are, or grouped.

    Returns
    -------
    tuple of Node
        In q, u, u', inputs and unknown reactions that stay, linear in the last two.
    """
    return _Recursion(rigid_steps(mechanism), moments).rows()


class _Recursion:
    """The tables that the two sweeps fill."""

    def __init__(self, mechanism: Mechanism, moments: Moments) -> None:
        self.mechanism, self.moments = mechanism, moments
        self.none = zeros(mechanism.builder)
        self.forces: list[dict[int, Vector]] = [{} for _ in mechanism.points]
        self.couples: list[Vector] = [self.none for _ in mechanism.frames]
        self.relative: list[Vector] = [self.none for _ in mechanism.frames]
        forces, couples = loads(mechanism)
        for force in forces:
            self.push(force.point, force.frame, negated(force.vector))
        self.turnings = self.turn()
        self.homes = self.home()
        self.accelerations = self.accelerate()
        self.inertia()
        for couple in couples:
            self.twist(couple.on, couple.by, couple.frame, couple.vector)

    def turn(self) -> list[_Turning]:
        """Equations (1) and (2)."""
        found: list[_Turning] = []
        for frame in self.mechanism.frames:
            if frame.parent == GROUND:
                own = gain = omega = alpha = self.none
            else:
                outer, back = found[frame.parent], transpose(frame.rotation)
                own, gain = relative_velocity(frame, self.mechanism.rates)
                carried = times(back, outer.omega)
                omega = add(carried, own)
                alpha = add(times(back, outer.alpha), cross(carried, own), gain)
            found.append(_Turning(own, omega, alpha, acceleration_matrix(omega, alpha)))
        return found

    def home(self) -> list[int]:
        """For each point the frame of its acceleration and force.

        It is the last frame that the steps to it and from it have in common: so each vector is
        taken from frame to frame once.
        """
        points = self.mechanism.points
        busy = [bool(forces) for forces in self.forces]
        for point in (*self.moments.mass, *(point for _, point in self.moments.first)):
            busy[point] = True
        frames: list[list[int]] = [[frame for frame, _ in place.step] for place in points]
        for point in reversed(range(1, len(points))):
            if busy[point]:
                busy[points[point].parent] = True
                frames[points[point].parent] += [frame for frame, _ in points[point].step]
        homes: list[int] = []
        for place, used in zip(points, frames, strict=True):
            if place.parent == GROUND:
                homes.append(0)
            elif used:
                homes.append(common(self.mechanism, used))
            else:
                homes.append(homes[place.parent])
        return homes

    def accelerate(self) -> list[Vector]:
        """Equation (3), in the home of each point."""
        mechanism = self.mechanism
        found: list[Vector] = []
        for point, place in enumerate(mechanism.points):
            home = self.homes[point]
            if place.parent == GROUND:
                pull = [collect(mechanism, load.acceleration, home) for load in mechanism.fields]
                found.append(negated(add(self.none, *pull)))
                continue
            total = express(mechanism, found[place.parent], self.homes[place.parent], home)
            for frame, column in place.step:
                first = tangent(column, mechanism.rates)
                second = tangent(first, mechanism.rates)
                turning = self.turnings[frame]
                twice = scale(2, cross(turning.omega, first))
                part = add(times(turning.U, column), twice, second)
                total = add(total, express(mechanism, part, frame, home))
            found.append(total)
        return found

    def push(self, point: int, frame: int, force: Vector) -> None:
        """Add a force at a point."""
        old = self.forces[point].get(frame)
        self.forces[point][frame] = force if old is None else add(old, force)

    def twist(self, on: int, by: int, frame: int, couple: Vector) -> None:
        """A couple between two frames acts on the turns that lie between them."""
        first, second = (lineage(self.mechanism, end) for end in (on, by))
        for one, other, sign in ((first, second, -1), (second, first, 1)):
            for turned in one:
                if turned not in other and turned != 0:
                    own = scale(sign, express(self.mechanism, couple, frame, turned))
                    self.relative[turned] = add(self.relative[turned], own)

    def inertia(self) -> None:
        """m a + U h of equation (4), and the first two terms of equation (5)."""
        mechanism, moments = self.mechanism, self.moments
        for point, mass in moments.mass.items():
            self.push(point, self.homes[point], scale(mass, self.accelerations[point]))
        for (frame, point), first in moments.first.items():
            turning = self.turnings[frame]
            self.push(point, frame, times(turning.U, first))
            local = express(mechanism, self.accelerations[point], self.homes[point], frame)
            self.couples[frame] = add(self.couples[frame], cross(first, local))
        for frame, second in moments.second.items():
            turning = self.turnings[frame]
            own = spin(turning.U, turning.omega, turning.alpha, second)
            self.couples[frame] = add(self.couples[frame], own)

    def gathered(self, point: int) -> Vector:
        """The force at a point, in its home: what is given farther out is taken inwards first."""
        home, parts = self.homes[point], self.forces[point]
        inner = lineage(self.mechanism, home)
        while outside := parts.keys() - inner:
            frame = max(outside)
            outer = self.mechanism.frames[frame]
            force = times(outer.rotation, parts.pop(frame))
            old = parts.get(outer.parent)
            parts[outer.parent] = force if old is None else add(old, force)
        total = self.none
        for frame, force in parts.items():
            total = add(total, express(self.mechanism, force, frame, home))
        return total

    def rows(self) -> tuple[Node, ...]:
        """Equations (4) to (6)."""
        mechanism = self.mechanism
        velocities: list[Node] = []
        weights: list[Node] = []
        for point in reversed(range(1, len(mechanism.points))):
            place, home = mechanism.points[point], self.homes[point]
            if not self.forces[point]:
                continue
            total = self.gathered(point)
            for frame, column in place.step:
                local = express(mechanism, total, home, frame)
                self.couples[frame] = add(self.couples[frame], cross(column, local))
                velocities += tangent(column, mechanism.rates)
                weights += local
            self.push(place.parent, home, total)
        for frame in reversed(range(1, len(mechanism.frames))):
            own = mechanism.frames[frame]
            couple = self.couples[frame]
            velocities += self.turnings[frame].relative
            weights += add(couple, self.relative[frame])
            inwards = times(own.rotation, couple)
            self.couples[own.parent] = add(self.couples[own.parent], inwards)
        return tuple(gradient(velocities, weights, mechanism.u))
