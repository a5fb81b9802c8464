"""A program that is written and read again is the same; what is none is refused in one line."""

import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from mechanics.errors import InputError
from mechanics.program import Builder, Program
from mechanics.program.json_format import FORMAT, LONGEST_NAME, read, write


@settings(max_examples=100, deadline=None)
@given(data=st.data())
def test_what_is_written_and_read_again_is_the_same(
    programs: SearchStrategy[Program], data: st.DataObject
) -> None:
    program = data.draw(programs)
    again = read(write(program))
    assert again == program
    assert again.systems == program.systems
    assert write(again) == write(program)


def test_systems_and_all_leaves_are_written() -> None:
    b = Builder()
    x, y = b.input("x"), b.input("Δθ")
    u, v = b.solve([[x, y], [y, x + 3]], [x.sin(), b.pi], symmetric=True)
    program = b.program({"f": [u, b.constant(-3) / 7], "g": [v, u]}, inputs=["Δθ", "unused", "x"])
    assert read(write(program)) == program
    assert read(write(program)).inputs == ("Δθ", "unused", "x")


def whole(nodes: object, inputs: object = ("x",), outputs: object = None) -> str:
    given = {"format": FORMAT, "inputs": inputs, "nodes": nodes, "outputs": outputs or {"f": [0]}}
    return json.dumps(given)


X = ["input", 0]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("[" * 100_000, "no JSON"),
        ("{", "no JSON"),
        ("[]", "format"),
        ('{"format": "another"}', "format"),
        (whole([X])[:-1] + ', "more": 1}', "entry 'more' is not known"),
        (whole([X], inputs=[1]), "named by strings"),
        (whole([X], inputs=["x", "x"]), "one name"),
        (whole([X], inputs=["x\ny"]), "on a line"),
        (whole({}), "list of nodes"),
        (whole([X, 3]), "node 1 is no list"),
        (whole([["explode"]]), "name of an operation"),
        (whole([[["add"]]]), "name of an operation"),
        (whole([["input", 1]]), "refers to something else than the 1 inputs"),
        (whole([["input", True]]), "refers to something else"),
        (whole([["input", -1]]), "refers to something else"),
        (whole([X, ["sin", 1]]), "1 earlier nodes"),
        (whole([X, ["sin", 0, 0]]), "has 2 operands, 1 expected"),
        (whole([["pi", 0]]), "has 1 operands, 0 expected"),
        (whole([["constant", 0.5]]), "no fraction"),
        (whole([["constant", "1/0"]]), "divides by 0"),
        (whole([["constant", "1e9999999"]]), "no fraction"),
        (whole([["constant", "9" * 2001]]), "no fraction"),
        (whole([["constant", "9"], ["multiply", 0, 0]]), "multiply of constants"),
        (whole([X, ["solve", True, 2, 0, 0]]), "2 x 2"),
        (whole([X, ["solve", 1, 1, 0, 0]]), "symmetric"),
        (whole([X, ["solve", True, 0]]), "symmetric"),
        (whole([X, ["solve", True, 1, 0, 0], ["sin", 1]]), "whole system"),
        (whole([X, ["solve", True, 1, 0, 0], ["entry", 1, 1]]), "smaller system"),
        (whole([X, ["entry", 0, 0]]), "something else than a system"),
        (whole([X, ["solve", True, 1, 0, 0]], outputs={"f": [1]}), "whole system"),
        (whole([X], outputs={"f": [1]}), "output f is no list of node numbers"),
        (whole([X], outputs={"f": 0}), "output f is no list of node numbers"),
    ],
)
def test_what_is_no_program_is_refused_in_one_line(text: str, message: str) -> None:
    with pytest.raises(InputError, match=message) as caught:
        read(text)
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 200


def test_names_have_up_to_two_hundred_characters() -> None:
    b = Builder()
    program = b.program({"f": [b.input("x" * LONGEST_NAME)]})
    assert read(write(program)) == program
    longer = b.program({"f": [b.input("x" * (LONGEST_NAME + 1))]})
    with pytest.raises(InputError, match=f"have 1 to {LONGEST_NAME} characters"):
        read(write(longer))


@pytest.mark.campaign
@settings(max_examples=200)
@given(st.recursive(st.none() | st.booleans() | st.integers() | st.text(max_size=8),
                    lambda children: st.lists(children, max_size=4), max_leaves=12))  # fmt: skip
def test_nodes_of_any_shape_are_refused_or_read(nodes: object) -> None:
    try:
        program = read(whole(nodes))
    except InputError as error:
        assert "program" in str(error)
    else:
        assert isinstance(program, Program)
