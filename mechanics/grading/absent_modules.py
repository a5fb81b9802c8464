"""What stands for modules that are not installed where a file is run.

    import jax.numpy as jnp    ->    numpy        @jit    ->    the function itself
    class Env(gym.Env)         ->    object       anything else has no value

A file names many modules that its formulas do not need. What is made with one that is not there is
no number and has no truth: a formula that needs it cannot be followed.
"""

import importlib
import sys
from collections.abc import Callable
from types import ModuleType
from typing import Any, NoReturn, TypeVar

from mechanics.errors import InputError

Result = TypeVar("Result")

SAME = {"jax.numpy": "numpy", "autograd.numpy": "numpy"}
"""Modules whose functions are those of another one."""
COMPILERS = ("jit", "njit", "vectorize", "script", "checkpoint", "lru_cache")
"""Decorators under which a function returns what it returned."""
FOLDER = "folder_of_the_submission"
"""The package that a file takes itself for part of: ``from .base import Env``."""
MOST = 40


class Absent:
    """What a module has that is not installed."""

    def __init__(self, name: str) -> None:
        self.__name__ = name

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return Absent(f"{self.__name__}.{name}")

    def __call__(self, *arguments: Any, **_: Any) -> Any:
        """Whatever it would make; a function is what it is under a compiler."""
        if self.__name__.rpartition(".")[2] in COMPILERS:
            return (
                arguments[0] if arguments and callable(arguments[0]) else lambda function: function
            )
        return Absent(f"{self.__name__}()")

    def __mro_entries__(self, _: tuple[type, ...]) -> tuple[type, ...]:
        return ()

    def _refused(self, *_: object) -> NoReturn:
        raise InputError(f"{self.__name__} is not installed, and a formula needs it")

    __bool__ = __iter__ = __len__ = __float__ = __int__ = __index__ = _refused
    __eq__ = __ne__ = __lt__ = __le__ = __gt__ = __ge__ = _refused
    __contains__ = __getitem__ = __array__ = __enter__ = _refused
    __hash__ = object.__hash__


class _Module(ModuleType):
    __path__: list[str] = []  # noqa: RUF012  (a module is a package where it has this)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        inner = f"{self.__name__}.{name}"
        return sys.modules.get(inner) or Absent(inner)


def standing_in(run: Callable[[], Result]) -> Result:
    """What `run` returns, with something in place of modules that it does not find.

    Raises
    ------
    ModuleNotFoundError
        For one that is still not found.
    """
    added = [FOLDER]
    sys.modules[FOLDER] = _Module(FOLDER)
    try:
        for _ in range(MOST):
            try:
                return run()
            except ModuleNotFoundError as error:
                if not error.name or error.name in sys.modules:
                    raise
                sys.modules[error.name] = _module(error.name)
                added.append(error.name)
        return run()
    finally:
        for name in added:
            del sys.modules[name]


def _module(name: str) -> ModuleType:
    if name in SAME:
        return importlib.import_module(SAME[name])
    return _Module(name)
