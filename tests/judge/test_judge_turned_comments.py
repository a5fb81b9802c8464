"""An equation in a comment is quoted, wherever the file says it: nobody judges it."""

import pytest

import mechanics
from systems import rod_pendulum

SCENE = rod_pendulum.scene()
JULIA = "function pend(theta, u, m, l, g)\n  return 3g/(2l)*sin(theta) + 3u/(m*l^2)\nend\n"


def quoted(tmp_path, comment: str) -> int:
    file = tmp_path / "mine.jl"
    file.write_text(f"{comment}\n{JULIA}")
    return len(mechanics.check(SCENE, file, blame=False).unjudged)


@pytest.mark.sample(6)
@pytest.mark.parametrize(
    "said",
    ["theta = pi - theta", "l = l/2", "u = -u", "l = 0.5", "theta'' = g/l*sin(theta)",
     "theta_ddot = 3g/(2l)*sin(theta)"],
)  # fmt: skip
@pytest.mark.parametrize("marks", ["# {}", "#=\n{}\n=#", '"""\n{}\n"""'])
def test_a_name_that_is_turned_is_quoted(tmp_path, marks, said):
    assert quoted(tmp_path, marks.format(said)) == 1


@pytest.mark.parametrize("said", ["l <= l", "=====", "[theta; omega]"])
def test_what_says_no_equation_is_not(tmp_path, said):
    assert quoted(tmp_path, f"# {said}") == 0


LINES = {
    "a.c": ("// {}", "double acc(double theta, double u, double m, double l, double g)\n"
            "{ return 3*g/(2*l)*sin(theta) + 3*u/(m*l*l); }\n"),
    "a.m": ("% {}", "function a = acc(theta, u, m, l, g)\na = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2);\n"
            "end\n"),
    "a.mo": ("// {}", "model Rod\n parameter Real m, l, g;\n input Real u;\n Real theta, w;\n"
             "equation\n der(theta) = w;\n m*l^2/3*der(w) = m*g*l/2*sin(theta) + u;\nend Rod;\n"),
    "a.txt": ("# {}", "m*l^2/3*theta'' = m*g*l/2*sin(theta) + u\n"),
    "a.tex": ("% {}", "\\[\\frac{m l^2}{3}\\ddot\\theta = \\frac{m g l}{2}\\sin\\theta + u\\]\n"),
}  # fmt: skip


@pytest.mark.parametrize("name", LINES)
def test_a_comment_of_any_language_is_quoted(tmp_path, name):
    said = "theta'' = g/l*sin(theta) + u/(m*l^2)"
    comment, code = LINES[name]
    file = tmp_path / name
    file.write_text(f"{comment.format(said)}\n{code}")
    found = mechanics.check(SCENE, file, blame=False)
    assert said in found.unjudged
