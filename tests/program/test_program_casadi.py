"""Programs become CasADi functions of the same value, and these become programs."""

import casadi
import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from mechanics.errors import ExpressionError
from mechanics.program import Builder, Program, interpret
from mechanics.program.casadi_printer import print_function
from mechanics.program.casadi_reader import read
from mechanics.program.numpy_domain import Arrays

POINT = {"x": 0.31, "y": -1.27, "z": 1.91}


@settings(max_examples=100, deadline=None)
@given(data=st.data())
def test_a_function_has_the_values_of_its_program(
    programs: SearchStrategy[Program], data: st.DataObject
) -> None:
    program = data.draw(programs)
    function = print_function(program, "f", {"v": ["z", "x"], "w": ["y"]})
    found = function([POINT["z"], POINT["x"]], POINT["y"])
    wanted = interpret(program, Arrays(), POINT)
    for name, values in zip(wanted, found, strict=True):
        np.testing.assert_allclose(
            np.array(values).ravel(), np.array(wanted[name], dtype=float), rtol=1e-9, atol=1e-9
        )


def test_an_output_of_no_entries_is_an_empty_column() -> None:
    b = Builder()
    function = print_function(b.program({"none": [], "one": [b.input("x")]}), "f", {"x": ["x"]})
    assert function.size_out("none") == (0, 1)
    assert function.size_out("one") == (1, 1)


def test_outputs_may_be_matrices_row_by_row() -> None:
    b = Builder()
    entries = [b.input("x") * k for k in range(6)]
    program = b.program({"m": entries})
    found = print_function(program, "f", {"x": ["x"]}, {"m": (2, 3)})(1)
    assert np.array(found).tolist() == [[0, 1, 2], [3, 4, 5]]
    with pytest.raises(ExpressionError, match="2 x 2 do not hold"):
        print_function(program, "f", {"x": ["x"]}, {"m": (2, 2)})


def test_inputs_stand_in_one_vector_each() -> None:
    b = Builder()
    program = b.program({"f": [b.input("x")]})
    with pytest.raises(ExpressionError, match="x stands in no vector"):
        print_function(program, "f", {"v": ["y"]})
    with pytest.raises(ExpressionError, match="x stands in two vectors"):
        print_function(program, "f", {"v": ["x"], "w": ["x"]})


def test_a_third_is_a_division_that_rounds_once() -> None:
    b = Builder()
    x = b.input("x")
    outputs = [x / 3, x * -1 / 7, x / 4, x * 2 / 3, b.constant(1) / 3]
    function = print_function(b.program({"f": outputs}), "f", {"x": ["x"]})
    values = np.array(function(5.3)).ravel().tolist()
    assert values == [5.3 / 3, -5.3 / 7, 5.3 / 4, 5.3 * (2 / 3), 1 / 3]
    codes = {function.instruction_id(k) for k in range(function.n_instructions())}
    assert casadi.OP_DIV in codes


def test_functions_of_numbers_are_rounded_once() -> None:
    b = Builder()
    x, three, two = b.input("x"), b.constant(3).sqrt(), b.constant(2).sqrt()
    outputs = [three / 2 * x, (two * two * two) * x, (b.pi / 6).sin() * x, (1 / (1 + two)) * x]
    function = print_function(b.program({"f": outputs}), "f", {"x": ["x"]})
    values = np.array(function(1)).ravel().tolist()
    assert values == [float(sympy.sqrt(3) / 2), float(sympy.sqrt(8)), 0.5, float(sympy.sqrt(2) - 1)]


@settings(max_examples=100, deadline=None)
@given(data=st.data())
def test_what_is_printed_and_read_again_has_the_same_values(
    programs: SearchStrategy[Program], data: st.DataObject
) -> None:
    program = data.draw(programs)
    function = print_function(program, "f", {"v": ["z", "x"], "w": ["y"]})
    b = Builder()
    x, y, z = (b.input(name) for name in "xyz")
    again = b.program(read(b, function, {"v": [z, x], "w": [y]}), program.inputs)
    before, after = (interpret(p, Arrays(), POINT) for p in (program, again))
    for name, values in before.items():
        np.testing.assert_allclose(
            np.array(after[name], float), np.array(values, float), rtol=1e-9, atol=1e-9
        )


X, Y = casadi.SX.sym("x"), casadi.SX.sym("y")


@pytest.mark.parametrize(
    "graph",
    [
        X**2, 2 * X, 1 / X, X**2.5, X**Y, casadi.expm1(X), casadi.log1p(X), casadi.hypot(X, Y),
        casadi.ceil(X), casadi.fmax(X, Y), casadi.fmin(X, Y), casadi.fmod(X, Y),
        casadi.fmod(-X, Y), casadi.copysign(X, -Y), X != Y, casadi.logic_not(X < Y),
        casadi.if_else(X < Y, X, Y), casadi.if_else(X > Y, X, 0), casadi.if_else(X > Y, 0, X),
        casadi.sign(X - Y), casadi.fabs(-X), casadi.erf(X), casadi.atan2(X, Y),
        casadi.logic_and(X < Y, X > 0), casadi.logic_or(X > Y, X > 0),
    ],
)  # fmt: skip
def test_every_operation_has_the_value_that_casadi_gives_it(graph: casadi.SX) -> None:
    function = casadi.Function("f", [X, Y], [graph], ["x", "y"], ["f"])
    b = Builder()
    program = b.program(read(b, function))
    for x, y in ((0.7, 2.3), (5.25, 0.75)):
        (found,) = interpret(program, Arrays(), {"x": x, "y": y})["f"]
        assert float(found) == pytest.approx(float(function(x, y)), rel=1e-14)


def test_a_side_of_if_else_stands_under_its_condition() -> None:
    b = Builder()
    shared = casadi.log(X)
    graph = casadi.if_else(X > 0, casadi.sqrt(X) + shared, 1 / X) + shared
    (node,) = read(b, casadi.Function("f", [X], [graph], ["x"], ["f"]))["f"]
    positive = b.less(0, b.input("x"))
    conditions = {o.operation: o.conditions for o in b.obligations}
    assert conditions["sqrt"] == ((positive.number, True),)
    assert conditions["divide"] == ((positive.number, False),)
    assert () in {o.conditions for o in b.obligations if o.operation == "log"}
    assert node.constant is None


def test_matrices_are_read_row_by_row_and_noughts_are_noughts() -> None:
    matrix = casadi.SX.sym("m", casadi.Sparsity.upper(2))
    function = casadi.Function("f", [matrix], [2 * matrix], ["m"], ["f"])
    b = Builder()
    found = read(b, function)["f"]
    assert found == (2 * b.input("m[0]"), 2 * b.input("m[1]"), b.zero, 2 * b.input("m[3]"))


def test_graphs_of_matrices_are_expanded() -> None:
    x = casadi.MX.sym("x", 2)
    function = casadi.Function("f", [x], [casadi.dot(x, x)], ["x"], ["f"])
    b = Builder()
    program = b.program(read(b, function))
    assert interpret(program, Arrays(), {"x[0]": 3.0, "x[1]": 4.0})["f"] == (25.0,)


def test_what_has_no_meaning_is_named() -> None:
    b = Builder()
    remainder = casadi.Function("f", [X, Y], [casadi.remainder(X, Y)])
    with pytest.raises(ExpressionError, match="OP_REMAINDER"):
        read(b, remainder)
    with pytest.raises(ExpressionError, match="finite"):
        read(b, casadi.Function("f", [X], [X + casadi.inf]))
    with pytest.raises(ExpressionError, match="has 1 entries, 2 found"):
        read(b, casadi.Function("f", [X], [X], ["x"], ["f"]), {"x": [b.one, b.one]})
    interpolant = casadi.interpolant("g", "linear", [[0, 1]], [0, 1])
    with pytest.raises(ExpressionError, match="OP_CALL"):
        read(b, interpolant)


def test_what_does_not_expand_is_refused() -> None:
    a, x = casadi.MX.sym("a", 2, 2), casadi.MX.sym("x", 2)
    with pytest.raises(ExpressionError, match=r"f does not expand to scalars: .*eval_sx"):
        read(Builder(), casadi.Function("f", [a, x], [casadi.solve(a, x)]))
