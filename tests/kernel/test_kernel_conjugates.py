"""Sets without interior, by the product over all cases."""

from fractions import Fraction

import pytest

from mechanics.kernel.conjugates import has_cases, is_thin
from mechanics.program import Builder

STATES = [
    {"x": Fraction(3, 7), "y": Fraction(5, 3)},
    {"x": Fraction(-9, 4), "y": Fraction(2, 5)},
]


def shown(expression, states=STATES):
    b = Builder()
    program = b.program({"f": [expression(b, b.input("x"), b.input("y"))]}, inputs=("x", "y"))
    return is_thin(program, "f", states)


THIN = {
    "a norm": lambda b, x, y: (x * x + y * y).sqrt() - x,
    "beside a number": lambda b, x, y: abs(x) - x - 1,
    "of a sum": lambda b, x, y: abs(x) + abs(y),
    "a root of a root": lambda b, x, y: (1 + (1 + x * x).sqrt()).sqrt() - y,
    "a sign": lambda b, x, y: x.sign() * y - 2,
    "both cases": lambda b, x, y: b.less(x, y).choose(x, y),
    "an exponential": lambda b, x, y: abs(x).exp() - y,
    "a logarithm": lambda b, x, y: (1 + x * x).log() - abs(y),
    "a power": lambda b, x, y: (1 + y * y).power(Fraction(1, 3)) - abs(x),
    "an angle": lambda b, x, y: b.call("atan", x) - abs(y),
    "a tangent": lambda b, x, y: b.call("tan", x) - abs(y),
}
WIDE = {
    "half a line": lambda b, x, y: abs(x) - x,
    "the other half": lambda b, x, y: abs(x) + x,
    "a root of a square": lambda b, x, y: (x * x).sqrt() - x,
    "one of two factors": lambda b, x, y: (abs(x) - 1) * (abs(x) + x),
    "a case that is 0": lambda b, x, y: b.less(x, y).choose(x - y, 0),
    "two roots": lambda b, x, y: (x * x).sqrt() - (y * y).sqrt() + y - x,
    "a sign that is 1": lambda b, x, y: x.sign() - 1,
    "a logarithm of what is not real": lambda b, x, y: (2 + (-1 - x * x).sqrt()).log() - y,
    "a logarithm of what is negative": lambda b, x, y: (-1 - x * x).log() - y,
    "an angle of what is not real": lambda b, x, y: b.call("atan", 2 + (-1 - x * x).sqrt()) - y,
    "cases of a floor are not known": lambda b, x, y: b.call("floor", x),
}


@pytest.mark.parametrize("name", THIN)
def test_what_is_zero_on_a_thin_set_is_shown_so(name):
    assert shown(THIN[name])


@pytest.mark.parametrize("name", WIDE)
def test_what_may_be_zero_on_an_open_set_is_not(name):
    assert not shown(WIDE[name])


def test_one_state_is_enough_and_none_shows_nothing():
    assert shown(THIN["a norm"], STATES[:1])
    assert not shown(THIN["a norm"], [])


def test_many_cases_are_not_tried():
    def of_ten(b, x, y):
        return sum((abs(x + k) for k in range(10)), y)

    assert not shown(of_ten)


def test_cases_are_all_but_analytic_functions():
    b = Builder()
    x = b.input("x")
    assert not has_cases(b.program({"f": [x.sin() / (1 + x * x).log()]}))
    assert has_cases(b.program({"f": [x.sqrt()]}))
    assert has_cases(b.program({"f": [b.call("floor", x)]}))
