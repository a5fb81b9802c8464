"""Shapes: closed forms against direct integration, composites, and what is refused."""

from dataclasses import fields

import pytest
from sympy import Expr, Matrix, Rational, S, expand, pi, symbols

from mechanics.errors import SceneError
from mechanics.kernel import Verdict
from mechanics.scene.composite import Part, composite, inertia_about, part
from mechanics.scene.shape_integrals import (
    integrated_centroid,
    integrated_inertia,
    integrated_mass,
)
from mechanics.scene.shapes import Disc, Rectangle, Ring, Rod, Semidisc, Shape
from mechanics.symbolic import prove_equal

SHAPES = (Rectangle, Disc, Semidisc, Rod, Ring)

R, L, b, h, m, density = symbols("R L b h m sigma", positive=True)
x, y, angle = symbols("x y alpha", real=True)


def sample(shape: type[Shape], mass: Expr | None = None) -> Part:
    """A shape with symbolic dimensions, offset and rotation."""
    sizes = symbols(f"l:{len(fields(shape))}", positive=True)
    given = {"mass": mass} if mass is not None else {"density": density}
    return part(shape(*sizes), at=(x, y), angle=angle, **given)


@pytest.mark.sample(2)
@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("mass", [None, m])
def test_closed_forms_are_what_direct_integration_gives(
    shape: type[Shape], mass: Expr | None
) -> None:
    body = sample(shape, mass)
    closed = [body.mass, *body.centroid, body.inertia, inertia_about(body, (0, 0))]
    direct = [
        integrated_mass(body),
        *integrated_centroid(body),
        integrated_inertia(body),
        integrated_inertia(body, (0, 0)),
    ]
    finding = prove_equal(shape.__name__, closed, direct)
    assert finding.verdict is Verdict.PROVED, finding


def test_a_wrong_closed_form_is_refuted() -> None:
    disc = part(Disc(R), mass=m)
    assert prove_equal("disc", disc.inertia, 2 * disc.inertia).verdict is Verdict.REFUTED


@pytest.mark.sample(2)
@pytest.mark.parametrize("shape", SHAPES)
def test_two_copies_joined_are_what_direct_integration_gives(shape: type[Shape]) -> None:
    one, sizes = sample(shape), symbols(f"k:{len(fields(shape))}", positive=True)
    body = composite((one, part(shape(*sizes), mass=m, at=(y, 1), angle=pi / 3)))
    finding = prove_equal(
        shape.__name__,
        [body.mass, *body.centroid, body.inertia],
        [integrated_mass(body), *integrated_centroid(body), integrated_inertia(body)],
    )
    assert finding.shown, finding


def test_textbook_inertias() -> None:
    assert part(Rod(L), mass=m).inertia == m * L**2 / 12
    assert part(Disc(R), mass=m).inertia == m * R**2 / 2
    assert part(Ring(R), mass=m).inertia == m * R**2
    assert part(Rectangle(b, h), mass=m).inertia == expand(m * (b**2 + h**2) / 12)
    assert inertia_about(part(Semidisc(R), mass=m), (0, 0)) == m * R**2 / 2


def test_a_composite_of_one_part_is_that_part() -> None:
    half = part(Semidisc(R), mass=m, at=(1, 2), angle=pi / 6)
    body = composite((half,))
    finding = prove_equal(
        "one part",
        [body.mass, *body.centroid, *body.second_moment],
        [half.mass, *half.centroid, *half.second_moment],
    )
    assert finding.verdict is Verdict.PROVED, finding


def test_two_halves_are_a_disc() -> None:
    halves = composite((part(Semidisc(R), mass=m), part(Semidisc(R), mass=m, angle=pi)))
    disc = part(Disc(R), mass=2 * m)
    assert halves.mass == disc.mass
    assert halves.centroid == Matrix([0, 0])
    assert halves.second_moment == disc.second_moment


def test_numbers_stay_exact() -> None:
    body = composite((part(Rod(1), mass=1), part(Disc(Rational(1, 2)), mass=2, at=(1, 0))))
    assert body.centroid == Matrix([Rational(2, 3), 0])
    assert body.inertia == Rational(1, 12) + Rational(1, 4) + Rational(2, 3)
    assert part(Ring(1), density=S.One).mass == 2 * pi


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Disc(-1), "disc: the radius -1 is not positive"),
        (lambda: Rectangle(b, 0), "rectangle: the height 0 is not positive"),
        (lambda: composite(()), "composite: no parts given"),
        (lambda: part(Disc(R)), "disc: neither of density and mass given"),
        (lambda: part(Disc(R), density=1, mass=1), "disc: both of density and mass given"),
        (lambda: part(Rod(L), mass=-m), "rod: the mass -m is negative"),
        (lambda: part(Rod(L), mass=m, at=(1, 2, 3)), "rod: at=.* has 3 entries"),
    ],
)
def test_what_cannot_be_right_is_refused(make: object, message: str) -> None:
    with pytest.raises(SceneError, match=message):
        make()  # type: ignore[operator]
