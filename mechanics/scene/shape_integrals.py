"""Mass, centroid and inertia of a placed shape by direct integration.

    m = integral dm        m c = integral r dm        I_P = integral |r - r_P|^2 dm

r runs over the shape in parameters (a, b) with the element of area |d(x, y)/d(a, b)| da db (a curve
has one parameter and an element of length). Nothing of the closed forms in `mechanics.scene.shapes`
is used but the shape's dimensions, and the parallel-axis theorem is not used at all.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from sympy import Dummy, Expr, ImmutableMatrix, Matrix, cos, expand, integrate, pi, sin, sympify

from mechanics.scene.composite import Composite, Part
from mechanics.scene.shapes import Disc, Rectangle, Ring, Rod, Semidisc, Shape

# Dummies: a user may well call a length a or b.
_A, _B = Dummy("a", real=True), Dummy("b", real=True)


@dataclass(frozen=True)
class Region:
    """A shape as the image of a box: position, element, and limits (symbol, low, high)."""

    position: ImmutableMatrix
    element: Expr
    limits: tuple[tuple[Dummy, Expr, Expr], ...]


def _sector(radius: Expr, angle: Expr) -> Region:
    polar = ImmutableMatrix([_A * cos(_B), _A * sin(_B)])
    return Region(polar, _A, ((_A, sympify(0), radius), (_B, sympify(0), angle)))


_REGIONS: dict[type[Shape], Callable[[Any], Region]] = {
    Rectangle: lambda s: Region(
        ImmutableMatrix([_A, _B]),
        sympify(1),
        ((_A, -s.width / 2, s.width / 2), (_B, -s.height / 2, s.height / 2)),
    ),
    Disc: lambda s: _sector(s.radius, 2 * pi),
    Semidisc: lambda s: _sector(s.radius, pi),
    Rod: lambda s: Region(
        ImmutableMatrix([_A, 0]), sympify(1), ((_A, -s.length / 2, s.length / 2),)
    ),
    Ring: lambda s: Region(
        s.radius * ImmutableMatrix([cos(_B), sin(_B)]), s.radius, ((_B, sympify(0), 2 * pi),)
    ),
}


def integrated_mass(body: Part | Composite) -> Expr:
    """Mass in kg: the integral of the density."""
    return sum((_integral(part, lambda r: sympify(1)) for part in _parts(body)), sympify(0))


def integrated_centroid(body: Part | Composite) -> Matrix:
    """2 x 1 centroid in the body's axes, in m."""
    moments = [
        sum(_integral(part, coordinate) for part in _parts(body))
        for coordinate in (lambda r: r[0], lambda r: r[1])
    ]
    return Matrix(moments).expand() / integrated_mass(body)


def integrated_inertia(body: Part | Composite, about: Sequence[Expr] | None = None) -> Expr:
    """Planar moment of inertia about a point, or about the centroid, in kg m^2."""
    point = integrated_centroid(body) if about is None else Matrix(about)

    def squared(r: Matrix) -> Expr:
        return (r - point).dot(r - point)

    return sum((_integral(part, squared) for part in _parts(body)), sympify(0))


def _parts(body: Part | Composite) -> tuple[Part, ...]:
    return body.parts if isinstance(body, Composite) else (body,)


def _integral(part: Part, integrand: Callable[[Matrix], Expr]) -> Expr:
    """Integral over dm of a polynomial in the position, given in the body's axes."""
    region = _REGIONS[type(part.shape)](part.shape)
    size = _over(region.element, region.limits)
    position = part.at + part.turn * region.position
    density = part.mass / size
    return density * _over(integrand(position) * region.element, region.limits)


def _over(integrand: Expr, limits: tuple[tuple[Dummy, Expr, Expr], ...]) -> Expr:
    # Few products of powers, sines and cosines stand under the coefficients of many terms.
    parts = (term.as_independent(_A, _B) for term in expand(integrand).as_ordered_terms())
    return sum((factor * _moment(product, limits) for factor, product in parts), sympify(0))


@cache
def _moment(product: Expr, limits: tuple[tuple[Dummy, Expr, Expr], ...]) -> Expr:
    return integrate(product, *limits)
