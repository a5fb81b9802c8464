"""Where the bodies of one of SymPy's models are, from positions and velocities that are set.

    v_C = d/dt (r_C - r_A) + w        w the velocity of the anchor A, the same for all bodies on it
    omega = s e                       of a frame that nothing orients, e fixed in its parent

SymPy's methods use velocities, which can be set; a scene has positions alone. Where both say the
same, w = 0. A wheel whose contact point is "at rest" has w != 0, the velocity with which the
contact moves on; so has a point of which only the velocity is said. Then A gets coordinates of its
own, with w as their rates: integrated where they are rates of others, else a motion constraint.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

from sympy import Derivative, Expr, Integral, S, Symbol, cos, expand_mul, integrate, sin
from sympy.core.function import AppliedUndef
from sympy.physics.vector import Point, ReferenceFrame, Vector, dynamicsymbols

from mechanics.errors import SceneError
from mechanics.importers.sympy_model import Parts, is_rigid
from mechanics.program.builder import Builder, Node
from mechanics.program.forward import tangent
from mechanics.program.operations import INPUT
from mechanics.program.residues import Residues
from mechanics.program.sympy_reader import read
from mechanics.program.vectors import add, cross, dot, product, subtract, times, transpose, zeros
from mechanics.routes.rows import coefficients, remainder
from mechanics.scene.geometry import (
    components,
    frame_path,
    point_path,
    relative_rotation,
    step_vector,
)
from mechanics.scene.symbols import plain_table, to_plain
from mechanics.symbolic import operations, tidy

AXES = "xyz"
QUATERNION = 4
LARGEST_INTEGRAND = 60
"""Operations of a rate that is integrated."""


@dataclass(frozen=True)
class Moved:
    """What places the bodies, beside the steps that the model has.

    Attributes
    ----------
    anchors : mapping of Point to Vector
        From the origin to one point of each group of points that know each other.
    turned : mapping of ReferenceFrame to (ReferenceFrame, Vector, Expr)
        Frames that nothing orients: parent, axis, angle.
    rates : mapping of Expr to Expr
        Of the coordinates that are new, in q and u.
    carriers : mapping of Point to RigidBody
        Of points with a load: the body with whose material they move at the moment, as that of a
        wheel at its contact.
    """

    anchors: Mapping[Point, Vector]
    turned: Mapping[ReferenceFrame, tuple[ReferenceFrame, Vector, Expr]]
    rates: Mapping[Expr, Expr]
    carriers: Mapping[Point, Any]


def place(parts: Parts) -> Moved:
    """Place the bodies of a model.

    Raises
    ------
    SceneError
        Where velocities contradict positions, or nothing places a body.
    """
    return _Placing(parts).moved()


def functions_of(expressions: Sequence[Any]) -> set[Expr]:
    """Functions of time in expressions."""
    found: set[Expr] = set()
    for expression in expressions:
        found |= {f for f in expression.atoms(AppliedUndef) if f.args == (dynamicsymbols._t,)}
    return found


def linked(point: Point) -> list[Point]:
    """The points that are placed from a point or from each other, it first."""
    found = [point]
    for one in found:
        found += [other for other in one._pos_dict if other not in found]
    return found


@dataclass
class _Placing:
    parts: Parts
    turned: dict[ReferenceFrame, tuple[ReferenceFrame, Vector, Expr]] = field(default_factory=dict)
    rates: dict[Expr, Expr] = field(default_factory=dict)

    def __post_init__(self) -> None:
        parts = self.parts
        self.build = Builder()
        self.resting = dict.fromkeys(parts.auxiliary, S.Zero)
        self.table = plain_table(sorted(self._functions(), key=str))
        u = parts.u
        self.to_rates = {u_k: q_d for q_d, u_k in parts.rates.items() if u_k in u}

    def _functions(self) -> set[Expr]:
        parts = self.parts
        found = {*parts.q, *(u for u in parts.u if not isinstance(u, Derivative))}
        for body in parts.bodies:
            for point in linked(body.masscenter):
                for vector in (*point._pos_dict.values(), *point._vel_dict.values()):
                    found |= functions_of([column for column, _ in vector.args])
        for frame in self._frames():
            for vector in frame._ang_vel_dict.values():
                found |= functions_of([column for column, _ in vector.args])
            for other in frame._dcm_dict:
                found |= functions_of([frame.dcm(other)])
        return found

    def _frames(self) -> list[ReferenceFrame]:
        found = [self.parts.frame]
        found += [body.frame for body in self.parts.bodies if is_rigid(body)]
        for one in found:
            found += [o for o in (*one._dcm_dict, *one._ang_vel_dict) if o not in found]
        return list(dict.fromkeys(found))

    # ------------------------------------------------------------------ nodes

    def node(self, expression: Expr, where: str) -> Node:
        """An expression with q' in u."""
        plain = to_plain(expression.xreplace(self.resting), self.table, where)
        known = {
            self.table[rate]: to_plain(value.xreplace(self.resting), self.table, where)
            for rate, value in {**self.parts.rates, **self.rates}.items()
            if rate in self.table
        }
        (found,) = read(self.build, (plain.xreplace(known),))
        return found

    def time_rates(self) -> dict[Node, Node]:
        """Rate of each function of time."""
        t = dynamicsymbols._t
        found = {self.build.input(str(t)): self.build.one}
        for function in [f for f in self.table if isinstance(f, AppliedUndef)]:
            rate = function.diff(t)
            if function in self.parts.u:
                continue
            found[self.node(function, "")] = self.node(rate, "")
        return found

    def rotation(self, frame: ReferenceFrame) -> Any:
        build = self.build
        found = tuple(
            tuple(build.one if i == j else build.zero for j in range(3)) for i in range(3)
        )
        for parent, child in pairwise(frame_path(self.parts.frame, self.oriented(frame))):
            step = relative_rotation(parent, child)
            rows = tuple(
                tuple(self.node(e, f"frame {child.name}") for e in step[i, :]) for i in range(3)
            )
            found = product(found, rows)
        return found

    def oriented(self, frame: ReferenceFrame) -> ReferenceFrame:
        """A frame that nothing orients is, for its axes, its parent."""
        return self.turned[frame][0] if frame in self.turned else frame

    def vector(self, vector: Vector, where: str) -> Any:
        total = zeros(self.build)
        for frame, column in components(vector):
            nodes = tuple(self.node(entry, where) for entry in column)
            total = add(total, times(self.rotation(frame), nodes))
        return total

    def zero(self, nodes: Sequence[Node]) -> bool:
        # A new filter knows the roots that were read since.
        return all(map(Residues(self.build).is_zero, nodes))

    # ------------------------------------------------------------------ placing

    def refuse_quaternions(self) -> None:
        """Four coordinates outside of sines and cosines turn a frame."""
        for frame in self._frames():
            for other in frame._dcm_dict:
                step = frame.dcm(other)
                angles = {one: S.Zero for one in step.atoms(sin, cos)}
                held = functions_of([step.xreplace(angles)]) & {*self.parts.q}
                if len(held) == QUATERNION:
                    names = ", ".join(sorted(one.func.__name__ for one in held))
                    raise SceneError(
                        f"frame {frame.name}: it is turned by the quaternion {names}: models with"
                        " quaternions do not come in; declare a Scene with quaternion(...)"
                    )

    def moved(self) -> Moved:
        self.refuse_quaternions()
        for body in self.parts.bodies:
            if is_rigid(body):
                self.orient(body)
        anchors: dict[Point, Vector] = {}
        seen: set[Point] = set()
        for body in self.parts.bodies:
            if body.masscenter not in seen:
                group = linked(body.masscenter)
                seen |= {*group}
                point, offset = self.anchor(group)
                anchors[point] = offset
        return Moved(anchors, self.turned, self.rates, dict(self.carriers()))

    def carriers(self) -> Iterator[tuple[Point, Any]]:
        """v_P = v_C + omega x (r_P - r_C)."""
        root = self.parts.frame
        bodies = [b for b in self.parts.bodies if is_rigid(b) and root in b.masscenter._vel_dict]
        for load in self.parts.loads:
            point = load.where
            if isinstance(point, ReferenceFrame) or root not in point._vel_dict:
                continue
            for body in bodies:
                if body.masscenter not in linked(point):
                    continue
                where = f"point {point.name}"
                arm = self.way(body.masscenter, point)
                omega = self.vector(body.frame.ang_vel_in(root), where)
                own = self.vector(body.masscenter._vel_dict[root], where)
                moved = add(own, cross(omega, arm))
                if self.zero(subtract(moved, self.vector(point._vel_dict[root], where))):
                    yield point, body
                    break

    def orient(self, body: Any) -> None:
        """Check the angular velocity of a frame, or make an angle of it."""
        frame, root = body.frame, self.parts.frame
        try:
            frame_path(root, frame)
        except SceneError:
            self.spin(body)
            return
        try:
            omega = frame.ang_vel_in(root)
        except ValueError:
            return
        turn = self.rotation(frame)
        flat = tangent([entry for row in turn for entry in row], self.time_rates())
        rate = [flat[3 * i : 3 * i + 3] for i in range(3)]
        # [omega]x = R' R^T
        skew = product(rate, transpose(turn))
        own = (skew[2][1], skew[0][2], skew[1][0])
        if not self.zero(subtract(own, self.vector(omega, f"frame {frame.name}"))):
            raise SceneError(
                f"body {body.name}: the angular velocity of frame {frame.name} that is set"
                f" contradicts how it is oriented: correct {frame.name}.set_ang_vel, or leave it"
                " out"
            )

    def spin(self, body: Any) -> None:
        """A frame of which only the angular velocity is said."""
        frame = body.frame
        for parent, omega in frame._ang_vel_dict.items():
            for own, column in components(omega):
                held = [k for k in range(3) if column[k] != 0]
                if own in (parent, frame) and len(omega.args) == 1 and len(held) == 1:
                    axis = (parent.x, parent.y, parent.z)[held[0]]
                    angle = self.coordinate(f"{frame.name}_angle", column[held[0]])
                    self.turned[frame] = (parent, axis, angle)
                    return
        raise SceneError(
            f"body {body.name}: nothing orients its frame {frame.name}: orient it, as in"
            f" {frame.name}.orient_axis({self.parts.frame.name}, ...)"
        )

    def coordinate(self, name: str, rate: Expr) -> Expr:
        """The integral of a rate: of other coordinates, or one of its own."""
        rate = rate.xreplace(self.resting)
        known = rate.xreplace(self.to_rates)
        slopes = {q: known.diff(q.diff(dynamicsymbols._t)) for q in self.parts.q}
        rest = known - sum((s * q.diff(dynamicsymbols._t) for q, s in slopes.items()), S.Zero)
        if not functions_of([rest.expand()]):
            offset = rest.expand() * dynamicsymbols._t
            integral = _integral(slopes)
            if integral is not None:
                return integral + offset
        plain = re.sub(r"\W", "_", name)
        taken = {f.func.__name__ for f in self.table if isinstance(f, AppliedUndef)}
        while plain in taken:
            plain += "_"
        new = dynamicsymbols(plain)
        self.table |= plain_table([new])
        self.rates[new.diff(dynamicsymbols._t)] = rate
        return new

    def anchor(self, group: Sequence[Point]) -> tuple[Point, Vector]:
        """One point of a group, and where it is from the origin."""
        root = self.parts.frame
        moving = [body for body in self.parts.bodies if body.masscenter in group]
        rest = [point for point in group if self.rests(point)]
        origin = self.parts.origin
        anchor = origin if origin in group else next(iter(rest), moving[0].masscenter)
        given = [body for body in moving if root in body.masscenter._vel_dict]
        if not given and not rest and anchor is not origin:
            raise SceneError(
                f"body {moving[0].name}: no point from which it is placed is at rest in"
                f" {root.name}, and no velocity of it is set: write O.set_vel({root.name}, 0) for"
                " the fixed point"
            )
        slips = [(body, self.slip(anchor, body)) for body in given]
        if not slips or all(self.held(slip) for _, slip in slips):
            return anchor, Vector(0)
        first, slip = min(slips, key=lambda pair: len(point_path(anchor, pair[0].masscenter)))
        for body, other in slips:
            if anchor is origin or not self.zero(subtract(slip, other)):
                wrong = first if self.zero(other) else body
                raise SceneError(
                    f"body {wrong.name}: the velocity of {wrong.masscenter.name} that is set"
                    f" contradicts its position: correct {wrong.masscenter.name}.set_vel, or leave"
                    " it out"
                )
        return anchor, self.offset(anchor, first, slip)

    def rests(self, point: Point) -> bool:
        velocity = point._vel_dict.get(self.parts.frame)
        if velocity is None:
            return False
        return all(
            not any(entry.xreplace(self.resting) for entry in column)
            for _, column in components(velocity)
        )

    def slip(self, anchor: Point, body: Any) -> Any:
        """w, in components of the inertial frame."""
        where, point = f"point {body.masscenter.name}", body.masscenter
        velocity = self.vector(point._vel_dict[self.parts.frame], where)
        return subtract(velocity, tuple(tangent(self.way(anchor, point), self.time_rates())))

    def way(self, start: Point, end: Point) -> Any:
        """From point to point, in components of the inertial frame."""
        total = zeros(self.build)
        for parent, child in pairwise(point_path(start, end)):
            total = add(total, self.vector(step_vector(parent, child), f"point {child.name}"))
        return total

    def held(self, slip: Sequence[Node]) -> bool:
        """Whether a velocity is zero at least where the constraints of the model hold."""
        if self.zero(slip):
            return True
        parts, build = self.parts, self.build
        places = [self.node(one, "constraint") for one in parts.holonomic]
        forms = [*tangent(places, self.time_rates())]
        forms += [self.node(one, "constraint") for one in parts.motion]
        speeds = [self.node(u, "") for u in parts.u]
        speeds = [u for u in speeds if build.operations[u.number] == INPUT]
        filter_ = Residues(build)

        def rows(nodes: Sequence[Node]) -> list[list[Node]]:
            found = coefficients(nodes, speeds)
            rests = remainder(build, nodes, speeds)
            return [[*f, r] for f, r in zip(found, rests, strict=True)]

        if not forms:
            return False
        table = rows(forms)
        return filter_.rank([*table, *rows(slip)]) == filter_.rank(table)

    def offset(self, anchor: Point, body: Any, slip: Any) -> Vector:
        """The integral of w, component by component."""
        root, point = self.parts.frame, body.masscenter
        velocity = point._vel_dict[root]
        basis = self.basis(velocity, slip)
        way = point.pos_from(anchor)
        moving = velocity - way.dt(root) if way != 0 else velocity
        total = Vector(0)
        for letter, axis in zip(AXES, (basis.x, basis.y, basis.z), strict=True):
            direction = self.vector(axis, "")
            if not self.zero([dot(direction, slip)]):
                rate = moving.dot(axis)
                total += self.coordinate(f"{anchor.name}_{letter}", rate) * axis
        return total

    def basis(self, velocity: Vector, slip: Any) -> ReferenceFrame:
        """A fixed frame along an axis of which the anchor moves; else the inertial one."""
        root = self.parts.frame
        for frame in [frame for _, frame in velocity.args]:
            path = pairwise(frame_path(root, self.oriented(frame)))
            if frame not in self.turned and not functions_of(
                [relative_rotation(*step) for step in path]
            ):
                return frame
        return root


def _integral(slopes: Mapping[Expr, Expr]) -> Expr | None:
    """The function of coordinates whose rate is sum a_q q'; None where there is none."""
    plain = {q: Symbol(q.func.__name__, real=True) for q in slopes}
    left = {plain[q]: slope.xreplace(plain) for q, slope in slopes.items()}
    total = S.Zero
    for q, slope in left.items():
        rest = expand_mul(slope - total.diff(q))
        if operations(rest) > LARGEST_INTEGRAND:
            return None
        total += integrate(rest, q) if rest.has(q) else rest * q
    if total.has(Integral) or any(tidy(total.diff(q) - slope) for q, slope in left.items()):
        return None
    return total.xreplace({symbol: q for q, symbol in plain.items()})
