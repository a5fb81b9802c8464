"""A scene as nodes of a program, lowered once.

Everything that a scene declares by frames, points, vectors and expressions becomes nodes of one
builder: symbols and their rates, steps between frames and points, masses and inertias, loads,
reactions, constraints. Routes, recursions and checks read this, and never the scene again.

    r = sum over the steps to a point of R_F c_F        (c_F: components of a step in the frame F)
    q' = N(q) u + n(q, t)
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from typing import Any

import sympy
from sympy.physics.vector import Dyadic
from sympy.physics.vector import Point as SympyPoint
from sympy.physics.vector import ReferenceFrame as SympyFrame
from sympy.physics.vector import Vector as SympyVector

from mechanics.closure import Closure, close
from mechanics.errors import SceneError
from mechanics.kernel import Range
from mechanics.nearest import plural
from mechanics.program.builder import Builder, Node
from mechanics.program.forward import tangent
from mechanics.program.operations import INPUT
from mechanics.program.program import reachable
from mechanics.program.residues import Residues
from mechanics.program.sympy_reader import read
from mechanics.program.vectors import Matrix, Vector
from mechanics.scene import (
    Body,
    Coulomb,
    Damper,
    Force,
    Gravity,
    Orientation,
    Position,
    RigidBody,
    Scene,
    Spring,
    Torque,
    TorsionSpring,
)
from mechanics.scene import Output as Declared
from mechanics.scene.geometry import (
    components,
    dyadic_matrix,
    frame_path,
    point_path,
    relative_rotation,
    step_vector,
)
from mechanics.scene.rates import TIME
from mechanics.scene.rotations import rotation_between
from mechanics.scene.symbols import DOTS, plain_symbol
from mechanics.scene.topology import tree

GROUND = -1

Mixed = tuple[tuple[int, Vector], ...]
"""A vector in the frames in which it was given: (frame, components) to be added."""


@dataclass(frozen=True)
class Turn:
    """A rotation about an axis that is fixed in both frames: v_parent = R(axis, angle) v_child."""

    axis: Vector
    angle: Node


@dataclass(frozen=True)
class Spin:
    """A rotation by a quaternion.

    Attributes
    ----------
    coordinates : four Nodes
        The scalar part first.
    rates : four Nodes
        In the coordinates and the speeds.
    omega : Vector
        The speeds: angular velocity relative to the parent, in the frame itself.
    """

    coordinates: tuple[Node, ...]
    rates: tuple[Node, ...]
    omega: Vector


@dataclass(frozen=True)
class Frame:
    """One step in the tree of frames.

    Attributes
    ----------
    parent : int
        Index of the frame that it is oriented in; GROUND for the inertial frame itself.
    rotation : 3 x 3
        R with v_parent = R v_frame.
    turn : Turn or None
        Where it turns about a coordinate axis; None for other and for fixed rotations.
    spin : Spin or None
        Where a quaternion turns it.
    """

    name: str
    parent: int
    rotation: Matrix
    turn: Turn | None
    spin: Spin | None = None


@dataclass(frozen=True)
class Place:
    """One step in the tree of points: the point lies at `step` from its parent, in m."""

    name: str
    parent: int
    step: Mixed


@dataclass(frozen=True)
class Mass:
    """A body.

    Attributes
    ----------
    centre : int
        Its mass centre, a point.
    frame : int or None
        Fixed in the body; None for a particle.
    mass : Node
        In kg.
    inertia : 3 x 3 or None
        About the mass centre, in the body's frame, in kg m^2; None for a particle. A scalar of
        the scene is that multiple of the unit matrix: in a plane only the product with the normal
        counts.
    scalar : bool
        Whether the scene gives a scalar.
    """

    name: str
    centre: int
    frame: int | None
    mass: Node
    inertia: Matrix | None
    scalar: bool = False


@dataclass(frozen=True)
class Field:
    """Uniform gravity, an acceleration in m/s^2."""

    name: str
    acceleration: Mixed


@dataclass(frozen=True)
class Line:
    """A spring or damper between two points: tension = stiffness (d - length) + coefficient d'.

    `along` is a fixed direction from first to second; None: d is the distance of the points.
    `first` and `second` are points, `by` and `on` the bodies that carry them, GROUND for none.
    """

    name: str
    first: int
    second: int
    by: int
    on: int
    along: Mixed | None
    stiffness: Node
    length: Node
    coefficient: Node


@dataclass(frozen=True)
class Push:
    """A force at a point (`at`) or a couple (at None) on body `on`, the opposite on body `by`."""

    name: str
    on: int
    by: int
    at: int | None
    vector: Mixed


@dataclass(frozen=True)
class Torsion:
    """A torsion spring: couple -stiffness angle along `axis` on body `on`, the opposite on `by`.

    `typed` is its angle and axis as the scene has them.
    """

    name: str
    on: int
    by: int
    axis: Mixed
    angle: Node
    stiffness: Node
    typed: tuple[str, str]


@dataclass(frozen=True)
class Friction:
    """Coulomb friction: -coefficient N sign(sliding) along `along`, N the unknown reaction.

    `typed` is its sliding velocity and direction as the scene has them.
    """

    name: str
    reaction: int
    along: Mixed
    sliding: Node
    coefficient: Node
    typed: tuple[str, str]


@dataclass(frozen=True)
class Reaction:
    """A unit of an unknown force (at a point) or couple (at None) on `on`, the opposite on `by`."""

    name: str
    on: int
    by: int
    at: int | None
    along: Mixed
    parts: tuple[Reaction, ...] = ()

    @property
    def actions(self) -> tuple[Reaction, ...]:
        """All that the unknown does, here and at other places."""
        return (self, *self.parts)


@dataclass(frozen=True)
class Constraint:
    """``expression = 0``, of coordinates, or linear in speeds; `reactions` maintain it."""

    name: str
    expression: Node
    holonomic: bool
    reactions: tuple[int, ...]


@dataclass(frozen=True)
class Output:
    """What the scene wants computed.

    Attributes
    ----------
    name : str
    kind : str
        ``"position"``, ``"rotation"`` or ``"velocity"``.
    basis : int
        Frame of the components; 0, the inertial one, unless another is declared.
    point : int
        Of a position or velocity; 0, the origin, of a rotation.
    frame : int
        Of a rotation; 0 of others.
    on : int or None
        Body with which the point moves; None for the point itself.
    along : Mixed or None
        Direction of a scalar velocity.
    """

    name: str
    kind: str
    basis: int
    point: int = 0
    frame: int = 0
    on: int | None = None
    along: Mixed | None = None


@dataclass(frozen=True, repr=False)
class Mechanism:
    """A scene as nodes.

    Attributes
    ----------
    builder : Builder
        Holds every node below; whoever lowered the scene made it.
    q, qd, qdd : tuples of Node
        Coordinates and their rates as inputs of their own.
    u, ud : tuples of Node
        Speeds and their rates; the same nodes as qd and qdd where u = q'.
    q_rates : tuple of Node
        q' = N u + n, in q, u and t.
    given_rates : mapping of Node to Node
        Rates of inputs and their derivatives, and of t.
    frames : tuple of Frame
        Parents first; the inertial frame is the first.
    points : tuple of Place
        Parents first; the origin is the first.
    parents : tuple of int
        Inboard neighbour of each body in the tree of bodies, or GROUND.
    order : tuple of int
        Bodies, parents before children.
    fields, lines, pushes, torsions, frictions : tuples
        The loads by kind.
    joints : tuple of tuples of int
        Reactions between each body and its parent.
    signs : mapping of str to str
        What is declared of inputs: ``"positive"``, ``"nonnegative"``.
    closure : Closure
        Where the constraints hold.
    """

    name: str
    builder: Builder
    q: tuple[Node, ...]
    qd: tuple[Node, ...]
    qdd: tuple[Node, ...]
    u: tuple[Node, ...]
    ud: tuple[Node, ...]
    q_rates: tuple[Node, ...]
    given_rates: Mapping[Node, Node]
    frames: tuple[Frame, ...]
    points: tuple[Place, ...]
    bodies: tuple[Mass, ...]
    parents: tuple[int, ...]
    order: tuple[int, ...]
    fields: tuple[Field, ...]
    lines: tuple[Line, ...]
    pushes: tuple[Push, ...]
    torsions: tuple[Torsion, ...]
    frictions: tuple[Friction, ...]
    reactions: tuple[Reaction, ...]
    joints: tuple[tuple[int, ...], ...]
    constraints: tuple[Constraint, ...]
    signs: Mapping[str, str]
    closure: Closure
    outputs: tuple[Output, ...]

    def __repr__(self) -> str:
        return (
            f"<mechanism {self.name}: {plural(len(self.bodies), 'body')},"
            f" {plural(len(self.q), 'coordinate')}, {plural(len(self.constraints), 'constraint')}>"
        )

    @property
    def rates(self) -> dict[Node, Node]:
        """Rate of every node that changes: q' = N u + n, u', inputs, t."""
        table = dict(zip(self.q, self.q_rates, strict=True))
        table.update(zip(self.u, self.ud, strict=True))
        return {**table, **self.given_rates}

    @property
    def coordinate_rates(self) -> dict[Node, Node]:
        """The same with q' and q'' as inputs of their own, whatever the speeds are."""
        table = dict(zip(self.q, self.qd, strict=True))
        table.update(zip(self.qd, self.qdd, strict=True))
        return {**table, **self.given_rates}

    @property
    def filters(self) -> tuple[Residues, Residues]:
        """Filters for what is zero at all states, and for what is where the constraints hold.

        No pivot may be zero where the constraints hold. One filter is both without constraints.
        """
        closure = self.closure
        anywhere = Residues(self.builder, begin=closure.choice)
        if not closure:
            return anywhere, anywhere
        return anywhere, Residues(self.builder, closure.values, closure.choice)

    @property
    def multipliers(self) -> tuple[int, ...]:
        """Reactions that maintain constraints, in the order of the constraints."""
        return tuple(r for constraint in self.constraints for r in constraint.reactions)

    def subtree(self, body: int) -> tuple[int, ...]:
        """A body and everything outboard of it, in tree order."""
        inside = {body}
        for other in self.order:
            if self.parents[other] in inside:
                inside.add(other)
        return tuple(other for other in self.order if other in inside)


def lower(scene: Scene, builder: Builder) -> Mechanism:
    """The scene as nodes of a builder.

    Raises
    ------
    SceneError
        When it cannot be told which body carries the point of a load.
    ExpressionError
        For an expression that the language does not know.
    """
    return _Lowering(scene, builder).mechanism()


class _Lowering:
    """The tables that grow while a scene is read."""

    def __init__(self, scene: Scene, builder: Builder) -> None:
        self.scene, self.builder = scene, builder
        self.frames: list[Frame] = []
        self.points: list[Place] = []
        self.of_frame: dict[SympyFrame, int] = {}
        self.of_point: dict[SympyPoint, int] = {}
        self.of_body = {body.name: i for i, body in enumerate(scene.bodies)}
        one, zero = builder.one, builder.zero
        unit = tuple(tuple(one if i == j else zero for j in range(3)) for i in range(3))
        self.frames.append(Frame(scene.frame.name, GROUND, unit, None))
        self.of_frame[scene.frame] = 0
        self.points.append(Place(scene.origin.name, GROUND, ()))
        self.of_point[scene.origin] = 0

    def mechanism(self) -> Mechanism:
        scene, read = self.scene, self.read
        bodies = tuple(self.body(body) for body in scene.bodies)
        spanning = tree(scene)
        reactions = tuple(self.reaction(reaction) for reaction in scene.reactions)
        place = {reaction.name: i for i, reaction in enumerate(scene.reactions)}
        second = [plain_symbol(q, 2) for q in scene.coordinates]
        number = self.of_body
        parents = [number.get(spanning.parent[body.name], GROUND) for body in scene.bodies]
        fields, lines, pushes, torsions, frictions = self.loads(place)
        mechanism = Mechanism(
            scene.name,
            self.builder,
            q=tuple(map(read, scene.q)),
            qd=tuple(map(read, scene.qd)),
            qdd=tuple(map(read, second)),
            u=tuple(map(read, scene.u)),
            ud=tuple(map(read, scene.ud)),
            q_rates=tuple(read(scene.coordinate_rates[rate]) for rate in scene.qd),
            given_rates=self.given_rates(),
            frames=(),
            points=(),
            bodies=bodies,
            parents=tuple(parents),
            order=tuple(number[name] for name in spanning.order),
            fields=fields,
            lines=lines,
            pushes=pushes,
            torsions=torsions,
            frictions=frictions,
            reactions=reactions,
            joints=tuple(
                tuple(place[reaction.name] for reaction in spanning.joints[body.name])
                for body in scene.bodies
            ),
            constraints=tuple(
                Constraint(
                    constraint.name,
                    self.expression(constraint.expression, f"constraint {constraint.name}"),
                    constraint.holonomic,
                    tuple(place[name] for name in constraint.reactions),
                )
                for constraint in scene.constraints
            ),
            signs=signs(scene),
            closure=Closure(),
            outputs=tuple(self.output(*item) for item in scene.outputs.items()),
        )
        # Frames and points are complete when everything that mentions them was read.
        return replace(
            mechanism,
            frames=tuple(self.frames),
            points=tuple(self.points),
            closure=self.closure(mechanism),
        )

    def closure(self, mechanism: Mechanism) -> Closure:
        """Where the constraints hold, on the component of the example and the typical values."""
        scene = self.scene
        if not scene.constraints and not scene.norms:
            return Closure()
        configuration = [c.expression for c in mechanism.constraints if c.holonomic]
        configuration += map(self.read, scene.norms)
        motion = [c.expression for c in mechanism.constraints if not c.holonomic]
        suggested = {name: Fraction(str(value)) for name, value in scene.example.items()}
        suggested |= {
            p.name: p.typical for p in scene.parameters if getattr(p, "typical", None) is not None
        }
        # What drives a constraint by itself may have any value.
        suggested |= {name_of(node): Fraction(1) for node in mechanism.given_rates}
        names = [name_of(node) for node in reversed(mechanism.u)]
        names += [symbol.name for symbol in scene.parameters]
        names += [name_of(node) for node in mechanism.q]
        return close(
            self.builder,
            configuration,
            [*tangent(configuration, mechanism.rates), *motion],
            names,
            mechanism.q,
            suggested,
            ranges(mechanism),
        )

    def read(self, expression: sympy.Expr) -> Node:
        (node,) = read(self.builder, (expression,))
        return node

    def expression(self, expression: sympy.Expr, where: str) -> Node:
        return self.read(self.scene.plain(expression, where))

    def given_rates(self) -> dict[Node, Node]:
        table = {self.builder.input(TIME.name): self.builder.one}
        for function in self.scene.inputs:
            symbols = [plain_symbol(function, order) for order in range(len(DOTS))]
            for symbol, rate in pairwise(symbols):
                table[self.read(symbol)] = self.read(rate)
        return table

    # ------------------------------------------------------------------ geometry

    def frame(self, frame: SympyFrame) -> int:
        for parent, child in pairwise(frame_path(self.scene.frame, frame)):
            if child not in self.of_frame:
                where = f"frame {child.name}"
                step = relative_rotation(parent, child).applyfunc(
                    lambda entry, where=where: self.scene.plain(entry, where)
                )
                rotation = tuple(tuple(map(self.read, step[i, :])) for i in range(3))
                self.of_frame[child] = len(self.frames)
                parts = self.turn(step), self.spin(parent, child)
                self.frames.append(Frame(child.name, self.of_frame[parent], rotation, *parts))
        return self.of_frame[frame]

    def spin(self, parent: SympyFrame, child: SympyFrame) -> Spin | None:
        rotation = rotation_between(self.scene.rotations, parent, child)
        if rotation is None:
            return None
        groups, where = (rotation.coordinates, rotation.rates, rotation.speeds), rotation.name
        return Spin(*(tuple(self.expression(e, where) for e in group) for group in groups))

    def turn(self, step: sympy.Matrix) -> Turn | None:
        recognised = axis_angle(step)
        if recognised is None:
            return None
        axis, angle = recognised
        return Turn(tuple(map(self.read, axis)), self.read(angle))

    def point(self, point: SympyPoint) -> int:
        for parent, child in pairwise(point_path(self.scene.origin, point)):
            if child not in self.of_point:
                step = self.vector(step_vector(parent, child), f"point {child.name}")
                self.of_point[child] = len(self.points)
                self.points.append(Place(child.name, self.of_point[parent], step))
        return self.of_point[point]

    def vector(self, vector: SympyVector, where: str) -> Mixed:
        return tuple(
            (self.frame(frame), tuple(self.expression(entry, where) for entry in column))
            for frame, column in components(vector)
        )

    # ------------------------------------------------------------------ bodies and loads

    def body(self, body: Body) -> Mass:
        where = f"body {body.name}"
        mass, centre = self.expression(body.mass, where), self.point(body.centre)
        if not isinstance(body, RigidBody):
            return Mass(body.name, centre, None, mass, None)
        if isinstance(body.inertia, Dyadic):
            matrix = dyadic_matrix(body.inertia, body.frame)
            rows = tuple(
                tuple(self.expression(entry, where) for entry in matrix[i, :]) for i in range(3)
            )
        else:
            about, zero = self.expression(body.inertia, where), self.builder.zero
            rows = tuple(tuple(about if i == j else zero for j in range(3)) for i in range(3))
        scalar = not isinstance(body.inertia, Dyadic)
        return Mass(body.name, centre, self.frame(body.frame), mass, rows, scalar)

    def reaction(self, reaction: Any) -> Reaction:
        return Reaction(
            reaction.name,
            self.of_body[reaction.on],
            GROUND if reaction.by is None else self.of_body[reaction.by],
            None if reaction.at is None else self.point(reaction.at),
            self.vector(reaction.along, reaction.name),
            tuple(map(self.reaction, reaction.parts)),
        )

    def output(self, name: str, declared: Declared) -> Output:
        basis = 0 if declared.in_ is None else self.frame(declared.in_)
        if isinstance(declared, Orientation):
            return Output(name, "rotation", basis, frame=self.frame(declared.frame))
        point = self.point(declared.point)
        if isinstance(declared, Position):
            return Output(name, "position", basis, point)
        along = None if declared.along is None else self.vector(declared.along, f"output {name}")
        on = None if declared.on is None else self.of_body[declared.on]
        return Output(name, "velocity", basis, point, on=on, along=along)

    def loads(
        self, place: Mapping[str, int]
    ) -> tuple[
        tuple[Field, ...],
        tuple[Line, ...],
        tuple[Push, ...],
        tuple[Torsion, ...],
        tuple[Friction, ...],
    ]:
        """The loads by kind."""
        fields: list[Field] = []
        lines: list[Line] = []
        pushes: list[Push] = []
        torsions: list[Torsion] = []
        frictions: list[Friction] = []
        for load in self.scene.loads:
            where = f"load {load.name}"
            if isinstance(load, Gravity):
                fields.append(Field(load.name, self.vector(load.field, where)))
            elif isinstance(load, Spring | Damper):
                lines.append(self.line(load, where))
            elif isinstance(load, Force | Torque):
                pushes.append(self.push(load, where))
            elif isinstance(load, TorsionSpring):
                axis = self.vector(load.axis, where)
                angle, stiffness = (self.expression(e, where) for e in (load.angle, load.stiffness))
                on, by = self.of_body[load.on], self.named(load.by)
                typed = str(load.angle), str(load.axis)
                torsions.append(Torsion(load.name, on, by, axis, angle, stiffness, typed))
            elif isinstance(load, Coulomb):
                along = self.vector(load.along, where)
                sliding, mu = (self.expression(e, where) for e in (load.sliding, load.coefficient))
                typed = str(load.sliding), str(load.along)
                frictions.append(Friction(load.name, place[load.normal], along, sliding, mu, typed))
            else:
                raise SceneError(f"load {load!r}: it is none of the loads of mechanics.scene.loads")
        return tuple(fields), tuple(lines), tuple(pushes), tuple(torsions), tuple(frictions)

    def named(self, body: str | None) -> int:
        return GROUND if body is None else self.of_body[body]

    def line(self, load: Spring | Damper, where: str) -> Line:
        zero = self.builder.zero
        stiffness = length = coefficient = zero
        if isinstance(load, Spring):
            stiffness, length = (self.expression(e, where) for e in (load.stiffness, load.length))
        else:
            coefficient = self.expression(load.coefficient, where)
        by = self.carrier(load.first, load.first_on, where, "first_on")
        on = self.carrier(load.second, load.second_on, where, "second_on")
        if by == on == GROUND:
            raise SceneError(
                f"{where}: both ends are on the ground, where it does nothing: name the bodies with"
                " first_on= and second_on="
            )
        along = None if load.along is None else self.vector(load.along, where)
        first, second = self.point(load.first), self.point(load.second)
        return Line(load.name, first, second, by, on, along, stiffness, length, coefficient)

    def push(self, load: Force | Torque, where: str) -> Push:
        vector = self.vector(load.vector, where)
        if isinstance(load, Torque):
            return Push(load.name, self.of_body[load.on], self.named(load.by), None, vector)
        at = self.point(load.at)
        on = self.carrier(load.at, load.on, where, "on")
        if on == GROUND:
            raise SceneError(f"force {load.name}: it acts on the ground, where it does nothing")
        return Push(load.name, on, self.named(load.by), at, vector)

    def carrier(self, point: SympyPoint, stated: str | None, where: str, title: str) -> int:
        """The body that carries a point; GROUND for the ground and for supports moved by hand."""
        if stated is not None:
            return self.of_body[stated]
        centred = [i for i, body in enumerate(self.scene.bodies) if body.centre == point]
        if len(centred) == 1:
            return centred[0]
        if not centred and not self.moves(self.point(point)):
            return GROUND
        raise SceneError(
            f"{where}: it is unclear which body carries point {point.name}: name it with {title}="
        )

    def moves(self, point: int) -> bool:
        """Whether a coordinate stands in the position of a point."""
        coordinates = {self.read(q) for q in self.scene.q}
        nodes: list[Node] = []
        while point != GROUND:
            for frame, column in self.points[point].step:
                nodes += column
                while frame != GROUND:
                    nodes += [entry for row in self.frames[frame].rotation for entry in row]
                    frame = self.frames[frame].parent
            point = self.points[point].parent
        return bool(coordinates & inputs_of(nodes))


def inputs_of(nodes: Iterable[Node]) -> set[Node]:
    """The inputs that nodes are computed from."""
    listed = list(nodes)
    if not listed:
        return set()
    builder = listed[0].builder
    numbers = reachable(builder, [node.number for node in listed])
    return {Node(builder, n) for n in numbers if builder.operations[n] == INPUT}


def name_of(node: Node) -> str:
    """The name of an input."""
    return node.builder.inputs[node.builder.operands[0][node.number]]


def ranges(mechanism: Mechanism) -> dict[str, Range]:
    """What the scene declares of the inputs, as the kernel takes it."""
    words = {"positive": Range.POSITIVE, "nonnegative": Range.NONNEGATIVE}
    return {name: words[sign] for name, sign in mechanism.signs.items()}


def signs(scene: Scene) -> dict[str, str]:
    """What the parameters of a scene are declared to be."""
    table = {}
    for symbol in scene.parameters:
        if symbol.is_positive:
            table[symbol.name] = "positive"
        elif symbol.is_nonnegative:
            table[symbol.name] = "nonnegative"
    return table


def axis_angle(step: sympy.Matrix) -> tuple[sympy.Matrix, sympy.Expr] | None:
    """(axis, angle) of a rotation about a coordinate axis by a variable angle; None for others."""
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        if step[k, k] != 1:
            continue
        angles = sorted({f.args[0] for f in step.atoms(sympy.sin, sympy.cos)}, key=str)
        for angle in angles:
            for signed in (angle, -angle):
                c, s = sympy.cos(signed), sympy.sin(signed)
                turn = sympy.eye(3)
                turn[i, i], turn[j, j], turn[i, j], turn[j, i] = c, c, -s, s
                if turn == step:
                    return sympy.Matrix([int(n == k) for n in range(3)]), signed
    return None
