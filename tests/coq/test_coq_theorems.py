"""Theorems for Coq: what they say can be read here, that they hold says coqc."""

import os
import shutil
from pathlib import Path

import pytest
from sympy import Rational, Symbol, pi, sin, sqrt

from mechanics.coq import checked, write_coq
from mechanics.coq.polynomial import Names, NotPolynomialError, equation, text
from systems import SEED

SYSTEMS = {system.name: system for system in SEED}
theta, R, x = Symbol("theta"), Symbol("R"), Symbol("x")

coqc = pytest.mark.skipif(
    shutil.which("coqc") is None and "MECHANICS_CI" not in os.environ, reason="needs coqc"
)


def written(left, right) -> str:
    names = Names()
    return " = ".join(text(side, names) for side in equation(left, right, names))


def test_sides_are_polynomials_with_whole_coefficients() -> None:
    assert written(x / 2, Rational(1, 3)) == "3*x = 2"
    assert written(x / R, 1) == "x = R_"
    assert written(sin(2 * theta), pi) == "2*c_theta*s_theta = pi"
    assert written(x**3 - x, 0) == "x*x*x - x = 0"
    assert written(4 * x, 6 * R) == "2*x = 3*R_"


@pytest.mark.parametrize("expression", [sqrt(x), sin(x * theta), abs(x), 2**x])
def test_what_is_no_polynomial_is_refused(expression) -> None:
    with pytest.raises(NotPolynomialError):
        written(expression, 0)


def test_no_name_is_a_word_of_coqs_and_none_stands_for_two() -> None:
    names = Names()
    symbols = [Symbol(name) for name in ("R", "R_", "in", "s_theta", "θ", "λ", "x'")]
    found = [names.of(symbol) for symbol in symbols]
    assert len(set(found)) == len(symbols)
    assert not {"R", "in"} & set(found)
    assert all(name.isascii() and name.isidentifier() for name in found)
    assert names.of(names.on_circle(theta)[0]) != names.of(Symbol("s_theta"))
    assert names.of(names.pi) != names.of(Symbol("pi"))


@pytest.mark.campaign
def test_a_file_has_the_balance_laws_with_their_bodies_and_reactions(tmp_path: Path) -> None:
    found = write_coq(SYSTEMS["elastic_pendulum"], tmp_path)
    assert {"laws_give_kane", "kane_is_lagrange", "energy_of_kane"} <= {one.name for one in found}
    assert all(one.path is not None for one in found)
    laws = (tmp_path / "laws_give_moving_point.v").read_text()
    assert "(* carriage: linear momentum along N.x *)\n  m*x_ddot = T - 2*k*x ->" in laws
    assert "s_theta*s_theta + c_theta*c_theta = 1 ->" in laws
    assert not any(word in laws for word in ("Axiom", "Admitted", "Parameter", "Hypothesis"))


@coqc
@pytest.mark.campaign
@pytest.mark.parametrize("name", SYSTEMS)
def test_coqc_accepts_every_file(name: str, tmp_path: Path) -> None:
    found = checked(write_coq(SYSTEMS[name], tmp_path))
    assert len(found) >= 7
    assert [one for one in found if one.reason] == []


@coqc
@pytest.mark.campaign
@pytest.mark.parametrize(
    ("right", "wrong"),
    [("m*x_ddot = T - 2*k*x", "m*x_ddot = T + 2*k*x"), ("= -2*T ->", "= 2*T ->")],
)
def test_coqc_rejects_a_flipped_sign(right: str, wrong: str, tmp_path: Path) -> None:
    found = write_coq(SYSTEMS["elastic_pendulum"], tmp_path)
    (one,) = (one for one in found if one.name == "laws_give_kane")
    content = one.path.read_text()
    assert right in content
    one.path.write_text(content.replace(right, wrong))
    (judged,) = checked([one])
    assert judged.reason
