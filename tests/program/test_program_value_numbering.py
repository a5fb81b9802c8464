"""Value numbering: what is equal is one node, and what is equal on one branch alone is not."""

import numpy as np

from mechanics.program import Builder, Program
from mechanics.program.interpret import interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.program.value_numbering import with_one_value


def values(program: Program, **inputs: float) -> list[float]:
    (found,) = interpret(program, Arrays(), inputs).values()
    return [float(value) for value in found]


def test_equal_values_are_one_node() -> None:
    build = Builder()
    x, y = build.input("x"), build.input("y")
    c, s = x.cos(), x.sin()
    program = build.program(
        {"out": [s * (c * y) - c * (s * y), (c * c + s * s) * y, (x + y) * (x + y), x * x + y * y,
                 x * x + (y + 2 * x) * y]}
    )  # fmt: skip
    other = with_one_value(program)
    assert other.count == 5
    one, two = (values(p, x=0.7, y=-1.3) for p in (program, other))
    np.testing.assert_allclose(one, two, rtol=1e-14, atol=1e-15)
    assert two[0] == 0 and two[1] == -1.3


def test_opposite_values_are_one_node_with_a_sign() -> None:
    build = Builder()
    x, y = build.input("x"), build.input("y")
    other = with_one_value(build.program({"out": [x * x - y * y, (y - x) * (y + x)]}))
    assert other.count == 4
    assert values(other, x=2.0, y=3.0) == [-5, 5]


def test_a_root_is_not_what_it_is_on_one_branch() -> None:
    build = Builder()
    x, y = build.input("x"), build.input("y")
    d = x - y
    program = build.program({"out": [d * y, (d * d).sqrt() * y, (-d) * x]})
    other = with_one_value(program)
    for pair in ({"x": 2.0, "y": 1.0}, {"x": 1.0, "y": 2.0}):
        assert values(other, **pair) == values(program, **pair)


def test_a_program_without_equal_values_is_left_as_it_is() -> None:
    build = Builder()
    program = build.program({"out": [build.input("x") * build.input("y")]})
    assert with_one_value(program) is program
