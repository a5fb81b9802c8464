"""A name that says another quantity, in another unit or a part of it, is not guessed."""

import math

import pytest

import mechanics
from mechanics.claims.scaled_names import another_quantity
from mechanics.errors import InputError
from mechanics.judge.check import derived
from systems import bead_on_hoop, rod_pendulum

ROD = derived(rod_pendulum.scene())
LAW = r"$$\ddot\theta=\frac{{3g}}{{2{0}}}\sin\theta+\frac{{3u}}{{m{0}^2}}$$"


@pytest.mark.parametrize(
    ("name", "word"),
    [
        ("theta_deg", "deg"), ("thetaDeg", "Deg"), ("omega_rpm", "rpm"), ("R_mm", "mm"),
        ("u_kNm", "kNm"), ("l_half", "half"), ("halfLength", "half"), ("diameter", "diameter"),
        ("l_full", "full"), ("l_1over2", "1/2"), ("theta_ddot", ""), ("m_kg", ""), ("l_c", ""),
        ("x_min", "min"), ("u_max", "max"),
        ("theta_ref", "ref"), ("umax", "max"), ("maximal", ""), ("m1", ""), ("tau_Nm", ""),
    ],
)  # fmt: skip
def test_what_a_name_says(name: str, word: str) -> None:
    assert another_quantity(name) == word


@pytest.mark.parametrize("name", ["l_{1/2}", r"l_{\mathrm{half}}", r"l_{\mathrm{cm}}"])
def test_a_formula_with_it_is_open(name: str) -> None:
    (entry,) = mechanics.check(ROD, LAW.format(name), blame=False).judged
    assert entry.verdict.name == "UNDECIDED"
    assert "no name of the scene" in entry.statement.doubt


def test_one_that_is_defined_is_read() -> None:
    text = "l_half = l/2\ntheta'' = 3*g/(4*l_half)*sin(theta) + 3*u/(4*m*l_half^2)"
    assert mechanics.check(ROD, text, blame=False).verdict.name == "PROVED"
    wrong = text.replace("4*", "2*")
    assert mechanics.check(ROD, wrong, blame=False).verdict.name == "REFUTED"


def in_degrees(theta_deg, u, m, l, g):
    return 1.5 * g / l * math.sin(math.radians(theta_deg)) + 3 * u / (m * l**2)


def across(theta, omega, diameter, g):
    return (omega**2 * math.cos(theta) - 2 * g / diameter) * math.sin(theta)


@pytest.mark.parametrize(
    ("system", "function", "said"),
    [(rod_pendulum, in_degrees, "deg"), (bead_on_hoop, across, "diameter")],
)
def test_code_has_to_say_what_it_takes(system, function, said: str) -> None:
    with pytest.raises(InputError, match=f"says '{said}'"):
        mechanics.check(system.scene(), function, blame=False)


def test_a_name_that_is_given_is_taken() -> None:
    text = LAW.format(r"l_{\mathrm{full}}")
    names = {"l_full": "l"}
    assert mechanics.check(ROD, text, names=names, blame=False).verdict.name == "PROVED"
