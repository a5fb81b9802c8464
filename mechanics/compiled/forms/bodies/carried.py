"""Accelerations of points and frames, each defined by those that carry it and by u'.

    alpha_F = R^T alpha_parent + (R^T omega_parent) x o + o'            components in F
    a_Q = a_P + c'' + 2 omega x c' + alpha x c + omega x (omega x c)    components in F, c = PQ

o is the angular velocity that a step between frames adds, c the components of a step between points
in the frame F in which the user gave it. A uniform field of gravity is subtracted from all
accelerations at the root, so that it is carried with them and no weight is ever written.
"""

from dataclasses import dataclass, field
from itertools import pairwise

import casadi as ca
from sympy import Matrix
from sympy.physics.vector import Point, ReferenceFrame

from mechanics.compiled.forms.bodies.affine import (
    PLANES,
    STILL,
    Affine,
    Graphs,
    Vector,
    across,
    cross,
    known,
    minus,
    plus,
    rotated,
    scaled,
    summed,
    turned,
)
from mechanics.compiled.forms.bodies.gauss import Gauss, Turn
from mechanics.compiled.forms.bodies.reading import Reading
from mechanics.compiled.forms.bodies.turning import Turning
from mechanics.scene.geometry import components, point_path, step_vector
from mechanics.scene.rates import rates

Name = tuple[object, ...]


@dataclass(frozen=True)
class Leg:
    """A part of the step between two points that was given in one frame."""

    frame: ReferenceFrame
    column: Matrix


@dataclass(frozen=True)
class Carried:
    """Accelerations along a scene's trees of frames and points; the tables only remember.

    Attributes
    ----------
    reading : Reading
    turning : Turning
    g : Gauss
        Where what carries something else gets an unknown of its own.
    gravity : tuple of SX
        Carried along, inertial components.
    inertial : bool
        Whether accelerations, once they are known, are passed on in inertial components: then what
        is small along one body is not found from what is large along another.
    """

    reading: Reading
    turning: Turning
    g: Gauss
    gravity: Graphs
    inertial: bool
    _legs: dict[Point, tuple[Point, tuple[Leg, ...]]] = field(default_factory=dict)
    _alphas: dict[tuple[ReferenceFrame, ReferenceFrame], Vector] = field(default_factory=dict)
    _points: dict[tuple[Point, ReferenceFrame], Vector] = field(default_factory=dict)
    _steadies: dict[Point, Vector] = field(default_factory=dict)

    def alpha(self, frame: ReferenceFrame, within: ReferenceFrame | None = None) -> Vector:
        """Angular acceleration of a frame, in its own components or those of another."""
        within = within or frame
        if (frame, within) not in self._alphas:
            name = ("alpha", frame, within)
            self._alphas[frame, within] = (
                self._named(name, self._spun(frame))
                if within == frame
                else self._rotated(name, self.alpha(frame), frame, within)
            )
        return self._alphas[frame, within]

    def _spun(self, frame: ReferenceFrame) -> Vector:
        step = self.turning.step(frame)
        if step is None:
            return known(STILL)
        spin = self.turning.declared(frame)
        if spin is not None:
            return self.reading.vector(rates(spin, self.reading.rates))
        gain = self.reading.vector(rates(step.own, self.reading.rates))
        swept = cross(self.turning.carried(frame), self.turning.own(frame))
        return plus(self.alpha(step.parent, frame), known(swept), gain)

    def legs(self, point: Point) -> tuple[Point, tuple[Leg, ...]]:
        """The point before it, and the parts of the step from there, outermost frame last."""
        scene = self.reading.scene
        if point not in self._legs:
            for before, after in pairwise(point_path(scene.origin, point)):
                if after not in self._legs:
                    self._legs[after] = before, self._split(before, after)
        return self._legs[point]

    def _split(self, before: Point, after: Point) -> tuple[Leg, ...]:
        scene = self.reading.scene
        found = [
            Leg(frame, column.applyfunc(lambda entry: scene.plain(entry, f"point {after.name}")))
            for frame, column in components(step_vector(before, after))
        ]
        return tuple(sorted(found, key=lambda leg: len(self.turning.path(leg.frame))))

    def home(self, point: Point) -> ReferenceFrame:
        """The frame in whose components the acceleration of a point is found."""
        if point == self.reading.scene.origin:
            return self.reading.scene.frame
        before, legs = self.legs(point)
        return legs[-1].frame if legs else self.home(before)

    def acceleration(self, point: Point, within: ReferenceFrame | None = None) -> Vector:
        """Acceleration of a point less the field, in components of its home or another frame."""
        home = self.home(point)
        within = within or home
        if (point, within) not in self._points:
            name = ("point", point, within)
            self._points[point, within] = (
                self._named(name, self._stepped(point))
                if within == home
                else self._rotated(name, self.acceleration(point), home, within)
            )
            if self.inertial and within != home:
                self._found_inertially(name, point, within)
        return self._points[point, within]

    def _found_inertially(self, name: Name, point: Point, within: ReferenceFrame) -> None:
        rotation = self.turning.rotation(within, self.reading.scene.frame)
        for k, entry in enumerate(turned(rotation, self._steady(point))):
            if (*name, k) in self.g.definitions:
                self.g.after[(*name, k)] = entry

    def _steady(self, point: Point) -> Vector:
        """Acceleration of a point, inertial components, in what is known after the elimination."""
        frame = self.reading.scene.frame
        if self.home(point) == frame:
            return self.acceleration(point)
        if point not in self._steadies:
            before, legs = self.legs(point)
            total = self._steady(before)
            for leg in legs:
                step = self._later(("step", point, leg.frame), self._leg(leg))
                total = plus(total, turned(self.turning.rotation(frame, leg.frame), step))
            self._steadies[point] = self._later(("steady", point), total)
        return self._steadies[point]

    def _later(self, name: Name, vector: Vector) -> Vector:
        found = []
        for k, entry in enumerate(vector):
            if not (entry.known or entry.alias):
                self.g.after[(*name, k)] = entry
                entry = Affine({(*name, k): ca.SX(1)})
            found.append(entry)
        return tuple(found)

    def _stepped(self, point: Point) -> Vector:
        if point == self.reading.scene.origin:
            return known(minus(self.gravity))
        before, legs = self.legs(point)
        if not legs:
            return self.acceleration(before)
        vector = self.acceleration(before, legs[0].frame)
        for place, (one, two) in enumerate(pairwise((*legs, legs[-1]))):
            vector = plus(vector, self._leg(one))
            if two.frame != one.frame:
                vector = self._named(("leg", point, place), vector)
                name = ("leg", point, place, two.frame)
                vector = self._rotated(name, vector, one.frame, two.frame)
        return vector

    def _leg(self, leg: Leg) -> Vector:
        """What a leg adds to the acceleration, in its frame."""
        table, read = self.reading.rates, self.reading
        first = rates(leg.column, table)
        arm, omega = read.column(leg.column), self.turning.omega(leg.frame)
        slip = scaled(ca.SX(2), cross(omega, read.column(first)))
        return plus(
            read.vector(rates(first, table)),
            known(slip),
            across(self.alpha(leg.frame), arm),
            known(centripetal(omega, arm)),
        )

    def _named(self, name: Name, vector: Vector) -> Vector:
        return tuple(self.g.define((*name, k), entry) for k, entry in enumerate(vector))

    def _rotated(
        self, name: Name, vector: Vector, frame: ReferenceFrame, within: ReferenceFrame
    ) -> Vector:
        """Components in another frame; two unknowns that turn into two others are noted."""
        rotation = self.turning.rotation(within, frame)
        for k, (i, j) in enumerate(PLANES):
            if rotation[k][k].is_one() and vector[i].alias and vector[j].alias:
                (one,), (two,) = vector[i].coefficients, vector[j].coefficients
                pair = ((*name, i), (*name, j))
                by = Turn(pair, (one, two), rotation[i][i], rotation[i][j])
                self.g.turns.update(dict.fromkeys(pair, by))
        return self._named(name, turned(rotation, vector))

    def offset(self, start: Point, end: Point, within: ReferenceFrame) -> tuple[Graphs, Graphs]:
        """The vector between two points, and its rate seen from the inertial frame."""
        origin = self.reading.scene.origin
        paths = [point_path(origin, point) for point in (start, end)]
        shared = sum(a == b for a, b in zip(*paths, strict=False))
        position, velocity = STILL, STILL
        for path, back in zip(paths, (True, False), strict=True):
            for point in path[shared:]:
                for leg in self.legs(point)[1]:
                    turn = self.turning.rotation(within, leg.frame)
                    arm, drift = (rotated(turn, vector) for vector in self._moved(leg))
                    if back:
                        arm, drift = minus(arm), minus(drift)
                    position, velocity = summed(position, arm), summed(velocity, drift)
        return position, velocity

    def _moved(self, leg: Leg) -> tuple[Graphs, Graphs]:
        """A leg and its rate, in its frame."""
        arm = self.reading.column(leg.column)
        drift = self.reading.column(rates(leg.column, self.reading.rates))
        return arm, summed(drift, cross(self.turning.omega(leg.frame), arm))


def centripetal(omega: Graphs, arm: Graphs) -> Graphs:
    """``omega x (omega x c)``."""
    squares = [entry * entry for entry in omega]
    return tuple(
        omega[k] * omega[i] * arm[i]
        + omega[k] * omega[j] * arm[j]
        - (squares[i] + squares[j]) * arm[k]
        for k, (i, j) in enumerate(PLANES)
    )
