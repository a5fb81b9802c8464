"""How a scene moves, as SymPy expressions: programs composed along the chain, printed.

What people write and read is compared with this: positions and velocities, energies, momenta, mass
matrices. It is derived as programs, by `chain` and `energy`, and printed when it is asked for.
"""

from dataclasses import dataclass
from functools import cached_property
from itertools import chain as flat

from sympy import Add, Expr, Matrix, Symbol, eye, zeros

from mechanics.errors import InputError
from mechanics.kinematics import chain, energy, motion
from mechanics.kinematics.motion import Motions
from mechanics.kinematics.printer import Printer
from mechanics.mechanism import Mechanism, lower
from mechanics.program import Builder
from mechanics.program.builder import Node
from mechanics.program.vectors import Matrix as Rows
from mechanics.program.vectors import Vector
from mechanics.scene import Body, Scene
from mechanics.scene.momenta import momentum_symbols


@dataclass(frozen=True)
class PointMotion:
    """Motion of a geometric point, 3 x 1 inertial components in plain symbols.

    Attributes
    ----------
    position, velocity, acceleration : Matrix
        In m, m/s, m/s^2; the velocity in q and u, the acceleration in q, u and u'.
    """

    position: Matrix
    velocity: Matrix
    acceleration: Matrix


@dataclass(frozen=True)
class BodyMotion:
    """Motion of a body: its mass centre, and how it turns.

    Attributes
    ----------
    rotation : Matrix
        3 x 3, v_inertial = R v_body; the identity for a particle.
    angular_velocity : Matrix
        3 x 1, inertial components, in rad/s; zero for a particle.
    inertia : Matrix
        3 x 3 about the mass centre, inertial components, in kg m^2; zero for a particle.
    translation, turning : Expr
        Kinetic energy of translation and of rotation, in J.
    """

    body: Body
    centre: PointMotion
    rotation: Matrix
    angular_velocity: Matrix
    inertia: Matrix
    translation: Expr
    turning: Expr

    @property
    def turns(self) -> bool:
        """Whether the body has an angular velocity at all."""
        return any(entry != 0 for entry in self.angular_velocity)


@dataclass(frozen=True, eq=False, repr=False)
class Kinematics:
    """Motion of a scene; each quantity is derived and printed once, when it is first asked for.

    Attributes
    ----------
    lowered : Mechanism or None
        Of that scene, where it is at hand.
    """

    scene: Scene
    lowered: Mechanism | None = None

    def __repr__(self) -> str:
        return f"<kinematics of {self.scene.name}>"

    @cached_property
    def mechanism(self) -> Mechanism:
        """The scene as nodes."""
        return self.lowered or lower(self.scene, Builder())

    @cached_property
    def motions(self) -> Motions:
        """Motion of all frames and points as nodes, in q, u and u'."""
        return chain.motions(self.mechanism)

    @cached_property
    def moving(self) -> tuple[motion.BodyMotion, ...]:
        """Motion of all bodies as nodes."""
        return motion.body_motions(self.mechanism, self.motions)

    @cached_property
    def printer(self) -> Printer:
        """Nodes in the scene's symbols."""
        return Printer(self.scene, self.mechanism)

    @cached_property
    def bodies(self) -> dict[str, BodyMotion]:
        """Motion of each body by its name, in scene order."""
        return {body.name: self._body(i) for i, body in enumerate(self.scene.bodies)}

    def _body(self, index: int) -> BodyMotion:
        own, moving = self.mechanism.bodies[index], self.moving[index]
        energies, centre = self._energies[index], moving.centre
        rotation, omega, inertia = eye(3), zeros(3, 1), zeros(3, 3)
        if own.frame is not None:
            frame = self.motions.frames[own.frame]
            rotation, omega = self._matrix(frame.rotation), self._matrix(frame.omega)
        if moving.inertia is not None:
            inertia = self._matrix(moving.inertia)
        return BodyMotion(
            self.scene.bodies[index],
            self._point(centre),
            rotation,
            omega,
            inertia,
            *self.printer(energies),
        )

    def point_nodes(self, name: str) -> motion.PointMotion:
        """Motion of a point that the scene mentions, as nodes.

        Raises
        ------
        InputError
            When there is none of that name.
        """
        names = [place.name for place in self.mechanism.points]
        if name not in names:
            known = ", ".join(sorted(names))
            raise InputError(
                f"{self.scene.name}: there is no point {name!r}: the points are {known}"
            )
        return self.motions.points[names.index(name)]

    def _point(self, point: motion.PointMotion) -> PointMotion:
        vectors = (point.position, point.velocity, point.acceleration)
        return PointMotion(*map(self._matrix, vectors))

    def _matrix(self, rows: Vector | Rows) -> Matrix:
        """A column of nodes, or rows of them, printed."""
        if isinstance(rows[0], Node):
            return Matrix(self.printer(rows))
        return Matrix([self.printer(row) for row in rows])

    @cached_property
    def _energies(self) -> tuple[tuple[Node, Node], ...]:
        """Kinetic energies of translation and rotation of each body, in q and u."""
        return energy.kinetic_energies(self.mechanism, self.mechanism.rates)

    @cached_property
    def kinetic_energy(self) -> Expr:
        """Of all bodies in q and u, in J."""
        return Add(*self.printer(list(flat.from_iterable(self._energies))))

    @cached_property
    def mass_matrix(self) -> Matrix:
        """Second derivatives of the kinetic energy by the speeds, n x n."""
        return self._matrix(self.mass_nodes)

    @cached_property
    def mass_nodes(self) -> Rows:
        """The same as nodes."""
        return energy.mass_matrix(self.mechanism, flat.from_iterable(self._energies))

    @cached_property
    def energy_in_rates(self) -> Expr:
        """Kinetic energy in q and q', which are symbols of their own whatever the speeds are."""
        return Add(*self.printer(list(flat.from_iterable(self._in_rates))))

    @cached_property
    def _in_rates(self) -> tuple[tuple[Node, Node], ...]:
        return energy.kinetic_energies(self.mechanism, self.mechanism.coordinate_rates)

    @cached_property
    def momenta(self) -> dict[Symbol, Expr]:
        """p_i = dT/dq_i' in q and u, by its symbol, in kg m/s or kg m^2/s."""
        by_coordinate = dict(
            zip(
                self.scene.q,
                self.printer(energy.momenta(flat.from_iterable(self._in_rates), self.mechanism.qd)),
                strict=True,
            )
        )
        table = self.scene.coordinate_rates
        symbols = momentum_symbols(self.scene).items()
        return {p: by_coordinate[q].xreplace(table) for p, q in symbols}
