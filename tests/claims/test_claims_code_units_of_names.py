"""A unit at the end of a name in code is that of what it holds."""

from pathlib import Path

import pytest

import mechanics
from mechanics.claims.scaled_names import unit_at_end
from mechanics.errors import InputError
from mechanics.grading.submission import things_in
from mechanics.judge.check import Check
from systems import cartpole, rod_pendulum

ROD = mechanics.derive(rod_pendulum.scene(), "free_body")
CART = mechanics.derive(cartpole.scene(), "free_body")
RIGHT = {
    "energy_J": "(theta, theta_dot, m, l, g): return m*l**2*theta_dot**2/6 + m*g*l/2*cos(theta)",
    "period_s": "(l, g): return 2*pi*sqrt(2*l/(3*g))",
    "kineticEnergy_J": "(theta_dot, m, l): return m*l**2*theta_dot**2/6",
    "frequency_rad_s": "(l, g): return sqrt(3*g/(2*l))",
}
FOREIGN = {
    "energy_mJ": RIGHT["energy_J"], "period_ms": RIGHT["period_s"],
    "frequency_Hz": RIGHT["frequency_rad_s"],
    "natural_frequency_hz": "(l, g): return sqrt(3*g/(2*l))/(2*pi)",
    "theta_ddot_deg": "(theta, u, m, l, g): return 3*g/(2*l)*sin(theta) + 3*u/(m*l**2)",
    "acc": "(theta, u, m, l, g):\n    l_cm = l\n"
    "    return 3*g/(2*l_cm)*sin(theta) + 3*u/(m*l_cm**2)",
    "rate": "(theta, u, m, l, g):\n    degPerS2 = 3*g/(2*l)*sin(theta) + 3*u/(m*l**2)\n"
    "    return degPerS2",
}  # fmt: skip
BESIDE = (
    "(theta, u, m, l, g):\n    deg = theta*180/pi\n    return 3*g/(2*l)*sin(theta) + 3*u/(m*l**2)"
)


def _answer(folder: Path, name: str, rest: str, **options: str) -> Check:
    file = folder / "rod.py"
    file.write_text(f"from math import cos, pi, sin, sqrt\n\n\ndef {name}{rest}\n")
    things = things_in(file, function=name, run_python=True)
    return mechanics.check(ROD, things, blame=False, **options)


@pytest.mark.parametrize("name", RIGHT)
def test_one_of_the_si_says_nothing_else(tmp_path: Path, name: str) -> None:
    assert _answer(tmp_path, name, RIGHT[name]).verdict.name == "PROVED"


@pytest.mark.parametrize("name", FOREIGN)
def test_one_that_no_scene_has_leaves_it_open(tmp_path: Path, name: str) -> None:
    assert _answer(tmp_path, name, FOREIGN[name]).verdict.name == "UNDECIDED"


def test_so_it_does_where_the_person_says_what_is_returned(tmp_path: Path) -> None:
    answer = _answer(tmp_path, "period_ms", RIGHT["period_s"], about="period")
    assert answer.verdict.name == "UNDECIDED"


def test_what_is_not_used_says_nothing(tmp_path: Path) -> None:
    assert _answer(tmp_path, "acc", BESIDE).verdict.name == "PROVED"


@pytest.mark.parametrize(
    ("name", "unit"),
    [("theta_deg", "deg"), ("accDegPerS2", "Deg"), ("cycles_per_second", "cycles"),
     ("x_mm_s", "mm"), ("acc_rad_s2", ""), ("theta_ddot", ""), ("v_s", ""), ("km", ""), ("ft", "")],
)  # fmt: skip
def test_the_end_of_a_name(name: str, unit: str) -> None:
    assert unit_at_end(name) == unit


SOLVED = """function a = acc(theta, theta_dot, F, mc, mp, l, g)
%s
M = [mc + mp, mp*l*cos(theta); mp*l*cos(theta), 4/3*mp*l^2];
f = [F + mp*l*theta_dot^2*sin(theta); mp*g*l*sin(theta)];
a = M\\f;
end
"""


@pytest.mark.parametrize(
    "comment", ["[thdd; xdd]", "a(1): theta_ddot, a(2): x_ddot", "returns thetaDDot, xDDot"]
)
def test_a_comment_has_accelerations_in_another_order(tmp_path: Path, comment: str) -> None:
    (tmp_path / "cart.m").write_text(SOLVED % f"% {comment}")
    try:
        answer = mechanics.check(CART, tmp_path / "cart.m", blame=False)
    except InputError as error:
        assert "another order" in str(error)
    else:
        assert answer.verdict.name == "UNDECIDED"


@pytest.mark.parametrize(
    "comment", ["[xdd; thdd]", "a(1): x_ddot, a(2): theta_ddot", "theta, theta_dot", "M, f"]
)
def test_other_comments_have_not(tmp_path: Path, comment: str) -> None:
    (tmp_path / "cart.m").write_text(SOLVED % f"% {comment}")
    assert mechanics.check(CART, tmp_path / "cart.m", blame=False).verdict.name == "PROVED"
