r"""Verdicts on chosen statements of a page; the rest is read for what letters mean."""

import json
from typing import Any

import pytest

from mechanics import check, check_html, check_json
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from mechanics.report.answer.check import Check
from mechanics.report.answer.sentences import shortened
from mechanics.testing import assert_equivalent
from systems import cartpole, rod_pendulum

RIGHT = r"\frac{m l^2}{3}\ddot\theta = \frac{m g l}{2}\sin\theta + u"
WRONG = r"m l^2\ddot\theta = \frac{m g l}{2}\sin\theta + u"


def answer(text: str, *only: str, **options: Any) -> Check:
    return check(rod_pendulum.scene(), text, only=only, blame=False, **options)


def page(*lines: str) -> str:
    return "\n\n".join(lines)


@pytest.mark.parametrize("what", ["(6)", "line 1", "lines 1-2", r"\frac{ml^2}{3}\ddot{\theta}"])
def test_a_statement_is_chosen_by_number_line_or_left_side(what: str) -> None:
    found = answer(page(rf"\[ {RIGHT} \tag{{6}} \]", rf"\[ {WRONG} \tag{{7}} \]"), what)
    assert (found.verdict, len(found.judged)) == (Verdict.PROVED, 1)
    assert found.aside == ("(7), line 3: " + WRONG,)


@pytest.mark.parametrize("what", ["1-2", "(1)-(2)", "(1-2)", "(1) to (2)"])
def test_a_range_of_numbers_may_have_brackets(what: str) -> None:
    tagged = [(RIGHT, 1), (RIGHT, 2), (WRONG, 3), (WRONG, 4)]
    text = page(*(rf"\[ {row} \tag{{{number}}} \]" for row, number in tagged))
    assert [entry.statement.tag for entry in answer(text, what).judged] == ["(1)", "(2)"]
    assert [entry.statement.tag for entry in answer(text, "4").judged] == ["(4)"]


@pytest.mark.parametrize("what", ["lines 8-5", "4-2", "(4)-(2)"])
def test_a_range_that_runs_backwards_is_refused(what: str) -> None:
    with pytest.raises(InputError, match="runs backwards"):
        answer(rf"\[ {RIGHT} \tag{{4}} \]", what)


def test_a_long_quotation_ends_at_a_token_and_says_so() -> None:
    assert shortened("x" * 120) == "x" * 120
    assert shortened("a" * 114 + " m*L^{2} + 1") == "a" * 114 + " m*…"
    assert shortened("a" * 112 + r" + L^2 \theta") == "a" * 112 + " + L^2…"


@pytest.mark.parametrize("what", ["theta_ddot", "theta''", r"\ddot\theta", r"\ddot{\theta}"])
def test_what_stands_on_the_left_may_be_spelled_in_any_notation(what: str) -> None:
    text = "theta'' = 3/2*g/l*sin(theta) + 3*u/(m*l^2)\nT = m*l^2/2*theta'^2"
    assert answer(text, what).verdict is Verdict.PROVED
    assert answer(text, "T").verdict is Verdict.REFUTED
    assert answer(text, "1-1").verdict is Verdict.PROVED


@pytest.mark.parametrize("what", ["(8)", "line 9", "phi", "lines 2-2"])
def test_what_is_not_there_is_refused_with_what_there_is(what: str) -> None:
    with pytest.raises(InputError, match=r"there are \(6\) in line 1, \(7\) in line 3"):
        answer(page(rf"\[ {RIGHT} \tag{{6}} \]", rf"\[ {WRONG} \tag{{7}} \]"), what)


def test_a_wrong_definition_makes_what_uses_it_wrong() -> None:
    text = page(r"\[ J = m l^2 \]", r"\[ J\ddot\theta = \frac{m g l}{2}\sin\theta + u \tag{6}\]")
    assert answer(text, "(6)").verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    "relation",
    [
        r"\[ 2 l = m \]", r"\[ l \leftarrow 2 a \dbinom{1}{2} \]",
        r"\[ \frac{l}{2} = \sideset{}{}a \]", r"\[ \frac{a}{2} = m l \]",
    ],
)  # fmt: skip
def test_what_relates_letters_and_is_not_shown_leaves_their_users_in_doubt(relation: str) -> None:
    found = answer(page(relation, rf"\[ {RIGHT} \tag{{6}} \]"), "(6)")
    assert found.verdict is Verdict.UNDECIDED


@pytest.mark.parametrize(
    "line", [r"\[ F_1 = - m g \]", r"\[ \ddot\theta = \sideset{}{}a \]", rf"\[ {WRONG} \]"]
)
def test_what_says_nothing_of_the_letters_does_not(line: str) -> None:
    found = answer(page(line, rf"\[ {RIGHT} \tag{{6}} \]"), "(6)")
    assert (found.verdict, len(found.aside)) == (Verdict.PROVED, 1)


def test_a_condition_in_its_own_sentence_counts() -> None:
    text = rf"Only for a heavy rod we have \[ {RIGHT} \tag{{6}} \]"
    assert answer(text, "(6)").verdict is Verdict.UNDECIDED
    found = answer(text, "(6)", "formulas")
    assert (found.verdict, found.aside) == (Verdict.PROVED, ("Only for a heavy rod we have …",))


def test_the_sentence_behind_it_counts_and_one_elsewhere_does_not() -> None:
    rest = "The rod is made of steel. It was bought in Ulm. It is painted red."
    near = page(rf"\[ {RIGHT} \tag{{6}} \]", "This is wrong.", rest)
    far = page(rf"\[ {RIGHT} \tag{{6}} \]", rest, "The other answer is wrong.")
    assert answer(near, "(6)").verdict is Verdict.UNDECIDED
    assert answer(far).verdict is Verdict.UNDECIDED
    assert answer(far, "(6)").verdict is Verdict.PROVED


def test_a_sentence_beside_a_definition_counts_for_what_uses_it() -> None:
    rest = "The rod is made of steel. It was bought in Ulm. It is painted red. It has one end."
    text = page(
        r"Only for a heavy rod, \[ J = m l^2/3. \]", rest,
        r"\[ J\ddot\theta = \frac{m g l}{2}\sin\theta + u \tag{6}\]",
    )  # fmt: skip
    assert answer(text, "(6)").verdict is Verdict.UNDECIDED


@pytest.mark.parametrize("label", [r"\tag{false}", r"\quad\text{(this is wrong)}"])
def test_what_a_formula_says_of_itself_is_never_set_aside(label: str) -> None:
    assert answer(rf"\[ {RIGHT} {label} \]", "formulas").verdict is Verdict.UNDECIDED


def test_what_counts_otherwise_is_never_set_aside() -> None:
    text = page(r"where $\theta$ is measured from the horizontal.", rf"\[ {RIGHT} \tag{{6}} \]")
    assert answer(text, "(6)", "formulas").verdict is not Verdict.PROVED


def test_a_paragraph_of_text_counts_and_another_does_not() -> None:
    line = "theta'' = 3/2*g/l*sin(theta) + 3*u/(m*l^2)"
    assert answer(f"This is wrong\n{line}", "theta_ddot").verdict is Verdict.UNDECIDED
    assert answer(f"The other one is wrong\n\n{line}", "theta_ddot").verdict is Verdict.PROVED


@pytest.mark.parametrize(
    ("words", "verdict"),
    [
        ("where theta is angle. And u is torque in N * m", Verdict.PROVED),
        ("where l is 2*R of it", Verdict.UNDECIDED),
        ("which must be (theta + m g) for all", Verdict.PROVED),
        ("l : 2*R of it", Verdict.UNDECIDED),
    ],
)
def test_words_that_are_read_as_a_formula_may_say_what_letters_are(
    words: str, verdict: Verdict
) -> None:
    text = f"{words}\n\ntheta'' = 3/2*g/l*sin(theta) + 3*u/(m*l^2)"
    assert answer(text, "theta_ddot").verdict is verdict


def test_an_answer_in_doubt_names_what_can_be_chosen() -> None:
    found = answer(page(r"\[ F_1 = - m g \]", rf"\[ {RIGHT} \]"))
    assert "to judge what is shown, without the rest: --only 'line 3' (only=)" in found.suggested
    assert answer(page(r"\[ F_1 = - m g \]", rf"\[ {RIGHT} \]"), "line 3").ok
    told = answer(page("This is wrong.", rf"\[ {RIGHT} \]")).suggested
    assert "to judge the formulas alone: --only formulas (only=)" in told


def test_the_answer_its_page_and_its_json_say_what_was_set_aside() -> None:
    found = answer(page(r"\[ F_1 = - m g \]", rf"\[ {RIGHT} \]"), "line 3")
    words = "What you chose is PROVED: 1 statement. 1 line or sentence is set aside by --only."
    assert words in " ".join(str(found).split()) and words in check_html(found)
    assert r"not judged, as you asked: 'line 1: F_1 = - m g'" in str(found)
    assert "Not judged, as you asked: 1" in check_html(found)
    assert json.dumps(check_json(found)["aside"]) == json.dumps(["line 1: F_1 = - m g"])


def test_an_answer_that_is_not_shown_begins_with_how_many_were_chosen() -> None:
    found = answer(page(*[rf"\[ {RIGHT} \]"] * 2, r"\[ F_1 = - m g \]", rf"\[ {WRONG} \]"), "4")
    assert found.verdict is Verdict.REFUTED
    words = (
        "What you chose is 1 statement, not all of it shown."
        " 3 lines or sentences are set aside by --only."
    )
    assert " ".join(str(found).split()).startswith(words) and words in check_html(found)


def test_equations_that_were_set_aside_are_not_missing() -> None:
    text = page(
        r"\[ (m_c + m_p)\ddot x + m_p l(\ddot\theta\cos\theta - \dot\theta^2\sin\theta) = F \]",
        r"\[ \frac43 l\ddot\theta + \ddot x\cos\theta = g\sin\theta \]",
    )
    found = check(cartpole.scene(), text, only="line 1", blame=False)
    assert found.ok and "of 2 equations of motion given" not in check_html(found)
    whole = check(cartpole.scene(), text.split("\n")[0], blame=False)
    assert "1 of 2 equations of motion given" in check_html(whole)
    with pytest.raises(AssertionError, match="choose more, or pass partial=True"):
        assert_equivalent(text, cartpole.scene(), only="line 1")


def test_no_choice_is_suggested_where_it_changes_nothing() -> None:
    code = "double acc(float theta, double m, double l, double g, double u)\n{\n"
    code += "  float s = sinf(theta);\n  return 1.5*g/l*s + 3*u/(m*l*l);\n}\n"
    found = answer(code, notation="c")
    assert (found.verdict, found.suggested) == (Verdict.UNDECIDED, ())
    assert not answer(code, "formulas", notation="c").ok


def test_a_test_suite_may_choose_too() -> None:
    text = page(rf"\[ {WRONG} \]", rf"\[ {RIGHT} \tag{{6}} \]")
    assert_equivalent(text, rod_pendulum.scene(), only="(6)")
    with pytest.raises(AssertionError):
        assert_equivalent(text, rod_pendulum.scene())


MODEL = """
model Rod
  parameter Modelica.Units.SI.{} l = 1;
  parameter Modelica.Units.SI.Mass m = 1;
  parameter Modelica.Units.SI.Acceleration g = 9.81;
  input Real u;
  Real theta;
  Real w;
equation
  der(theta) = w;
  der(w) = 3*g/(2*l)*sin(theta) + {}/(m*l^2)*u;
end Rod;
"""


def test_formulas_alone_set_a_unit_of_a_declaration_aside() -> None:
    right, wrong = MODEL.format("Time", 3), MODEL.format("Time", 2)
    assert answer(right).verdict is Verdict.UNDECIDED
    found = answer(right, "formulas")
    assert found.verdict is Verdict.PROVED
    assert any("declares l in s" in words for words in found.aside)
    assert answer(wrong, "formulas").verdict is Verdict.REFUTED
    assert answer(MODEL.format("Length", 3)).verdict is Verdict.PROVED


@pytest.mark.parametrize("words", ["e.g. as in a clock", "i.e. a bar", "z.B. als Pendel"])
def test_abbreviations_are_no_words_whose_letters_stand_apart(words: str) -> None:
    assert answer(page(f"A rod, l {words}, moves so:", rf"\[ {RIGHT} \]")).verdict is Verdict.PROVED
