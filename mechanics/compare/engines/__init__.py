"""Engines to compare with, each optional: one file an adapter, made from a scene or a file.

An adapter takes the engine's module and gives `Engine(name, answers)`: functions of the scene's own
coordinates and speeds.
"""

import importlib.util
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from importlib import import_module
from pathlib import Path

from mechanics.compare.ours import Ours
from mechanics.compare.quantities import Answer
from mechanics.errors import InputError


@dataclass(frozen=True, eq=False)
class Engine:
    """An engine with a model.

    Attributes
    ----------
    name : str
        With its version.
    answers : mapping of str to callable
        See `mechanics.compare.quantities`.
    notes : tuple of str
        What it was told to leave out.
    """

    name: str
    answers: Mapping[str, Answer]
    notes: tuple[str, ...] = field(default=())


ENGINES: tuple[tuple[str, str, str], ...] = (
    ("pinocchio", "pinocchio", "pin"),
    ("mujoco", "mujoco", "mujoco"),
    ("sympy", "sympy", "sympy"),
    ("drake", "pydrake.all", "drake"),
    ("pybullet", "pybullet", "pybullet"),
    ("roboticstoolbox", "roboticstoolbox", "roboticstoolbox-python"),
)
"""Name of each adapter, the module that it needs, and the package that brings it."""


def installed() -> tuple[str, ...]:
    """The engines that are here."""
    return tuple(name for name, module, _ in ENGINES if _is_here(module))


def _is_here(module: str) -> bool:
    return importlib.util.find_spec(module.partition(".")[0]) is not None


Make = Callable[[Path | None], Engine]


def _made(name: str, make: Make, file: Path | None) -> Engine:
    """From the file, or from the scene where the engine refuses the file."""
    try:
        return _tried(name, make, file)
    except InputError as error:
        if file is None:
            raise
        refusal = error
    try:
        made = _tried(name, make, None)
    except InputError:
        raise refusal from None
    return replace(made, notes=(*made.notes, f"{refusal}: its model is made from the scene"))


def _tried(name: str, make: Make, file: Path | None) -> Engine:
    try:
        return make(file)
    except InputError:
        raise
    except Exception as error:
        words = " ".join(str(error).split())
        told = f"{name} does not take the model: {type(error).__name__}: {words}"
        raise InputError(told) from error


def engine(name: str, ours: Ours, file: Path | None = None) -> Engine:
    """An engine with the model of a scene, or of the file that the scene was read from.

    Raises
    ------
    InputError
        For a name that there is not, an engine that is not installed, and what it does not take.
    """
    for known, module, package in ENGINES:
        if known == name:
            if not _is_here(module):
                raise InputError(f"{name} is not installed: pip install {package}")
            make: Callable[..., Engine] = import_module(f"mechanics.compare.engines.{name}").make
            return _made(name, partial(make, import_module(module), ours), file)
    raise InputError(f"engine {name!r}: they are {', '.join(row[0] for row in ENGINES)}")
