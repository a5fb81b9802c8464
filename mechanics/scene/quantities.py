"""The mechanical part of the closed vocabulary: what a published row can be about.

    sum F = dP/dt        sum tau_C = dH_C/dt        sum tau_B = dH_B/dt + v_B x P

Bodies and points are named as in the scene; several bodies are a tuple of names, taken as one free
body. `along` is an axis of the inertial frame, ``"x"`` or ``"-z"``; without it the row is about the
whole vector, and its sides are 3 x 1 matrices. `about=None` means the mass centre of the one body.

Unless a docstring says otherwise every side of a row is the quantity itself. A principle has two
sides that differ: the first is what the loads and the reactions that cross the boundary of the free
body give, with the reactions as symbols; every further one is the rate on the right.
"""

from dataclasses import dataclass

from sympy import Expr

from mechanics.scene.composite import Composite, Part
from mechanics.scene.published import Quantity

Names = str | tuple[str, ...]


@dataclass(frozen=True)
class Position(Quantity):
    """Position of a point from the origin, or from the point `of` (the vector BC), in m."""

    point: str
    along: str | None = None
    of: str | None = None


@dataclass(frozen=True)
class Velocity(Quantity):
    """Velocity of a geometric point, in m/s."""

    point: str
    along: str | None = None


@dataclass(frozen=True)
class Momentum(Quantity):
    """Linear momentum P, in kg m/s."""

    bodies: Names
    along: str | None = None


@dataclass(frozen=True)
class GeneralizedMomentum(Quantity):
    """dL/dq' of a coordinate, in kg m/s or kg m^2/s. Any row may call it p_ and the coordinate."""

    coordinate: str


@dataclass(frozen=True)
class GeneralizedForce(Quantity):
    """What has to drive a speed, besides the loads, for given u': inverse dynamics, in N or N m.

    The row of M u' - f that is power-conjugate to the speed, its inputs zero.
    """

    speed: str


@dataclass(frozen=True)
class RateOfMomentum(Quantity):
    """dP/dt, in N."""

    bodies: Names
    along: str | None = None


@dataclass(frozen=True)
class AngularMomentum(Quantity):
    """Angular momentum H_B = sum (H_C + BC x P) of absolute velocities, in kg m^2/s."""

    bodies: Names
    about: str | None = None
    along: str | None = None


@dataclass(frozen=True)
class RateOfAngularMomentum(Quantity):
    """dH_B/dt, in N m."""

    bodies: Names
    about: str | None = None
    along: str | None = None


@dataclass(frozen=True)
class MomentOfMomentum(Quantity):
    """BC x P, summed over the bodies, in kg m^2/s."""

    bodies: Names
    about: str
    along: str | None = None


@dataclass(frozen=True)
class MovingPointTerm(Quantity):
    """v_B x P with the velocity of the geometric point B, in N m."""

    bodies: Names
    about: str
    along: str | None = None


@dataclass(frozen=True)
class Moment(Quantity):
    """Moment about a point of the loads and of the reactions that cross the boundary, in N m."""

    bodies: Names
    about: str | None = None
    along: str | None = None


@dataclass(frozen=True)
class MomentumPrinciple(Quantity):
    """sum F = dP/dt: first side the forces, then forms of the rate."""

    bodies: Names
    along: str | None = None


@dataclass(frozen=True)
class AngularMomentumPrinciple(Quantity):
    """sum tau_C = dH_C/dt about the mass centre of one body: first side the moment."""

    body: str
    along: str | None = None


@dataclass(frozen=True)
class MovingPointPrinciple(Quantity):
    """sum tau_B = dH_B/dt + v_B x P about a moving point: first side the moment."""

    bodies: Names
    about: str
    along: str | None = None


@dataclass(frozen=True)
class ReactionValue(Quantity):
    """A reaction along the motion. Sides may contain other reactions and accelerations."""

    name: str


@dataclass(frozen=True)
class EquationOfMotion(Quantity):
    """An equation of motion, left side and right side: it holds along every motion."""


@dataclass(frozen=True)
class Mass(Quantity):
    """Mass of a part or composite, in kg."""

    body: Part | Composite


@dataclass(frozen=True)
class Centroid(Quantity):
    """Distance of a part's or composite's centroid from `origin` along ``"x"`` or ``"y"``, in m."""

    body: Part | Composite
    along: str
    origin: tuple[Expr, Expr] = (0, 0)


@dataclass(frozen=True)
class Inertia(Quantity):
    """Planar moment of inertia about a point of the body's plane, or the centroid, in kg m^2."""

    body: Part | Composite
    about: tuple[Expr, Expr] | None = None


@dataclass(frozen=True)
class KineticEnergy(Quantity):
    """Kinetic energy of all bodies, in J."""


@dataclass(frozen=True)
class PotentialEnergy(Quantity):
    """Potential energy of the conservative loads, in J, up to a constant."""


@dataclass(frozen=True)
class TotalEnergy(Quantity):
    """Kinetic and potential energy together, in J, up to a constant."""


@dataclass(frozen=True)
class Lagrangian(Quantity):
    """Kinetic less potential energy, in J, up to a constant or the rate of a function of q, t."""


@dataclass(frozen=True)
class Hamiltonian(Quantity):
    """Sum of p q' less the Lagrangian, in J, up to a constant: Jacobi's integral, in q and q'.

    It is the energy T + V only where T is quadratic in q': not under prescribed motions.
    """


@dataclass(frozen=True)
class MassMatrix(Quantity):
    """Second derivatives of the kinetic energy by the speeds, in their order in the scene."""


@dataclass(frozen=True)
class Identity(Quantity):
    """Sides that are equal at every state of the scene: a definition, a kinematic relation."""
