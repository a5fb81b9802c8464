"""Statements that are known to be true or false; a run of the kernel decides them first.

Each part of the kernel has one that passes only if that part works, and one that a part which says
yes to everything would let pass.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from mechanics.kernel.statement import LEFT, RIGHT, Range, Statement
from mechanics.program import Builder, Node


def _statement(subject: str, left: Node, right: Node, **signs: Range) -> Statement:
    program = left.builder.program({LEFT: [left], RIGHT: [right]})
    return Statement(f"canary: {subject}", program, signs)


def _angle_sum() -> Statement:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    sines = x.sin() * y.cos() + x.cos() * y.sin()
    return _statement("sin(x + y)", (x + y).sin(), sines)


def _wrong_angle_sum() -> Statement:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    sines = x.sin() * y.cos() - x.cos() * y.sin()
    return _statement("sin(x + y) with a wrong sign", (x + y).sin(), sines)


def _solution() -> Statement:
    b = Builder()
    x, y, z = b.input("x"), b.input("y"), b.input("z")
    solution = b.solve([[x, y], [y, z]], [x * z, y * z], symmetric=True)
    return _statement("M x = f", x * solution[0] + y * solution[1], x * z)


def _wrong_solution() -> Statement:
    b = Builder()
    x, y, z = b.input("x"), b.input("y"), b.input("z")
    solution = b.solve([[x, y], [y, z]], [x * z, y * z], symmetric=True)
    return _statement("M x = 2 f", x * solution[0] + y * solution[1], 2 * x * z)


def _root_of_product() -> Statement:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    return _statement(
        "sqrt(x y)", (x * y).sqrt(), x.sqrt() * y.sqrt(), x=Range.POSITIVE, y=Range.POSITIVE
    )


def _root_of_square() -> Statement:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    return _statement("sqrt((x - y)**2) = x - y", ((x - y) * (x - y)).sqrt(), x - y)


def _tiny_difference() -> Statement:
    b = Builder()
    x = b.input("x")
    return _statement("x (1 + 2**-200) = x", x * (1 + Fraction(1, 2**200)), x)


CANARIES: tuple[tuple[Callable[[], Statement], bool], ...] = (
    (_angle_sum, True),
    (_wrong_angle_sum, False),
    (_solution, True),
    (_wrong_solution, False),
    (_root_of_product, True),
    (_root_of_square, False),
    (_tiny_difference, False),
)
"""What makes a statement, and whether it is true."""
