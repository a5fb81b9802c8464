"""Wrong code is shown as the formula that was read from it, with the wrong part marked."""

import re
from dataclasses import replace

import pytest
import sympy
from numpy import cos, sin
from sympy import Matrix, symbols
from sympy import cos as cosine
from sympy.physics.mechanics import dynamicsymbols

from mechanics.blame.result import Edit, Mistake, Repair
from mechanics.judge.check import check
from mechanics.report.answer.check import Check
from mechanics.report.answer.page import check_html
from mechanics.report.answer.places import placed
from systems import elastic_pendulum


def wrong(x, theta, x_dot, theta_dot, M, m, L, k, g):
    """The spring is too stiff in the first row, and the second row is right."""
    push = M * L / 2 * theta_dot**2 * sin(theta)
    det = (M + m) * L / 3 - M * L / 4 * cos(theta) ** 2
    weight = g / 2 * sin(theta)
    x_ddot = (L / 3 * (push - 3 * k * x) + M * L / 2 * weight * cos(theta)) / det
    theta_ddot = -((M + m) * weight + cos(theta) / 2 * (push - 2 * k * x)) / det
    return [x_ddot, theta_ddot]


@pytest.fixture(scope="module")
def found() -> Check:
    return check(elastic_pendulum.scene(), wrong)


def edit(written: str, right: str) -> Edit:
    return Edit(Mistake.TERM, written, right)


def test_edits_are_placed_where_they_stand_as_often_as_they_are() -> None:
    formula = "a = 2*k*x/3 + 12*k**2 + x"
    (one,) = placed(formula, [edit("3", "4")])
    assert one.span == (formula.index("3"), formula.index("3") + 1)
    both = placed("a = k/2 + m/2", [edit("2", "3"), edit("2", "3")])
    assert [found.span for found in both] == [(6, 7), (12, 13)]
    for text in ("x", "k", "9", "2*k**2"):
        (lost,) = placed("x = k*x - k*12", [edit(text, "y")])
        assert lost.span is None
    (told,) = placed("a = 3*k + 3*m/3", [edit("3", "2")], "a = 3*k+2*m/3")
    assert told.span == (10, 11)
    (told,) = placed("a = k*cos(k) - k**2", [edit("k", "m")], "a = k*cos(k)-m**2")
    assert told.span == (15, 16)
    (power,) = placed("a = k**2", [edit("k", "m")])
    assert power.span is None


def test_what_is_divided_by_and_signs_are_told_by_less() -> None:
    (told,) = placed("a = k*x/12 + k/12", [edit("1/12", "1/3")], "a = k*x/3 + k/12")
    assert (told.written, told.right, told.span) == ("12", "3", (8, 10))
    sign = Edit(Mistake.SIGN, "k*x", "(-k*x)")
    (told,) = placed("a = m + k*x", [sign], "a = m - k*x")
    assert (told.written, told.right, told.span) == ("+", "-", (6, 7))
    (told,) = placed("a = k*x", [sign], "a = -k*x")
    assert (told.written, told.right, told.span) == ("k*x", "(-k*x)", (4, 7))


@pytest.mark.campaign
def test_wrong_code_is_told_as_a_formula(found: Check) -> None:
    entry, right = found.told
    assert right is found.judged[1]
    assert entry.statement.source.startswith("x_ddot = ")
    assert found.judged[0].statement.source == "wrong: x_ddot"
    assert "wrong: x_ddot" in entry.statement.place
    assert "x_ddot = " in str(found)


@pytest.mark.campaign
def test_right_statements_and_texts_stay(answered: Check) -> None:
    assert answered.told == answered.judged


def test_the_page_marks_the_formula(found: Check) -> None:
    page = check_html(found)
    card = page[page.index('<article class="statement') : page.index("</article>")]
    assert "wrong: x_ddot" in card
    assert re.findall(r'class="wrong"><mn>(\d+)</mn>', card) == ["3"]
    assert re.findall(r'class="right"><mn>(\d+)</mn>', card) == ["2"]
    assert re.search(r"<code>x_ddot = ", card) is None


def test_a_matrix_is_told_as_a_matrix() -> None:
    M, m, L = symbols("M m L")
    theta = dynamicsymbols("theta")
    mixed = M * L / 2 * cosine(theta)
    wrong = Matrix([[M + m, mixed], [mixed, M * L**2 / 12]])
    found = check(elastic_pendulum.scene(), wrong, about="mass matrix")
    assert (
        "    [[M + m, L*M*cos(theta)/2], [L*M*cos(theta)/2, L**2*M/12]]\n"
        "                                                          ^^\n"
        "    write 3 for 12: the factor is wrong\n"
        "    then PROVED: [[M + m, L*M*cos(theta)/2], [L*M*cos(theta)/2, L**2*M/3]]\n"
    ) in str(found)
    assert "<mtable" in check_html(found)


def test_an_edit_of_a_definition_says_so() -> None:
    text = r"""
    \begin{align}
    I_B &= \frac{M L^{2}}{12} \\
    M \frac{L}{2} \ddot{x} \cos \theta + I_B \ddot{\theta} + M g \frac{L}{2} \sin \theta &= 0
    \end{align}"""
    found = check(elastic_pendulum.scene(), text)
    assert "write 3 for 12 in the definition of I_B: the factor is wrong\n" in str(found)
    assert "in the definition of <math" in check_html(found)


def test_equations_of_sympy_are_numbered_and_spelled_alike() -> None:
    x, theta = dynamicsymbols("x theta")
    L, g = symbols("L g", positive=True)
    t = dynamicsymbols._t
    second = x.diff(t, 2) * cosine(theta) + 2 * L / 3 * theta.diff(t, 2) + g * sympy.sin(theta)
    found = check(elastic_pendulum.scene(), [second, second + g])
    assert [entry.statement.tag for entry in found.told] == ["1", "2"]
    assert not any("Derivative" in entry.statement.source for entry in found.told)
    assert all("theta_ddot" in entry.statement.source for entry in found.told)


def test_a_term_that_may_be_added_on_either_side_is_told_once() -> None:
    found = check(elastic_pendulum.scene(), "(M + m)*x'' + 2*k*x = 0")
    (entry,) = found.judged
    assert entry.blame is not None
    repairs = tuple(
        Repair((Edit(Mistake.MISSING, "", right, (0, 0)),), "", entry.finding)
        for right in ("- a*b", "+ a*b", "+ a*c")
    )
    both = replace(entry, blame=replace(entry.blame, repairs=repairs))
    (told,) = replace(found, judged=(both,)).told
    assert told.blame is not None
    assert [repair.edits[0].right for repair in told.blame.repairs] == ["- a*b", "+ a*c"]
