"""A scene as SymPy's own frames, points, bodies and loads, whose motion SymPy works out.

    r = sum of the steps,   v = r.dt(N),   a = v.dt(N),   omega = frame.ang_vel_in(N)

Frames are oriented and points placed as the scene declares them. Nothing of `mechanics.kinematics`
and `mechanics.scene.geometry` is used, so that SymPy's methods are witnesses of their own. All
objects are made anew: SymPy's are mutable, and a velocity that somebody set can contradict the
position.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise
from typing import Any

import sympy.physics.mechanics as me
from sympy import Derivative, Expr, Matrix, Rational, S, sign
from sympy.physics.vector import Dyadic, Point, ReferenceFrame, Vector, dynamicsymbols, outer

from mechanics.scene import Body, RigidBody, Scene
from mechanics.scene.actions import carrier_of
from mechanics.scene.declared import decimals
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
from mechanics.scene.reactions import Reaction
from mechanics.scene.rotations import rotation_between
from mechanics.scene.symbols import plain_table
from mechanics.symbolic import canonical


@dataclass(frozen=True)
class Opening:
    """Bodies that move by ``distance`` along the direction of a reaction, which holds them."""

    reaction: Reaction
    bodies: tuple[str, ...]
    distance: Expr


@dataclass(frozen=True)
class SympyModel:
    """SymPy's objects for one scene.

    Parameters
    ----------
    replaced : mapping of Expr to Expr
        What stands for some symbols of the scene.
    openings : sequence of Opening
        Displacements of bodies, besides the motion that the scene declares.
    """

    scene: Scene
    replaced: Mapping[Expr, Expr] = field(default_factory=dict)
    openings: Sequence[Opening] = ()
    _frames: dict[ReferenceFrame, ReferenceFrame] = field(default_factory=dict)
    _points: dict[Point, Point] = field(default_factory=dict)

    @cached_property
    def frame(self) -> ReferenceFrame:
        """The inertial frame."""
        return ReferenceFrame("N")

    @cached_property
    def bodies(self) -> dict[str, Any]:
        """SymPy's particles and rigid bodies, by name."""
        return {body.name: self._body(body) for body in self.scene.bodies}

    def scalar(self, expression: Expr) -> Expr:
        """An expression as it was typed, in SymPy's dynamic symbols."""
        exact = decimals(expression).xreplace(self.replaced)
        return exact.doit() if exact.has(Derivative) else exact

    def turned(self, frame: ReferenceFrame) -> ReferenceFrame:
        """The frame that stands for one of the scene, each step oriented as it was declared."""
        root, known = self.scene.frame, self._frames
        known.setdefault(root, self.frame)
        if frame not in known:
            path = root._dict_list(frame, 0)
            for parent, child in pairwise(path if path[0] is root else path[::-1]):
                if child not in known:
                    known[child] = self._step(parent, child)
        return known[frame]

    def _step(self, parent: ReferenceFrame, child: ReferenceFrame) -> ReferenceFrame:
        rotation = rotation_between(self.scene.rotations, parent, child)
        if rotation is not None:
            # From the derivative of its matrix SymPy needs a minute for a heavy top.
            frame = rotation.orient(child.name, self._frames[parent])
            omega = [self.scalar(speed) for speed in rotation.speeds]
            frame.set_ang_vel(self._frames[parent], Vector([(Matrix(omega), frame)]))
            return frame
        frame = ReferenceFrame(child.name)
        frame.orient_dcm(self._frames[parent], child.dcm(parent).applyfunc(self.scalar))
        return frame

    def point(self, point: Point) -> Point:
        """The point that stands for one of the scene, each step placed as it was declared."""
        root, known = self.scene.origin, self._points
        known.setdefault(root, Point(root.name))
        if point not in known:
            path = root._pdict_list(point, 0)
            for parent, child in pairwise(path if path[0] is root else path[::-1]):
                if child not in known:
                    known[child] = known[parent].locatenew(
                        child.name, self.vector(child.pos_from(parent))
                    )
        return known[point]

    def vector(self, vector: Vector) -> Vector:
        """The same components in the frames that stand for those of the scene."""
        return Vector([(c.applyfunc(self.scalar), self.turned(frame)) for c, frame in vector.args])

    def place(self, point: Point) -> Vector:
        """Position from the origin."""
        return self.point(point).pos_from(self.point(self.scene.origin))

    def _body(self, body: Body) -> Any:
        centre = Point(f"centre of {body.name}")
        place = self.place(body.centre)
        for opening in self.openings:
            if body.name in opening.bodies:
                place += opening.distance * self.vector(opening.reaction.along)
        velocity = place.dt(self.frame)
        centre.set_vel(self.frame, velocity)
        # Accelerations are only projected: in inertial components that takes fewer operations.
        centre.set_acc(self.frame, velocity.dt(self.frame).express(self.frame))
        mass = self.scalar(body.mass)
        if not isinstance(body, RigidBody) or body.inertia == 0:
            # A body without inertia about its centre is a point mass: no angular terms to form.
            return me.Particle(body.name, centre, mass)
        frame = self.turned(body.frame)
        # In the frame of the inertia, so that SymPy need not turn it for every product.
        frame.set_ang_vel(self.frame, frame.ang_vel_in(self.frame).express(frame))
        return me.RigidBody(body.name, centre, frame, mass, (self._inertia(body), centre))

    def _inertia(self, body: RigidBody) -> Dyadic:
        """About the mass centre; a scalar stands for a multiple of the identity."""
        if not isinstance(body.inertia, Dyadic):
            frame, scalar = self.turned(body.frame), self.scalar(body.inertia)
            return me.inertia(frame, scalar, scalar, scalar)
        return sum(
            (
                self.scalar(size) * outer(self.vector(one), self.vector(two))
                for size, one, two in body.inertia.args
            ),
            Dyadic(0),
        )

    def potential(self, load: Gravity | Spring | TorsionSpring) -> Expr:
        """Potential energy of a conservative load, in J."""
        if isinstance(load, Gravity):
            field = self.vector(load.field)
            energies = [
                -self.scalar(body.mass) * self.place(body.centre).dot(field)
                for body in self.scene.bodies
            ]
            return sum(energies, S.Zero)
        if isinstance(load, Spring):
            stretch = self._line(load)[0] - self.scalar(load.length)
        else:
            stretch = self.scalar(load.angle)
        return Rational(1, 2) * self.scalar(load.stiffness) * stretch**2

    def loads(self, loads: Sequence[Load]) -> list[tuple[object, Vector]]:
        """Forces on points and couples on frames, for SymPy's methods."""
        return [pair for load in loads for pair in self._load(load)]

    def reactions(self) -> list[tuple[object, Vector]]:
        """The reactions on both bodies, their sizes unknown."""
        found: list[tuple[object, Vector]] = []
        for one in self.scene.reactions:
            along = one.symbol * self.vector(one.along)
            if one.at is None:
                found += self._couples(one.on, one.by, along)
            else:
                found += self._forces(one.on, one.by, one.at, along)
        return found

    def _load(self, load: Load) -> Iterator[tuple[object, Vector]]:
        if isinstance(load, Gravity):
            for body in self.bodies.values():
                if body.mass != 0:
                    yield body.masscenter, body.mass * self.vector(load.field)
        elif isinstance(load, Spring | Damper):
            distance, direction = self._line(load)
            if isinstance(load, Spring):
                tension = self.scalar(load.stiffness) * (distance - self.scalar(load.length))
            else:
                tension = self.scalar(load.coefficient) * distance.diff(dynamicsymbols._t)
            first = carrier_of(self.scene, load, load.first, load.first_on)
            second = carrier_of(self.scene, load, load.second, load.second_on)
            yield from self._forces(first, None, load.first, tension * direction)
            yield from self._forces(second, None, load.second, -tension * direction)
        elif isinstance(load, Force):
            on = carrier_of(self.scene, load, load.at, load.on)
            yield from self._forces(on, load.by, load.at, self.vector(load.vector))
        elif isinstance(load, Torque):
            yield from self._couples(load.on, load.by, self.vector(load.vector))
        elif isinstance(load, TorsionSpring):
            back = -self.scalar(load.stiffness) * self.scalar(load.angle)
            yield from self._couples(load.on, load.by, back * self.vector(load.axis))
        elif isinstance(load, Coulomb):
            normal = self.scene.reaction(load.normal)
            size = -normal.symbol * self.scalar(load.coefficient) * sign(self.scalar(load.sliding))
            rubbing = size * self.vector(load.along)
            yield from self._forces(normal.on, normal.by, normal.at, rubbing)

    def _line(self, load: Spring | Damper) -> tuple[Expr, Vector]:
        """Distance between two points, and the unit direction from the first to the second."""
        span = self.point(load.second).pos_from(self.point(load.first))
        if load.along is not None:
            direction = self.vector(load.along)
            return span.dot(direction), direction
        distance = span.magnitude()
        return distance, span / distance

    def _forces(
        self, on: str | None, by: str | None, at: Point, force: Vector
    ) -> Iterator[tuple[object, Vector]]:
        for name, signed in ((on, force), (by, -force)):
            if name is not None:
                yield self._material(name, at), signed

    def _couples(
        self, on: str | None, by: str | None, couple: Vector
    ) -> Iterator[tuple[object, Vector]]:
        for name, signed in ((on, couple), (by, -couple)):
            body = self.scene.body(name) if name is not None else None
            if isinstance(body, RigidBody):
                yield self.turned(body.frame), signed

    def _material(self, name: str, at: Point) -> Point:
        """The point of a body that is where a point of the scene is now."""
        body, centre = self.scene.body(name), self.bodies[name].masscenter
        if at == body.centre:
            return centre
        arm = self.point(at).pos_from(self.point(body.centre))
        point = centre.locatenew(f"{at.name} of {name}", arm)
        if isinstance(body, RigidBody):
            point.v2pt_theory(centre, self.frame, self.turned(body.frame))
        else:
            point.set_vel(self.frame, centre.vel(self.frame))
        return point


def plain(scene: Scene, matrix: Matrix, more: Mapping[Expr, Expr]) -> Matrix:
    """SymPy's dynamic symbols as plain ones, those in `more` as it says."""
    speeds = [u for u, _ in scene.speeds]
    table = {**plain_table((*scene.coordinates, *speeds, *scene.inputs)), **more}
    return matrix.applyfunc(lambda entry: entry.xreplace(table))


def cramer(matrix: Matrix, sides: Matrix) -> Matrix:
    """Solve by Cramer's rule; LU would divide by what is zero at ordinary states."""
    return matrix.cramer_solve(sides, det_method="berkowitz")


def tidied(scene: Scene, matrix: Matrix) -> Matrix:
    """Entries of SymPy's methods in the normal form where time is explicit.

    A frame that turns as Omega t leaves sin(Omega t)^2 + cos(Omega t)^2 all over them.
    """
    return matrix.applyfunc(canonical) if scene.explicit_time else matrix
