"""A name that is guessed by its unit, where a comment of the file says what it is."""

from pathlib import Path

import pytest

from mechanics import check
from mechanics.judge.sources import Around
from tests.notation_scenes import truth

CODE = """from sympy import Eq, Symbol, sin
from sympy.physics.mechanics import dynamicsymbols
theta, g, a = dynamicsymbols("theta"), Symbol("g"), Symbol("a")  # {}
def equation(): return Eq(theta.diff(dynamicsymbols._t, 2), -g/a*sin(theta))
"""


@pytest.mark.parametrize(
    ("comment", "verdict"),
    [
        ("a = 2*l, twice the length", "UNDECIDED"),
        ("a is 2 l", "UNDECIDED"),
        ("a is the length of the rod", "PROVED"),
        ("symbols of the text", "PROVED"),
    ],
)
def test_a_comment_that_says_what_a_name_is(comment: str, verdict: str, tmp_path: Path) -> None:
    code = CODE.format(comment)
    names: dict[str, object] = {}
    exec(code, names)
    found = check(truth("pendulum"), [names["equation"], Around(code, frozenset(("equation",)))])
    assert found.verdict.name == verdict


LAW = """from math import sin
{}
def acc(theta, a, g):
    return -g/a*sin(theta)
{}
"""


@pytest.mark.parametrize(
    ("before", "after", "verdict"),
    [
        ("R = 1\na = 2*R", "", "UNDECIDED"),
        ("R = 1\nb = 2*R\na = b", "", "UNDECIDED"),
        ("L, a = 1, 2", "", "UNDECIDED"),
        ("R = 1\nvalues = dict(a=2*R)", "", "UNDECIDED"),
        ("R = 1\nvalues = {'a': 2*R}", "", "UNDECIDED"),
        ("", "R = 1\nprint(acc(0.1, 2*R, 9.81))", "UNDECIDED"),
        ("a = 2", "", "PROVED"),
        ("length = 1.5", "print(acc(0.1, length, 9.81))", "PROVED"),
        ("L = 1", "print(acc(0.1, L, 9.81))", "PROVED"),
        ("a = float('1.5')", "", "PROVED"),
        ("a = 1.5", "print(f'a = {a}')", "PROVED"),
    ],
)
def test_what_lines_of_the_file_give_a_name(before: str, after: str, verdict: str) -> None:
    code = LAW.format(before, after)
    names: dict[str, object] = {}
    exec(code, names)
    found = check(truth("pendulum"), [names["acc"], Around(code, frozenset(("acc",)))])
    assert found.verdict.name == verdict


@pytest.mark.parametrize(
    ("file", "code", "verdict"),
    [
        ("a.m", "R = 1; a = 2*R;\n{m}", "UNDECIDED"),
        ("a.m", "p.R = 1; p.a = 2*p.R;\n{m}", "UNDECIDED"),
        ("a.m", "a = 2;\n{m}", "PROVED"),
        ("a.jl", "p = (g = 9.81, a = 2b)\n{jl}", "UNDECIDED"),
        ("a.jl", "p = (g = 9.81, a = 2.0)\n{jl}", "PROVED"),
        ("a.cpp", "const double R{{1.0}}, a{{2*R}};\n{cpp}", "UNDECIDED"),
        ("a.cpp", "const double a{{2.0}};\n{cpp}", "PROVED"),
        ("a.mo", "model P parameter Real R = 1; parameter Real a(start = 2*R);{mo}", "UNDECIDED"),
        ("a.mo", 'model P parameter Real a = 1 "twice the rod length";{mo}', "UNDECIDED"),
        ("a.mo", 'model P parameter Real a = 1 "rod length";{mo}', "PROVED"),
    ],
)
def test_what_files_of_other_languages_give_a_name(
    file: str, code: str, verdict: str, tmp_path: Path
) -> None:
    laws = {
        "m": "function w = acc(theta, a, g)\nw = -g/a*sin(theta);\nend\n",
        "jl": "function acc(theta, a, g)\n return -g/a*sin(theta)\nend\n",
        "cpp": "double acc(double theta, double a, double g) {return -g/a*std::sin(theta);}\n",
        "mo": " parameter Real g = 9.81; Real theta; Real w;\nequation\n der(theta) = w;"
        "\n der(w) = -g/a*sin(theta);\nend P;\n",
    }
    path = tmp_path / file
    path.write_text(code.format(**laws))
    assert check(truth("pendulum"), path).verdict.name == verdict
