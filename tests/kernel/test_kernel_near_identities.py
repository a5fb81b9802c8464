"""Statements that are nearly identities: what numbers tell apart is never shown.

Right and wrong rules of roots, moduli, logarithms, inverse functions and fixed turns, of random
terms; numbers come from mpmath, another library than the kernel's.
"""

import random
from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise
from typing import ClassVar

import mpmath
import pytest
from mpmath_domain import MultiplePrecision

from mechanics.kernel import Range, Statement, Verdict, decide
from mechanics.program import Builder, Node, Program, interpret

NAMES = "xyz"
TURNS = (3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 15, 16, 18, 20, 24)
Pair = tuple[Node, Node]


class NoValue(Exception):
    """An operation has no value at these numbers."""


def where(known: Callable[..., bool], value: Callable[..., object]) -> Callable[..., object]:
    """A partial operation."""

    def partial(*numbers: object) -> object:
        if not known(*numbers):
            raise NoValue
        return value(*numbers)

    return partial


class Reals(MultiplePrecision):
    """mpmath's numbers, kept away from the edges of where operations have values."""

    operations: ClassVar = {
        "add": lambda x, y: x + y, "subtract": lambda x, y: x - y, "multiply": lambda x, y: x * y,
        "negate": lambda x: -x, "abs": abs, "sign": mpmath.sign, "sin": mpmath.sin,
        "cos": mpmath.cos, "tan": mpmath.tan, "atan": mpmath.atan, "tanh": mpmath.tanh,
        "divide": where(lambda x, y: abs(y) > 1e-9, lambda x, y: x / y),
        "sqrt": where(lambda x: x > 1e-20, mpmath.sqrt),
        "log": where(lambda x: x > 1e-9, mpmath.log),
        "exp": where(lambda x: abs(x) < 1000, mpmath.exp),
        "asin": where(lambda x: abs(x) < 1 - 1e-9, mpmath.asin),
        "acos": where(lambda x: abs(x) < 1 - 1e-9, mpmath.acos),
        "atan2": where(lambda y, x: abs(y) > 1e-9, mpmath.atan2),
        "power": where(lambda x, y: abs(x) > 1e-9, lambda x, y: x**y),
        "less": lambda x, y: mpmath.mpf(x < y), "select": lambda c, x, y: x if c else y,
    }  # fmt: skip


RULES: tuple[Callable[[Builder, Node, Node], Pair], ...] = (
    lambda b, p, q: ((p * p).sqrt(), p),
    lambda b, p, q: ((p * p).sqrt(), abs(p)),
    lambda b, p, q: (b.call("sign", p) * p, abs(p)),
    lambda b, p, q: (b.call("sign", p) * abs(p), p),
    lambda b, p, q: (p.log().exp(), p),
    lambda b, p, q: (p.exp().log(), p),
    lambda b, p, q: ((p * p).log(), 2 * p.log()),
    lambda b, p, q: ((p * p).log(), 2 * abs(p).log()),
    lambda b, p, q: (b.call("atan", b.call("tan", p)), p),
    lambda b, p, q: (b.call("tan", b.call("atan", p)), p),
    lambda b, p, q: (b.call("asin", p.sin()), p),
    lambda b, p, q: (b.call("asin", p).sin(), p),
    lambda b, p, q: (b.call("acos", p.cos()), p),
    lambda b, p, q: (b.call("atan2", p.sin(), p.cos()), p),
    lambda b, p, q: (b.call("atan2", p.sin(), p.cos()).sin(), p.sin()),
    lambda b, p, q: ((p * p * p).sqrt(), p * p.sqrt()),
    lambda b, p, q: (b.less(p, -p).choose(-p, p), abs(p)),
    lambda b, p, q: (b.less(p, -p).choose(p, -p), abs(p)),
    lambda b, p, q: (abs(p).sin(), p.sin()),
    lambda b, p, q: (abs(p).cos(), p.cos()),
    lambda b, p, q: ((1 - p.sin() ** 2).sqrt(), p.cos()),
    lambda b, p, q: ((1 - p.sin() ** 2).sqrt(), abs(p.cos())),
    lambda b, p, q: (((1 + p.cos()) / 2).sqrt(), (p / 2).cos()),
    lambda b, p, q: ((p * q).sqrt(), p.sqrt() * q.sqrt()),
    lambda b, p, q: (abs(p * q), abs(p) * abs(q)),
    lambda b, p, q: (abs(p + q), abs(p) + abs(q)),
    lambda b, p, q: ((p * q).log(), p.log() + q.log()),
    lambda b, p, q: ((p * p + q * q).sqrt(), p + q),
    lambda b, p, q: (b.less(p, q).choose(q, p), (p + q + abs(p - q)) / 2),
    lambda b, p, q: (b.less(p, q).choose(p, q), (p + q + abs(p - q)) / 2),
    lambda b, p, q: (p.sqrt() / q.sqrt(), (p / q).sqrt()),
    lambda b, p, q: ((p + q).exp(), p.exp() * q.exp()),
    lambda b, p, q: (b.call("atan2", p, q), b.call("atan", p / q)),
)


def term(draw: random.Random, b: Builder, depth: int) -> Node:
    """A random term of three inputs."""
    if depth == 0 or draw.random() < 0.15:
        if draw.random() < 0.75:
            return b.input(draw.choice(NAMES))
        return b.constant(Fraction(draw.choice((1, 2, 3, -1, -2, 5)), draw.choice((1, 1, 2, 3))))
    first, kind = term(draw, b, depth - 1), draw.random()
    if kind < 0.6:
        other = term(draw, b, depth - 1)
        return first + other if kind < 0.35 else first * other
    name = draw.choice(("sin", "cos", "abs", "sqrt", "sign", "exp", "log", "tanh"))
    return b.call(name, first)


def rule(draw: random.Random, b: Builder) -> Pair:
    """A rule of random terms, in a larger statement or alone."""
    left, right = draw.choice(RULES)(b, term(draw, b, 2), term(draw, b, 1))
    if draw.random() < 0.5:
        factor, more = term(draw, b, 1), term(draw, b, 1)
        left, right = left * factor + more, right * factor + more
    return left, right


def turns(draw: random.Random, b: Builder) -> Pair:
    """A product of sines and cosines of fixed turns, and its sum, signs of which may be wrong."""
    n, x = draw.choice(TURNS), b.input("x")
    angles = [x * draw.choice((0, 0, 1, 2)) + b.pi * Fraction(draw.randrange(-2 * n, 2 * n + 1), n)
              for _ in range(draw.choice((2, 3)))]  # fmt: skip
    product, wrong = b.one, draw.random() < 0.6
    for angle in angles:
        product = product * angle.cos()
    total = [(b.one, angles[0])]
    for _, angle in pairwise(angles):
        total = [(c / 2, other + s * angle) for c, other in total for s in (1, -1)]
    right = b.zero
    for c, angle in total:
        flipped = -1 if wrong and draw.random() < 0.5 else 1
        shown = draw.choice((angle.cos(), (b.pi / 2 - angle).sin(), -(angle + b.pi).cos()))
        right = right + c * flipped * shown
    return product * (x + 1), right * (x + 1)


def apart(draw: random.Random, program: Program, signs: dict[str, Range]) -> bool:
    """Whether numbers tell the sides apart somewhere."""
    for k in range(60):
        scale = (0.05, 0.7, 1, 3, 9)[k % 5]
        state = {
            name: mpmath.mpf(draw.randrange(1, 1000)) / 300 * scale
            * (draw.choice((-1, 1)) if signs[name] is Range.FREE else 1)
            for name in NAMES
        }  # fmt: skip
        try:
            outputs = interpret(program, Reals(), {n: state[n] for n in program.inputs})
        except NoValue:
            continue
        left, right = outputs["left"][0], outputs["right"][0]
        if abs(left - right) > 1e-18 * (1 + abs(left) + abs(right)):
            return True
    return False


@pytest.mark.parametrize(
    ("make", "seed", "count"),
    [
        (rule, 0, 20), (turns, 0, 30),
        pytest.param(rule, 1, 500, marks=pytest.mark.campaign),
        pytest.param(turns, 1, 400, marks=pytest.mark.campaign),
    ],
)  # fmt: skip
def test_what_numbers_tell_apart_is_never_shown(
    make: Callable[[random.Random, Builder], Pair], seed: int, count: int
) -> None:
    draw, shown, refuted = random.Random(seed), 0, 0
    for _ in range(count):
        b = Builder()
        left, right = make(draw, b)
        program = b.program({"left": [left], "right": [right]})
        signs = {name: draw.choice((Range.FREE, Range.FREE, Range.POSITIVE)) for name in NAMES}
        known = {n: s for n, s in signs.items() if n in program.inputs and s is not Range.FREE}
        finding = decide(Statement("nearly an identity", program, known))
        with mpmath.workdps(50):
            different = apart(draw, program, signs)
        assert not (finding.shown and different), finding
        # All of these turns have points on the circle: what is true of them is shown.
        assert finding.shown or different or make is not turns, finding
        shown += finding.shown
        refuted += finding.verdict is Verdict.REFUTED
    assert shown > count // 4
    assert refuted > count // 10
