"""Values of `--at` and `--speeds` are exact formulas in parameters."""

from typing import Any

import pytest
from sympy import Rational, Symbol, cos, pi, sqrt

from mechanics.cli.formulas import formulas
from mechanics.errors import InputError

SYMBOLS = {name: Symbol(name, positive=True) for name in ("l", "g", "m", "e")}
l, g, m, e = SYMBOLS.values()


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("l/3", l / 3),
        ("sqrt(m*g/(2*l))", sqrt(m * g / (2 * l))),
        ("-0.1*l + 1e-3", -l / 10 + Rational(1, 1000)),
        ("l^2 - l**-1", l**2 - 1 / l),
        ("cos(pi/6)*e", cos(pi / 6) * e),
        ("1e-3", Rational(1, 1000)),
        ("-3*pi/4", -3 * pi / 4),
        ("sqrt(1/4)", Rational(1, 2)),
    ],
)
def test_formulas_are_read_exactly(text: str, value: Any) -> None:
    assert formulas([f"x={text}"], "--at", SYMBOLS) == {"x": value}


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("k/3", "'k' is no number, parameter, or formula"),
        ("l/0", "'0' is no number"),
        ("exec(l)", "'exec.l.'"),
        ("l.__class__", "formula"),
        ("l**999", "'999'"),
        ("l**l", "'l'"),
        ("(l", "formula in parameters"),
        ("1/2,y=1", "write --at once for each name"),
        ("ll", "formula in parameters"),
        ("[l, 1]", "formula"),
        ("(" * 300 + "l" + ")" * 300, "formula"),
        ("l*1j", "'1j'"),
        ("", "write"),
    ],
)
def test_what_is_no_formula_is_told_with_what_is(text: str, words: str) -> None:
    with pytest.raises(InputError, match=words):
        formulas([f"x={text}"], "--at", SYMBOLS)


def test_speeds_may_hold_symbols_of_their_own() -> None:
    (value,) = formulas(["u2=v/l"], "--speeds", SYMBOLS, more=True).values()
    assert value == Symbol("v", real=True) / l


def test_a_loop_is_linearized_about_its_declared_equilibrium(run: Any, tmp_path: Any) -> None:
    file = tmp_path / "bead.py"
    file.write_text(BEAD)
    ran = run("linearize", file)
    assert ran.code == 0
    assert "about the declared equilibrium y = -1" in ran.out
    assert run("linearize", file, "--at", "y=-l").code == 0
    wrong = run("linearize", file, "--at", "y=-l/2")
    assert wrong.code == 2
    assert "--at NAME=VALUE" in wrong.err


BEAD = """
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
from mechanics import Particle, Scene, gravity, holonomic, parameters, reaction

def scene():
    (x, y), (m, l, g) = dynamicsymbols("x y"), parameters("m l g", "kg m m/s^2", "1 1 9.81")
    N, O = ReferenceFrame("N"), Point("O")
    P = O.locatenew("P", x * N.x + y * N.y)
    return Scene(
        "bead", N, O, (x, y), (Particle("bead", P, m),), (gravity(-g * N.y),), plane=N.z,
        reactions=(reaction("S", at=P, on="bead", by=None, along=x * N.x + y * N.y),),
        constraints=(holonomic("ring", (x**2 + y**2 - l**2) / 2, "S"),),
        equilibria=({"y": -1},), example={"x": 0.6, "y": -0.8},
    )
"""
