"""Numbers in place of parameters: for which values a statement is right, and judged at values."""

import pytest
from sympy import Matrix, solve

from mechanics import check, derive
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from systems import elastic_pendulum, four_bar

SCENE = elastic_pendulum.scene()
RIGHT = "M*L/2*x'' *cos(theta) + M*L^2/3*theta'' + M*g*L/2*sin(theta) = 0"
LIGHT = "x''*cos(theta)/2 + L/3*theta'' + {}*sin(theta) = 0"


def _told(text: str, **options: object) -> tuple[str, ...]:
    (entry,) = check(SCENE, text, blame=False, **options).judged
    assert entry.finding.verdict is Verdict.REFUTED
    return entry.right_if


@pytest.mark.parametrize(
    ("number", "words"),
    [("9.81/2", "g = 9.81"), ("4.9", "g = 9.8"), ("1.62/2", "g = 1.62"), ("5", "g = 10")],
)
def test_the_value_for_which_it_is_right_stands_beside_the_refutation(
    number: str, words: str
) -> None:
    assert _told(LIGHT.format(number)) == (words,)


def test_what_is_wrong_at_all_values_has_none() -> None:
    assert _told("x''*cos(theta)/2 + L/3*theta'' - 9.81*sin(theta)/2 = 0") == ()
    # 1 stands in no statement as a value, so a length that is forgotten is not said to be 1.
    assert _told("M*x''*cos(theta)/2 + M/3*theta'' + M*g/2*sin(theta) = 0") == ()
    assert _told("x''*cos(theta)/2 + L/3*theta'' + 9.81*g*sin(theta)/2 = 0") == ()


def test_several_values_are_the_typical_ones_and_no_more_than_matter() -> None:
    text = "(M + 1)*x'' + 20*x + M*L/2*(theta''*cos(theta) - theta'^2*sin(theta)) = 0"
    assert _told(text) == ("k = 10, m = 1",)


def test_statements_are_judged_where_parameters_have_values() -> None:
    text = LIGHT.format("4.905")
    found = check(SCENE, text, values={"g": 9.81})
    assert found.verdict is Verdict.PROVED
    assert found.judged[0].finding.evidence.endswith("where g = 9.81")
    assert "judged where g = 9.81" in str(found)
    assert check(SCENE, text, values={"g": "9.8"}).verdict is Verdict.REFUTED
    # A symbol and its value are the same thing there.
    assert check(SCENE, RIGHT, values={"g": 9.81, "m": 3}).verdict is Verdict.PROVED
    assert check(SCENE, "V = k*x^2", values={"g": 9.81}).verdict is Verdict.UNDECIDED


@pytest.mark.parametrize(
    ("values", "words"),
    [({"q": 1}, "has no such parameter"), ({"g": "a"}, "is no number"), ({"L": -1}, "negative")],
)
def test_values_that_no_parameter_has(values: dict, words: str) -> None:
    with pytest.raises(InputError, match=words):
        check(SCENE, RIGHT, values=values)


def test_values_that_stand_elsewhere_too_are_refused() -> None:
    scene = four_bar.scene()
    name = scene.parameters[0].name
    with pytest.raises(InputError, match=rf"--value \(values=\) {name}: it occurs in constraints"):
        check(scene, "0 = 0", values={name: 1})
    with pytest.raises(InputError, match="exclude each other: give one"):
        check(SCENE, RIGHT, values={"g": 9.81}, convention="other vertical")


def test_what_sympy_solve_returns_is_an_equation_for_each_entry() -> None:
    known = derive(SCENE, "lagrange")
    ud = Matrix(SCENE.ud)
    solution = solve(list(known.mass * ud - known.forcing), list(ud), dict=True)
    found = check(SCENE, solution)
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED", "PROVED"]
    (table,) = solution
    first = next(iter(table))
    assert check(SCENE, {first: 2 * table[first]}, blame=False).verdict is Verdict.REFUTED
    with pytest.raises(InputError, match="is given as str: pass an expression"):
        check(SCENE, {first: "x"})
