"""A name means one thing in all that is handed in together."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from sympy import Eq, Function, Rational, Symbol, cos, sin, symbols

from mechanics import check
from mechanics.judge.check import derived
from systems import cartpole

CART = derived(cartpole.scene())
T = Symbol("t")
X, F = (Function(name)(T) for name in "xF")
MC, MP, L, G = symbols("mc mp l g")


def rail(angle: Any, place: Any = X) -> Eq:
    turning = angle.diff(T, 2) * cos(angle) - angle.diff(T) ** 2 * sin(angle)
    return Eq((MC + MP) * place.diff(T, 2) + MP * L * turning, F)


def pole(angle: Any, place: Any = X) -> Eq:
    left = Rational(4, 3) * L * angle.diff(T, 2) + place.diff(T, 2) * cos(angle)
    return Eq(left, G * sin(angle))


def in_text(equation: Eq) -> str:
    return f"{equation.lhs} = {equation.rhs}"


@pytest.mark.sample(4)
@pytest.mark.parametrize("form", [lambda equation: equation, in_text], ids=["objects", "texts"])
@pytest.mark.parametrize(
    ("one", "other", "verdict"),
    [
        ("theta x", "theta x", "PROVED"),
        ("phi x", "phi x", "PROVED"),
        ("phi x", "psi x", "UNDECIDED"),
        ("theta x", "theta s", "UNDECIDED"),
        ("phi x", "theta x", "UNDECIDED"),
    ],
)
def test_two_names_for_one_quantity_are_not_guessed(
    form: Callable[[Eq], Any], one: str, other: str, verdict: str
) -> None:
    first, second = ([Function(n)(T) for n in names.split()] for names in (one, other))
    things = [form(rail(*first)), form(pole(*second))]
    assert check(CART, things, blame=False).verdict.name == verdict
    assert check(CART, things[::-1], blame=False).verdict.name == verdict


def test_functions_have_names_of_their_own() -> None:
    def mass_matrix(theta, mc, mp, l):  # type: ignore[no-untyped-def]
        both = mp * l * np.cos(theta)
        return np.array([[mc + mp, both], [both, 4 / 3 * mp * l**2]])

    things = [in_text(rail(Function("phi")(T))), mass_matrix]
    assert check(CART, things, blame=False).verdict.name == "PROVED"
