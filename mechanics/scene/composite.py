"""Bodies joined from plane shapes of uniform density, by the parallel-axis theorem.

    m = sum m_i        m c = sum m_i c_i
    S = sum (S_i + m_i (c_i - c) (c_i - c)^T)        S = integral of (r - c) (r - c)^T dm
    I_z = S_xx + S_yy

S is the second moment of mass about the centroid, 2 x 2. The planar moment of inertia is its
trace, and the spatial inertia of a thin body follows from its entries, so S is all that is kept.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from sympy import Expr, ImmutableMatrix, Matrix, cos, diag, expand, sin, sympify, zeros

from mechanics.errors import SceneError
from mechanics.scene.shapes import Shape


class Massive(Protocol):
    """What a part and a composite have in common; matrices in the body's axes.

    `mass` in kg, `centroid` 2 x 1 in m, `second_moment` 2 x 2 about the centroid in kg m^2.
    """

    @property
    def mass(self) -> Expr: ...  # noqa: D102

    @property
    def centroid(self) -> ImmutableMatrix: ...  # noqa: D102

    @property
    def second_moment(self) -> ImmutableMatrix: ...  # noqa: D102


@dataclass(frozen=True)
class Part:
    """A shape with a mass, placed in a body's plane.

    Attributes
    ----------
    mass : Expr
        In kg.
    at : ImmutableMatrix
        2 x 1 position of the shape's local origin in the body's axes, in m.
    angle : Expr
        Rotation of the local axes from the body's, counterclockwise, in rad.
    """

    shape: Shape
    mass: Expr
    at: ImmutableMatrix
    angle: Expr

    @property
    def turn(self) -> Matrix:
        """2 x 2 rotation from local to body axes."""
        c, s = cos(self.angle), sin(self.angle)
        return Matrix([[c, -s], [s, c]])

    @property
    def centroid(self) -> ImmutableMatrix:
        """2 x 1 centroid in the body's axes, in m."""
        return ImmutableMatrix(self.at + self.turn * Matrix(self.shape.centroid))

    @property
    def second_moment(self) -> ImmutableMatrix:
        """2 x 2 second moment of mass about the centroid in the body's axes, in kg m^2."""
        local = diag(*self.shape.spread) * self.mass
        return ImmutableMatrix(self.turn * local * self.turn.T).applyfunc(expand)

    @property
    def inertia(self) -> Expr:
        """Planar moment of inertia about the centroid, in kg m^2."""
        return expand(self.mass * sum(self.shape.spread))


@dataclass(frozen=True)
class Composite:
    """Parts joined to one body: see `composite`."""

    parts: tuple[Part, ...]

    @property
    def mass(self) -> Expr:
        """Sum of the parts' masses, in kg."""
        return expand(sum(part.mass for part in self.parts))

    @property
    def centroid(self) -> ImmutableMatrix:
        """2 x 1 centroid in the body's axes, in m."""
        total = zeros(2, 1)
        for part in self.parts:
            total += part.mass * part.centroid
        return ImmutableMatrix(total.expand() / self.mass)

    @property
    def second_moment(self) -> ImmutableMatrix:
        """2 x 2 second moment of mass about the composite's centroid, in kg m^2."""
        total, centroid = zeros(2, 2), self.centroid
        for part in self.parts:
            offset = part.centroid - centroid
            total += part.second_moment + part.mass * offset * offset.T
        return ImmutableMatrix(total).applyfunc(expand)

    @property
    def inertia(self) -> Expr:
        """Planar moment of inertia about the composite's centroid, in kg m^2."""
        return expand(self.second_moment.trace())


def part(
    shape: Shape,
    density: Expr | None = None,
    mass: Expr | None = None,
    at: Sequence[Expr] = (0, 0),
    angle: Expr = 0,
) -> Part:
    """A shape with a mass, placed in a body's plane: see `Part`.

    Parameters
    ----------
    density, mass : Expr
        One of them: the mass in kg, or the density per size: in kg/m^2 for an area (rho h), in
        kg/m for a rod or ring.

    Raises
    ------
    SceneError
        When neither or both of density and mass are given, or one is a negative number.
    """
    name = type(shape).__name__.lower()
    if (density is None) == (mass is None):
        found = "neither" if mass is None else "both"
        raise SceneError(f"{name}: {found} of density and mass given: give one of them")
    value = sympify(mass) if density is None else sympify(density) * shape.size
    if value.is_negative:
        raise SceneError(f"{name}: the mass {value} is negative: a mass is zero or more")
    if len(at) != 2:
        raise SceneError(f"{name}: at={at!r} has {len(at)} entries: give x and y in the plane")
    return Part(shape, value, ImmutableMatrix(at), sympify(angle))


def composite(parts: Sequence[Part]) -> Composite:
    """Join parts to one body by the parallel-axis theorem.

    Raises
    ------
    SceneError
        When there are no parts.
    """
    if not parts:
        raise SceneError("composite: no parts given: a body consists of one part or more")
    return Composite(tuple(parts))


def inertia_about(body: Massive, point: Sequence[Expr]) -> Expr:
    """Planar moment of inertia about a point of the plane: I_C + m d^2, in kg m^2."""
    offset = body.centroid - Matrix(point)
    return expand(body.second_moment.trace() + body.mass * offset.dot(offset))
