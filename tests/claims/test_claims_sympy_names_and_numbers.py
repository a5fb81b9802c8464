"""What a symbol of SymPy's is called, and doubles in its formulas."""

import pytest
from sympy import Eq, Expr, Float, Mul, Symbol, sin
from sympy.physics.mechanics import dynamicsymbols

from mechanics import check
from tests.notation_scenes import truth

theta, t = dynamicsymbols("theta"), dynamicsymbols._t
g, l = Symbol("g"), Symbol("l")
RATE = theta.diff(t, 2)


@pytest.mark.parametrize("name", ["L/2", "2*L", "l + 1", "2 l", "-l", "l^2"])
def test_a_formula_is_no_name(name: str) -> None:
    (entry,) = check(truth("pendulum"), Eq(RATE, -g / Symbol(name) * sin(theta))).judged
    assert (
        entry.verdict.name == "UNDECIDED" and "is the name of one symbol" in entry.statement.doubt
    )


@pytest.mark.parametrize("name", ["L", "l_{rod}", "ell", "L_1"])
def test_names_in_other_spellings_are_guessed(name: str) -> None:
    (entry,) = check(truth("pendulum"), Eq(RATE, -g / Symbol(name) * sin(theta))).judged
    assert entry.verdict.name == "PROVED"


@pytest.mark.parametrize(
    ("factor", "verdict", "told"),
    [
        (Float(1.0), "PROVED", False),
        (Float(1.0000000000000002), "PROVED", True),
        (Float(1.000000001), "REFUTED", False),
    ],
)
def test_doubles_are_read_as_in_code(factor: Expr, verdict: str, told: bool) -> None:
    right = Mul(factor, -g / l * sin(theta), evaluate=False)
    (entry,) = check(truth("pendulum"), Eq(RATE, right, evaluate=False), blame=False).judged
    assert entry.verdict.name == verdict
    assert any("is read as" in note for note in entry.statement.notes) is told
