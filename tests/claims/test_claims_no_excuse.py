"""Nothing becomes right by a guess, a tautology, a remark in the text or a type of number."""

import numpy as np
import pytest

import mechanics
from mechanics.errors import InputError
from mechanics.judge.check import derived
from systems import cartpole, double_pendulum

CART = derived(cartpole.scene())
DOUBLE = derived(double_pendulum.scene())

RAIL = "({pole} + {cart})*x'' + {pole}*l*theta''*cos(theta) - {pole}*l*theta'^2*sin(theta) = F"
RIGHT = (
    r"\begin{equation}(m_c + m_p) \ddot x + m_p l \ddot\theta \cos\theta"
    r" - m_p l \dot\theta^2 \sin\theta = F\end{equation}"
)
LINKS = (
    "({a}+{b})*{c}*phi1'' + {b}*{d}*phi2''*cos(phi1-phi2) + {b}*{d}*phi2'^2*sin(phi1-phi2)"
    " + ({a}+{b})*g*sin(phi1) = 0"
)


def verdicts(truth, thing, **options) -> list[str]:
    found = mechanics.check(truth, thing, blame=False, **options)
    return [entry.finding.verdict.name for entry in found.judged]


def test_masses_that_are_exchanged_stay_wrong() -> None:
    assert verdicts(CART, RAIL.format(pole="m_pole", cart="m_cart")) == ["PROVED"]
    assert verdicts(CART, RAIL.format(pole="m_cart", cart="m_pole")) == ["REFUTED"]


@pytest.mark.parametrize("names", ["M1 M2 L1 L2", "mass1 mass2 len1 len2"])
def test_numbers_that_are_exchanged_stay_wrong(names: str) -> None:
    a, b, c, d = names.split()
    assert verdicts(DOUBLE, LINKS.format(a=a, b=b, c=c, d=d)) == ["PROVED"]
    assert verdicts(DOUBLE, LINKS.format(a=b, b=a, c=c, d=d)) == ["REFUTED"]
    assert verdicts(DOUBLE, LINKS.format(a=a, b=b, c=d, d=c)) == ["REFUTED"]


@pytest.mark.parametrize(
    "text",
    [
        "R = F - 7*theta''\nR + 7*theta'' = F",
        "F = H + 3*mc*x''\nH = F - 3*mc*x''",
    ],
)
def test_a_tautology_says_nothing(text: str) -> None:
    assert "PROVED" not in verdicts(CART, text)
    assert not mechanics.check(CART, text, blame=False).ok


@pytest.mark.parametrize("words", [r"\ddot x = 0", r"\ddot x = -2", r"0 = \ddot x", "N = 0"])
def test_a_value_of_an_acceleration_or_reaction_in_prose_is_not_passed_over(words: str) -> None:
    assert verdicts(CART, f"Here ${words}$ and\n{RIGHT}") == ["UNDECIDED", "PROVED"]


@pytest.mark.parametrize("words", ["g = 9.81", r"\dot x = 0", "x(0) = 0"])
def test_values_and_initial_conditions_are_remarks(words: str) -> None:
    assert verdicts(CART, f"Here ${words}$ and\n{RIGHT}") == ["PROVED"]


def whole(x, theta, x_dot, theta_dot, F, mc=2, mp=1, l=1, g=10):
    """An array of integers cuts what is put into it."""
    mass = np.array([[mc + mp, 0], [0, 4 * mp * l * l]]) * 1
    mass[0, 1] = mass[1, 0] = mp * l * np.cos(theta)
    right = np.array([F + mp * l * theta_dot**2 * np.sin(theta), mp * g * l * np.sin(theta)])
    mass = mass / np.array([[1, 1], [1, 3]])
    return np.linalg.solve(mass, right)


def decimal(x, theta, x_dot, theta_dot, F, mc=2.0, mp=1.0, l=1.0, g=10.0):
    """The same with floats."""
    return whole(x, theta, x_dot, theta_dot, F, mc, mp, l, g)


def test_whole_numbers_are_tried_as_they_are() -> None:
    assert verdicts(CART, decimal) == ["PROVED", "PROVED"]
    assert verdicts(CART, whole) == ["UNDECIDED", "UNDECIDED"]


def test_a_matrix_without_an_inverse_has_a_place() -> None:
    with pytest.raises(InputError, match="line 1, column 1: this matrix has no inverse"):
        mechanics.check(CART, "[1, 2; 2, 4]^-1*[x''; theta''] = [0; 0]", notation="text")
