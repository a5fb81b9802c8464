"""Every system derived by every route, once for the whole session."""

from collections.abc import Callable
from functools import cache
from math import comb

import pytest
from every_route import derive_with

import systems
from mechanics.crosscheck import CrossCheck, crosscheck
from mechanics.equations import Equations
from mechanics.kernel import Verdict
from mechanics.scene import Scene

Derived = Callable[[str], dict[str, Equations]]


@cache
def _derived(name: str) -> dict[str, Equations]:
    (system,) = (system for system in systems.ALL if system.name == name)
    return derive_with(system.scene())


@pytest.fixture(scope="session")
def derived() -> Derived:
    """Equations of a system by route."""
    return _derived


@pytest.fixture(scope="session")
def assert_laws() -> Callable[[Scene], None]:
    """Every law of the engine holds for a scene: routes, kinematics, energy, reactions, graphs."""

    def check(scene: Scene) -> None:
        result = crosscheck(scene, CrossCheck(states=0))
        assert not result.open
        assert {f.verdict for f in result.witnesses} == {Verdict.SUPPORTED}
        assert set(result.routes) == {"free_body", "moving_point", "kane", "lagrange"}
        columns = [column for column in result.columns.values() if not column.absent]
        assert len(result.pairs) == comb(len(columns), 2)

    return check
