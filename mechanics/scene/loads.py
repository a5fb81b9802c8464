"""Loads: gravity, springs, dampers, applied forces and torques, friction.

A load acts on bodies at points. A conservative load is declared once; each route lowers it in its
own way, as a force (`mechanics.scene.actions`) or as a potential (`mechanics.scene.potential`).
"""

from dataclasses import dataclass

from sympy import Expr, S
from sympy.physics.vector import Point, Vector

from mechanics.errors import SceneError
from mechanics.scene.declared import scalar


@dataclass(frozen=True)
class Gravity:
    """A uniform field that pulls every body with m times the acceleration `field` (m/s^2)."""

    field: Vector
    name: str = "gravity"


@dataclass(frozen=True)
class Spring:
    """A linear spring between two points.

    Its tension is stiffness times elongation. With `along`, only the distance along that direction
    counts (a spring on a rail); without, the distance between the points.

    Parameters
    ----------
    name : str
    first, second : Point
    stiffness : Expr
        In N/m.
    along : Vector or None
        Unit direction from first to second, fixed in the inertial frame, or that in which second is
        seen from first: then the distance counts as positive along it.
    length : Expr
        Length without tension, in m.
    first_on, second_on : str or None
        Names of the bodies that carry first and second; on these the points stay where they are.
        None where the points tell: a point that is the centre of one body, or is fixed in the
        inertial frame.
    """

    name: str
    first: Point
    second: Point
    stiffness: Expr
    along: Vector | None = None
    length: Expr = S.Zero
    first_on: str | None = None
    second_on: str | None = None


@dataclass(frozen=True)
class Damper:
    """A linear damper between two points: tension = coefficient times rate of elongation.

    Fields are those of `Spring`, with a coefficient in N s/m in place of stiffness and length.
    """

    name: str
    first: Point
    second: Point
    coefficient: Expr
    along: Vector | None = None
    first_on: str | None = None
    second_on: str | None = None


@dataclass(frozen=True)
class Force:
    """An applied force `vector` (N) at `at` on body `on`; `by` feels the opposite, if named."""

    name: str
    at: Point
    vector: Vector
    on: str | None = None
    by: str | None = None


@dataclass(frozen=True)
class Torque:
    """An applied torque `vector` (N m) on body `on`; `by` feels the opposite, if named."""

    name: str
    vector: Vector
    on: str
    by: str | None = None


@dataclass(frozen=True)
class TorsionSpring:
    """A torsion spring: torque -stiffness * angle along `axis` on body `on`, opposite on `by`.

    Parameters
    ----------
    name : str
    angle : Expr
        Rotation of `on` relative to `by` about `axis`, from the torque-free position, in rad.
    axis : Vector
        Unit vector, fixed in both bodies.
    stiffness : Expr
        In N m/rad.
    on : str
    by : str or None
        None for the ground.
    """

    name: str
    angle: Expr
    axis: Vector
    stiffness: Expr
    on: str
    by: str | None = None


@dataclass(frozen=True)
class Coulomb:
    """Dry friction of a body that slides: -coefficient * normal * sign(sliding) along `along`.

    It depends on a reaction, and so on the accelerations. It acts on the bodies that the reaction
    acts on and at its point, and holds while the reaction presses: the scene says so by a condition
    on it. At rest the sign is zero; sticking is not modelled.

    Parameters
    ----------
    name : str
    normal : str
        Name of the reaction that presses the surfaces together where it is positive.
    along : Vector
        Unit direction of sliding; the body that the reaction acts on feels the friction along it.
    sliding : Expr
        Velocity of that body against the other one at the point of contact, along `along`, in m/s.
        It is checked against the motion.
    coefficient : Expr
        mu, without a unit.
    """

    name: str
    normal: str
    along: Vector
    sliding: Expr
    coefficient: Expr


Load = Gravity | Spring | Damper | Force | Torque | TorsionSpring | Coulomb
CONSERVATIVE = (Gravity, Spring, TorsionSpring)


def gravity(field: Vector) -> Gravity:
    """Uniform gravity, e.g. ``gravity(-g * ground.y)``.

    Examples
    --------
    >>> from sympy.physics.mechanics import ReferenceFrame
    >>> N, (g,) = ReferenceFrame("N"), parameters("g", "m/s^2", "9.81")
    >>> gravity(-g * N.y).field
    - g*N.y
    """
    if not isinstance(field, Vector):
        raise SceneError(f"gravity: {field!r} is no vector: write e.g. gravity(-g * ground.y)")
    return Gravity(field)


def spring(
    name: str,
    first: Point,
    second: Point,
    stiffness: Expr,
    along: Vector | None = None,
    length: Expr = S.Zero,
    first_on: str | None = None,
    second_on: str | None = None,
) -> Spring:
    """See `Spring`.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O = ReferenceFrame("N"), Point("O")
    >>> s, (k, r) = dynamicsymbols("s"), parameters("k r", "N/m m", "40 1/2")
    >>> bob = O.locatenew("B", s * N.x)
    >>> coil = spring("coil", O, bob, k, along=N.x, length=r)
    >>> coil.stiffness, coil.length
    (k, r)
    """
    k = scalar(stiffness, f"load {name}: the stiffness")
    slack = scalar(length, f"load {name}: the length")
    return Spring(name, first, second, k, along, slack, first_on, second_on)


def damper(
    name: str,
    first: Point,
    second: Point,
    coefficient: Expr,
    along: Vector | None = None,
    first_on: str | None = None,
    second_on: str | None = None,
) -> Damper:
    """See `Damper`.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O = ReferenceFrame("N"), Point("O")
    >>> s, (d,) = dynamicsymbols("s"), parameters("d", "N*s/m", "0.5")
    >>> wheel = O.locatenew("W", s * N.x)
    >>> damper("strut", O, wheel, d, along=N.x).coefficient
    d
    """
    c = scalar(coefficient, f"load {name}: the coefficient")
    return Damper(name, first, second, c, along, first_on, second_on)


def force(
    name: str, at: Point, vector: Vector, on: str | None = None, by: str | None = None
) -> Force:
    """See `Force`.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O = ReferenceFrame("N"), Point("O")
    >>> force("thrust", O, dynamicsymbols("f") * N.x, on="cart").vector
    f(t)*N.x
    """
    return Force(name, at, vector, on, by)


def torque(name: str, vector: Vector, on: str, by: str | None = None) -> Torque:
    """See `Torque`.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, M = ReferenceFrame("N"), dynamicsymbols("M")
    >>> torque("motor", M * N.z, on="arm").vector
    M(t)*N.z
    """
    return Torque(name, vector, on, by)


def torsion_spring(
    name: str, angle: Expr, axis: Vector, stiffness: Expr, on: str, by: str | None = None
) -> TorsionSpring:
    """See `TorsionSpring`.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, q, (k,) = ReferenceFrame("N"), dynamicsymbols("q"), parameters("k", "N*m/rad", "3")
    >>> torsion_spring("coil", q, N.z, k, on="arm").stiffness
    k
    """
    turn = scalar(angle, f"load {name}: the angle")
    k = scalar(stiffness, f"load {name}: the stiffness")
    return TorsionSpring(name, turn, axis, k, on, by)


def coulomb(name: str, normal: str, along: Vector, sliding: Expr, coefficient: Expr) -> Coulomb:
    """See `Coulomb`."""
    speed = scalar(sliding, f"load {name}: the sliding velocity")
    mu = scalar(coefficient, f"load {name}: the coefficient")
    return Coulomb(name, normal, along, speed, mu)
