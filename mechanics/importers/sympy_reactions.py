"""Reactions of a model that declares none: what coordinates and constraints leave no freedom.

    w . V = sum_k r_k u_k            power of a unit wrench w on the velocities of isolated bodies
    r = 0                            an ideal reaction, of a joint                              (1)
    r in the row space of A          ideal where A u + a = 0 holds, and maintains it            (2)
    number of them = freedoms of the isolated bodies - independent speeds

Candidates are unit forces at points of the scene along axes of its frames, and couples about these,
between two bodies or a body and the ground. They are tried at one point of a field, on the
constraints; that the chosen ones are ideal and complete is checked of every scene before it is
derived. Where they are too few, candidates are put together, with powers r_i as formulas:

    sum_i c_i r_i = 0, or A_k        w = sum_i c_i w_i                                          (3)

So the force on a bead is along the normal of its curve, and that of a rope pulls at both ends.
"""

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial

from sympy import Dummy, Expr, Matrix, S, linsolve, sqrt, zeros
from sympy.physics.vector import Point, ReferenceFrame, Vector, dynamicsymbols

from mechanics.errors import SceneError
from mechanics.importers.sympy_motion import linked
from mechanics.kinematics import chain
from mechanics.kinematics.motion import body_motions
from mechanics.mechanism import Mechanism, lower
from mechanics.program.builder import Builder
from mechanics.routes.directions import used_directions
from mechanics.routes.loads import applied
from mechanics.routes.rows import coefficients, velocity_forms
from mechanics.scene import Body, Output, Scene, orientation, position
from mechanics.scene.bodies import RigidBody
from mechanics.scene.geometry import frame_path, point_path
from mechanics.scene.rates import rate, rate_table
from mechanics.scene.reactions import Reaction
from mechanics.symbolic import tidy

AXES = "xyz"
Row = list[int]


@dataclass(frozen=True)
class Candidate:
    """A unit force at a point, or a couple without one; `name` where the model has one."""

    on: str
    by: str | None
    point: Point | None
    frame: ReferenceFrame
    axis: int
    name: str = ""

    @property
    def along(self) -> Vector:
        """Unit vector."""
        return (self.frame.x, self.frame.y, self.frame.z)[self.axis]


@dataclass(frozen=True)
class Joined:
    """A joint that the model declares: where its reactions are looked for first."""

    name: str
    parent: str | None
    child: str
    point: Point
    frame: ReferenceFrame


@dataclass(frozen=True)
class Named:
    """A force that the model brings into evidence: its name, its point, its axis."""

    name: str
    point: Point
    frame: ReferenceFrame
    axis: int


@dataclass(frozen=True)
class Found:
    """Reactions: `alone` and `ideal` of joints, `maintaining` and `together` by constraint."""

    alone: list[Candidate]
    maintaining: list[Candidate | None]
    ideal: list[list[tuple[Expr, Candidate]]]
    together: dict[int, list[tuple[Expr, Candidate]]]


class Finder:
    """Velocities of a scene at one point of a field.

    Parameters
    ----------
    scene : Scene
        With loads and constraints; the reactions that these name stand for those that are found.
    """

    def __init__(
        self, scene: Scene, joints: Sequence[Joined] = (), named: Sequence[Named] = ()
    ) -> None:
        self.scene, self.joints, self.named = scene, joints, named
        ends = [end for joint in joints for end in (joint.point, joint.frame)]
        ends += [end for one in named for end in (one.point, one.frame)]
        self.points = [scene.origin, *(p for p in ends if isinstance(p, Point))]
        self.frames = [scene.frame, *(f for f in ends if isinstance(f, ReferenceFrame))]
        for body in scene.bodies:
            self.points += point_path(scene.origin, body.centre)
            for vector in body.centre._pos_dict.values():
                self.frames += [frame for _, frame in vector.args]
            if isinstance(body, RigidBody):
                self.frames += frame_path(scene.frame, body.frame)
        self.points = list(dict.fromkeys([*self.points, *linked(scene.origin)]))
        self.frames = list(dict.fromkeys(self.frames))
        self._lower()

    def _lower(self) -> None:
        scene = self.scene
        outputs: dict[str, Output] = {
            f"point{i}": position(point) for i, point in enumerate(self.points)
        }
        outputs |= {f"frame{i}": orientation(frame) for i, frame in enumerate(self.frames)}
        mechanism = lower(replace(scene, outputs=outputs), Builder())
        anywhere, self.filter = mechanism.filters
        motions = chain.motions(mechanism)
        u = mechanism.u
        self.size = len(u)
        places = {o.name: o for o in mechanism.outputs}
        self.places = {
            point: self.filter.values(motions.poses.positions[places[f"point{i}"].point])
            for i, point in enumerate(self.points)
        }
        self.axes = {}
        for i, frame in enumerate(self.frames):
            matrix = motions.poses.rotations[places[f"frame{i}"].frame]
            flat = self.filter.values([matrix[r][c] for c in range(3) for r in range(3)])
            self.axes[frame] = [flat[3 * k : 3 * k + 3] for k in range(3)]
        none = [[0] * 3 for _ in range(self.size)]
        self.velocity: dict[str | None, list[Row]] = {None: none}
        self.turning: dict[str | None, list[Row]] = {None: none}
        self.centre: dict[str | None, Row] = {None: [0, 0, 0]}
        for body, mass in zip(scene.bodies, mechanism.bodies, strict=True):
            point = motions.points[mass.centre]
            self.velocity[body.name] = self._partial(mechanism, point.velocity)
            self.centre[body.name] = self.filter.values(point.position)
            if mass.frame is not None:
                turning = self._partial(mechanism, motions.frames[mass.frame].omega)
                # Without a couple the equations of moments of what does not turn are left out.
                if self.joints or any(map(any, turning)):
                    self.turning[body.name] = turning
        forms = velocity_forms(mechanism)
        self.rows = [self.filter.values(row) for row in coefficients(forms, u)]
        bodies = body_motions(mechanism, motions)
        used = used_directions(anywhere, bodies, applied(mechanism, motions))
        self.used = (used.translation, used.rotation)
        if self.joints:
            self.used = ((0, 1, 2), (0, 1, 2))

    def _partial(self, mechanism: Mechanism, vector: Sequence) -> list[Row]:
        """Partial velocities, speed by speed."""
        flat = [self.filter.values(row) for row in coefficients(vector, mechanism.u)]
        return [[flat[k][i] for k in range(3)] for i in range(self.size)]

    @cached_property
    def slots(self) -> list[tuple[str, str, int]]:
        """Freedoms of the isolated bodies: body, kind and direction."""
        found = []
        for body in self.scene.bodies:
            found += [(body.name, "force", i) for i in self.used[0]]
            if body.name in self.turning:
                found += [(body.name, "couple", i) for i in self.used[1]]
        return found

    # ------------------------------------------------------------------ one candidate

    def wrench(self, one: Candidate) -> Row | None:
        """What it does to each freedom; None where it leaves the directions that are in use."""
        prime, axis = self.filter.prime, self.axes[one.frame][one.axis]
        found: dict[tuple[str, str, int], int] = {}
        for body, sign in ((one.on, 1), (one.by, -1)):
            if body is None:
                continue
            force, couple = ([0, 0, 0], axis) if one.point is None else (axis, [0, 0, 0])
            if one.point is not None and body in self.turning:
                couple = _cross(_minus(self.places[one.point], self.centre[body]), axis)
            if body not in self.turning:
                if one.point is None:
                    return None
                couple = [0, 0, 0]
            for kind, vector in (("force", force), ("couple", couple)):
                for i, entry in enumerate(vector):
                    if entry % prime:
                        found[body, kind, i] = sign * entry % prime
        if not found or not found.keys() <= {*self.slots}:
            return None
        return [found.get(slot, 0) for slot in self.slots]

    def power(self, one: Candidate) -> Row:
        """r, its power on a unit of each speed."""
        prime, axis = self.filter.prime, self.axes[one.frame][one.axis]
        found = []
        for k in range(self.size):
            total = 0
            for body, sign in ((one.on, 1), (one.by, -1)):
                if one.point is None:
                    moved = self.turning[body][k]
                else:
                    moved = self.velocity[body][k]
                    if body in self.turning and body is not None:
                        arm = _minus(self.places[one.point], self.centre[body])
                        moved = _plus(moved, _cross(self.turning[body][k], arm))
                total += sign * _dot(moved, axis)
            found.append(total % prime)
        return found

    # ------------------------------------------------------------------ the search

    def candidates(self) -> Iterator[Candidate]:
        """Joints first, then what is named, then every pair of bodies, near ones first."""
        for joint in self.joints:
            for point in (joint.point, None):
                for k in range(3):
                    word = f"{joint.name}_{'' if point else 'm'}{AXES[k]}"
                    yield Candidate(joint.child, joint.parent, point, joint.frame, k, word)
        for one in self.named:
            for body in self.scene.bodies:
                yield Candidate(body.name, None, one.point, one.frame, one.axis, one.name)
        for body in self.scene.bodies:
            for by in self._neighbours(body):
                yield from self._between(body, by)

    def _neighbours(self, body: Body) -> list[str | None]:
        """Bodies on the way to a body, the nearest first, the ground, and then all before it."""
        way = point_path(self.scene.origin, body.centre)[::-1][1:]
        frames: tuple[ReferenceFrame, ...] = ()
        if isinstance(body, RigidBody):
            frames = frame_path(self.scene.frame, body.frame)[::-1][1:]
        others = [other for other in self.scene.bodies if other is not body]
        near = [o.name for point in way for o in others if o.centre == point]
        near += [
            o.name for f in frames for o in others if isinstance(o, RigidBody) and o.frame == f
        ]
        before = [o.name for o in self.scene.bodies[: self.scene.bodies.index(body)]]
        return list(dict.fromkeys([*near, None, *before]))

    def _between(self, body: Body, by: str | None) -> Iterator[Candidate]:
        way = list(point_path(self.scene.origin, body.centre))[::-1]
        points = list(dict.fromkeys([*way[1:], way[0], *self.points]))
        frames = self.frames
        if isinstance(body, RigidBody):
            frames = [*frame_path(self.scene.frame, body.frame)[::-1], *self.frames]
        else:
            points = [body.centre]
        frames = list(dict.fromkeys(frames))
        for point in (*points, None):
            for frame in frames:
                for k in range(3):
                    yield Candidate(body.name, by, point, frame, k)

    def find(self) -> Found:
        """The reactions.

        Raises
        ------
        SceneError
            When they cannot be found.
        """
        wanted = len(self.slots) - (self.size - len(self.rows))
        chosen: list[Candidate] = []
        basis = _Basis(self.filter.prime)
        candidates = [(one, w) for one in self.candidates() if (w := self.wrench(one)) is not None]
        kept: list[tuple[Candidate, Row]] = []
        held, maintained = _Basis(self.filter.prime), _Basis(self.filter.prime)
        for row in self.rows:
            held.add(row)
        tests: tuple[Callable[[Row], bool], ...] = (
            lambda row: not any(row),
            lambda row: not held.independent(row) and maintained.independent(row),
            lambda row: not held.independent(row),
        )
        for admitted in tests:
            for one, wrench in candidates:
                if len(chosen) == wanted:
                    break
                row = self.power(one)
                if admitted(row) and basis.add(wrench):
                    chosen.append(one)
                    maintained.add(row)
                    if any(row):
                        kept.append((one, row))
        maintaining = self._paired(kept)
        if None in maintaining:
            # What is a combination of several constraints may be that of those that are missing.
            maintaining = [
                one if one is not None and self._along(self.power(one), row) else None
                for one, row in zip(maintaining, self.rows, strict=True)
            ]
        alone = [one for one in chosen if not any(self.power(one))]
        missing = [k for k, one in enumerate(maintaining) if one is None]
        if not missing:
            alone = [one for one in chosen if one not in maintaining]
        left = wanted - len(alone) - len(self.rows)
        found = Found(alone, maintaining, [], {})
        if missing or left:
            # What the joints do not span, and does work: on few speeds at first.
            fresh = _Basis(self.filter.prime)
            for one, wrench in candidates:
                if one in alone:
                    fresh.add(wrench)
            candidates.sort(key=lambda pair: sum(map(bool, self.power(pair[0]))))
            others = [one for one, wrench in candidates if fresh.add(wrench)]
            powers = [self.power_of(one) for one in others]
            for k in missing:
                found.together[k] = self.solution(others, powers, k)
            for combination in Matrix(powers).T.nullspace()[:left] if powers else ():
                found.ideal.append(_weighted(combination, others))
            if len(found.ideal) < left:
                raise SceneError(
                    f"{self.scene.name}: reactions for {left - len(found.ideal)} of the {wanted}"
                    " directions that coordinates and constraints hold were not found"
                )
        return found

    def power_of(self, one: Candidate) -> list[Expr]:
        """r as formulas, in plain symbols."""
        along, total = self.scene.vector(one.along), [S.Zero] * self.size
        moving = partial(rate, table=rate_table(self.scene))
        for body, sign in ((one.on, 1), (one.by, -1)):
            if body is None:
                continue
            own = self.scene.body(body)
            centre = self.scene.position(own.centre)
            moved = zeros(3, 1)
            if one.point is not None:
                moved = centre.applyfunc(moving)
            if body in self.turning and isinstance(own, RigidBody):
                turn = self.scene.rotation(own.frame)
                skew = turn.applyfunc(moving) * turn.T
                omega = Matrix([skew[2, 1], skew[0, 2], skew[1, 0]])
                arm = None if one.point is None else self.scene.position(one.point) - centre
                moved = omega if arm is None else moved + omega.cross(arm)
            power = sign * moved.dot(along)
            total = [t + power.diff(u) for t, u in zip(total, self.scene.u, strict=True)]
        return [tidy(entry) for entry in total]

    def solution(
        self, others: Sequence[Candidate], powers: Sequence[Sequence[Expr]], k: int
    ) -> list[tuple[Expr, Candidate]]:
        """Candidates whose powers add up to the rate of a constraint."""
        constraint = self.scene.constraints[k]
        form = constraint.expression
        if constraint.holonomic:
            form = form.diff(dynamicsymbols._t)
        plain = self.scene.plain(form, f"constraint {constraint.name}")
        wanted = Matrix([plain.diff(u) for u in self.scene.u])
        weights = [Dummy() for _ in others]
        rows = list(Matrix(powers).T * Matrix(weights) - wanted) if powers else [S.One]
        for solved in linsolve(rows, *weights):
            return _weighted(solved.xreplace(dict.fromkeys(weights, S.Zero)), others)
        raise SceneError(
            f"constraint {constraint.name}: the force that maintains it was not found: no forces at"
            " points of the model have its power"
        )

    def _paired(self, kept: Sequence[tuple[Candidate, Row]]) -> list[Candidate | None]:
        """For each constraint a reaction whose power is its rate, or holds it."""
        basis, independent = _Basis(self.filter.prime), []
        # What is proportional to one constraint comes first.
        kept = sorted(kept, key=lambda pair: not any(self._along(pair[1], r) for r in self.rows))
        for pair in kept:
            if basis.add(pair[1]):
                independent.append(pair)
        found: list[Candidate | None] = [None] * len(self.rows)
        for k, row in enumerate(self.rows):
            for pair in independent:
                if self._along(pair[1], row):
                    found[k] = pair[0]
                    independent.remove(pair)
                    break
        for k, one in enumerate(found):
            if one is None and independent:
                found[k] = independent.pop(0)[0]
        return found

    def _along(self, one: Row, two: Row) -> bool:
        basis = _Basis(self.filter.prime)
        basis.add(one)
        return not basis.independent(two)

    def dual(self, speed: int, on: str | None = None) -> tuple[Candidate, int] | None:
        """A unit force or couple whose power is one speed, and the sign of that power."""
        prime = self.filter.prime
        bodies = [b for b in self.scene.bodies if on is None or b.name == on]
        for body in bodies:
            for by in self._neighbours(body):
                for one in self._between(body, by):
                    if self.wrench(one) is None:
                        continue
                    row = self.power(one)
                    others = [entry for k, entry in enumerate(row) if k != speed and entry]
                    if not others and row[speed] in (1, prime - 1):
                        return one, 1 if row[speed] == 1 else -1
        return None


class _Basis:
    """Rows modulo a prime, eliminated as they come."""

    def __init__(self, prime: int) -> None:
        self.prime = prime
        self.rows: list[tuple[int, Row]] = []

    def reduced(self, row: Row) -> Row:
        row = [entry % self.prime for entry in row]
        for column, pivot in self.rows:
            if factor := row[column]:
                row = [(a - factor * b) % self.prime for a, b in zip(row, pivot, strict=True)]
        return row

    def independent(self, row: Row) -> bool:
        return any(self.reduced(row))

    def add(self, row: Row) -> bool:
        """Whether it is independent of those before it."""
        left = self.reduced(row)
        column = next((k for k, entry in enumerate(left) if entry), None)
        if column is None:
            return False
        inverse = pow(left[column], -1, self.prime)
        self.rows.append((column, [entry * inverse % self.prime for entry in left]))
        return True


def declared(finder: Finder) -> tuple[tuple[Reaction, ...], tuple[str, ...]]:
    """The reactions of a scene, and the name of the one that maintains each constraint.

    Raises
    ------
    SceneError
        When they cannot be found.
    """
    found, scene = finder.find(), finder.scene
    taken = {constraint.name for constraint in scene.constraints}
    taken |= {s.name for s in (*scene.q, *scene.u, *scene.qd, *scene.parameters)}
    taken |= {symbol.name for symbol in scene.input_symbols}
    reactions, names = [], []
    for one in found.alone:
        name = _free(one.name or _name(one), taken)
        reactions.append(Reaction(name, one.on, one.by, one.along, one.point))
    for parts in found.ideal:
        name = _free(f"{parts[0][1].on}_normal", taken)
        reactions.append(_together(scene, name, parts))
    for k, own in enumerate(found.maintaining):
        constraint = scene.constraints[k].name
        names.append(_free(own.name if own and own.name else f"{constraint}_force", taken))
        parts = found.together[k] if own is None else [(S.One, own)]
        reactions.append(_together(scene, names[-1], parts))
    return tuple(reactions), tuple(names)


def _weighted(
    weights: Iterable[Expr], candidates: Sequence[Candidate]
) -> list[tuple[Expr, Candidate]]:
    pairs = zip(map(tidy, weights), candidates, strict=True)
    return [(weight, one) for weight, one in pairs if weight != 0]


def _together(scene: Scene, name: str, parts: Sequence[tuple[Expr, Candidate]]) -> Reaction:
    """Equation (3) as one reaction: what acts at one place is one vector."""
    back = dict(zip(scene.q, scene.coordinates, strict=True))
    places: dict[tuple[str, str | None, Point | None], Vector] = {}
    for weight, one in parts:
        key = (one.on, one.by, one.point)
        places[key] = places.get(key, Vector(0)) + weight.xreplace(back) * one.along
    actions = [Reaction(name, on, by, along, at) for (on, by, at), along in places.items()]
    # One with a constant lever comes first, and counts the force.
    actions.sort(key=lambda action: len(scene.vector(action.along).free_symbols))
    first = scene.vector(actions[0].along)
    length = sqrt(tidy(first.dot(first))).xreplace(back)
    actions = [replace(action, along=action.along / length) for action in actions]
    return replace(actions[0], parts=tuple(actions[1:]))


def _name(one: Candidate) -> str:
    by = f"_{one.by}" if one.by else ""
    return f"{one.on}{by}_{'' if one.point else 'm'}{AXES[one.axis]}"


def _free(name: str, taken: set[str]) -> str:
    """A name that nothing has, and that is taken from now on."""
    plain = re.sub(r"\W", "_", name)
    number, free = 2, plain
    while free in taken:
        free, number = f"{plain}{number}", number + 1
    taken.add(free)
    return free


def _cross(a: Row, b: Row) -> Row:
    return [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]


def _dot(a: Row, b: Row) -> int:
    return sum(x * y for x, y in zip(a, b, strict=True))


def _minus(a: Row, b: Row) -> Row:
    return [x - y for x, y in zip(a, b, strict=True)]


def _plus(a: Row, b: Row) -> Row:
    return [x + y for x, y in zip(a, b, strict=True)]
