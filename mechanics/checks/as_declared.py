"""Motions and loads of a scene, read from SymPy's objects as the author made them.

    R = product of the parents' dcm,  r = sum of R_F c_F over `pos_from`              (1)
    v = r',  a = r'',  [omega] = R' R^T,  H' = J alpha + J' omega,  J' = dJ/dt        (2)

Everything is a Taylor series along one motion, so that (2) are coefficients of (1). Loads follow
the definitions in their docstrings once more. Only the data of the declaration are read, for the
reason that `mechanics.checks.virtual_power` gives.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import reduce
from itertools import pairwise
from operator import add

from flint import arb, arb_mat, arb_series
from sympy import Expr, eye, sign, zeros
from sympy.physics.vector import Dyadic, Point, ReferenceFrame, Vector

from mechanics.checks.jets import Instant, Jet
from mechanics.errors import SceneError
from mechanics.scene import Body, Particle, Scene
from mechanics.scene.loads import (
    Coulomb,
    Damper,
    Force,
    Gravity,
    Load,
    Spring,
    Torque,
    TorsionSpring,
)

NONE = arb_mat(3, 1)


@dataclass(frozen=True)
class Wrench:
    """A force at a place and a couple on a body, 3 x 1, inertial components."""

    body: str
    at: arb_mat
    force: arb_mat
    couple: arb_mat

    def times(self, factor: arb) -> "Wrench":
        """So many times as large."""
        return Wrench(self.body, self.at, self.force * factor, self.couple * factor)


@dataclass(frozen=True)
class Motion:
    """A scene along one motion; rotations and positions that were worked out are kept."""

    scene: Scene
    instant: Instant
    _rotations: dict[ReferenceFrame, Jet] = field(default_factory=dict)
    _positions: dict[Point, Jet] = field(default_factory=dict)

    def number(self, expression: Expr) -> arb:
        """A scalar now."""
        return self.instant.coefficients(expression)[0]

    def rotation(self, frame: ReferenceFrame) -> Jet:
        """R with v_inertial = R v_frame, 3 x 3."""
        root, known = self.scene.frame, self._rotations
        known.setdefault(root, self.instant.matrix(3, 3, eye(3)))
        if frame not in known:
            path = root._dict_list(frame, 0)
            for parent, child in pairwise(path if path[0] is root else path[::-1]):
                if child not in known:
                    step = self.instant.matrix(3, 3, parent.dcm(child))
                    known[child] = known[parent] * step
        return known[frame]

    def vector(self, vector: Vector) -> Jet:
        """Inertial components, 3 x 1."""
        parts = [
            self.rotation(frame) * self.instant.matrix(3, 1, column)
            for column, frame in vector.args
        ]
        return reduce(add, parts, self.instant.matrix(3, 1, zeros(3, 1)))

    def position(self, point: Point) -> Jet:
        """From the origin, 3 x 1."""
        root, known = self.scene.origin, self._positions
        known.setdefault(root, self.vector(Vector(0)))
        if point not in known:
            path = root._pdict_list(point, 0)
            for parent, child in pairwise(path if path[0] is root else path[::-1]):
                if child not in known:
                    known[child] = known[parent] + self.vector(child.pos_from(parent))
        return known[point]

    def centre(self, name: str) -> Jet:
        """Position of a body's mass centre."""
        return self.position(self._body(name).centre)

    def spin(self, name: str) -> tuple[arb_mat, arb_mat]:
        """Angular velocity and acceleration of a body; zero for a particle."""
        body = self._body(name)
        if isinstance(body, Particle):
            return NONE, NONE
        r0, r1, r2 = self.rotation(body.frame).parts
        now = r0.transpose()
        return _axis(r1 * now), _axis(r2 * now * 2 + r1 * r1.transpose())

    def inertia_forces(self, name: str) -> Wrench:
        """m a, and the rate of the angular momentum about the mass centre."""
        body, place = self._body(name), self.centre(name).parts
        force = place[2] * (2 * self.number(body.mass))
        if isinstance(body, Particle):
            return Wrench(name, place[0], force, NONE)
        omega, alpha = self.spin(name)
        if not isinstance(body.inertia, Dyadic):
            # About the normal of the plane that the scene keeps.
            return Wrench(name, place[0], force, alpha * self.number(body.inertia))
        parts = (
            self.vector(size * one) * self.vector(two).T for size, one, two in body.inertia.args
        )
        inertia = reduce(add, parts, self.instant.matrix(3, 3, zeros(3, 3))).parts
        return Wrench(name, place[0], force, inertia[0] * alpha + inertia[1] * omega)

    def power(self, wrench: Wrench) -> arb:
        """F . v + T . omega along this motion."""
        centre, (omega, _) = self.centre(wrench.body).parts, self.spin(wrench.body)
        speed = centre[1] + cross(omega, wrench.at - centre[0])
        return dot(wrench.force, speed) + dot(wrench.couple, omega)

    def load(self, load: Load) -> Iterator[Wrench]:
        """What a load does to the bodies; friction per unit of the reaction that presses."""
        if isinstance(load, Gravity):
            field = self.vector(load.field).parts[0]
            for body in self.scene.bodies:
                place = self.centre(body.name).parts[0]
                yield Wrench(body.name, place, field * self.number(body.mass), NONE)
        elif isinstance(load, Spring | Damper):
            yield from self._line(load)
        elif isinstance(load, Force):
            at, force = self.position(load.at).parts[0], self.vector(load.vector).parts[0]
            yield from self._pair(self._carrier(load.at, load.on), load.by, at, force, NONE)
        elif isinstance(load, Torque):
            couple = self.vector(load.vector).parts[0]
            yield from self._pair(load.on, load.by, NONE, NONE, couple)
        elif isinstance(load, TorsionSpring):
            back = -self.number(load.stiffness) * self.number(load.angle)
            couple = self.vector(load.axis).parts[0] * back
            yield from self._pair(load.on, load.by, NONE, NONE, couple)
        elif isinstance(load, Coulomb):
            (normal,) = (r for r in self.scene.reactions if r.name == load.normal)
            size = -self.number(load.coefficient) * self.number(sign(load.sliding))
            force = self.vector(load.along).parts[0] * size
            at = self.position(normal.at).parts[0]
            yield from self._pair(normal.on, normal.by, at, force, NONE)
        else:
            raise SceneError(f"load {load!r}: it is none of the loads of mechanics.scene.loads")

    def reactions(self) -> Iterator[tuple[str, Wrench]]:
        """(name, what a unit of it does to a body), for all bodies of each reaction."""
        for reaction in (action for one in self.scene.reactions for action in one.actions):
            along, at = self.vector(reaction.along).parts[0], NONE
            force, couple = NONE, along
            if reaction.at is not None:
                at, force, couple = self.position(reaction.at).parts[0], along, NONE
            for wrench in self._pair(reaction.on, reaction.by, at, force, couple):
                yield reaction.name, wrench

    def _line(self, load: Spring | Damper) -> Iterator[Wrench]:
        """Tension along a line: what holds `second` back pulls `first` on."""
        ends = self.position(load.first), self.position(load.second)
        span = ends[1] - ends[0]
        if load.along is not None:
            direction = self.vector(load.along)
            length = arb_series([part[0, 0] for part in (span.T * direction).parts])
            along = direction.parts[0]
        else:
            length = arb_series([part[0, 0] for part in (span.T * span).parts]).sqrt()
            along = span.parts[0] * (1 / length[0])
        if isinstance(load, Spring):
            tension = self.number(load.stiffness) * (length[0] - self.number(load.length))
        else:
            tension = self.number(load.coefficient) * length[1]
        for name, end, pull in (
            (self._carrier(load.first, load.first_on), ends[0], tension),
            (self._carrier(load.second, load.second_on), ends[1], -tension),
        ):
            yield from self._pair(name, None, end.parts[0], along * pull, NONE)

    def _pair(
        self, on: str | None, by: str | None, at: arb_mat, force: arb_mat, couple: arb_mat
    ) -> Iterator[Wrench]:
        if on is not None:
            yield Wrench(on, at, force, couple)
        if by is not None:
            yield Wrench(by, at, -force, -couple)

    def _carrier(self, point: Point, stated: str | None) -> str | None:
        """The body that was named, or the one whose centre it is; None for the ground."""
        centred = [body.name for body in self.scene.bodies if body.centre == point]
        return stated or (centred[0] if len(centred) == 1 else None)

    def _body(self, name: str) -> Body:
        return next(body for body in self.scene.bodies if body.name == name)


def dot(one: arb_mat, two: arb_mat) -> arb:
    """Scalar product of 3 x 1 columns."""
    return (one.transpose() * two)[0, 0]


def cross(a: arb_mat, b: arb_mat) -> arb_mat:
    """Vector product of 3 x 1 columns."""
    entries = [a[i, 0] * b[j, 0] - a[j, 0] * b[i, 0] for i, j in ((1, 2), (2, 0), (0, 1))]
    return arb_mat(3, 1, entries)


def _axis(skew: arb_mat) -> arb_mat:
    return arb_mat(3, 1, [skew[2, 1], skew[0, 2], skew[1, 0]])
