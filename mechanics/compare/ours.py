"""Our numbers for a scene, and for the scene with the changes that other engines make.

    tau = rows(q, v, a; masses + dm, inertias + dI, gravity + dg) + A a + b v + c sign(v)  (1)
    M e_j = tau(q, 0, e_j) - tau(q, 0, 0)           bias = tau(q, v, 0)                    (2)
    J e_j = velocity(q, e_j) - velocity(q, 0)                                              (3)
    M a + C^T l = f - bias,   C a = c               where constraints hold                 (4)
    A v = (m v_G, H_G)        A' its rate           G the mass centre of all bodies        (5)

All changes are inputs of one program: the scene is derived once, and a changed scene is other
numbers in it.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from mechanics.checks.admissible import check_scene
from mechanics.checks.agreement import compare as same_motion
from mechanics.checks.agreement import linear_system
from mechanics.compare.change import NOTHING, Array, Change, changeable, inputs, loads
from mechanics.errors import InputError, ValueMissingError
from mechanics.kernel import Finding
from mechanics.kinematics import chain
from mechanics.kinematics.energy import HALF, kinetic_energies
from mechanics.kinematics.motion import body_motions
from mechanics.mechanism import Mass, Mechanism, name_of
from mechanics.program import Program
from mechanics.program.builder import Node
from mechanics.program.forward import tangent
from mechanics.program.interpret import interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.program.vectors import add, cross, scale, times, zeros
from mechanics.routes import kane, lagrange
from mechanics.routes.loads import potential
from mechanics.routes.rows import acceleration_forms, coefficients, remainder
from mechanics.scene import Orientation, Output, Position, Scene
from mechanics.scene.joints import Joint

AXES = "xyz"
FRAME = "compared_frame_"
"""Begins the names of outputs that this module adds to a scene."""


@dataclass(frozen=True, eq=False)
class Ours:
    """A scene as numbers; see `of_scene`.

    Attributes
    ----------
    scene : Scene
    mechanism : Mechanism
        With inputs for the changes.
    values : mapping of str to float
        Of the parameters.
    """

    scene: Scene
    mechanism: Mechanism
    values: Mapping[str, float]

    @property
    def labels(self) -> tuple[str, ...]:
        """Of the speeds: the coordinate of which one is the rate, or its own name."""
        rates = dict(zip(self.scene.qd, self.scene.q, strict=True))
        return tuple(rates.get(symbol, symbol).name for symbol in self.scene.u)

    @property
    def speeds(self) -> tuple[str, ...]:
        """Names of the speeds."""
        return tuple(symbol.name for symbol in self.scene.u)

    @property
    def loads(self) -> tuple[str, ...]:
        """Names of the loads but gravity."""
        return tuple(load.name for load in loads(self.mechanism))

    def coordinate(self, speed: int) -> int:
        """Index of the coordinate whose rate is a speed.

        Raises
        ------
        InputError
            For a speed that is no rate.
        """
        own = self.scene.u[speed]
        if own not in self.scene.qd:
            raise InputError(f"{self.scene.name}: speed {own} is the rate of no coordinate")
        return self.scene.qd.index(own)

    @cached_property
    def frames(self) -> dict[str, tuple[int | None, int | None]]:
        """Point and frame in the mechanism of everything that has a Jacobian, by name."""
        found: dict[str, tuple[int | None, int | None]] = {}
        known = {output.name: output for output in self.mechanism.outputs}
        for place, name in enumerate(carried(self.scene)):
            ends = known[f"{FRAME}{place}_position"], known[f"{FRAME}{place}_orientation"]
            found[name] = ends[0].point, ends[1].frame
        for name, output in known.items():
            if name.startswith(FRAME) or output.basis or output.kind == "velocity":
                continue
            found[name] = (
                (output.point, None) if output.kind == "position" else (None, output.frame)
            )
        return found

    @cached_property
    def _rows(self) -> Program:
        rows = kane.derive(self.mechanism)
        return self._program(
            {"rows": remainder(self.mechanism.builder, rows.values, rows.multipliers)}
        )

    @cached_property
    def _closing(self) -> Program:
        held = [c.expression for c in self.mechanism.constraints if c.holonomic]
        return self._program({"closing": acceleration_forms(self.mechanism), "held": held})

    @cached_property
    def _rates(self) -> Program:
        return self._program({"rates": self.mechanism.q_rates})

    @cached_property
    def _energy(self) -> Program:
        mechanism = self.mechanism
        parts = kinetic_energies(mechanism, mechanism.rates, HALF)
        kinetic = sum((part for body in parts for part in body), mechanism.builder.zero)
        stored = potential(mechanism, chain.motions(mechanism).poses)
        return self._program({"kinetic": [kinetic], "potential": [stored]})

    @cached_property
    def _momenta(self) -> Program:
        """Momentum over that about the origin, by the speeds; its rate; m r_G; the mass m."""
        mechanism = self.mechanism
        build, motions = mechanism.builder, chain.motions(mechanism)
        mass, moment, linear, angular = build.zero, zeros(build), zeros(build), zeros(build)
        for body, motion in zip(mechanism.bodies, body_motions(mechanism, motions), strict=True):
            momentum, at = scale(body.mass, motion.centre.velocity), motion.centre.position
            mass, moment = mass + body.mass, add(moment, scale(body.mass, at))
            linear, angular = add(linear, momentum), add(angular, cross(at, momentum))
            if motion.turning is not None and motion.inertia is not None:
                angular = add(angular, times(motion.inertia, motion.turning.omega))
        rows = coefficients([*linear, *angular], mechanism.u)
        entries = [entry for row in rows for entry in row]
        rates = tangent(entries, mechanism.rates)
        return self._program({"matrix": entries, "rate": rates, "moment": moment, "mass": [mass]})

    @cached_property
    def _motion(self) -> Program:
        """Velocities and poses of the named frames."""
        motions = chain.motions(self.mechanism)
        found: dict[str, Sequence[Node]] = {}
        for name, (point, frame) in self.frames.items():
            velocity: list[Node] = []
            if point is not None:
                velocity += motions.points[point].velocity
                found[f"position {name}"] = motions.points[point].position
            if frame is not None:
                velocity += motions.frames[frame].omega
                found[f"rotation {name}"] = [
                    e for row in motions.frames[frame].rotation for e in row
                ]
            found[f"velocity {name}"] = velocity
        return self._program(found)

    @cached_property
    def _bodies(self) -> Program:
        """Masses, inertias and poses of the bodies, and the field of gravity."""
        mechanism, where = self.mechanism, chain.motions(self.mechanism).poses
        found: dict[str, Sequence[Node]] = {}
        for place, body in enumerate(mechanism.bodies):
            found[f"mass {place}"] = [body.mass]
            found[f"position {place}"] = where.positions[body.centre]
            turn = where.rotations[body.frame or 0]
            found[f"rotation {place}"] = [entry for row in turn for entry in row]
            inertia = body.inertia or [[mechanism.builder.zero] * 3] * 3
            found[f"inertia {place}"] = [entry for row in inertia for entry in row]
        pulls = [where.vector(load.acceleration) for load in mechanism.fields]
        found["gravity"] = [
            sum(column, mechanism.builder.zero) for column in zip(*pulls, strict=True)
        ]
        return self._program(found)

    def _program(self, outputs: Mapping[str, Sequence[Node]]) -> Program:
        kept = {name: list(nodes) for name, nodes in outputs.items() if len(nodes)}
        return self.mechanism.builder.program(kept)

    def _evaluate(
        self, program: Program, q: Array, v: Array | None = None, a: Array | None = None,
        change: Change = NOTHING,
    ) -> dict[str, Array]:  # fmt: skip
        """Outputs of a program, each (N, entries)."""
        mechanism, count = self.mechanism, len(q)
        given: dict[str, float | Array] = dict.fromkeys(program.inputs, 0.0)
        given |= {name: self.values[name] for name in program.inputs if name in self.values}
        zero = np.zeros((count, len(mechanism.u)))
        groups = ((mechanism.ud, a), (mechanism.u, v), (mechanism.q, q))
        for nodes, columns in groups:
            table = zero if columns is None else columns
            given |= {name_of(node): table[:, i] for i, node in enumerate(nodes)}
        given |= inputs(mechanism, change)
        found = interpret(program, Arrays(), given, release=False)
        return {
            name: np.stack([np.broadcast_to(entry, count) for entry in entries], axis=1)
            for name, entries in found.items()
        }

    def forces(self, q: Array, v: Array, a: Array, change: Change = NOTHING) -> Array:
        """(N, speeds): equation (1), the forces that give the accelerations."""
        found = self._evaluate(self._rows, q, v, a, change)["rows"]
        if change.armature is not None:
            found = found + change.armature * a
        if change.damping is not None:
            found = found + change.damping * v
        if change.friction is not None:
            found = found + change.friction * np.sign(v)
        if np.any(change.step):
            damped = np.einsum("nij,nj->ni", self.damping(q, change), a)
            found = found + np.reshape(change.step, (-1, 1)) * damped
        return found

    def damping(self, q: Array, change: Change = NOTHING) -> Array:
        """(N, speeds, speeds): D of forces that are linear in v; dry friction only has its sign."""
        size, still = len(self.mechanism.u), np.zeros((len(q), len(self.mechanism.u)))
        plain, columns = replace(change, step=0.0), []
        for unit in np.eye(size):
            slow, back, fast, away = (
                self.forces(q, factor * unit + still, still, plain) for factor in (1, -1, 2, -2)
            )
            columns.append((fast - away - slow + back) / 2)
        return np.stack(columns, axis=2)

    def mass_matrix(self, q: Array, change: Change = NOTHING) -> Array:
        """(N, speeds, speeds): equation (2)."""
        size, count = len(self.mechanism.u), len(q)
        units = np.repeat(np.vstack([np.zeros(size), np.eye(size)]), count, axis=0)
        still = np.zeros_like(units)
        rows = self.forces(np.tile(q, (size + 1, 1)), still, units, change.repeated(size + 1))
        rows = rows.reshape(size + 1, count, size)
        return np.moveaxis(rows[1:] - rows[0], 0, 2)

    def accelerations(self, q: Array, v: Array, f: Array, change: Change = NOTHING) -> Array:
        """(N, speeds): equation (4)."""
        mass, right = self.mass_matrix(q, change), f - self.forces(q, v, np.zeros_like(v), change)
        n = mass.shape[1]
        matrix, closing = np.zeros((len(q), 0, n)), np.zeros((len(q), 0))
        if self.mechanism.constraints and not change.opened:
            matrix, closing = self.constraints(q, v)
        held = np.tile(np.eye(n)[list(change.locked)], (len(q), 1, 1))
        matrix = np.concatenate([matrix, held], axis=1)
        closing = np.hstack([closing, np.zeros((len(q), len(change.locked)))])
        c = matrix.shape[1]
        whole = np.zeros((len(q), n + c, n + c))
        whole[:, :n, :n], whole[:, n:, :n] = mass, matrix
        whole[:, :n, n:] = np.swapaxes(matrix, 1, 2)
        return np.linalg.solve(whole, np.hstack([right, -closing])[..., None])[:, :n, 0]

    def constraints(self, q: Array, v: Array) -> tuple[Array, Array]:
        """C (N, constraints, speeds) and what C a is to be the opposite of (N, constraints)."""
        size = len(self.mechanism.u)
        rest = self._evaluate(self._closing, q, v)["closing"]
        unit = [np.tile(row, (len(q), 1)) for row in np.eye(size)]
        columns = [self._evaluate(self._closing, q, v, a)["closing"] - rest for a in unit]
        return np.stack(columns, axis=2), rest

    def energies(self, q: Array, v: Array, change: Change = NOTHING) -> tuple[Array, Array]:
        """Kinetic and potential energy, (N,) each, in J."""
        found = self._evaluate(self._energy, q, v, None, change)
        kinetic = found["kinetic"][:, 0]
        if change.armature is not None:
            kinetic = kinetic + (v**2 * change.armature).sum(axis=1) / 2
        return kinetic, found["potential"][:, 0]

    def momentum_matrices(
        self, q: Array, v: Array, change: Change = NOTHING
    ) -> tuple[Array, Array, Array]:
        """Equation (5): A and A', (N, 6, speeds) each, and v_G, (N, 3).

        Raises
        ------
        LinAlgError
            Where there is no mass.
        """
        found = self._evaluate(self._momenta, q, v, None, change)
        matrix, rate = (found[name].reshape(len(q), 6, -1) for name in ("matrix", "rate"))
        if not found["mass"].all():
            raise np.linalg.LinAlgError("a scene without mass has no mass centre")
        linear, centre = matrix[:, :3], found["moment"] / found["mass"]
        velocity = np.einsum("nij,nj->ni", linear, v) / found["mass"]
        rate[:, 3:] -= np.cross(velocity[:, :, None], linear, axis=1)
        rate[:, 3:] -= np.cross(centre[:, :, None], rate[:, :3], axis=1)
        matrix[:, 3:] -= np.cross(centre[:, :, None], linear, axis=1)
        return matrix, rate, velocity

    def jacobians(self, q: Array) -> dict[str, Array]:
        """(N, 3 or 6, speeds) by name: velocity over angular velocity; equation (3)."""
        size, count = len(self.mechanism.u), len(q)
        units = np.repeat(np.vstack([np.zeros(size), np.eye(size)]), count, axis=0)
        moved = self._evaluate(self._motion, np.tile(q, (size + 1, 1)), units)
        found = {}
        for name in self.frames:
            rows = moved[f"velocity {name}"].reshape(size + 1, count, -1)
            found[name] = np.moveaxis(rows[1:] - rows[0], 0, 2)
        return found

    def poses(self, q: Array) -> dict[str, tuple[Array | None, Array | None]]:
        """Position (N, 3) and rotation (N, 3, 3) of each named frame, in the inertial frame."""
        found = self._evaluate(self._motion, q)
        poses = {}
        for name in self.frames:
            turn = found.get(f"rotation {name}")
            poses[name] = (
                found.get(f"position {name}"),
                None if turn is None else turn.reshape(-1, 3, 3),
            )
        return poses

    def links(self, q: Array) -> dict[str, tuple[Array, Array]]:
        """The same of what joints carry, which have both."""
        return {
            name: (at, turn)
            for name, (at, turn) in self.poses(q).items()
            if at is not None and turn is not None
        }

    def bodies(self, q: Array) -> list[tuple[Array, Array, Array, Array]]:
        """Mass, centre (3,), rotation and inertia (3, 3) of each body at one q (1, coordinates)."""
        found = self._evaluate(self._bodies, q)
        return [
            (
                found[f"mass {k}"][0, 0],
                found[f"position {k}"][0],
                found[f"rotation {k}"][0].reshape(3, 3),
                found[f"inertia {k}"][0].reshape(3, 3),
            )
            for k in range(len(self.mechanism.bodies))
        ]

    @cached_property
    def gravity(self) -> Array:
        """The field in the inertial frame, (3,), in m/s^2."""
        return self._evaluate(self._bodies, self.zero)["gravity"][0]

    @property
    def zero(self) -> Array:
        """(1, coordinates): all zero, and quaternions that turn by nothing."""
        found = np.zeros((1, len(self.scene.q)))
        names = [*self.scene.coordinates]
        for rotation in self.scene.rotations:
            found[0, names.index(rotation.coordinates[0])] = 1.0
        return found

    def gap(self, q: Array) -> Array:
        """(N, constraints): how far the coordinates are off those that hold between them."""
        still = np.zeros((len(q), len(self.mechanism.u)))
        held = self._evaluate(self._closing, q, still).get("held")
        return np.zeros((len(q), 0)) if held is None else held

    def moved(self, q: Array, by: Array) -> Array:
        """The coordinates after a small motion that speeds give: q + N(q) u, with quaternions of
        length one.
        """
        rates = [self._evaluate(self._rates, q, u)["rates"] for u in (by, np.zeros_like(by))]
        moved, names = q + rates[0] - rates[1], [*self.scene.coordinates]
        for rotation in self.scene.rotations:
            places = [names.index(entry) for entry in rotation.coordinates]
            moved[:, places] /= np.linalg.norm(moved[:, places], axis=1, keepdims=True)
        return moved

    def proof(self) -> Finding:
        """Whether two principles give the same motion of the scene, whatever is changed of it."""
        filter_ = self.mechanism.filters[1]
        one, two = (
            linear_system(self.mechanism, route.derive(self.mechanism), filter_)
            for route in (kane, lagrange)
        )
        return same_motion(one, two, filter_)


def carried(scene: Scene) -> tuple[str, ...]:
    """Names of the bodies that joints carry: each has the frame of its joint."""
    return tuple(
        joint.child for joint in scene.joints if isinstance(joint, Joint) and joint.carries
    )


def of_scene(scene: Scene, given: Mapping[str, float] | None = None) -> Ours:
    """A scene that was found admissible, as numbers.

    Parameters
    ----------
    scene : Scene
    given : mapping of str to float, optional
        Values of parameters; the others have their typical ones.

    Raises
    ------
    SceneError
        When the scene cannot be right.
    InputError
        For a name that is no parameter, and for friction, whose reactions no engine here has.
    ValueMissingError
        For a parameter without a value.
    """
    given = dict(given or {})
    known = {symbol.name: symbol for symbol in scene.parameters}
    for name in given:
        if name not in known:
            raise InputError(
                f"{scene.name}: there is no parameter {name!r}: they are {', '.join(known)}"
            )
    values = {}
    for name, symbol in known.items():
        value = given.get(name, getattr(symbol, "typical", None))
        if value is None:
            raise ValueMissingError(
                f"{scene.name}: parameter {name} has no value: give it one, --value {name}=1.5"
                f" or values={{{name!r}: 1.5}}"
            )
        values[name] = float(value)
    outputs: dict[str, Output] = dict(scene.outputs)
    joints = [j for j in scene.joints if isinstance(j, Joint) and j.carries]
    for place, joint in enumerate(joints):
        outputs[f"{FRAME}{place}_position"] = Position(joint.point)
        outputs[f"{FRAME}{place}_orientation"] = Orientation(joint.frame)
    mechanism = check_scene(replace(scene, outputs=outputs))
    if mechanism.frictions:
        raise InputError(f"{scene.name}: friction is not compared: leave the load out")
    return Ours(scene, changeable(mechanism, bare_links(mechanism)), values)


def bare_links(mechanism: Mechanism) -> list[Mass]:
    """Links that no body stands for, as bodies of no mass: outputs NAME_position, _orientation."""
    known, zero = {output.name: output for output in mechanism.outputs}, mechanism.builder.zero
    nothing = ((zero, zero, zero),) * 3
    return [
        Mass(name.removesuffix("_position"), known[name].point, known[other].frame, zero, nothing)
        for name in known
        if not name.startswith(FRAME) and name.endswith("_position")
        and (other := name.removesuffix("_position") + "_orientation") in known
        and name.removesuffix("_position") not in {body.name for body in mechanism.bodies}
    ]  # fmt: skip
