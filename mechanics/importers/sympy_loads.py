"""Loads of one of SymPy's models: forces on points, couples on frames, gravity, potential energies.

(P, F)            a force on the body that carries P; none on a point at rest, where it does no
                  work: one that an auxiliary speed brings into evidence is a reaction
(C, m g) on all   gravity
V                 -dV/dq is its generalized force. What a load of the same body has exerted
                  already is counted once
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from sympy import Expr, Matrix, S, Symbol, linsolve, symbols
from sympy.physics.vector import Point, ReferenceFrame, Vector, dynamicsymbols

from mechanics.errors import SceneError
from mechanics.importers.sympy_copy import Copy
from mechanics.importers.sympy_model import Acting, Parts, is_rigid
from mechanics.importers.sympy_motion import functions_of
from mechanics.importers.sympy_reactions import Finder, Named
from mechanics.scene import Force, Gravity, Load, RigidBody, Scene, Torque
from mechanics.scene.attachment import moved_by, turning
from mechanics.scene.geometry import components
from mechanics.symbolic import tidy

AXES = "xyz"
ENERGY = "potential_"
"""Begins the names of loads that are gradients of potential energies."""


def bring(parts: Parts, copy: Copy, scene: Scene) -> tuple[tuple[Load, ...], tuple[Named, ...]]:
    """The loads of a scene, and forces that the model brings into evidence.

    Parameters
    ----------
    scene : Scene
        With everything but the loads.

    Raises
    ------
    SceneError
        For a load on a point or frame that no body carries, and a potential energy that no force
        is found for.
    """
    brought = _Loads(parts, copy, scene)
    found: list[Load] = []
    named: list[Named] = []
    for acting in parts.loads:
        found += brought.load(acting)
        named += brought.evidence(acting)
    found += brought.potentials(found)
    return tuple(_numbered(brought.with_gravity(found))), tuple(named)


@dataclass(frozen=True)
class _Loads:
    parts: Parts
    copy: Copy
    scene: Scene

    def load(self, acting: Acting) -> list[Load]:
        """The force or couple on the body that carries it."""
        if isinstance(acting.where, ReferenceFrame):
            return self.couple(acting)
        if not self.works(acting):
            return []
        point = self.copy.point(acting.where)
        on = None if point is None else self.carrier(point)
        if on is None and acting.where in self.copy.moved.carriers:
            on = self.copy.moved.carriers[acting.where].name
        if point is None or on is None:
            if point is not None and not moved_by(self.scene, None, point):
                return []
            raise SceneError(
                f"{acting.name} on point {acting.where.name}: no body carries that point: let it"
                " act on a point that is fixed in the frame of a body"
            )
        return [Force(f"{acting.name}_{on}", point, self.copy.vector(acting.vector), on)]

    def couple(self, acting: Acting) -> list[Load]:
        frame, vector = acting.where, self.copy.vector(acting.vector)
        bodies = {b.name: b for b in self.parts.bodies if is_rigid(b)}
        for name, body in bodies.items():
            if body.frame == frame:
                moving = any(name == one.name for one in self.scene.bodies)
                return [Torque(f"{acting.name}_{name}", vector, name)] if moving else []
        own = self.copy.turned(frame)
        for carrier in self.scene.bodies:
            if isinstance(carrier, RigidBody) and carrier.frame == own:
                return [Torque(f"{acting.name}_{carrier.name}", vector, carrier.name)]
        if not turning(self.scene.frame, own):
            return []
        for body in self.scene.bodies:
            if isinstance(body, RigidBody) and not turning(body.frame, own):
                return [Torque(f"{acting.name}_{body.name}", vector, body.name)]
        raise SceneError(
            f"{acting.name} on frame {frame.name}: no body turns with that frame: let it act on the"
            " frame of a body"
        )

    def works(self, acting: Acting) -> bool:
        """Whether its point moves when auxiliary speeds are zero."""
        velocity = acting.where._vel_dict.get(self.parts.frame)
        if velocity is None:
            return True
        resting = dict.fromkeys(self.parts.auxiliary, S.Zero)
        return any(
            entry.xreplace(resting) != 0 for _, column in components(velocity) for entry in column
        )

    def evidence(self, acting: Acting) -> list[Named]:
        """Unknown forces on a point that only auxiliary speeds move."""
        if isinstance(acting.where, ReferenceFrame) or self.works(acting):
            return []
        velocity = acting.where._vel_dict[self.parts.frame]
        held = functions_of([column for column, _ in velocity.args])
        point = self.copy.point(acting.where)
        if point is None or held.isdisjoint(self.parts.auxiliary):
            return []
        found = []
        for frame, column in components(acting.vector):
            for axis, entry in enumerate(column):
                if isinstance(entry, Symbol) or entry in functions_of([entry]):
                    name = entry.name if isinstance(entry, Symbol) else entry.func.__name__
                    found.append(Named(name, point, self.copy.turned(frame), axis))
        return found

    def carrier(self, point: Point) -> str | None:
        """The body of which a point stays where it is."""
        centred = [body.name for body in self.scene.bodies if body.centre == point]
        if centred:
            return centred[0]
        for body in self.scene.bodies:
            if isinstance(body, RigidBody):
                carried = not moved_by(self.scene, body.name, point)
            else:
                gap = self.scene.position(point) - self.scene.position(body.centre)
                carried = not any(map(tidy, gap))
            if carried:
                return body.name
        return None

    # ------------------------------------------------------------------ potential energies

    def potentials(self, loads: Sequence[Load]) -> list[Load]:
        """What potential energies exert and no load does."""
        parts, own = self.parts, []
        given = {b.name: self.plain(b.potential_energy) for b in parts.bodies}
        total = sum(given.values(), S.Zero)
        if parts.energy is not None:
            rates = {q.diff(dynamicsymbols._t): S.Zero for q in parts.q}
            energy = -self.plain(parts.energy.xreplace(rates))
            if any(tidy((energy - total).diff(q)) != 0 for q in self.scene.q):
                given, total = {}, energy
                own = self.exerted("", energy)
        for name, energy in given.items():
            if not any(energy.diff(q) != 0 for q in self.scene.q):
                continue
            wanted = [-energy.diff(q) for q in self.scene.q]
            if not any(self.same(wanted, load) for load in loads):
                own += self.exerted(name, energy)
        return own

    def plain(self, expression: Expr) -> Expr:
        return self.scene.plain(self.copy.scalar(expression), "potential energy")

    def same(self, wanted: Sequence[Expr], load: Load) -> bool:
        """Whether a load has these generalized forces."""
        if not isinstance(load, Force):
            return False
        place, force = self.scene.position(load.at), self.scene.vector(load.vector)
        own = [place.diff(q).dot(force) for q in self.scene.q]
        return all(tidy(a - b) == 0 for a, b in zip(wanted, own, strict=True))

    def exerted(self, name: str, energy: Expr) -> list[Load]:
        """The forces of a potential energy: gravity, or others that have its power."""
        q = self.scene.q
        bodies = [b for b in self.scene.bodies if not name or b.name == name]
        field = symbols("field_x field_y field_z", cls=Symbol, real=True)
        column = Matrix(field)
        rows = []
        for one in q:
            pulled = sum(
                (b.mass * self.scene.position(b.centre).diff(one).dot(column) for b in bodies),
                S.Zero,
            )
            rows.append(tidy(energy.diff(one) + pulled))
        if pull := _uniform(rows, field, q):
            vector = sum(
                (p * e for p, e in zip(pull, _axes(self.scene.frame), strict=True)), Vector(0)
            )
            return [Force(f"{ENERGY}{b.name}", b.centre, b.mass * vector, b.name) for b in bodies]
        return self.dual(name, energy)

    def dual(self, name: str, energy: Expr) -> list[Load]:
        """Forces and couples, each of which does work on one speed alone."""
        if self.scene.speeds:
            raise SceneError(
                f"potential energy of {name or self.parts.kind}: it is not that of gravity: give"
                " the forces as loads"
            )
        finder, found = Finder(self.scene), list[Load]()
        back = dict(zip(self.scene.q, self.scene.coordinates, strict=True))
        for k, q in enumerate(self.scene.q):
            slope = energy.diff(q)
            if slope == 0:
                continue
            own = finder.dual(k, name or None) or finder.dual(k)
            if own is None:
                raise SceneError(
                    f"potential energy of {name or self.parts.kind}: no force of a body does work"
                    f" on {q} alone: give the forces as loads"
                )
            one, sign = own
            vector = (-sign * slope).xreplace(back) * one.along
            title = f"{ENERGY}{name or 'L'}_{q}"
            if one.point is None:
                found.append(Torque(title, vector, one.on, one.by))
            else:
                found.append(Force(title, one.point, vector, one.on, one.by))
        return found

    # ------------------------------------------------------------------ gravity

    def with_gravity(self, loads: Sequence[Load]) -> list[Load]:
        """One uniform field in place of the forces m g on all bodies."""
        pulls: dict[str, tuple[int, Matrix]] = {}
        for k, load in enumerate(loads):
            body = next((b for b in self.scene.bodies if b.name == getattr(load, "on", "")), None)
            if body is None or body.name in pulls or body.mass == 0:
                continue
            if isinstance(load, Force) and load.at == body.centre and load.by is None:
                field = (self.scene.vector(load.vector) / body.mass).applyfunc(tidy)
                if not field.free_symbols & {*self.scene.q, *self.scene.u, *body.mass.free_symbols,
                                             *self.scene.input_symbols}:  # fmt: skip
                    pulls[body.name] = k, field
        massive = {body.name for body in self.scene.bodies if body.mass != 0}
        fields = [field for _, field in pulls.values()]
        if not pulls or pulls.keys() != massive or any(f != fields[0] for f in fields):
            return [*loads]
        gone = {k for k, _ in pulls.values()}
        axes = zip(fields[0], _axes(self.scene.frame), strict=True)
        vector = sum((size * axis for size, axis in axes if size != 0), Vector(0))
        energies = all(loads[k].name.startswith(ENERGY) for k in gone)
        pull = Gravity(vector, f"{ENERGY}gravity" if energies else "gravity")
        return [pull, *(load for k, load in enumerate(loads) if k not in gone)]


def _uniform(rows: Sequence[Expr], field: Sequence[Symbol], q: Sequence[Symbol]) -> list[Expr]:
    """The constant field for which all rows vanish; empty where there is none."""
    points = [{one: S(3 * k + 2 * j + 1) / (7 + k) for j, one in enumerate(q)} for k in range(4)]
    equations = [row.subs(point) for row in rows for point in points]
    for solution in linsolve([e for e in equations if e != 0] or [S.Zero], *field):
        values = [value.subs(dict.fromkeys(field, S.Zero)) for value in solution]
        put = dict(zip(field, map(tidy, values), strict=True))
        if not any(tidy(row.xreplace(put)) for row in rows):
            return list(put.values())
    return []


def _axes(frame: ReferenceFrame) -> tuple[Vector, Vector, Vector]:
    return frame.x, frame.y, frame.z


def _numbered(loads: Sequence[Load]) -> list[Load]:
    """Names that differ."""
    found: list[Load] = []
    taken: set[str] = set()
    for load in loads:
        name, number = load.name, 2
        while name in taken:
            name, number = f"{load.name}_{number}", number + 1
        taken.add(name)
        found.append(load if name == load.name else replace(load, name=name))
    return found
