"""Equations and models that the tests of mechanics.compiled share, derived once."""

import functools
import importlib
from collections.abc import Callable

import pytest

from mechanics.compiled import Model
from mechanics.compiled import compile as compile_model
from mechanics.equations import Equations
from mechanics.routes.derivation import by_route


@functools.cache
def _derived(system: str, route: str) -> Equations:
    scene = importlib.import_module(f"systems.{system}").scene()
    return by_route(route, scene)


@functools.cache
def _modelled(system: str, route: str) -> Model:
    return compile_model(_derived(system, route))


@pytest.fixture(scope="session")
def derived() -> Callable[[str, str], Equations]:
    return _derived


@pytest.fixture(scope="session")
def modelled() -> Callable[[str, str], Model]:
    return _modelled


@pytest.fixture
def unwritten(monkeypatch: pytest.MonkeyPatch) -> None:
    """M and f must not be written out while the test runs."""

    def refuse(*_: object) -> None:
        raise AssertionError("M and f are written out")

    monkeypatch.setattr("mechanics.routes.textbook._matrices", refuse)
