"""Of two opposite differences one is computed, and nothing else changes."""

from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from mechanics.program import Builder, Program, interpret
from mechanics.program.differences import with_one_difference
from mechanics.program.elimination import expand_solves
from mechanics.program.numpy_domain import Arrays

POINT = {"x": 0.31, "y": -1.27, "z": 1.91}


def test_the_second_of_two_opposite_differences_is_a_sign() -> None:
    b = Builder()
    x, y, c, d = map(b.input, "xycd")
    program = b.program({"f": [c + d * (x - y), c * (y - x) + d]})
    found = with_one_difference(program)
    assert (program.count, found.count) == (6, 5)
    assert found.counts()["subtract"] == 2  # x - y and d - c (x - y)


def test_a_sign_costs_nothing_where_there_is_one_difference() -> None:
    b = Builder()
    x, y = map(b.input, "xy")
    program = b.program({"f": [x - y, -(x * y), (y / x) - 1]})
    assert with_one_difference(program) is program


@settings(max_examples=60, deadline=None)
@given(data=st.data())
def test_values_are_the_same_to_the_last_bit(
    programs: SearchStrategy[Program], data: st.DataObject
) -> None:
    program = expand_solves(data.draw(programs))
    found = with_one_difference(program)
    assert found.count <= program.count
    values = [interpret(one, Arrays(), POINT) for one in (program, found)]
    for name, want in values[0].items():
        assert [repr(float(v)) for v in values[1][name]] == [repr(float(v)) for v in want]
