"""Accelerations of points and frames, each defined by those that carry it and by u'.

    R(F <- G) = Rz(a_G - a_F)                    steps about one coordinate axis
    R(F <- G) = R(F <- parent) R(parent <- G)    any other
    alpha_F = R^T alpha_parent + (R^T omega_parent) x o + o'            components in F
    a_Q = a_P + c'' + 2 omega x c' + alpha x c + omega x (omega x c)    components in F, c = PQ

o is the angular velocity that a step between frames adds, c the components of a step between points
in the frame F in which the user gave it. Gravity is subtracted from all accelerations at the root,
so that it is carried with them and no weight is ever written. Frames that the user oriented
relative to the same frame stay independent of each other, so that a chain in absolute angles has no
product of many rotations.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from mechanics.kinematics.chain import relative_velocity
from mechanics.mechanism import GROUND, Mechanism, inputs_of, name_of
from mechanics.program.builder import Node
from mechanics.program.derivatives import gradient
from mechanics.program.forward import tangent
from mechanics.program.interpret import include
from mechanics.program.residues import Residues
from mechanics.program.vectors import (
    Matrix,
    Vector,
    add,
    cross,
    identity,
    product,
    scale,
    times,
    transpose,
    zeros,
)
from mechanics.recursions.frames import collect, common, lineage, negated
from mechanics.recursions.least_constraint.affine import (
    PLANES,
    Affine,
    Affines,
    across,
    is_one,
    known,
    plus,
    turned,
)
from mechanics.recursions.least_constraint.gauss import Gauss, Turn

Name = tuple[object, ...]
Spin = tuple[dict[int, Node], ...]
"""Components of an angular velocity: what each takes of the speeds, by their indices."""
Leg = tuple[int, Vector]
"""A part of the step between two points: its frame and components."""


@dataclass(frozen=True)
class Accelerations:
    """Accelerations along the trees of frames and points; the tables only remember.

    Attributes
    ----------
    mechanism : Mechanism
    g : Gauss
        Where what carries something else gets an unknown of its own.
    inertial : bool
        Whether accelerations, once they are known, are passed on in inertial components: then what
        is small along one body is not found from what is large along another.
    """

    mechanism: Mechanism
    g: Gauss
    inertial: bool
    _rotations: dict[tuple[int, int], Matrix] = field(default_factory=dict)
    _angles: dict[tuple[int, int], Node] = field(default_factory=dict)
    _omegas: dict[int, Vector] = field(default_factory=dict)
    _declared: dict[int, Spin | None] = field(default_factory=dict)
    _alphas: dict[tuple[int, int], Affines] = field(default_factory=dict)
    _points: dict[tuple[int, int], Affines] = field(default_factory=dict)
    _steadies: dict[int, Affines] = field(default_factory=dict)

    # ------------------------------------------------------------------ frames

    def rotation(self, to: int, of: int) -> Matrix:
        """R with v_to = R v_of."""
        if to == of:
            return identity(self.mechanism.builder)
        if (to, of) not in self._rotations:
            self._rotations[to, of] = self._rotation(to, of)
        return self._rotations[to, of]

    def _rotation(self, to: int, of: int) -> Matrix:
        if (of, to) in self._rotations:
            return transpose(self._rotations[of, to])
        frames, base = self.mechanism.frames, common(self.mechanism, (to, of))
        down, up = (self._between(base, frame) for frame in (to, of))
        axes = {self._axis(frame) for frame in (*down, *up)}
        axis = axes.pop()
        if not axes and axis is not None:
            return self._about(axis, base, to, of)
        if not down and len(up) == 1:
            return frames[of].rotation
        if not down:
            inner = frames[of].parent
            return product(self.rotation(to, inner), self.rotation(inner, of))
        if not up:
            return transpose(self.rotation(of, to))
        return product(self.rotation(to, base), self.rotation(base, of))

    def _between(self, base: int, frame: int) -> tuple[int, ...]:
        path = lineage(self.mechanism, frame)
        return path[: path.index(base)]

    def _axis(self, frame: int) -> int | None:
        """The coordinate axis that a step turns about; None for any other rotation."""
        turn = self.mechanism.frames[frame].turn
        return None if turn is None else next((k for k in range(3) if is_one(turn.axis[k])), None)

    def _about(self, axis: int, base: int, to: int, of: int) -> Matrix:
        """Cosine and sine of a_of - a_to, the angles from the common frame.

        Of angles that are large the difference would be rounded, and with it its sine.
        """
        (c, s), (d, e) = (self._circle(base, frame) for frame in (of, to))
        cosine, sine = c * d + s * e, s * d - c * e
        i, j = PLANES[axis]
        rows = [list(row) for row in identity(self.mechanism.builder)]
        rows[i][i], rows[j][j], rows[i][j], rows[j][i] = cosine, cosine, -sine, sine
        return tuple(map(tuple, rows))

    def _circle(self, base: int, frame: int) -> tuple[Node, Node]:
        """Cosine and sine of the angle from one frame out to another."""
        build = self.mechanism.builder
        if frame == base:
            return build.one, build.zero
        angle = self._angle(base, frame)
        return angle.cos(), angle.sin()

    def _angle(self, base: int, frame: int) -> Node:
        """Sum of the angles of the steps from one frame out to another."""
        if (base, frame) not in self._angles:
            own = self.mechanism.frames[frame]
            assert own.turn is not None
            outer = None if own.parent == base else self._angle(base, own.parent)
            self._angles[base, frame] = own.turn.angle if outer is None else outer + own.turn.angle
        return self._angles[base, frame]

    def omega(self, frame: int) -> Vector:
        """Angular velocity of a frame, in its own components."""
        if frame not in self._omegas:
            self._omegas[frame] = self._turning(frame)
        return self._omegas[frame]

    def _turning(self, frame: int) -> Vector:
        mechanism = self.mechanism
        own = mechanism.frames[frame]
        if own.parent == GROUND:
            return zeros(mechanism.builder)
        spin = self.declared(frame)
        if spin is not None:
            zero = mechanism.builder.zero
            return tuple(sum((c * mechanism.u[k] for k, c in e.items()), zero) for e in spin)
        relative, _ = relative_velocity(own, mechanism.rates)
        return add(self._carried(frame), relative)

    def _carried(self, frame: int) -> Vector:
        """Angular velocity of the frame that it is oriented by, in its own components."""
        parent = self.mechanism.frames[frame].parent
        return times(self.rotation(frame, parent), self.omega(parent))

    def declared(self, frame: int) -> Spin | None:
        """Angular velocity, affine in u, where speeds were declared to be its components.

        Euler's equations are regular where the rates of Euler's angles are not. Found at points of
        a field: what is built from it is shown to solve the rows.
        """
        mechanism = self.mechanism
        if mechanism.u == mechanism.qd or mechanism.frames[frame].parent == GROUND:
            return None
        if frame not in self._declared:
            relative, _ = relative_velocity(mechanism.frames[frame], mechanism.rates)
            self._declared[frame] = self._constant(add(self._carried(frame), relative))
        return self._declared[frame]

    def _constant(self, omega: Vector) -> Spin | None:
        """Components as sums of speeds, each taken once or not at all."""
        build, filter_ = self.mechanism.builder, Residues(self.mechanism.builder)
        if not all(map(filter_.is_zero, without(omega, self.mechanism.u))):
            return None
        found = []
        for entry in omega:
            slopes: dict[int, Node] = {}
            for k, slope in enumerate(gradient([entry], [1], self.mechanism.u)):
                value = next((v for v in (0, 1, -1) if filter_.is_zero(slope - v)), None)
                if value is None:
                    return None
                if value:
                    slopes[k] = build.constant(value)
            found.append(slopes)
        return tuple(found)

    def alpha(self, frame: int, within: int | None = None) -> Affines:
        """Angular acceleration of a frame, in its own components or those of another."""
        within = frame if within is None else within
        if (frame, within) not in self._alphas:
            name = ("alpha", frame, within)
            self._alphas[frame, within] = (
                self._named(name, self._spun(frame))
                if within == frame
                else self._rotated(name, self.alpha(frame), frame, within)
            )
        return self._alphas[frame, within]

    def _spun(self, frame: int) -> Affines:
        mechanism = self.mechanism
        own = mechanism.frames[frame]
        if own.parent == GROUND:
            return known(zeros(mechanism.builder))
        spin = self.declared(frame)
        if spin is not None:
            zero = mechanism.builder.zero
            return tuple(Affine({mechanism.ud[k]: c for k, c in e.items()}, zero) for e in spin)
        relative, gain = relative_velocity(own, mechanism.rates)
        swept = cross(self._carried(frame), relative)
        return plus(self.alpha(own.parent, frame), known(swept), self.affine(gain))

    # ------------------------------------------------------------------ points

    def legs(self, point: int) -> tuple[Leg, ...]:
        """The parts of the step to a point, outermost frame last."""
        depth = lambda leg: len(lineage(self.mechanism, leg[0]))  # noqa: E731
        return tuple(sorted(self.mechanism.points[point].step, key=depth))

    def home(self, point: int) -> int:
        """The frame in whose components the acceleration of a point is found."""
        while self.mechanism.points[point].parent != GROUND:
            if legs := self.legs(point):
                return legs[-1][0]
            point = self.mechanism.points[point].parent
        return 0

    def acceleration(self, point: int, within: int | None = None) -> Affines:
        """Acceleration of a point less gravity, in components of its home or another frame."""
        home = self.home(point)
        within = home if within is None else within
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

    def _found_inertially(self, name: Name, point: int, within: int) -> None:
        for k, entry in enumerate(turned(self.rotation(within, 0), self._steady(point))):
            if (*name, k) in self.g.definitions:
                self.g.after[(*name, k)] = entry

    def _steady(self, point: int) -> Affines:
        """Acceleration of a point, inertial components, in what is known after the elimination."""
        if self.home(point) == 0:
            return self.acceleration(point)
        if point not in self._steadies:
            total = self._steady(self.mechanism.points[point].parent)
            for leg in self.legs(point):
                step = self._later(("step", point, leg[0]), self._leg(leg))
                total = plus(total, turned(self.rotation(0, leg[0]), step))
            self._steadies[point] = self._later(("steady", point), total)
        return self._steadies[point]

    def _later(self, name: Name, vector: Affines) -> Affines:
        build, found = self.mechanism.builder, []
        for k, entry in enumerate(vector):
            if not (entry.known or entry.alias):
                self.g.after[(*name, k)] = entry
                entry = Affine({(*name, k): build.one}, build.zero)
            found.append(entry)
        return tuple(found)

    def _stepped(self, point: int) -> Affines:
        mechanism, parent = self.mechanism, self.mechanism.points[point].parent
        if parent == GROUND:
            fields = [collect(mechanism, load.acceleration, 0) for load in mechanism.fields]
            return known(negated(add(zeros(mechanism.builder), *fields)))
        legs = self.legs(point)
        if not legs:
            return self.acceleration(parent)
        vector = self.acceleration(parent, legs[0][0])
        for place, (one, two) in enumerate(pairwise((*legs, legs[-1]))):
            vector = plus(vector, self._leg(one))
            if two[0] != one[0]:
                vector = self._named(("leg", point, place), vector)
                vector = self._rotated(("leg", point, place, two[0]), vector, one[0], two[0])
        return vector

    def _leg(self, leg: Leg) -> Affines:
        """What a leg adds to the acceleration, in its frame."""
        frame, arm = leg
        first = tangent(arm, self.mechanism.rates)
        omega = self.omega(frame)
        slip = scale(2, cross(omega, first))
        return plus(
            self.affine(tangent(first, self.mechanism.rates)),
            known(slip),
            across(self.alpha(frame), arm),
            known(centripetal(omega, arm)),
        )

    def affine(self, vector: Iterable[Node]) -> Affines:
        """Nodes that are linear in u', in the unknowns u'."""
        return tuple(map(self._split, vector))

    def _split(self, node: Node) -> Affine:
        ud = [symbol for symbol in self.mechanism.ud if symbol in inputs_of([node])]
        if not ud:
            return Affine({}, node)
        (rest,) = without([node], ud)
        slopes = zip(ud, gradient([node], [1], ud), strict=True)
        return Affine({symbol: slope for symbol, slope in slopes if not slope.is_zero}, rest)

    def _named(self, name: Name, vector: Affines) -> Affines:
        return tuple(self.g.define((*name, k), entry) for k, entry in enumerate(vector))

    def _rotated(self, name: Name, vector: Affines, frame: int, within: int) -> Affines:
        """Components in another frame; two unknowns that turn into two others are noted."""
        rotation = self.rotation(within, frame)
        for k, (i, j) in enumerate(PLANES):
            if is_one(rotation[k][k]) and vector[i].alias and vector[j].alias:
                (one,), (two,) = vector[i].coefficients, vector[j].coefficients
                pair = ((*name, i), (*name, j))
                by = Turn(pair, (one, two), rotation[i][i], rotation[i][j])
                self.g.turns.update(dict.fromkeys(pair, by))
        return self._named(name, turned(rotation, vector))


def centripetal(omega: Sequence[Node], arm: Sequence[Node]) -> Vector:
    """``omega x (omega x c)``."""
    squares = [entry * entry for entry in omega]
    return tuple(
        omega[k] * omega[i] * arm[i]
        + omega[k] * omega[j] * arm[j]
        - (squares[i] + squares[j]) * arm[k]
        for k, (i, j) in enumerate(PLANES)
    )


def without(nodes: Sequence[Node], inputs: Iterable[Node]) -> tuple[Node, ...]:
    """Nodes where some inputs are zero."""
    build = nodes[0].builder
    none = dict.fromkeys(map(name_of, inputs), build.zero)
    return include(build, build.program({"rest": nodes}), none)["rest"]
