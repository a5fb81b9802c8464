"""Equal nodes are one node; what is frozen depends on what is computed alone."""

from fractions import Fraction
from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from mechanics.errors import ExpressionError
from mechanics.program import Builder, Node, Obligation
from mechanics.program.composed import COMPOSED, build
from mechanics.program.interpret import include, interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.program.operations import ARITY, OPERATIONS, Sign
from mechanics.simulate.reference_series import FixedPoint


def test_rows_stand_at_their_codes() -> None:
    assert [row.code for row in OPERATIONS] == list(range(len(OPERATIONS)))
    assert len({row.name for row in OPERATIONS}) == len(OPERATIONS)
    assert len(ARITY) == len(OPERATIONS)


def test_equal_nodes_are_one_node() -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    assert x * y + x.sin() == x.sin() + y * x
    assert (x - y) == -(y - x)
    assert x * 2 * 3 == 6 * x
    assert (-x).sin() == -(x.sin())
    assert (-x).cos() == x.cos()
    assert b.solve([[x, y], [y, x]], [x, y]) == b.solve([[x, y], [y, x]], [x, y])


@given(st.fractions(), st.fractions())
def test_rationals_are_folded_exactly(p: Fraction, q: Fraction) -> None:
    b = Builder()
    a, c = b.constant(p), b.constant(q)
    assert (a + c).constant == p + q
    assert (a - c).constant == p - q
    assert (a * c).constant == p * q
    assert (-a).constant == -p
    assert abs(a).constant == abs(p)
    assert b.less(a, c).constant == (p < q)
    if q:
        assert (a / c).constant == p / q


def test_the_text_does_not_depend_on_what_was_built_before() -> None:
    def text(first: str) -> str:
        b = Builder()
        b.input(first)
        x, y = b.input("x"), b.input("y")
        if first == "y":
            _ = y * x, y.cos() + x
        return b.program({"value": [(x * y + y.cos()) * (x + y.cos())]}).digest

    assert text("x") == text("y") == text("z")


def test_a_program_that_is_included_is_the_same_program() -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    a, c = b.solve([[x, y], [y, x + 3]], [x.sin(), y.sqrt()], symmetric=True)
    program = b.program({"a": [a * b.pi], "b": [c, b.call("atan2", x, y)]})
    other = Builder()
    assert other.program(include(other, program)) == program


def test_demands_are_recorded_before_anything_is_folded() -> None:
    b = Builder()
    x = b.input("x")
    assert (0 * x.sqrt()).is_zero
    assert (x.log() - x.log()).is_zero
    assert (x / x).constant == 1
    signs = {(o.sign, o.node, o.operation) for o in b.obligations}
    assert signs == {
        (Sign.NONNEGATIVE, x.number, "sqrt"),
        (Sign.POSITIVE, x.number, "log"),
        (Sign.NONZERO, x.number, "divide"),
    }


@pytest.mark.parametrize("name", COMPOSED)
def test_what_is_composed_takes_as_many_operands_as_it_says(name: str) -> None:
    b = Builder()
    operands = [b.input(f"x{k}") for k in range(COMPOSED[name].arity)]
    program = b.program({"value": [build(b, name, *operands)]})
    assert len(program.inputs) == COMPOSED[name].arity
    with pytest.raises(TypeError):
        build(b, name, *operands, b.one)


EIGHTH = Fraction(1, 8)
BORDERS = {
    "sqrt": (0, -EIGHTH), "log": (EIGHTH, 0), "asin": (1, 1 + EIGHTH), "acos": (-1, -1 - EIGHTH),
    "acosh": (1, 1 - EIGHTH), "atanh": (1 - EIGHTH, 1),
}  # fmt: skip
"""Where an operation has a value, and where it has none, an eighth further."""
SENSES = {
    Sign.NONNEGATIVE: lambda x: x >= 0, Sign.POSITIVE: lambda x: x > 0, Sign.NONZERO: lambda x: x,
}  # fmt: skip


@pytest.mark.parametrize("name", BORDERS)
def test_demands_are_met_where_an_operation_has_a_value(name: str) -> None:
    b = Builder()
    x = b.input("x")
    b.call(name, x)
    asked = list(b.obligations)
    assert asked
    program = b.program({"demands": [Node(b, o.node) for o in asked]})
    for value, defined in zip(BORDERS[name], (True, False), strict=True):
        values = interpret(program, Arrays(), {"x": float(value)})["demands"]
        met = (SENSES[o.sign](v) for o, v in zip(asked, values, strict=True))
        assert all(met) is defined


FOLDED = [row.name for row in OPERATIONS if row.exact]


@pytest.mark.parametrize("name", FOLDED)
def test_constants_are_folded_to_what_numpy_computes(name: str) -> None:
    arity = next(row.arity for row in OPERATIONS if row.name == name)
    for values in product((-2, 0, 1, Fraction(3, 2)), repeat=arity):
        b = Builder()
        folded = b.call(name, *map(b.constant, values)).constant
        computed = Arrays().operations[name](*map(float, values))
        assert folded is not None and float(folded) == float(computed), values


def test_a_demand_knows_the_branch_it_stands_in() -> None:
    b = Builder()
    x = b.input("x")
    inside = b.less(0, x)
    with b.under(inside, True):
        positive = x.sqrt()
    value = inside.choose(positive, 0)
    assert value.constant is None
    assert list(b.obligations) == [
        Obligation(Sign.NONNEGATIVE, x.number, "sqrt", ((inside.number, True),))
    ]


def test_constants_have_no_open_demands() -> None:
    b = Builder()
    assert b.constant(4).sqrt().constant == 2
    _ = b.constant(2).sqrt(), b.constant(3).log(), b.input("x") / 3
    assert not b.obligations
    _ = b.constant(-1).sqrt()
    assert [o.sign for o in b.obligations] == [Sign.NONNEGATIVE]


def test_what_cannot_be_is_refused() -> None:
    b = Builder()
    x = b.input("x")
    with pytest.raises(ExpressionError, match="division by the constant 0"):
        _ = x / 0
    with pytest.raises(ExpressionError, match="finite"):
        b.constant(float("nan"))
    with pytest.raises(ExpressionError, match="gamma"):
        b.call("gamma", x)
    with pytest.raises(ValueError, match="two builders"):
        _ = x + Builder().input("x")
    with pytest.raises(ValueError, match="input x is used and not listed"):
        b.program({"x": [x]}, inputs=["y"])
    with pytest.raises(TypeError, match="truth value"):
        bool(x)


@given(st.integers(-9, 9))
def test_integer_powers_are_products(n: int) -> None:
    b = Builder()
    assert b.constant(Fraction(3, 2)).power(n).constant == Fraction(3, 2) ** n
    power: Node = b.input("x").power(n)
    assert "power" not in b.program({"p": [power]}).counts()


@pytest.mark.parametrize("n", [-300, -65, 65, 300])
def test_large_powers_have_their_sign(n: int) -> None:
    b = Builder()
    program = b.program({"p": [b.input("x").power(n)]})
    (found,) = interpret(program, Arrays(), {"x": 1.01})["p"]
    assert found == pytest.approx(1.01**n)


def test_programs_of_many_nodes_need_no_recursion() -> None:
    b = Builder()
    x, value = b.input("x"), b.input("y")
    for _ in range(20_000):
        value = value * x + x
    program = b.program({"value": [value]})
    assert program.count == 40_000
    assert len(repr(program)) < 80


def test_truth_values_are_denied_in_one_way() -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    less = b.less(x, y)
    denied = b.call("not", less)
    assert denied == 1 - less == b.call("equal", less, 0) == b.call("equal", 0, less)
    assert b.call("not", denied) == less == b.call("equal", 1, less)
    assert b.call("not", b.call("not", x)) != x


def test_a_linear_system_needs_a_domain_that_solves() -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    program = b.program({"f": b.solve([[x, y], [y, x]], [x, y])})
    with pytest.raises(ExpressionError, match="operation solve is not supported"):
        interpret(program, FixedPoint(64), {"x": 1 << 64, "y": 2 << 64})
