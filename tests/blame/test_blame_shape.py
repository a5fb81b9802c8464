"""Terms are shown in the shape that is shortest to read, and no shape changes their value."""

import pytest
from sympy import Expr, S, cos, expand_trig, sin, symbols

from mechanics.blame.shape import in_sums, shortest
from mechanics.blame.terms import terms_of
from mechanics.symbolic import is_zero

a, b, m, l = symbols("a b m l", real=True)

WRITTEN = [
    m * cos(a) * cos(b) + m * sin(a) * sin(b),
    sin(a) * cos(b) - cos(a) * sin(b),
    m * (1 - cos(a) ** 2),
    m * l * cos(a) ** 3 * sin(b) ** 2 - sin(a) * cos(a),
    sin(a) ** 2 * sin(b) ** 2 + l,
]


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (WRITTEN[0], m * cos(a - b)),
        (WRITTEN[1], sin(a - b)),
        (WRITTEN[2], m * sin(a) ** 2),
        (m * l * sin(a) + m * l, m * l * (sin(a) + 1)),
        (S.Zero, S.Zero),
    ],
)
def test_the_shortest_shape(value: Expr, shown: Expr) -> None:
    (terms,) = terms_of([value])
    left, right = shortest(terms, {}, summed=True)
    assert (left, right) == (shown, S.Zero)
    assert shortest({}, terms, summed=True) == (S.Zero, shown)


@pytest.mark.parametrize("value", WRITTEN)
def test_no_shape_changes_the_value(value: Expr) -> None:
    (terms,) = terms_of([value])
    for shape in (in_sums(terms), *shortest(terms, {})):
        same = shape == 0 or is_zero(expand_trig(shape - value))
        assert same, shape


def test_what_both_have_is_not_shown() -> None:
    one, two = terms_of([m * cos(a) + l, 2 * m * cos(a) + l])
    assert shortest(one, two) == (m * cos(a), 2 * m * cos(a))
