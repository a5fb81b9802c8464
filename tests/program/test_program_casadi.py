"""Programs become CasADi functions of the same value."""

import casadi
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from mechanics.errors import ExpressionError
from mechanics.program import Builder, Program, interpret
from mechanics.program.casadi_printer import print_function
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
