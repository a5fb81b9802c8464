"""Equations that others published: scenes derived once, digits as their sources print them."""

from collections.abc import Callable
from decimal import Decimal
from functools import cache

import numpy as np
import pytest

import systems
from mechanics import compile
from mechanics.equations import Equations
from mechanics.judge.check import Judged, derived


@cache
def _truth(name: str) -> Equations:
    (system,) = (system for system in systems.ALL if system.name == name)
    return derived(system.scene())


@pytest.fixture(scope="session")
def truth() -> Callable[[str], Equations]:
    """What the engine derives for a system."""
    return _truth


def _agrees(value: float, printed: str, scale: float) -> bool:
    """Whether a double, give or take roundings of numbers of a size, is what was printed."""
    unit = Decimal(1).scaleb(int(Decimal(printed).as_tuple().exponent))
    return abs(Decimal(value) - Decimal(printed)) <= unit / 2 + Decimal(32 * np.spacing(scale))


@pytest.fixture(scope="session")
def assert_agree() -> Callable:
    """Assert that numbers are those that were printed, to every digit that was."""

    def check(values, printed: tuple[str, ...]) -> None:
        pairs = list(zip(map(float, values), printed, strict=True))
        scale = max(abs(value) for value, _ in pairs)
        assert all(_agrees(value, text, scale) for value, text in pairs), pairs

    return check


@pytest.fixture(scope="session")
def accelerations() -> Callable:
    """Accelerations by the engine at a state, from values by name."""

    def at(equations: Equations, values: dict[str, float]) -> np.ndarray:
        scene = equations.scene
        q, u, inputs = (
            [values[s.name] for s in group] for group in (scene.q, scene.u, scene.input_symbols)
        )
        given = {s.name: values[s.name] for s in scene.parameters}
        model = compile(equations, compiler=None)
        return model.forward_dynamics(q, u, given, inputs=inputs or None)

    return at


@pytest.fixture(scope="session")
def edits() -> Callable:
    """What the first repair of a refuted statement says: (mistake, written, right) of each edit."""

    def of(entry: Judged) -> list[tuple[str, str, str]]:
        assert entry.finding.verdict.name == "REFUTED"
        assert entry.blame is not None and entry.blame.repairs, entry.blame
        first = entry.blame.repairs[0]
        assert first.finding.shown
        return [(e.mistake.name, e.written, e.right) for e in first.edits]

    return of
