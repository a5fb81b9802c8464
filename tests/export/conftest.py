"""Models that the tests of mechanics.export share, compilers, and the switch for golden files."""

import functools
import importlib
import os
import shutil
from collections.abc import Callable

import pytest

from mechanics.compiled import Model
from mechanics.compiled import compile as compile_model


@functools.cache
def _modelled(system: str, route: str) -> Model:
    scene = importlib.import_module(f"systems.{system}").scene()
    equations = importlib.import_module(f"mechanics.routes.{route}").derive(scene)
    return compile_model(equations, compiler=None)


@pytest.fixture(scope="session")
def modelled() -> Callable[[str, str], Model]:
    return _modelled


@pytest.fixture(params=["gcc", "clang"])
def compiler(request: pytest.FixtureRequest) -> str:
    """Each C compiler in turn; what is not installed is skipped."""
    found = shutil.which(request.param)
    if found is None:
        pytest.skip(f"no {request.param} here")
    return found


@pytest.fixture(scope="session")
def update_golden() -> bool:
    """Set UPDATE_GOLDEN=1 to write golden files instead of comparing with them."""
    return os.environ.get("UPDATE_GOLDEN") == "1"
