"""Bounds of numbers that are made of roots hold for all their conjugates."""

from itertools import product
from math import log2, prod, sqrt

import pytest
from flint import fmpq, fmpq_mpoly_ctx

from mechanics.kernel.numbers import Numbers

CONTEXT = fmpq_mpoly_ctx.get(["r", "s", "x"])
R, S, X = CONTEXT.gens()
ONE = CONTEXT.constant(1)
TOWERS = {
    "a root": (ONE * fmpq(7, 3), ONE * 5, R),
    "a sum": (ONE * 2, ONE * 3, R + S),
    "a product": (ONE * 2, ONE * fmpq(3, 5), 4 * R * S - 1),
    "a root in a root": (ONE * 5, 10 - 2 * R, S / 4),
    "a fraction in a root": (ONE * 5, fmpq(5, 8) - R / 8, 3 * S * R - fmpq(1, 7)),
    "many terms": (ONE * fmpq(2, 9), ONE * 11 + R, (R + S - fmpq(1, 3)) ** 3),
}


def value(polynomial, r: float, s: float) -> float:
    return sum(
        float(c.p) / float(c.q) * r ** int(m[0]) * s ** int(m[1])
        for m, c in polynomial.to_dict().items()
    )


@pytest.mark.parametrize("name", TOWERS)
def test_no_conjugate_is_beyond_the_bound(name: str) -> None:
    """With l, each conjugate is an algebraic integer below u, so that their product is whole."""
    first, second, number = TOWERS[name]
    numbers = Numbers()
    numbers.root(0, first)
    numbers.root(1, second)
    bound = numbers.bound(number.to_dict())
    assert bound is not None
    u, l = bound
    conjugates = []
    for one, other in product((1, -1), repeat=2):
        r = one * sqrt(value(first, 0, 0))
        conjugates.append(value(number, r, other * sqrt(value(second, r, 0))))
    assert all(log2(abs(c)) + l <= u + 1e-5 for c in conjugates)
    whole = prod(c * round(2**l) for c in conjugates)
    assert whole == pytest.approx(round(whole), rel=1e-6)
    smallest = min(map(abs, conjugates))
    assert smallest >= 2.0 ** -(3 * u + l)


def test_bounds_of_one_root_are_reached() -> None:
    """3 sqrt(7/3) = sqrt(21)."""
    numbers = Numbers()
    numbers.root(0, ONE * fmpq(7, 3))
    u, l = numbers.bound(R.to_dict()) or (0, 0)
    assert (2**u, 2**l) == pytest.approx((sqrt(21), 3), rel=1e-5)
    assert 2**u > sqrt(21), "rounding leaves it above"


def test_what_is_no_root_has_no_bound() -> None:
    numbers = Numbers()
    numbers.pi(0)
    numbers.circular(1, 2, R, ONE)
    assert numbers.bound((R + 1).to_dict()) is None
    assert numbers.holds(R * S + X)
    assert numbers.sign((R - 3).to_dict()) == 1
    assert numbers.sign((R - fmpq(22, 7)).to_dict()) == -1
    assert numbers.sign((X + 1).to_dict()) is None
    assert numbers.sign((S + X).to_dict()) == -1
