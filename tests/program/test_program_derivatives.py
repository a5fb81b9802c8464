"""Forward and reverse derivatives agree with each other and with central differences."""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics.program import OPERATIONS, Builder, Node, interpret
from mechanics.program.derivatives import gradient
from mechanics.program.forward import tangent
from mechanics.program.numpy_domain import Arrays

POINT = {"x": 0.37, "y": 0.81, "z": 1.9}

SMOOTH = [row.name for row in OPERATIONS if row.arity and row.partials and row.numpy]


def derivative_by_differences(build: Callable[[Builder], Node], name: str) -> float:
    b = Builder()
    program = b.program({"f": [build(b)]}, inputs=list(POINT))
    step = 1e-6
    ends = [
        interpret(program, Arrays(), POINT | {name: POINT[name] + sign * step})["f"][0]
        for sign in (1, -1)
    ]
    return (ends[0] - ends[1]) / (2 * step)


@pytest.mark.parametrize("name", SMOOTH)
def test_every_row_has_right_partial_derivatives(name: str) -> None:
    row = next(row for row in OPERATIONS if row.name == name)

    def build(b: Builder) -> Node:
        x, y, z = (b.input(n) for n in POINT)
        operands = {1: (x,), 2: (x, y), 3: (b.less(x, 1), x * y, y)}[row.arity]
        if name == "acosh":
            operands = (z * y,)
        return b.call(name, *operands)

    for variable in POINT:
        b = Builder()
        value = build(b)
        (forward,) = tangent([value], {b.input(variable): b.one})
        (reverse,) = gradient([value], [1], [b.input(variable)])
        program = b.program({"d": [forward, reverse]}, inputs=list(POINT))
        found = interpret(program, Arrays(), POINT)["d"]
        wanted = derivative_by_differences(build, variable)
        assert found == pytest.approx((wanted, wanted), abs=2e-8)


@pytest.mark.parametrize(("truth", "slopes"), [(1, (1, 0)), (0, (0, 1))])
def test_a_choice_grows_with_what_is_chosen(truth: int, slopes: tuple[int, int]) -> None:
    b = Builder()
    x, y, c = (b.input(n) for n in "xyc")
    value = b.less(0, c).choose(x, y)
    outputs = [*tangent([value], {x: b.one}), *tangent([value], {y: b.one})]
    found = interpret(b.program({"d": outputs}), Arrays(), {"x": 3.0, "y": 5.0, "c": float(truth)})
    assert tuple(found["d"]) == slopes


def test_solutions_of_linear_systems_are_differentiated() -> None:
    def build(b: Builder) -> Node:
        x, y, z = (b.input(n) for n in POINT)
        matrix = [[x + 2, y.sin(), x], [y, z, x * y], [b.one, x, z * z]]
        u, v, w = b.solve(matrix, [x, y * z, z.cos()])
        return u * v - w * x

    for variable in POINT:
        b = Builder()
        value = build(b)
        (forward,) = tangent([value], {b.input(variable): b.one})
        (reverse,) = gradient([value], [1], [b.input(variable)])
        program = b.program({"d": [forward, reverse]}, inputs=list(POINT))
        found = interpret(program, Arrays(), POINT)["d"]
        wanted = derivative_by_differences(build, variable)
        assert found == pytest.approx((wanted, wanted), abs=1e-8)


@settings(max_examples=60)
@given(st.lists(st.tuples(st.integers(0, 5), st.integers(0, 99), st.integers(0, 99)), max_size=30))
def test_reverse_is_the_transpose_of_forward(steps: list[tuple[int, int, int]]) -> None:
    """w . (J v) = (J^T w) . v for whatever is built."""
    b = Builder()
    nodes = [b.input(name) for name in POINT]
    for operation, i, j in steps:
        x, y = nodes[i % len(nodes)], nodes[j % len(nodes)]
        built = (x + y, x - y, x * y, x.sin(), -x, x / (2 + y.cos()))[operation]
        nodes.append(built)
    outputs = nodes[-3:]
    inputs = [b.input(name) for name in POINT]
    directions = [b.constant(k) for k in (2, -3, 5)]
    weights = [b.constant(k) for k in (7, 1, -4)]
    forward = tangent(outputs, dict(zip(inputs, directions, strict=True)))
    reverse = gradient(outputs, weights, inputs)
    left = sum((w * f for w, f in zip(weights, forward, strict=True)), b.zero)
    right = sum((r * d for r, d in zip(reverse, directions, strict=True)), b.zero)
    values = interpret(b.program({"d": [left, right]}, list(POINT)), Arrays(), POINT)["d"]
    assert np.isclose(*values, rtol=1e-9, atol=1e-9)
