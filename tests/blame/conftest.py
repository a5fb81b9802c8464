"""Statements made from expressions, and systems derived once for all tests of blame."""

from collections.abc import Callable
from functools import cache

import pytest
from sympy import Expr, S

import systems
from mechanics.equations import Equations
from mechanics.judge.check import derived
from mechanics.reading.statement import Statement
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion
from mechanics.scene.system import System

MEMBERS: tuple[System, ...] = systems.ALL
NAMES = tuple(member.name for member in MEMBERS)


@cache
def _truth(name: str) -> Equations:
    (member,) = (member for member in MEMBERS if member.name == name)
    return derived(member.scene())


@pytest.fixture(params=NAMES)
def truth(request: pytest.FixtureRequest) -> Equations:
    """Each built-in system in turn, as it is derived for a check."""
    return _truth(request.param)


@pytest.fixture(scope="session")
def truth_of() -> Callable[[str], Equations]:
    """A built-in system by its name."""
    return _truth


@pytest.fixture(scope="session")
def stated() -> Callable[..., Statement]:
    """An equation of motion ``value = 0`` as a statement."""

    def make(value: Expr, tag: str = "1", right: Expr = S.Zero) -> Statement:
        row = published(tag, EquationOfMotion(), value, right, label=str(value)[:60])
        return Statement(row, str(value)[:60], tag)

    return make
