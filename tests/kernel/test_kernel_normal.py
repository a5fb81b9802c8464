"""The normal form: relations, budgets, fractions, roots."""

from fractions import Fraction

import pytest
from flint import fmpq

from mechanics.kernel import Range, Statement
from mechanics.kernel.normal import MOST_UNKNOWNS, Fractions, capacity, proves
from mechanics.kernel.quotients import NoValue, Quotient, Quotients
from mechanics.kernel.radicals import LARGEST_CONTENT
from mechanics.kernel.ring import MOST_WORK, Ring, TooLarge, leading_powers, primitive_part
from mechanics.program import Builder, Node


def shown(left: Node, right: Node, **signs: Range) -> bool:
    b = left.builder
    return proves(Statement("normal", b.program({"left": [left], "right": [right]}), signs))


def test_relations_replace_their_leading_power_wherever_it_stands() -> None:
    ring = Ring(6)
    c, s = ring.circle("x")
    x = ring.generator("x", positive=True)
    assert ring.reduced(s**2 + c**2) == 1
    assert ring.reduced(x * s**5 - x * s) == ring.reduced(x * s * (c**4 - 2 * c**2))
    assert ring.circle("x") == (c, s)
    assert ring.power(s, 4) == ring.product(s**2, s**2)
    assert ring.power(x + s, 3) == ring.reduced((x + s) ** 3)
    assert ring.power(x, 0) == 1
    assert ring.positive == {ring.place("x")}
    assert leading_powers(2 * s * x**3 + c) == tuple(
        sorted(((ring.place(("sin", "x")), 1), (ring.place("x"), 3)))
    )
    ring.generator("y")
    ring.generator("z")
    with pytest.raises(TooLarge, match="full"):
        ring.generator("one too many"), ring.generator("two too many")
    assert primitive_part(ring.constant(Fraction(4, 3)) * x + 2) == (Fraction(2, 3), 2 * x + 3)


def test_budgets_count_terms() -> None:
    with pytest.raises(TooLarge, match="generators"):
        Ring(601)
    assert Ring(600).capacity == 600
    ring = Ring(2)
    ring.spend(MOST_WORK)
    with pytest.raises(TooLarge, match="products"):
        ring.spend(1)
    b = Builder()
    total = b.one
    for k in range(20):
        total = total * (b.input(f"x{k}") + b.input(f"y{k}"))
    assert not shown(
        total, total * 2 - total * 1 + 0 * total.sqrt() + (total - total / 2) - total / 2
    )
    unknowns = [b.input(f"x{k}") for k in range(MOST_UNKNOWNS + 1)]
    matrix = [[u if i == j else 1 for j in range(len(unknowns))] for i, u in enumerate(unknowns)]
    first = b.solve(matrix, unknowns)[0]
    assert not shown(first * 2, first + first * 1 + b.input("z") - b.input("z") * 1)


def test_fractions() -> None:
    a = Quotients(4)
    x, y = a.generator("x"), a.generator("y")
    one = a.constant(Fraction(1))
    third = a.divide(one, a.multiply(a.constant(Fraction(3)), a.add(x, y)))
    assert a.is_zero(a.subtract(a.multiply(third, a.add(x, y)), a.constant(Fraction(1, 3))))
    total = a.add(a.divide(one, x), a.divide(one, y))
    assert a.is_zero(a.subtract(total, a.divide(a.add(x, y), a.multiply(x, y))))
    assert not a.is_zero(a.subtract(total, a.divide(a.add(x, x), a.multiply(x, y))))
    assert a.multiply(a.divide(x, y), y).powers == {}
    assert a.multiply(a.divide(one, a.multiply(y, y)), y).powers == a.divide(one, y).powers
    assert a.inverse(a.inverse(x)) == x
    with pytest.raises(NoValue):
        a.inverse(a.subtract(x, x))
    assert a.denominator({}) == 1


@pytest.mark.parametrize("size", [1, 2, 3, 4])
def test_cramers_rule(size: int) -> None:
    b = Builder()
    x = [b.input(f"x{k}") for k in range(size)]
    matrix = [[x[i] * (i == j) + (i + 2 * j) ** 3 % 7 for j in range(size)] for i in range(size)]
    right = [x[k] * k + 1 for k in range(size)]
    solution = b.solve(matrix, right)
    for row, side in zip(matrix, right, strict=True):
        left = sum((m * v for m, v in zip(row, solution, strict=True)), b.zero)
        assert shown(left, side)
        assert not shown(left, side + x[0])
    singular = b.solve([[x[0], x[0]], [x[0], x[0]]], [x[0], x[0] + 1])[0]
    assert not shown(singular * 2, singular + x[0] - x[0] * 1 + singular * 1)


def test_roots_and_absolute_values() -> None:
    b = Builder()
    x, y, a, n = (b.input(name) for name in "xyan")
    positive = {"a": Range.POSITIVE, "n": Range.NEGATIVE}
    third = Fraction(1, 3)
    assert shown((12 * x * x * a).sqrt(), 2 * b.constant(3).sqrt() * abs(x) * a.sqrt(), **positive)
    assert not shown((12 * x * x * a).sqrt(), 2 * b.constant(3).sqrt() * x * a.sqrt(), **positive)
    for k, surd in ((2, b.constant(12).sqrt()), (3, b.constant(24).power(third))):
        assert shown(surd.power(k), b.constant(12 * (k - 1)))
        assert not shown(surd, b.constant(2))
    assert shown((x / y).sqrt() * abs(y), (x * y).sqrt())
    assert not shown((x / y).sqrt() * y, (x * y).sqrt())
    assert shown((a / 8).power(third), a.power(third) / 2, **positive)
    assert shown((a * a).power(third).power(3), a * a, **positive)
    assert shown((8 * a * a * a).power(third), 2 * a, **positive)
    assert shown((x * x / (y * y * y)).power(third).power(3), x * x / (y * y * y))
    assert shown(abs(n), -n, **positive)
    assert not shown(abs(n), n, **positive)
    assert shown(abs(x / y), abs(x) / abs(y))
    assert shown(abs(x) * abs(x), x * x)
    assert shown(abs(a * x + a), a * abs(x + 1), **positive)
    assert shown(abs(x * x + 1), x * x + 1)
    assert shown(abs(a + 1), a + 1, **positive)
    assert shown(abs(-a * a * a - x * x), a * a * a + x * x, **positive)
    assert not shown(abs(x * x - 1), x * x - 1)
    assert shown(n.sign() * n, -n, **positive)
    assert shown((-x).sign(), -(x.sign()))
    assert shown(x.sign() * abs(x), x)
    assert shown((-2 * x - y).sign() * abs(2 * x + y), -2 * x - y)
    assert not shown(x.sign() * abs(x), 2 * x)
    assert shown((x / -2).sign() * 3, -3 * x.sign())
    assert not shown(x.sign() * x.sign(), b.one)
    assert shown((x * x).power(Fraction(3, 2)), abs(x) * x * x)


def test_large_radicands_are_not_factored() -> None:
    b = Builder()
    for number, factored in ((LARGEST_CONTENT // 4 - 2, True), (LARGEST_CONTENT - 2, False)):
        root = b.constant(number).sqrt() + b.input("x")
        assert shown(2 * root, b.constant(4 * number).sqrt() + 2 * b.input("x")) is factored


def test_logarithms_of_rationals_are_sums_of_those_of_primes() -> None:
    b = Builder()
    x, half = b.input("x"), b.constant(Fraction(1, 2)).log()
    assert shown(x * b.constant(Fraction(50, 9)).log(),
                 x * (2 * b.constant(5).log() - half - 2 * b.constant(3).log()))  # fmt: skip
    assert not shown(b.constant(-8).log() * x, 3 * b.constant(2).log() * x)
    assert not shown(b.constant(0).log() * x, b.zero)
    for number, factored in ((2 * (LARGEST_CONTENT // 2), True), (LARGEST_CONTENT + 2, False)):
        for side in (1, -1):
            one, other = (b.constant(Fraction(n) ** side).log() for n in (number, number // 2))
            assert shown(one * x, (other - side * half) * x) is factored


def test_truth_values() -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    below = b.less(x, y)
    assert shown(below * below, below)
    assert shown(b.call("or", below, below), below)
    assert shown(b.call("and", below, b.less(y + 1, x)) * 2,
                 b.call("and", b.less(2 * y + 2, 2 * x), below) * 2)  # fmt: skip
    assert shown(b.call("not", below), b.call("not_greater", y, x))
    assert not shown(b.call("not", below), b.call("less", y, x))
    assert shown(b.call("equal", 2 * x, 2 * y), b.call("equal", y, x))
    assert shown(b.call("equal", (x + y).power(2), x * x + 2 * x * y + y * y), b.one)
    assert shown(below.choose(x, y) + below.choose(y, x), x + y)


def test_angles_are_first_kept_whole() -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    assert shown((x * x + y).sin() * (-y - x * x).cos(), -(-y - x * x).sin() * (y + x * x).cos())
    assert shown((x - x * 1 + y).cos() * 2, 2 * y.cos())
    assert shown((x + y).exp() * (-x - y).exp(), b.one)
    assert shown((b.constant(Fraction(1, 2**40)) * x).sin().power(2) - 1,
                 -(b.constant(Fraction(1, 2**40)) * x).cos().power(2))  # fmt: skip
    assert shown((2 * x).sin(), 2 * x.sin() * x.cos())


def test_what_is_kept_whole_is_known_again() -> None:
    """Whatever the order in which its argument was built."""
    b = Builder()
    x, y, z = b.input("x"), b.input("y"), b.input("z")
    one, other = 1 / (y + 1) / (z + 2), 1 / (z + 2) / (y + 1)
    assert shown((x * one).log(), (other * x).log())
    assert shown((x * one + x).log(), (x + other * x).log())
    assert not shown((x * one).log(), (2 * other * x).log())


def test_exponentials_of_small_parts() -> None:
    b = Builder()
    x = b.input("x")
    part = b.constant(Fraction(1, 2**40)) * x
    assert shown(part.exp() * (-part).exp(), b.one)
    assert shown((-3 * part).exp() * part.exp() ** 3, b.one)
    assert not shown((-part).exp(), b.one)


def test_capacity_is_enough() -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    program = b.program({"v": [(x.sin() + 2).sqrt() + abs(y) + x.cosh() + b.less(x, y)]})
    assert capacity(program) >= 2 + 2 + 1 + 1 + 1 + 1
    domain = Fractions(2)
    assert domain.quotients.is_zero(Quotient(domain.constant(Fraction(0)).numerator, {}))
    assert domain.constant(Fraction(2, 3)).numerator.leading_coefficient() == fmpq(2, 3)
