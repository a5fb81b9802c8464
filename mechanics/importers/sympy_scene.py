"""A model of SymPy's as a scene.

positions           as the model places points and frames; from velocities where it places none
speeds              u, by q' = N u + n; q' where the model has none
constraints         holonomic ones, and of the others those that do not follow from them
loads               as declared; gravity and potential energies once
reactions           of the joints, or what coordinates and constraints leave no freedom
"""

import re
from collections.abc import Mapping, Sequence, Set
from dataclasses import replace
from typing import Any

from sympy import Derivative, Expr, Matrix, S, Symbol
from sympy.physics.vector import Dyadic, ReferenceFrame, Vector, dynamicsymbols

from mechanics.errors import SceneError
from mechanics.importers.sympy_copy import Copy
from mechanics.importers.sympy_loads import bring
from mechanics.importers.sympy_model import Parts, is_rigid, read_model
from mechanics.importers.sympy_motion import functions_of, place
from mechanics.importers.sympy_reactions import Finder, Joined, declared
from mechanics.kinematics import chain
from mechanics.mechanism import lower
from mechanics.program.builder import Builder
from mechanics.program.forward import tangent
from mechanics.program.residues import Residues
from mechanics.program.sympy_reader import read
from mechanics.routes.rows import coefficients
from mechanics.scene import (
    Body,
    Constraint,
    Particle,
    RigidBody,
    Scene,
    holonomic,
    nonholonomic,
    reaction,
)
from mechanics.scene.geometry import Movers
from mechanics.scene.symbols import plain_table, to_plain
from mechanics.symbolic import tidy


def from_sympy(model: Any, *, name: str = "", bodies: Sequence[Any] = ()) -> Scene:
    """A `System`, a `KanesMethod` or a `LagrangesMethod` of SymPy's as a scene.

    Constants without assumptions become real parameters, masses and principal moments of inertia
    positive ones. The model itself stays as it is.

    Parameters
    ----------
    model : System, KanesMethod or LagrangesMethod
        Of `sympy.physics.mechanics`.
    name : str, optional
        Of the scene.
    bodies : sequence of RigidBody and Particle, optional
        Of a method that was made without.

    Returns
    -------
    Scene
        With the reactions of its joints, by name and direction (``J1_x``, ``J1_my``); of a model
        without joints those are declared that coordinates and constraints hold, named after body
        and direction.

    Raises
    ------
    SceneError
        Where the model leaves out what a scene needs, or contradicts itself.

    Examples
    --------
    >>> from sympy import symbols
    >>> from sympy.physics.mechanics import Particle, PinJoint, RigidBody, System
    >>> ground, bob = RigidBody("ground"), RigidBody("bob", mass=symbols("m"))
    >>> system = System.from_newtonian(ground)
    >>> system.add_joints(PinJoint("pin", ground, bob, child_point=symbols("l") * bob.y))
    >>> from_sympy(system)
    <scene system: 1 body, 1 coordinate, 0 constraints>
    """
    parts = read_model(model, bodies)
    return _Made(parts, name or re.sub(r"\W", "", parts.kind.split(" ")[0]).lower()).scene()


class _Made:
    """The steps from the parts of a model to a scene, each from what those before have found."""

    def __init__(self, parts: Parts, name: str) -> None:
        self.parts, self.name = parts, name
        self.moved = place(parts)
        self.resting = dict.fromkeys(parts.auxiliary, S.Zero)
        self.copy = Copy(parts.frame, self.moved, _massive(parts))
        self.copy.all_points()
        self.idle: set[str] = set()
        self.bodies = self._bodies()
        self.rates = {
            self.copy.scalar(q): self.copy.scalar(rate.xreplace(self.resting))
            for q, rate in {**parts.rates, **self.moved.rates}.items()
        }

    def scene(self) -> Scene:
        speeds, rolling = self._speeds()
        parts = self.parts
        new = tuple(rate.expr for rate in self.moved.rates)
        bare = Scene(
            self.name,
            self.copy.frame,
            self.copy.origin,
            coordinates=(*parts.q, *new),
            speeds=speeds,
            bodies=self.bodies,
            inputs=self._inputs(new),
        )
        bare = replace(bare, bodies=_working(bare, self.idle))
        constraints = self._constraints(bare, rolling)
        stands = [Constraint(c.name, c.expression, (f"_{c.name}",), c.holonomic)
                  for c in constraints]  # fmt: skip
        stand_ins = tuple(
            reaction(f"_{c.name}", bare.origin, bare.bodies[0].name, None, bare.frame.x)
            for c in constraints
        )
        held = replace(bare, constraints=tuple(stands), reactions=stand_ins)
        loads, named = bring(parts, self.copy, held)
        held = replace(held, loads=loads)
        finder = Finder(held, self._joints(held), named)
        reactions, maintaining = declared(finder)
        return replace(
            held,
            reactions=reactions,
            constraints=tuple(
                replace(constraint, reactions=(own,))
                for constraint, own in zip(constraints, maintaining, strict=True)
            ),
        )

    def _bodies(self) -> tuple[Body, ...]:
        """The bodies that move; what does not is the ground."""
        found: list[Body] = []
        movers = Movers(self.copy.frame, self.copy.origin)
        for body in self.parts.bodies:
            centre = self.copy.points[body.masscenter]
            mass = self.copy.scalar(body.mass)
            functions = movers.point(centre)
            if is_rigid(body):
                functions |= movers.frame(self.copy.turned(body.frame))
            if not functions:
                continue
            name = body.name or f"body{len(found) + 1}"
            if any(name == other.name for other in found):
                name = f"{name}{len(found) + 1}"
            if self._idle(body):
                self.idle.add(name)
            if not is_rigid(body):
                rod = self._rod(body)
                found.append(
                    Particle(name, centre, mass)
                    if rod is None
                    else RigidBody(name, centre, self.copy.turned(rod), mass, Dyadic(0))
                )
            else:
                frame = self.copy.turned(body.frame)
                found.append(RigidBody(name, centre, frame, mass, self.copy.inertia(body)))
        return tuple(found)

    def _idle(self, body: Any) -> bool:
        if body.mass != 0 or (is_rigid(body) and body.central_inertia != 0):
            return False
        own = {body.masscenter, body.frame} if is_rigid(body) else {body.masscenter}
        return not any(load.where in own for load in self.parts.loads)

    def _rod(self, body: Any) -> ReferenceFrame | None:
        """The frame of a massless rod that carries a particle, where a couple acts on that rod."""
        given = {other.frame for other in self.parts.bodies if is_rigid(other)}
        steps = body.masscenter._pos_dict.values()
        near = [frame for vector in steps for _, frame in vector.args if len(vector.args) == 1]
        acting = [load.where for load in self.parts.loads]
        return next((f for f in near if f in acting and f not in given), None)

    def _inputs(self, new: Sequence[Expr]) -> tuple[Expr, ...]:
        """Functions of time that are neither coordinates nor speeds."""
        parts = self.parts
        known = {*parts.q, *parts.u, *parts.auxiliary, *new}
        found: set[Expr] = set()
        for body in parts.bodies:
            for vector in body.masscenter._pos_dict.values():
                found |= functions_of([column for column, _ in vector.args])
        found |= functions_of([*parts.holonomic, *parts.motion, *self.rates.values()])
        for load in parts.loads:
            velocity = getattr(load.where, "_vel_dict", {}).get(parts.frame, Vector(0))
            # What an auxiliary speed brings into evidence is an unknown.
            if functions_of([c for c, _ in velocity.args]).isdisjoint(parts.auxiliary):
                found |= functions_of([column for column, _ in load.vector.args])
        return tuple(sorted(found - known, key=str))

    # ------------------------------------------------------------------ speeds

    def _speeds(self) -> tuple[tuple[tuple[Expr, Expr], ...], dict[Expr, Expr]]:
        """(speed, definition) of each, and rates that are motion constraints, by the rate."""
        u = [one for one in self.parts.u if not isinstance(one, Derivative)]
        if not self.parts.rates or not u:
            return (), dict(self.moved.rates and self.rates)
        rates = list(self.rates)
        slopes = Matrix([self.rates[rate] for rate in rates]).jacobian(u)
        kept = _independent(slopes, self.parts)
        if len(kept) < len(u):
            still = [k for k in range(len(u)) if not any(slopes[:, k])] or range(len(u))
            raise SceneError(
                f"{self.parts.kind}: {u[next(iter(still))]} moves nothing: no rate of a coordinate"
                " and no velocity of a body holds it"
            )
        rows = [self.rates[rates[k]] for k in kept]
        rest = Matrix(rows).xreplace(dict.fromkeys(u, S.Zero))
        square = slopes.extract(kept, list(range(len(u))))
        right = Matrix([rates[k] for k in kept]) - rest
        solved = _solve(square, right)
        speeds = list(zip(u, solved, strict=True))
        rolling = {}
        for k, rate in enumerate(rates):
            if k not in kept:
                speed = dynamicsymbols(f"{rate.expr.func.__name__}_dot")
                speeds.append((speed, rate))
                rolling[rate] = self.rates[rate]
        return tuple(speeds), rolling

    # ------------------------------------------------------------------ constraints

    def _constraints(self, bare: Scene, rolling: Mapping[Expr, Expr]) -> tuple[Constraint, ...]:
        """Those of the model that do not follow from those before them."""
        given = [holonomic(f"constraint{k}", self._expression(e))
                 for k, e in enumerate(self.parts.holonomic, 1)]  # fmt: skip
        given += [nonholonomic(f"{rate.expr.func.__name__}_rate", rate - value)
                  for rate, value in rolling.items()]  # fmt: skip
        given += [nonholonomic(f"motion{k}", self._expression(e))
                  for k, e in enumerate(self.parts.motion, 1)]  # fmt: skip
        if not given:
            return ()
        holding = [c for c in given if c.holonomic]
        stand_ins = tuple(
            reaction(f"_{c.name}", bare.origin, bare.bodies[0].name, None, bare.frame.x)
            for c in holding
        )
        stated = tuple(replace(c, reactions=(f"_{c.name}",)) for c in holding)
        mechanism = lower(replace(bare, constraints=stated, reactions=stand_ins), Builder())
        nodes = [
            read(mechanism.builder, (bare.plain(c.expression, f"constraint {c.name}"),))[0]
            for c in given
        ]
        forms = [
            tangent([node], mechanism.rates)[0] if c.holonomic else node
            for c, node in zip(given, nodes, strict=True)
        ]
        _, filter_ = mechanism.filters
        rows = [filter_.values(row) for row in coefficients(forms, mechanism.u)]
        independent = {k for k, _ in filter_.eliminate([[*row] for row in rows], len(rows[0]))}
        return tuple(c for k, c in enumerate(given) if k in independent)

    def _expression(self, expression: Expr) -> Expr:
        return self.copy.scalar(expression.xreplace(self.resting))

    # ------------------------------------------------------------------ joints

    def _joints(self, scene: Scene) -> tuple[Joined, ...]:
        centres = {body.centre: body.name for body in self.bodies}
        left_out = {body.name for body in self.bodies} - {body.name for body in scene.bodies}
        found = []
        for joint in self.parts.joints:
            child, parent = (
                centres.get(self.copy.point(body.masscenter))
                for body in (joint.child, joint.parent)
            )
            if {child, parent} & left_out:
                continue
            point = self.copy.point(joint.child_point)
            frame = joint.parent_interframe
            if child is None:
                child, parent = parent, None
            if child is not None and point is not None:
                found.append(Joined(joint.name, parent, child, point, self.copy.turned(frame)))
        return tuple(found)


def _working(scene: Scene, idle: Set[str]) -> tuple[Body, ...]:
    """The bodies without those that have neither mass nor load, where the others move as much."""
    if not idle:
        return scene.bodies
    mechanism = lower(scene, Builder())
    motions = chain.motions(mechanism)
    kept = [body for body in mechanism.bodies if body.name not in idle]
    entries = [entry for body in kept for entry in motions.points[body.centre].velocity]
    for body in kept:
        if body.frame is not None:
            entries += motions.frames[body.frame].omega
    if not entries:
        return scene.bodies
    filter_, _ = mechanism.filters
    if filter_.rank(coefficients(entries, mechanism.u)) < len(mechanism.u):
        return scene.bodies
    return tuple(body for body in scene.bodies if body.name not in idle)


def _solve(square: Matrix, right: Matrix) -> list[Expr]:
    """By Cramer's rule, which divides by nothing but the determinant."""
    if square.is_diagonal():
        return [r / square[k, k] for k, r in enumerate(right)]
    known = functions_of([square, right])
    # SymPy does not see that sin^2 + cos^2 - 1 is zero; the table has rates first.
    table = dict(reversed(plain_table(sorted(known, key=str)).items()))
    back = {symbol: entry for entry, symbol in table.items()}
    square, right = (part.xreplace(table) for part in (square, right))
    scale = tidy(square.det(method="berkowitz"))
    solved = [tidy(entry / scale) for entry in square.adjugate() * right]
    return [entry.xreplace(back) for entry in solved]


def _independent(matrix: Matrix, parts: Parts) -> list[int]:
    """Rows that are independent of those before them."""
    functions = sorted(functions_of([matrix]), key=str)
    table = plain_table(functions)
    build = Builder()
    rows = [
        list(read(build, [to_plain(entry, table, parts.kind) for entry in matrix[k, :]]))
        for k in range(matrix.rows)
    ]
    filter_ = Residues(build)
    values = [filter_.values(row) for row in rows]
    return sorted(k for k, _ in filter_.eliminate(values, matrix.cols))


def _massive(parts: Parts) -> set[Expr]:
    """Masses and principal moments of inertia that are symbols of their own."""
    found = {body.mass for body in parts.bodies}
    for body in parts.bodies:
        if is_rigid(body):
            found |= {size for size, one, two in body.central_inertia.args if one == two}
    return {entry for entry in found if isinstance(entry, Symbol)}
