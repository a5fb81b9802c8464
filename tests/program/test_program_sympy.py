"""SymPy expressions become programs, and programs SymPy expressions, of the same value."""

from fractions import Fraction

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy
from sympy import Rational, Symbol, symbols

from mechanics.errors import ExpressionError
from mechanics.program import Builder, Program, interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.program.operations import Sign
from mechanics.program.sympy_printer import expressions, written_size
from mechanics.program.sympy_reader import read

x, y, z = symbols("x y z")
POINTS = {
    "x": np.array([0.31, -1.27, 1.91]),
    "y": np.array([0.77, 1.39, -0.63]),
    "z": np.array([-1.13, 0.59, 1.71]),
}


def program_of(*found: sympy.Basic) -> Program:
    b = Builder()
    return b.program({"f": read(b, found)})


def value_of(expression: sympy.Basic, **values: float) -> float:
    return float(interpret(program_of(expression), Arrays(), values)["f"][0])


@settings(max_examples=80, deadline=None)
@given(data=st.data())
def test_what_is_printed_and_read_again_has_the_same_values(
    programs: SearchStrategy[Program], data: st.DataObject
) -> None:
    program = data.draw(programs)
    printed = expressions(program)
    b = Builder()
    again = b.program({name: read(b, found) for name, found in printed.items()}, program.inputs)
    before, after = (interpret(p, Arrays(), POINTS) for p in (program, again))
    for name in program.outputs:
        for left, right in zip(before[name], after[name], strict=True):
            np.testing.assert_allclose(
                np.broadcast_to(left, 3), np.broadcast_to(right, 3), rtol=1e-9, atol=1e-9
            )


@pytest.mark.parametrize(
    "expression",
    [
        x / y / z / 3, sympy.sqrt(x) ** -3 * y, x ** Rational(2, 3), x**y, x**-y, x**-5, 2**x,
        sympy.Mod(x, y), sympy.Mod(-x, y), sympy.ceiling(x * 5), sympy.floor(-x * 5),
        sympy.frac(x * 7), sympy.Max(x, y, z), sympy.Min(x, y, z), sympy.Abs(x - y),
        sympy.sign(x - y), sympy.Heaviside(x - y), sympy.E * sympy.pi * x, sympy.exp(-x),
        sympy.log(x), sympy.cot(x), sympy.sec(x), sympy.csc(x), sympy.coth(x), sympy.sech(x),
        sympy.csch(x), sympy.atan2(x, y), sympy.erf(x), sympy.tan(x), sympy.asin(x / 9),
        sympy.acos(x / 9), sympy.atan(x), sympy.sinh(x), sympy.cosh(x), sympy.tanh(x),
        sympy.asinh(x), sympy.acosh(x + 2), sympy.atanh(x / 9), sympy.Float(0.1) * x,
        sympy.Piecewise((x, x > y), (y, x + y <= 1), (z, True)),
        sympy.Piecewise((x, sympy.And(x > y, sympy.Ne(x, z), y > 0)), (y, x > -9)),
        sympy.Piecewise((x, sympy.Or(x >= y, sympy.Eq(x, z))), (z, sympy.Not(x > y))),
    ],
)  # fmt: skip
def test_every_head_has_the_value_that_sympy_gives_it(expression: sympy.Expr) -> None:
    for point in ({"x": 0.7, "y": 2.3, "z": 1.1}, {"x": 3.4, "y": 0.6, "z": 5.3}):
        wanted = expression.subs({Symbol(name): Rational(value) for name, value in point.items()})
        found = interpret(program_of(expression), Arrays(), point)["f"][0]
        assert float(found) == pytest.approx(float(wanted.evalf(30)), rel=1e-13)


def test_at_zero_heaviside_is_a_half() -> None:
    assert value_of(sympy.Heaviside(x), x=0.0) == 0.5
    assert value_of(sympy.Heaviside(x, 1), x=0.0) == 1


def test_a_float_is_the_dyadic_rational_that_it_is() -> None:
    b = Builder()
    (node,) = read(b, [sympy.Float(0.1)])
    assert node.constant == Fraction(0.1)
    (node,) = read(b, [sympy.Float("0.1", 30)])
    assert 0 < abs(node.constant - Fraction(1, 10)) < Fraction(1, 10**29)


def test_factors_with_negative_powers_are_one_divisor() -> None:
    assert program_of(x / (y * z * 3)).counts() == {"divide": 1, "multiply": 2}
    assert program_of(x - y).counts() == {"subtract": 1}


def test_a_branch_stands_under_its_condition() -> None:
    b = Builder()
    read(b, [sympy.Piecewise((sympy.sqrt(x), x > 0), (sympy.log(-x), x < 0), (y / x, True))])
    (positive,) = read(b, [x > 0])
    (negative,) = read(b, [x < 0])
    first, second, third = b.obligations
    assert first.conditions == ((positive.number, True),)
    assert second.conditions == ((positive.number, False), (negative.number, True))
    assert third.conditions == ((positive.number, False), (negative.number, False))


def test_what_a_branch_shares_with_the_rest_is_demanded_without_it() -> None:
    root = sympy.sqrt(x)
    for order in ([root, sympy.Piecewise((root, y > 0), (y, True))],
                  [sympy.Piecewise((root, y > 0), (y, True)), root]):  # fmt: skip
        b = Builder()
        read(b, order)
        assert () in {o.conditions for o in b.obligations}


def test_cases_that_do_not_cover_everything_leave_a_demand() -> None:
    b = Builder()
    read(b, [sympy.Piecewise((x, x > y))])
    (obligation,) = b.obligations
    assert (obligation.sign, obligation.operation) == (Sign.NONZERO, "select")


def test_a_symbol_is_an_input_or_a_node_that_is_given() -> None:
    b = Builder()
    t = Symbol("t")
    theta = sympy.Function("theta")(t)
    node = b.input("q")
    (found,) = read(b, [theta**2 + x], {theta: node})
    assert found == node * node + b.input("x")


@pytest.mark.parametrize(
    ("expression", "message"),
    [
        (sympy.gamma(x), "gamma"),
        (sympy.zoo, "ComplexInfinity"),
        (sympy.oo + x, "Infinity"),
        (sympy.I * x, "ImaginaryUnit"),
        (sympy.Function("f")(x), "f"),
        (sympy.nan, "NaN"),
        (Symbol("x", positive=True) + x, "two different symbols are called x"),
        (sympy.Integral(sympy.exp(x**x), x), "Integral"),
    ],
)
def test_what_has_no_meaning_is_named(expression: sympy.Basic, message: str) -> None:
    with pytest.raises(ExpressionError, match=message):
        read(Builder(), [expression])


def test_forms_that_are_too_long_to_read_are_refused() -> None:
    b = Builder()
    node = b.input("x")
    for _ in range(60):
        node = node.sin() * node
    program = b.program({"f": [node]})
    assert program.count == 120
    assert written_size(program) == 2 * (2**60 - 1)
    with pytest.raises(ExpressionError, match="more than 100000"):
        expressions(program)


@pytest.mark.campaign
def test_what_is_shared_is_read_once() -> None:
    e = x
    for _ in range(300):
        e = sympy.sin(e) * e
    b = Builder()
    read(b, [e])
    assert len(b) == 603  # written out, it has 2^300 operations
