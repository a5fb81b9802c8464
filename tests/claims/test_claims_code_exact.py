"""What code computes from exact numbers is exact: sqrt(3) is no double."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import sympy
from sympy import Expr, Symbol, pi, sqrt

from mechanics.claims.code.constants import constant_of
from mechanics.claims.code.trace.tracing import trace
from mechanics.cli.program_listing import program_python
from mechanics.crosscheck import derive
from mechanics.judge.check import check
from tests.serial_arms import serial_arm

X = Symbol("x", real=True)
THIRD = np.sqrt(3) / 3


def returned(function: Callable[..., Any]) -> Expr:
    return trace(function, {"x": X}).values[0][0]


@pytest.mark.parametrize(
    ("function", "formula"),
    [
        (lambda x: np.sqrt(3) * x, sqrt(3) * X),
        (lambda x: x * np.sqrt(3) ** 2 / 4, 3 * X / 4),
        (lambda x: x * (1 / 2 * np.sqrt(3)) ** 2, 3 * X / 4),
        (lambda x: math.sqrt(2) * x, sqrt(2) * X),
        (lambda x: np.cos(np.pi / 6) * x, sqrt(3) * X / 2),
        (lambda x: math.cos(math.radians(30)) + x, sqrt(3) / 2 + X),
        (lambda x: np.sin(np.pi * x), sympy.sin(pi * X)),
        (lambda x: np.float64(2) * np.sqrt(2) * x, 2 * sqrt(2) * X),
        (lambda x: np.hypot(1, 2) * x, sqrt(5) * X),
        (lambda x: np.arctan2(1, np.sqrt(3)) * x, pi * X / 6),
        (lambda x: np.power(2, 0.5) * x, sqrt(2) * X),
        (lambda x: (np.sqrt(np.array([2.0, 3.0])) * x)[1], sqrt(3) * X),
        (lambda x: (np.array([1, x]) * np.sqrt(2)).sum(), sqrt(2) + sqrt(2) * X),
        (lambda x: (np.arange(3) * np.sqrt(2))[2] * x, 2 * sqrt(2) * X),
        (lambda x: (np.array([[np.sqrt(2), 0], [0, 1]]) @ np.array([x, x]))[0], sqrt(2) * X),
        (lambda x: np.cos(np.array([x, 0]))[1] * x, X),
        (lambda x: np.abs(-np.sqrt(2)) * x, sqrt(2) * X),
        (lambda x: THIRD * x, sqrt(3) * X / 3),
        (lambda x: math.exp(1) * x if math.sqrt(2) > 1.4 else 0, sympy.E * X),
        (lambda x: int(np.sqrt(9)) * x, 3 * X),
        (lambda x: x * len(range(int(2 * np.pi))), 6 * X),
        (lambda x: np.linalg.norm([1.0, 1.0]) / np.sqrt(2) * x, X),
    ],
)
def test_numbers_that_code_computes_are_exact(function: Callable[..., Any], formula: Expr) -> None:
    assert sympy.simplify(returned(function) - formula) == 0


def test_a_number_that_is_refined_in_a_loop_becomes_a_double() -> None:
    def function(x: Any) -> Any:
        root = math.sqrt(2) + 1 / 7
        for _ in range(30):
            root = (root + 2 / root) / 2
        return root * x

    assert float(returned(function).subs(X, 1)) == pytest.approx(math.sqrt(2))


@pytest.mark.parametrize("value", [sqrt(3) / 2, -sqrt(2), sqrt(5) / 5, sqrt(sympy.Rational(1, 7))])
def test_a_double_that_was_a_root_is_that_root(value: Expr) -> None:
    number, note = constant_of(float(value))
    assert number == value
    assert note


@pytest.mark.parametrize("value", [math.exp(1), math.sin(1), 1.2345678901234567])
def test_other_doubles_stay_what_they_are(value: float) -> None:
    assert constant_of(value)[0] == sympy.Rational(value)


@pytest.mark.parametrize("size", [1e-9, 1e-3, 1.0, 1e4, 1e5, 1e6, 1e7, 1e12])
def test_drawn_doubles_stand_for_nothing_simpler(size: float) -> None:
    for value in size * np.random.default_rng(1).uniform(1, 10, 200):
        assert constant_of(value)[0] == sympy.Rational(float(value))


@pytest.mark.campaign
def test_what_is_printed_of_an_arm_with_turns_of_a_third_is_shown() -> None:
    scene = serial_arm(2, "zz", "x", turn=pi / 3, zero="abcxyz").scene
    text = program_python(derive(scene, "free_body"), {})
    assert "sqrt(3)" in text
    module: dict[str, Any] = {}
    exec(text, module)
    found = check(scene, module["residual"], blame=False)
    assert found.ok, str(found)
