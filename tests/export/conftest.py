"""Models that the tests of mechanics.export share, compilers, and the switch for golden files."""

import functools
import importlib
import os
import sys
from collections.abc import Callable

import pytest

from mechanics.compiled import Model
from mechanics.compiled import compile as compile_model
from mechanics.export.evidence.chain import Chain
from mechanics.routes.derivation import by_route


@functools.cache
def _modelled(system: str, route: str) -> Model:
    scene = importlib.import_module(f"systems.{system}").scene()
    equations = by_route(route, scene)
    return compile_model(equations, compiler=None)


@pytest.fixture(scope="session")
def modelled() -> Callable[[str, str], Model]:
    return _modelled


@pytest.fixture(autouse=True)
def without_chain(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """What is shown about generated code has tests of its own, and takes a second a folder."""
    if "evidence" not in request.path.parts:
        module = sys.modules["mechanics.export.write_c"]
        monkeypatch.setattr(module, "chain", lambda *_, **__: Chain((), (), ()))


@pytest.fixture
def compiler(each: str) -> str:
    """Each C compiler in turn."""
    return each


@pytest.fixture(scope="session")
def update_golden() -> bool:
    """Set UPDATE_GOLDEN=1 to write golden files instead of comparing with them."""
    return os.environ.get("UPDATE_GOLDEN") == "1"
