"""Statements made from expressions, and systems derived once for all tests of blame."""

from collections.abc import Callable
from functools import cache

import pytest
from sympy import Expr, S

import systems
from mechanics.blame.reference import Reference
from mechanics.claims.statement import Statement
from mechanics.equations import Equations
from mechanics.judge.check import derived
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion
from mechanics.scene.system import System

MEMBERS: tuple[System, ...] = systems.ALL
NAMES = tuple(member.name for member in MEMBERS)


@cache
def _reference(name: str) -> Reference:
    (member,) = (member for member in MEMBERS if member.name == name)
    return Reference(derived(member.scene()))


def _truth(name: str) -> Equations:
    return _reference(name).truth


@pytest.fixture(params=NAMES)
def reference(request: pytest.FixtureRequest) -> Reference:
    """What statements about a system are compared with, for each built-in one in turn."""
    return _reference(request.param)


@pytest.fixture
def truth(reference: Reference) -> Equations:
    """That system, as it is derived for a check."""
    return reference.truth


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
