"""What the engine writes, it reads and proves: every system, as text and as LaTeX."""

import functools

import pytest
from sympy import Matrix, latex, sstr

import mechanics
from mechanics.equations import Equations
from mechanics.judge.check import derived
from systems import ALL

NAMES = [system.name for system in ALL]


@functools.cache
def truth(name: str) -> Equations:
    (system,) = (system for system in ALL if system.name == name)
    return derived(system.scene())


@functools.cache
def rows(name: str) -> list[tuple]:
    """u' by themselves where there are no constraints; else rows with the multipliers."""
    equations = truth(name)
    left = equations.mass * Matrix(equations.scene.ud)
    right = equations.forcing
    if equations.multipliers:
        right = right + equations.reaction_matrix * Matrix(equations.multipliers)
    return list(zip(left, right, strict=True))


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", NAMES)
def test_text_is_read_back(name: str) -> None:
    text = "\n".join(f"{sstr(left)} = {sstr(right)}" for left, right in rows(name))
    found = mechanics.check(truth(name), text, notation="text")
    verdicts = {entry.finding.verdict.name for entry in found.judged}
    assert verdicts <= {"PROVED", "CERTIFIED"}
    assert len(found.judged) == len(rows(name))


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", NAMES)
def test_latex_is_read_back(name: str) -> None:
    body = " \\\\\n".join(f"{latex(left)} &= {latex(right)}" for left, right in rows(name))
    found = mechanics.check(truth(name), f"\\begin{{align}}\n{body}\n\\end{{align}}")
    verdicts = {entry.finding.verdict.name for entry in found.judged}
    assert verdicts <= {"PROVED", "CERTIFIED"}
    assert len(found.judged) == len(rows(name))


@pytest.mark.sample(0)
@pytest.mark.parametrize("name", NAMES)
def test_a_row_with_a_wrong_sign_is_refuted(name: str) -> None:
    for left, right in rows(name):
        if right == 0:
            continue
        text = f"{sstr(left)} = -({sstr(right)})"
        (entry,) = mechanics.check(truth(name), text, notation="text").judged
        assert entry.finding.verdict.name == "REFUTED"
