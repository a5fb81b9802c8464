"""Translation keeps the mathematics, number by number."""

import casadi as ca
import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Abs, Float, Integer, Max, Piecewise, Rational, cos, exp, pi, sin, sqrt

from mechanics.compiled.translate import Translator
from mechanics.errors import ExpressionError
from mechanics.symbolic import Arithmetic, decide

x, y = sympy.symbols("x y", real=True)
a = sympy.Symbol("a", positive=True)
SYMBOLS = (x, y, a)


def graph_of(expression: sympy.Expr) -> tuple[ca.Function, list[sympy.Expr]]:
    """The graph as a function of the symbols and the named constants, and what these are."""
    given_symbols = ca.SX.sym("s", len(SYMBOLS))
    translate = Translator({s: given_symbols[i] for i, s in enumerate(SYMBOLS)})
    graph = ca.densify(translate(expression))
    constants = translate.constants
    inputs = [given_symbols, ca.vertcat(*constants.values()) if constants else ca.SX(0, 1)]
    return ca.Function("f", inputs, [graph]), list(constants)


def instructions(function: ca.Function, operation: int) -> list[int]:
    return [k for k in range(function.n_instructions()) if function.instruction_id(k) == operation]


numbers = st.fractions(min_value=-9, max_value=9, max_denominator=60).map(
    lambda f: Rational(f.numerator, f.denominator)
)
leaves = st.one_of(st.sampled_from([*SYMBOLS, pi, sqrt(2)]), numbers)
expressions = st.recursive(
    leaves,
    lambda inner: st.one_of(
        st.builds(lambda p, q: p + q, inner, inner),
        st.builds(lambda p, q: p - q, inner, inner),
        st.builds(lambda p, q: p * q, inner, inner),
        st.builds(lambda p: p / (a + 3), inner),
        st.builds(lambda p, n: p**n, inner, st.integers(2, 5)),
        st.builds(lambda p: p / sqrt(a), inner),
        st.builds(lambda n: sin(n * x), st.integers(-3, 3)),
        st.builds(lambda n: cos(n * y / 2), st.integers(-3, 3)),
    ),
    max_leaves=8,
)


@settings(max_examples=60, deadline=None)
@given(expressions)
def test_graph_is_the_expression_in_exact_arithmetic(expression: sympy.Expr) -> None:
    function, constants = graph_of(expression)

    def experiment(arithmetic: Arithmetic) -> list:
        ((value,),) = arithmetic.graph(function, symbols=[list(SYMBOLS), constants])
        return [(value, arithmetic.value(expression))]

    assert decide("graph = expression", experiment).shown


@settings(max_examples=60, deadline=None)
@given(expressions)
def test_every_constant_in_a_graph_is_a_dyadic_that_was_meant(expression: sympy.Expr) -> None:
    function, _ = graph_of(expression)
    constants = [function.instruction_constant(k) for k in instructions(function, ca.OP_CONST)]
    # Integers, or integers over a power of two: 1/3 and pi never become doubles.
    assert all(float(c * 2**30).is_integer() for c in constants)


def test_a_third_is_a_division() -> None:
    function, constants = graph_of(x / 3 + y * Rational(2, 7))
    assert len(instructions(function, ca.OP_DIV)) == 2
    assert set(constants) == {3, 7}
    assert float(function([1, 1, 1], [int(c) for c in constants])) == 1 / 3 + 2 / 7


def test_pi_is_named_and_a_product_of_roots_is_shared() -> None:
    function, constants = graph_of(pi * x + a ** Rational(3, 2) + a ** Rational(-1, 2))
    assert constants == [pi]
    assert len(instructions(function, ca.OP_SQRT)) == 1
    assert not instructions(function, ca.OP_POW) + instructions(function, ca.OP_CONSTPOW)


def test_sine_of_one_angle_is_evaluated_once() -> None:
    function, _ = graph_of(sin(x) ** 3 * y + sin(x) * cos(x) + cos(x) ** 2)
    assert len(instructions(function, ca.OP_SIN)) == 1
    assert len(instructions(function, ca.OP_COS)) == 1


@pytest.mark.campaign
def test_depth_does_not_matter() -> None:
    expression = x
    for _ in range(3000):
        expression = sympy.sin(expression + y, evaluate=False)
    function, _ = graph_of(expression)
    assert len(instructions(function, ca.OP_SIN)) == 3000


@pytest.mark.parametrize(
    ("expression", "value"),
    [
        (Piecewise((x, x > 0), (-2 * x, True)), 6.0),
        (Piecewise((1, sympy.And(x < 0, sympy.Not(y > 0))), (0, True)), 0.0),
        (Max(x, y, 1), 2.0),
        (sympy.Min(x, y), -3.0),
        (Abs(x) + sympy.sign(x), 2.0),
        (exp(a) ** 2, np.exp(0.5) ** 2),
        (a**y, 0.25),
        (Float(0.1) * x, -0.1 * 3),
        (Integer(2) ** 60 + 1 + 0 * x, 2.0**60),
        (1 / (x * y), -1 / 6),
        (sympy.atan2(y, x), np.arctan2(2, -3)),
    ],
)
def test_values(expression: sympy.Expr, value: float) -> None:
    function, constants = graph_of(expression)
    found = float(function([-3.0, 2.0, 0.5], [float(c) for c in constants]))
    assert found == pytest.approx(value, rel=1e-15)


@pytest.mark.parametrize(
    ("expression", "words"),
    [
        (sympy.gamma(x), "gamma"),
        (sympy.Function("f")(x), "f"),
        (sympy.I * x, "ImaginaryUnit"),
        (sympy.oo + 0, "Infinity"),
        (sympy.Symbol("unknown") + x, "symbol unknown"),
        (Piecewise((x, x > 0)), "undefined outside its cases"),
    ],
)
def test_what_cannot_be_translated_is_named(expression: sympy.Expr, words: str) -> None:
    with pytest.raises(ExpressionError, match=words):
        graph_of(expression)
