"""Roots of squares as absolute values."""

from fractions import Fraction

import pytest

from mechanics.kernel import Range, Statement, Verdict, decide
from mechanics.kernel.squares import roots_of_squares
from mechanics.kernel.trial import Answer, trial
from mechanics.program import Builder
from mechanics.program.interpret import include

SIGNS = {"m": Range.POSITIVE, "k": Range.NONNEGATIVE}
SQUARES = {
    "of an input": (lambda v: v["x"] ** 2, lambda v: abs(v["x"])),
    "of a difference": (lambda v: (v["x"] - v["y"]) ** 2, lambda v: abs(v["x"] - v["y"])),
    "expanded": (
        lambda v: (v["x"] ** 2 + 2 * v["x"] * v["y"] + v["y"] ** 2) / 9,
        lambda v: abs(v["x"] + v["y"]) / 3,
    ),
    "of what is positive": (lambda v: v["m"] ** 2 * v["k"] ** 2, lambda v: v["m"] * v["k"]),
    "of both": (lambda v: 4 * v["m"] ** 2 * v["x"] ** 2, lambda v: 2 * v["m"] * abs(v["x"])),
    "an even power": (lambda v: v["x"] ** 4, lambda v: v["x"] ** 2),
    "of a quotient": (lambda v: v["x"] ** 2 / v["y"] ** 2, lambda v: abs(v["x"] / v["y"])),
    "of a sine": (lambda v: 1 - v["x"].cos() ** 2, lambda v: abs(v["x"].sin())),
    "of a cosine": (lambda v: 1 - v["x"].sin() ** 2, lambda v: abs(v["x"].cos())),
    "times a number": (
        lambda v: 2 * (v["x"] - v["y"]) ** 2,
        lambda v: v["x"].builder.constant(2).sqrt() * abs(v["x"] - v["y"]),
    ),
}
OTHERS = {
    "a sum of squares": lambda v: v["x"] ** 2 + v["y"] ** 2,
    "an odd power": lambda v: v["x"] ** 3,
    "less than a square": lambda v: -(v["x"] ** 2),
    "a positive factor once": lambda v: v["m"] * v["x"] ** 2,
    "beside a number": lambda v: v["x"] ** 2 + 2 * v["x"] + 2,
}


def inputs():
    b = Builder()
    return b, {name: b.input(name) for name in "xymk"}


@pytest.mark.parametrize("name", SQUARES)
def test_a_root_of_a_square_is_a_modulus(name):
    radicand, modulus = SQUARES[name]
    b, v = inputs()
    left, right = radicand(v).sqrt(), modulus(v)
    names = tuple("xymk")
    there = roots_of_squares(b.program({"f": [left]}, names), SIGNS)
    number = b.program({"f": [right]}, names)
    assert decide(same_value(there, number)).verdict is Verdict.PROVED
    assert ("sqrt" in there.counts()) is (name == "times a number")
    claim = Statement(name, b.program({"left": [left], "right": [right]}), SIGNS)
    outcome = trial(claim, lambda: False)
    assert outcome.answer is Answer.ZERO
    assert "a random point" in outcome.words


def same_value(one, other):
    b = Builder()
    outputs = {"left": include(b, one)["f"], "right": include(b, other)["f"]}
    return Statement("the same", b.program(outputs), SIGNS)


@pytest.mark.parametrize("name", OTHERS)
def test_other_roots_stay(name):
    b, v = inputs()
    program = b.program({"f": [OTHERS[name](v).sqrt()]})
    assert roots_of_squares(program, SIGNS) == program


def test_programs_without_roots_are_returned_as_they_are():
    b, v = inputs()
    program = b.program({"f": [v["x"] ** 2 + Fraction(1, 2)]})
    assert roots_of_squares(program, SIGNS) is program


@pytest.mark.parametrize("right", [lambda x, y: x - y, lambda x, y: y - x])
def test_a_false_root_is_zero_at_no_point(right):
    b, v = inputs()
    x, y = v["x"], v["y"]
    claim = Statement(
        "a root", b.program({"left": [((x - y) ** 2).sqrt()], "right": [right(x, y)]})
    )
    assert trial(claim, lambda: False).answer is Answer.NONZERO
    assert decide(claim).verdict is Verdict.REFUTED
