r"""A percent sign begins a comment in LaTeX alone, three dots go on at the end of a line alone.

50 % of it: $a = b$        read        a = b ... - c        refused, or goes on in MATLAB's code
"""

import pytest

import mechanics
from mechanics.claims.latex.blocks import page
from mechanics.claims.latex.comments import SIGN
from mechanics.errors import InputError
from systems import rod_pendulum

SCENE = rod_pendulum.scene()
RIGHT = r"$$\frac{m l^2}{3}\ddot\theta = \frac{m g l}{2}\sin\theta + u$$"
WRONG = r"\ddot\theta = \frac gl\sin\theta"
LINE = "m*l^2/3*theta'' = m*g*l/2*sin(theta) + u"


def check(tmp_path, text: str, name: str = "a.md"):
    file = tmp_path / name
    file.write_text(text)
    return mechanics.check(SCENE, file, blame=False)


@pytest.mark.parametrize(
    "before",
    ["50 % of it: ", "- 5 % error: ", "| 5 % | ", "[x](a%20b.html) ", "{% raw %} ", "%% "],
)
def test_prose_behind_a_percent_sign_is_read(tmp_path, before):
    found = check(tmp_path, f"{RIGHT}\n\n{before}${WRONG}$\n")
    assert found.verdict.name == "REFUTED"


def test_words_behind_a_percent_sign_deny(tmp_path):
    words = "The inertia is to 0 % known and this is 100 % wrong."
    assert check(tmp_path, f"{RIGHT}\n\n{words}\n").verdict.name == "UNDECIDED"


def test_words_behind_a_percent_sign_are_quoted_with_it(tmp_path):
    found = check(tmp_path, f"{RIGHT}\n\nSteel has 2 % of carbon.\n")
    assert found.unjudged == ("Steel has 2 % of carbon",)


def test_a_comment_within_a_formula_is_one_and_is_quoted(tmp_path):
    found = check(tmp_path, RIGHT.replace(" + u", f" % {WRONG}\n + u"))
    assert found.verdict.name == "PROVED"
    assert found.unjudged == (WRONG,)


def test_a_comment_of_a_document_is_one_and_is_quoted(tmp_path):
    text = f"\\documentclass{{article}}\\begin{{document}}\n{RIGHT}\n% ${WRONG}$\n\\end{{document}}"
    for name in ("a.tex", "a.md"):
        found = check(tmp_path, text, name)
        assert found.verdict.name == "PROVED"
        assert found.unjudged == (f"${WRONG}$",)


@pytest.mark.parametrize(
    ("hidden", "name"),
    [("\\begin{comment}\n?\n\\end{comment}", "a.tex"), ("\\iffalse\n?\n\\fi", "a.tex")],
)
def test_what_is_not_printed_is_quoted(tmp_path, hidden, name):
    found = check(tmp_path, f"{RIGHT}\n{hidden.replace('?', WRONG)}\n", name)
    assert found.verdict.name == "PROVED"
    assert found.unjudged == (WRONG,)


@pytest.mark.parametrize("marks", ["%{\n?\n%}", "#=\n?\n=#"])
def test_a_comment_over_lines_of_a_text_is_quoted(tmp_path, marks):
    said = "theta'' = g/l*sin(theta)"
    found = check(tmp_path, f"{LINE}\n{marks.replace('?', said)}\n", "a.txt")
    assert found.unjudged == (said,)


def test_no_place_moves():
    text = f"5 % of {RIGHT} % and \\% and $a % b$\n"
    assert len(page(text)) == len(text)
    assert page(text).replace(SIGN, "%") == text
    assert page(text).count(SIGN) == 2


@pytest.mark.parametrize(
    "behind",
    [" ... - 0.1*theta'", "...", " ... is wrong", " ... theta'' = g/l*sin(theta)",
     " ... ; theta'' = 0", " % 1", " % l", " % (2*pi)"],
)  # fmt: skip
@pytest.mark.parametrize("name", ["a.md", "a.txt"])
def test_what_stands_behind_a_line_of_text_is_not_dropped(tmp_path, name, behind):
    try:
        found = check(tmp_path, f"{LINE}{behind}\n", name)
    except InputError:
        return
    assert found.verdict.name not in ("PROVED", "CERTIFIED")


@pytest.mark.parametrize("on", [" ...\n + u", " ... % the torque\n + u", " % gravity\n + u"])
def test_what_goes_on_is_one_equation(tmp_path, on):
    assert check(tmp_path, LINE.replace(" + u", on), "a.txt").verdict.name == "PROVED"
