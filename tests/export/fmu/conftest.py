"""Units of all systems, each written once, and how FMPy opens them."""

import contextlib
import functools
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from fmpy import extract, instantiate_fmu, read_model_description

from mechanics.compiled import Model
from mechanics.compiled import compile as compile_model
from mechanics.crosscheck.fmu import write_fmu
from mechanics.routes.derivation import by_route
from mechanics.scene.actions import frictions
from systems import ALL

SCENES = {system.name: system.scene for system in ALL}


@functools.cache
def _model(name: str) -> Model:
    # Units are compiled in a tenth of the time without optimisation.
    return compile_model(by_route("free_body", SCENES[name]()), flags="-O0")


@pytest.fixture(scope="session")
def model_of() -> Callable[[str], Model]:
    return _model


@pytest.fixture(scope="session")
def unit_of(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """The unit of a system, at the values that its scene gives as an example."""
    folder = tmp_path_factory.mktemp("units")

    @functools.cache
    def unit(name: str) -> Path:
        model = _model(name)
        if model.compiler is None:
            pytest.skip("no C compiler here")
        # A unit does not watch where sliding ends, which has to be accepted.
        rubs = bool(frictions(model.equations.scene))
        # Each proof has a test of its own.
        return write_fmu(model, folder / f"{name}.fmu", beyond_domain=rubs, prove=False)

    return unit


@dataclass(frozen=True)
class Open:
    """An instance that FMPy has made, what it logs, and references by name."""

    fmu: Any
    log: list[tuple[int, str]]
    references: dict[str, int]

    def get(self, *names: str) -> list[float]:
        return self.fmu.getFloat64([self.references[name] for name in names])

    def set(self, **values: float) -> None:
        self.fmu.setFloat64([self.references[name] for name in values], list(values.values()))

    def initialised(self, **values: float) -> "Open":
        self.set(**values)
        self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()
        return self


@pytest.fixture
def opened(unit_of: Callable[[str], Path], tmp_path: Path) -> Iterator[Callable[..., Open]]:
    """Instances by the name of the system and the kind; freed afterwards."""
    with contextlib.ExitStack() as stack:

        @functools.cache
        def extracted(name: str) -> tuple[str, Any]:
            return (
                extract(str(unit_of(name)), unzipdir=str(tmp_path / name)),
                read_model_description(str(unit_of(name))),
            )

        def make(name: str, kind: str = "CoSimulation") -> Open:
            folder, description = extracted(name)
            log: list[tuple[int, str]] = []

            def logged(environment: object, status: int, category: bytes, words: bytes) -> None:
                log.append((status, words.decode()))

            fmu = instantiate_fmu(folder, description, kind, logger=logged)
            stack.callback(fmu.freeInstance)
            names = {v.name: v.valueReference for v in description.modelVariables}
            return Open(fmu, log, names)

        yield make
