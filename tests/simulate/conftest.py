"""Models that several tests simulate, each derived once."""

import functools
from collections.abc import Callable

import pytest

from mechanics.compiled.model import Model, compile
from mechanics.routes.derivation import by_route
from systems import ALL


@pytest.fixture(scope="session")
def model_of() -> Callable[[str], Model]:
    """Model of a system by its name, on CasADi's virtual machine: the graph is what is tested."""
    scenes = {system.name: system.scene for system in ALL}

    @functools.cache
    def model(name: str) -> Model:
        return compile(by_route("lagrange", scenes[name]()), compiler=None)

    return model
