"""What a scene declares: its fields, its symbols, its vectors in the inertial frame.

q' = N(q) u + n(q, t)          (u = q' unless speeds are declared)
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise
from typing import Any

from sympy import Abs, Dummy, Expr, Matrix, Symbol, eye, linsolve, sign, sympify, zeros
from sympy.physics.vector import Point, ReferenceFrame, Vector

from mechanics.errors import SceneError
from mechanics.nearest import instead
from mechanics.scene.bodies import Body, RigidBody, inertia_entries
from mechanics.scene.conditions import Condition
from mechanics.scene.declared import scalar
from mechanics.scene.geometry import (
    Placed,
    components,
    frame_path,
    point_path,
    relative_rotation,
    step_vector,
)
from mechanics.scene.joints.joint import Joint
from mechanics.scene.joints.rope import Rope
from mechanics.scene.loads import Coulomb, Load
from mechanics.scene.outputs import Output
from mechanics.scene.reactions import Constraint, Reaction
from mechanics.scene.rotations import Rotation
from mechanics.scene.symbols import TIME, by_name, name_of, plain_symbol, plain_table, to_plain

REFUSE, DROP = "refuse", "drop"
"""What is done about redundant constraints."""


@dataclass(frozen=True, eq=False, repr=False)
class Declaration:
    """The data of a scene; `Scene` completes and validates it."""

    name: str
    frame: ReferenceFrame
    origin: Point
    coordinates: tuple[Expr, ...] = ()
    bodies: tuple[Body, ...] = ()
    loads: tuple[Load, ...] = ()
    reactions: tuple[Reaction, ...] = ()
    constraints: tuple[Constraint, ...] = ()
    inputs: tuple[Expr, ...] = ()
    speeds: tuple[tuple[Expr, Expr], ...] = ()
    definitions: Mapping[Symbol, Expr] = field(default_factory=dict)
    example: Mapping[str, float] = field(default_factory=dict)
    conditions: tuple[Condition, ...] = ()
    equilibria: tuple[Mapping[str, Any], ...] = ()
    rotations: tuple[Rotation, ...] = ()
    joints: tuple[Joint | Rope, ...] = ()
    plane: Vector | None = None
    outputs: Mapping[str, Output] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    redundant: str = REFUSE

    @cached_property
    def q(self) -> tuple[Symbol, ...]:
        """Generalized coordinates as plain symbols."""
        return tuple(plain_symbol(q) for q in self.coordinates)

    @cached_property
    def qd(self) -> tuple[Symbol, ...]:
        """Rates of the coordinates as plain symbols; the same symbols as `u` when u = q'."""
        return tuple(plain_symbol(q, 1) for q in self.coordinates)

    @cached_property
    def u(self) -> tuple[Symbol, ...]:
        """Generalized speeds as plain symbols."""
        if not self.speeds:
            return self.qd
        return tuple(plain_symbol(u) for u, _ in self.speeds)

    @cached_property
    def ud(self) -> tuple[Symbol, ...]:
        """Rates of the speeds as plain symbols."""
        if not self.speeds:
            return tuple(plain_symbol(q, 2) for q in self.coordinates)
        return tuple(plain_symbol(u, 1) for u, _ in self.speeds)

    @cached_property
    def coordinate_rates(self) -> dict[Symbol, Expr]:
        """q' = N u + n, by coordinate rate."""
        if not self.speeds:
            return {rate: rate for rate in self.qd}
        table = self._table
        known = {plain_symbol(q, 1): to_plain(rate, table, f"rate of {q}")
                 for rotation in self.rotations
                 for q, rate in zip(rotation.coordinates, rotation.rates, strict=True)}  # fmt: skip
        turning = {u for rotation in self.rotations for u in rotation.speeds}
        # A speed may have the name of a rate.
        unknown = {rate: Dummy(rate.name) for rate in self.qd if rate not in known}
        rows = [
            symbol - to_plain(definition, table, f"speed {u}").xreplace(unknown)
            for symbol, (u, definition) in zip(self.u, self.speeds, strict=True)
            if u not in turning
        ]
        (solution,) = linsolve(rows, *unknown.values()) if unknown else [()]
        known |= zip(unknown, solution, strict=True)
        return {rate: known[rate] for rate in self.qd}

    @cached_property
    def quaternions(self) -> frozenset[Symbol]:
        """Coordinates that are parts of quaternions, as plain symbols."""
        return frozenset(plain_symbol(q) for r in self.rotations for q in r.coordinates)

    @cached_property
    def norms(self) -> tuple[Expr, ...]:
        """The square of the norm of each quaternion, less 1; 0 at every state."""
        table = self._table
        return tuple(to_plain(r.square - 1, table, f"rotation {r.name}") for r in self.rotations)

    @cached_property
    def parameters(self) -> tuple[Symbol, ...]:
        """Free symbols that are no coordinate, speed or input, in order of their names."""
        known = {*self.q, *self.qd, *self.u, *self.ud, *self._table.values(), TIME}
        return tuple(sorted(self._symbols - known, key=by_name))

    @cached_property
    def explicit_time(self) -> bool:
        """Whether time itself is written somewhere: a table that turns as Omega t, for example."""
        return TIME in self._symbols

    @cached_property
    def _symbols(self) -> set[Symbol]:
        found: set[Symbol] = set()
        for expression in self._expressions():
            found |= expression.free_symbols
        return found

    @cached_property
    def input_symbols(self) -> tuple[Symbol, ...]:
        """Inputs as plain symbols."""
        return tuple(plain_symbol(f) for f in self.inputs)

    def plain(self, expression: Expr, where: str = "") -> Expr:
        """The expression in plain symbols, with q' and q'' written in q, u and u'."""
        result = to_plain(expression, self._table, where or self.name)
        result = self.pressed(result)
        if not self.speeds:
            return result
        return result.xreplace(self._second_rates).xreplace(self.coordinate_rates)

    def pressed(self, expression: Any) -> Any:
        """An expression or matrix where reactions press on which friction depends.

        There sign(N v) is sign(v).
        """
        if not self._pressing or not expression.has(sign, Abs):
            return expression
        back = {positive: symbol for symbol, positive in self._pressing.items()}
        return expression.xreplace(self._pressing).xreplace(back)

    def rates(self, expression: Expr) -> Expr:
        """The expression in plain symbols, with q' left as symbols of its own."""
        return to_plain(expression, self._table, self.name)

    def position(self, point: Point) -> Matrix:
        """3 x 1 position of a point from the origin, in the inertial frame, in plain symbols."""
        known = self._positions
        if point not in known:
            for parent, child in pairwise(point_path(self.origin, point)):
                if child not in known:
                    step = self.vector(step_vector(parent, child), f"point {child.name}")
                    known[child] = known[parent] + step
        return known[point].copy()

    def rotation(self, frame: ReferenceFrame) -> Matrix:
        """3 x 3 matrix R with v_inertial = R v_frame, in plain symbols."""
        known = self._rotations
        if frame not in known:
            for parent, child in pairwise(frame_path(self.frame, frame)):
                if child not in known:
                    where = f"frame {child.name}"
                    step = relative_rotation(parent, child).applyfunc(
                        lambda entry, where=where: self.plain(entry, where)
                    )
                    known[child] = known[parent] * step
        return known[frame].copy()

    def vector(self, vector: Vector, where: str = "") -> Matrix:
        """3 x 1 components of a vector in the inertial frame, in plain symbols."""
        total = zeros(3, 1)
        for frame, column in components(vector):
            plain = column.applyfunc(lambda entry: self.plain(entry, where))
            total += plain if frame == self.frame else self.rotation(frame) * plain
        return total

    def body(self, name: str) -> Body:
        """The body of that name."""
        for body in self.bodies:
            if body.name == name:
                return body
        raise SceneError(
            f"{self.name}: there is no body {name!r}:"
            f" {instead(name, [body.name for body in self.bodies], 'bodies')}"
        )

    def reaction(self, name: str) -> Reaction:
        """The reaction of that name."""
        for reaction in self.reactions:
            if reaction.name == name:
                return reaction
        declared = [reaction.name for reaction in self.reactions]
        raise SceneError(
            f"{self.name}: there is no reaction {name!r}: {instead(name, declared, 'reactions')}"
        )

    @property
    def unconstrained(self) -> bool:
        """Whether every state is admitted: no constraint holds, and no norm of a quaternion."""
        return not self.constraints and not self.rotations

    @property
    def degrees_of_freedom(self) -> int:
        """Number of independent speeds."""
        return len(self.u) - len(self.constraints)

    @cached_property
    def _table(self) -> dict[Expr, Symbol]:
        speeds = tuple(u for u, _ in self.speeds)
        return plain_table((*self.coordinates, *speeds, *self.inputs))

    @cached_property
    def _pressing(self) -> dict[Symbol, Symbol]:
        """Reactions on which friction depends, and positive symbols in place of them."""
        names = [load.normal for load in self.loads if isinstance(load, Coulomb)]
        return {Symbol(name, real=True): Dummy(name, positive=True) for name in names}

    @cached_property
    def _positions(self) -> dict[Point, Matrix]:
        """Positions of the points that were asked for, each worked out once from its parent's."""
        return {self.origin: zeros(3, 1)}

    @cached_property
    def _rotations(self) -> dict[ReferenceFrame, Matrix]:
        """Rotations of the frames that were asked for, each worked out once from its parent's."""
        return {self.frame: eye(3)}

    @cached_property
    def _second_rates(self) -> dict[Symbol, Expr]:
        """q'' in q, q', u and u'."""
        return {
            plain_symbol(q, 2): self._second_rate(qd)
            for q, qd in zip(self.coordinates, self.qd, strict=True)
        }

    def _second_rate(self, qd: Symbol) -> Expr:
        rate = self.coordinate_rates[qd]
        total = sympify(0)
        for symbol, derivative in (
            *zip(self.q, self.qd, strict=True),
            *zip(self.u, self.ud, strict=True),
        ):
            total += rate.diff(symbol) * derivative
        return total

    @cached_property
    def typed(self) -> tuple[tuple[str, Expr], ...]:
        """(where it stands, expression) for everything declared, as it was typed."""
        return tuple(self._typed_expressions())

    def _typed_expressions(self) -> Iterator[tuple[str, Expr]]:
        """(where it stands, expression) for everything declared, as it was typed."""
        placed = Placed(self.frame, self.origin)
        for body in self.bodies:
            where = f"body {body.name}"
            yield where, body.mass
            yield from ((where, e) for e in placed.point(body.centre))
            if isinstance(body, RigidBody):
                yield from ((where, e) for e in placed.frame(body.frame))
                yield from ((where, e) for e in inertia_entries(body))
        acting = [action for reaction in self.reactions for action in reaction.actions]
        for kind, parts in (("load", self.loads), ("reaction", acting)):
            for part in parts:
                for value in vars(part).values():
                    where = f"{kind} {part.name}"
                    if isinstance(value, Point):
                        yield from ((where, e) for e in placed.point(value))
                    elif isinstance(value, Vector):
                        yield from ((where, e) for e in placed.vector(value))
                    elif isinstance(value, Expr):
                        yield where, value
        yield from ((f"constraint {c.name}", c.expression) for c in self.constraints)
        for name, output in self.outputs.items():
            for value in vars(output).values():
                way: Iterator[Expr] = iter(())
                if isinstance(value, Point):
                    way = placed.point(value)
                elif isinstance(value, ReferenceFrame):
                    way = placed.frame(value)
                elif isinstance(value, Vector):
                    way = placed.vector(value)
                yield from ((f"output {name}", e) for e in way)
        for u, definition in self.speeds:
            where = f"speed {name_of(u)}"
            yield where, scalar(definition, f"{where}: its definition")

    def _expressions(self) -> list[Expr]:
        """Every expression of the scene, in plain symbols."""
        found = [self.plain(e, where) for where, e in self.typed]
        return [*found, *self.coordinate_rates.values()]
