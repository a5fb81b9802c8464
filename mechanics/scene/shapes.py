"""Plane shapes: size, centroid, and mean squared distances from the centroid.

    disc: pi R^2, R^2/4 each way         semidisc: pi R^2/2, centroid at 4 R / 3 pi
    rectangle: b h, b^2/12 and h^2/12    rod: L, L^2/12    ring: 2 pi R, R^2/2 each way

`mechanics.scene.composite` gives shapes a mass and a place and joins them to bodies;
`mechanics.scene.shape_integrals` integrates the same quantities over the shapes directly.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass, fields

from sympy import Expr, pi, sympify

from mechanics.errors import SceneError

_ORIGIN = (sympify(0), sympify(0))


@dataclass(frozen=True)
class Shape(ABC):
    """A region of the plane, or a curve in it, in axes of its own.

    The local axes are axes of symmetry or parallel to them, so that the mean of x y vanishes.

    Raises
    ------
    SceneError
        When a length is a number that is not positive.
    """

    def __post_init__(self) -> None:
        for entry in fields(self):
            value = sympify(getattr(self, entry.name))
            if value.is_number and not value.is_positive:
                raise SceneError(
                    f"{type(self).__name__.lower()}: the {entry.name} {value} is not positive:"
                    " give a length greater than zero"
                )
            object.__setattr__(self, entry.name, value)

    @property
    @abstractmethod
    def size(self) -> Expr:
        """Area in m^2, or length in m."""

    @property
    @abstractmethod
    def centroid(self) -> tuple[Expr, Expr]:
        """Centroid in the local axes, in m."""

    @property
    @abstractmethod
    def spread(self) -> tuple[Expr, Expr]:
        """Mean squared distances (xx, yy) from the centroid along the local axes, in m^2."""


@dataclass(frozen=True)
class Rectangle(Shape):
    """A rectangle about the local origin, `width` along x and `height` along y."""

    width: Expr
    height: Expr

    @property
    def size(self) -> Expr:
        """b h."""
        return self.width * self.height

    @property
    def centroid(self) -> tuple[Expr, Expr]:
        """The local origin."""
        return _ORIGIN

    @property
    def spread(self) -> tuple[Expr, Expr]:
        """b^2 / 12 and h^2 / 12."""
        return self.width**2 / 12, self.height**2 / 12


@dataclass(frozen=True)
class Disc(Shape):
    """A full disc about the local origin."""

    radius: Expr

    @property
    def size(self) -> Expr:
        """pi R^2."""
        return pi * self.radius**2

    @property
    def centroid(self) -> tuple[Expr, Expr]:
        """The local origin."""
        return _ORIGIN

    @property
    def spread(self) -> tuple[Expr, Expr]:
        """R^2 / 4 along every direction."""
        return self.radius**2 / 4, self.radius**2 / 4


@dataclass(frozen=True)
class Semidisc(Shape):
    """The half y > 0 of a disc; the local origin is the centre of the circle."""

    radius: Expr

    @property
    def size(self) -> Expr:
        """pi R^2 / 2."""
        return pi * self.radius**2 / 2

    @property
    def centroid(self) -> tuple[Expr, Expr]:
        """(0, 4 R / 3 pi)."""
        return sympify(0), 4 * self.radius / (3 * pi)

    @property
    def spread(self) -> tuple[Expr, Expr]:
        """R^2 / 4, and R^2 / 4 - (4 R / 3 pi)^2: the circle's own, moved to the centroid."""
        own = self.radius**2 / 4
        return own, own - self.centroid[1] ** 2


@dataclass(frozen=True)
class Rod(Shape):
    """A thin rod along x, the local origin in its middle."""

    length: Expr

    @property
    def size(self) -> Expr:
        """L."""
        return self.length

    @property
    def centroid(self) -> tuple[Expr, Expr]:
        """The local origin."""
        return _ORIGIN

    @property
    def spread(self) -> tuple[Expr, Expr]:
        """L^2 / 12 along the rod."""
        return self.length**2 / 12, sympify(0)


@dataclass(frozen=True)
class Ring(Shape):
    """A thin circular ring about the local origin."""

    radius: Expr

    @property
    def size(self) -> Expr:
        """2 pi R."""
        return 2 * pi * self.radius

    @property
    def centroid(self) -> tuple[Expr, Expr]:
        """The local origin."""
        return _ORIGIN

    @property
    def spread(self) -> tuple[Expr, Expr]:
        """R^2 / 2 along every direction."""
        return self.radius**2 / 2, self.radius**2 / 2
