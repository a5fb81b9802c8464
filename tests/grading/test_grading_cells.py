"""Nothing that is handed in is left out in silence: it is judged, or named as not read."""

import json
from pathlib import Path
from typing import Any

import pytest

from mechanics.blame.reference import Reference
from mechanics.errors import InputError
from mechanics.grading.grade import Grade, grade
from mechanics.grading.submission import things_in
from mechanics.judge.check import derived
from systems import rod_pendulum


def stream(text: str) -> dict[str, Any]:
    """What a cell prints."""
    return {"output_type": "stream", "name": "stdout", "text": [text]}


def displayed(kind: str, text: str) -> dict[str, Any]:
    """What a cell displays."""
    return {"output_type": "display_data", "data": {kind: [text]}}


KEY = Reference(derived(rod_pendulum.scene()))
TRUE = r"$$\ddot\theta = \frac{3g}{2l}\sin\theta + \frac{3u}{m l^2}$$"
FUNCTION = """
import numpy as np
def rate(theta, u, m, l, g):
    return 3*g/(2*l)*np.sin(theta) + 3*u/(m*l**2)
"""
SYMBOLS = """
from sympy import Eq, Function, symbols, sin
m, l, g, u, t = symbols("m l g u t")
theta = Function("theta")(t)
"""
OTHERS = {
    "a lambda": ("code", "acc = lambda theta, u, m, l, g: -3*g/(2*l)*theta"),
    "a function": ("code", "def other(theta, u, m, l, g):\n    return -3*g/(2*l)*theta"),
    "an equation": ("code", f"{SYMBOLS}one = Eq(theta.diff(t, 2), -g*theta)"),
    "an energy": ("code", f"{SYMBOLS}T = m*l**2*theta.diff(t)**2/2"),
    "a formula": ("code", f"{SYMBOLS}one = -3*g/(2*l)*theta"),
    "what is solved": (
        "code",
        "from scipy.integrate import solve_ivp\n"
        "s = solve_ivp(lambda t, y: [y[1], -y[0]], (0, 1), [0.1, 0])",
    ),
    "what is printed": ("code", f"{SYMBOLS}print(Eq(theta.diff(t, 2), -g*theta))"),
    "what is shown": ("code", f"{SYMBOLS}Eq(theta.diff(t, 2), -g*theta)"),
    "a class": ("code", f"{SYMBOLS}class A:\n    one = Eq(theta.diff(t, 2), -g*theta)"),
    "an object": ("code", f"{SYMBOLS}class A: pass\na = A()\na.one = -g*theta"),
    "what can be called": (
        "code",
        "class A:\n    def __call__(self, theta, u, m, l, g): return -g*theta\nother = A()",
    ),
    "what SymPy makes": ("code", f"{SYMBOLS}from sympy import lambdify\nf = lambdify(g, -g)"),
    "text": ("code", "one = r'\\ddot\\theta = -g/l'"),
    "a block of another language": ("markdown", "~~~julia\nacc(theta) = -g/l*theta\n~~~"),
    "raw text": ("raw", "theta'' = -g/l*theta"),
    "another kind": ("heading", "theta'' = -g/l*theta"),
    "a block": ("markdown", "```python\nacc = lambda theta: -g/l*theta\n```"),
}
INERT = [
    "import numpy as np\nm, l = 1.0, 2/3",
    "%matplotlib inline\nx0 = [0.1, 0]\nprint('x0 is', x0)",
    "# theta'' = 3*g/(2*l)*sin(theta) + 3*u/(m*l**2)\n# l = 2/3\n# theta = y[0]",
    "",
]


def graded(folder: Path, *cells: tuple[str, str], run_python: bool = True) -> Grade:
    path = folder / "a.ipynb"
    page = [{"cell_type": kind, "source": [text]} for kind, text in cells]
    path.write_text(json.dumps({"cells": page}))
    return grade(KEY, "a", things_in(path, run_python=run_python), options={"blame": False})


@pytest.mark.sample(8)
@pytest.mark.parametrize("first", [("markdown", TRUE), ("code", FUNCTION)])
@pytest.mark.parametrize("other", OTHERS)
def test_a_wrong_cell_beside_a_right_one_is_seen(
    tmp_path: Path, first: tuple[str, str], other: str
) -> None:
    found = graded(tmp_path, first, OTHERS[other])
    assert found.verdict in ("wrong", "in doubt")
    assert found.score == 0.5
    assert found.hint


@pytest.mark.parametrize("kind", [k for k, (kind, _) in OTHERS.items() if kind == "code"])
def test_code_that_is_not_run_is_named(tmp_path: Path, kind: str) -> None:
    found = graded(tmp_path, ("markdown", TRUE), OTHERS[kind], run_python=False)
    assert (found.verdict, found.score) == ("in doubt", 0.5)
    assert "code cell 2 is not read" in found.hint and "--run-python" in found.hint


@pytest.mark.parametrize("text", INERT)
@pytest.mark.parametrize("run_python", [True, False])
def test_what_claims_nothing_changes_nothing(tmp_path: Path, text: str, run_python: bool) -> None:
    found = graded(tmp_path, ("markdown", TRUE), ("code", text), run_python=run_python)
    assert (found.verdict, found.score) == ("right", 1.0)


def test_right_cells_are_right_together(tmp_path: Path) -> None:
    again = ("code", FUNCTION.replace("rate", "again"))
    use = ("code", "def plot(solution):\n    print(rate(*solution))\nplot((0.1, 0, 1, 1, 10))")
    assert graded(tmp_path, ("markdown", TRUE), ("code", FUNCTION), again, use).verdict == "right"


def test_an_equation_that_is_shown_and_not_assigned_is_not_read(tmp_path: Path) -> None:
    shown = ("code", "from IPython.display import Math, display\ndisplay(Math('x = 1'))")
    assert graded(tmp_path, ("markdown", TRUE), shown).verdict == "in doubt"
    with pytest.raises(InputError, match="SyntaxError"):
        graded(tmp_path, ("markdown", TRUE), ("code", "%%latex\n$x = 1$"))


RIGHT, WRONG = "3*g/(2*l)*sin(theta) + 3*u/(m*l**2)", "g/l*sin(theta)"
SHOWN = r"\frac{d^{2}}{d t^{2}} \theta{\left(t \right)} = "


@pytest.mark.parametrize(
    ("wrong", "right"),
    [
        (stream(f"theta_ddot = {WRONG}\n"), stream(f"theta_ddot = {RIGHT}\n")),
        (stream("theta_ddot = 2*x*l\n"), stream("theta_ddot = 1.5 rad/s^2\nx = [0.1, 0]\n")),
        (
            displayed("text/latex", rf"$\displaystyle {SHOWN}\frac{{g \sin\theta}}{{l}}$"),
            displayed("text/latex", rf"$\displaystyle {SHOWN}\frac{{3g \sin\theta}}{{2l}}"
                      r"+ \frac{3 u{\left(t \right)}}{l^{2} m}$"),
        ),
        (
            displayed("text/html", f"<b>theta'' = {WRONG}</b>"),
            displayed("text/plain", "<Figure size 640x480 with 1 Axes>"),
        ),
    ],
)  # fmt: skip
def test_what_a_cell_shows_is_judged(
    wrong: dict[str, Any], right: dict[str, Any], tmp_path: Path
) -> None:
    for output, marks in ((wrong, False), (right, True)):
        cell = {"cell_type": "code", "source": FUNCTION, "outputs": [output]}
        path = tmp_path / "a.ipynb"
        path.write_text(json.dumps({"cells": [cell]}))
        found = grade(KEY, "a", things_in(path, run_python=True), require="right")
        assert (found.score == 1, found.verdict == "right") == (marks, marks)


@pytest.mark.parametrize(
    ("output", "quoted"),
    [
        (displayed("text/plain", "-3*g*sin(theta(t))/(2*l) + Derivative(theta(t), (t, 2))"), True),
        (displayed("text/latex", r"$\displaystyle \frac{m l^2 \dot{\theta}^{2}}{6}$"), True),
        (stream("m*l**2*theta_dot**2/6\n"), True),
        (displayed("text/plain", "m*l**2/3"), False),
        (stream("the angle theta is 0.1 rad/s\n"), False),
        (stream("[0.1, 0.2]\n1.5\n"), False),
    ],
)
def test_an_expression_that_a_cell_shows_is_quoted(
    output: dict[str, Any], quoted: bool, tmp_path: Path
) -> None:
    cell = {"cell_type": "code", "source": FUNCTION, "outputs": [output]}
    path = tmp_path / "a.ipynb"
    path.write_text(json.dumps({"cells": [cell]}))
    found = grade(KEY, "a", things_in(path, run_python=True), require="right")
    assert found.verdict == "right"
    assert any("an expression, not judged" in words for words in found.unjudged) is quoted


@pytest.mark.parametrize(("law", "marks"), [(WRONG, False), (RIGHT, True)])
def test_formulas_in_comments_of_a_cell_are_judged(law: str, marks: bool, tmp_path: Path) -> None:
    cell = {"cell_type": "code", "source": f"{FUNCTION}\n# theta_ddot = {law}"}
    path = tmp_path / "a.ipynb"
    path.write_text(json.dumps({"cells": [cell]}))
    found = grade(KEY, "a", things_in(path, run_python=True), require="right")
    assert (found.score == 1, found.verdict == "right") == (marks, marks)
