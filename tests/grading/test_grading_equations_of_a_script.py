"""A script in Python without a function: its equations in SymPy's objects, and nothing beside."""

from pathlib import Path

import pytest

import mechanics
from mechanics.blame.reference import Reference
from mechanics.errors import InputError
from mechanics.grading.grade import Grade, grade
from mechanics.grading.submission import things_in
from mechanics.judge.check import derived
from systems import cartpole, rod_pendulum

CART = derived(cartpole.scene())
SCRIPT = """
from sympy import *
t, g, l = symbols("t g l")
x, theta = Function("x")(t), Function("theta")(t)
pole = Eq(Rational(4, 3)*l*theta.diff(t, 2) + x.diff(t, 2)*cos(theta), SIGN*g*sin(theta))
"""


def submitted(folder: Path, text: str) -> list[object]:
    path = folder / "a.py"
    path.write_text(text)
    return things_in(path, run_python=True)


@pytest.mark.parametrize(("sign", "verdict"), [("1", "PROVED"), ("-1", "REFUTED")])
def test_equations_of_a_script_are_judged(tmp_path: Path, sign: str, verdict: str) -> None:
    things = submitted(tmp_path, SCRIPT.replace("SIGN", sign))
    assert mechanics.check(CART, things, blame=False).verdict.name == verdict


@pytest.mark.parametrize(
    "beside", ["r = l*g*cos(theta)", "b = {'V': l*g*cos(theta)}", "no = Eq(1, 2)"]
)
def test_a_script_with_other_formulas_is_refused(tmp_path: Path, beside: str) -> None:
    with pytest.raises(InputError, match="no function to check"):
        submitted(tmp_path, SCRIPT.replace("SIGN", "1") + beside)


def test_a_comment_that_denies_an_equation_leaves_it_undecided(tmp_path: Path) -> None:
    things = submitted(tmp_path, SCRIPT.replace("SIGN", "1") + "# This equation is wrong.\n")
    assert mechanics.check(CART, things, blame=False).verdict.name == "UNDECIDED"


LAGRANGE = """
from sympy import *
t, mp, mc, l, g, F = symbols("t mp mc l g F")
x, theta = Function("x")(t), Function("theta")(t)
p = Matrix([x + l*sin(theta), l*cos(theta)]).diff(t)
T = mc*x.diff(t)**2/2 + mp*p.dot(p)/2 + mp*l**2*theta.diff(t)**2/6
V = mp*g*l*cos(theta)
L = T - V
eqs = [L.diff(q.diff(t), t) - L.diff(q) - Q for q, Q in ((x, F), (theta, 0))]
"""


@pytest.mark.parametrize(
    ("written", "other", "verdicts"),
    [
        ("", "", {"PROVED"}),
        ("/6", "/3", {"PROVED", "REFUTED"}),
        ("Q for", "2*Q for", {"PROVED", "REFUTED"}),
    ],
)
def test_energies_and_what_vanishes_are_claims_of_a_script(
    tmp_path: Path, written: str, other: str, verdicts: set[str]
) -> None:
    things = submitted(tmp_path, LAGRANGE.replace(written, other, 1) if written else LAGRANGE)
    found = mechanics.check(CART, things, blame=False)
    assert {entry.finding.verdict.name for entry in found.judged} == verdicts


@pytest.mark.parametrize("beside", ["N = mp*g", "eqs = [x.diff(t)*l]", "rest = eqs[0].diff(t)"])
def test_a_formula_that_is_no_part_and_no_claim_is_not_read(tmp_path: Path, beside: str) -> None:
    with pytest.raises(InputError, match="no function to check"):
        submitted(tmp_path, LAGRANGE + beside)


SYMBOLS = (
    "from sympy import *\nt = symbols('t')\nm, l, g, u = symbols('m l g u', positive=True)\n"
    "theta = Function('theta')(t)\n"
)
MOVES = "Eq(m*l**2/3*theta.diff(t, 2), {}m*g*l/2*sin(theta) + u)"


def graded(code: str, tmp_path: Path) -> Grade:
    (tmp_path / "a.py").write_text(code)
    things = things_in(tmp_path / "a.py", run_python=True)
    return grade(Reference(derived(rod_pendulum.scene())), "a.py", things)


@pytest.mark.parametrize(
    ("lines", "verdict"),
    [
        (f"eq = {MOVES.format('')}", "right"),
        (f"eq = {MOVES.format('-')}\neq = {MOVES.format('')}", "in doubt"),
        (f"eq = {MOVES.format('')}\neq2 = {MOVES.format('-')}\ndel eq2", "in doubt"),
        (f"eq = {MOVES.format('')}\neq = Eq(2*eq.lhs, 2*eq.rhs)", "right"),
    ],
)
def test_an_equation_that_the_script_loses_is_named(
    lines: str, verdict: str, tmp_path: Path
) -> None:
    assert graded(SYMBOLS + lines, tmp_path).verdict == verdict


def test_numbers_of_a_formula_are_named_as_not_judged(tmp_path: Path) -> None:
    code = (
        "import numpy as np\nm, l, g, u = 1.0, 2.0, 9.81, 0.0\ntheta = np.linspace(0, 1, 5)\n"
        "def acc(theta, theta_dot, u, m, l, g):\n"
        "    return 3*g/(2*l)*np.sin(theta) + 3*u/(m*l**2)\n"
        "wrong = -3*g/(2*l)*np.sin(theta)\n"
    )
    found = graded(code, tmp_path)
    assert found.unjudged == ("wrong: its formula was computed to numbers",)
    assert found.hint == f"not judged: {found.unjudged[0]}"
