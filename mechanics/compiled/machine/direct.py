"""One state at a time from Python in less than a microsecond: an extension of CPython.

ctypes converts every argument at every call, which takes longer than the function. The C files in
`extension` read the arrays where they are. They are compiled when they are first needed, by the
compiler that makes the functions; where the headers of Python or NumPy are missing, or they are
refused, ctypes stays.
"""

import functools
import importlib.util
import platform
import sys
import sysconfig
from collections.abc import Sequence
from importlib.resources import files
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from mechanics.compiled.machine.library import build
from mechanics.errors import CompilerError

NAME = "mechanics_direct"
SOURCES = ("head.c", "caller.c", "bound.c", "states.c", "module.c")
FLAGS = ("-std=c11", "-O2", "-fPIC")
# Symbols of Python itself are found in the process, which linkers elsewhere do not expect.
LINKED = ("-undefined", "dynamic_lookup") if sys.platform == "darwin" else ()


class Direct(NamedTuple):
    """The extension with ``Caller``, ``Bound`` and ``States``, or why there is none."""

    module: Any
    why_not: str = ""


@functools.cache
def direct_calls(compiler: str) -> Direct:
    """The extension, compiled once a process.

    Where it cannot be had, the functions are compiled all the same: only a call takes longer.
    """
    if missing := _missing():
        return Direct(None, missing)
    folders = dict.fromkeys([*_python(), *_numpy()])
    flags = [*FLAGS, *(f"-I{folder}" for folder in folders)]
    try:
        return Direct(_loaded(build(extension_source(), compiler, flags, LINKED)))
    except (CompilerError, ImportError) as error:
        return Direct(None, str(error).splitlines()[0])


def extension_source() -> str:
    """The C of the extension, its files one after the other."""
    folder = files("mechanics.compiled.machine").joinpath("extension")
    return "\n".join(folder.joinpath(name).read_text(encoding="ascii") for name in SOURCES)


def _missing() -> str:
    """What is missing to compile an extension, in a phrase; empty where nothing is."""
    if platform.python_implementation() != "CPython":
        return f"{platform.python_implementation()} is no CPython"
    for header, folders in (("Python.h", _python()), ("numpy/arrayobject.h", _numpy())):
        if not any((Path(folder) / header).is_file() for folder in folders):
            return f"no {header}"
    return ""


def _python() -> Sequence[str]:
    return [sysconfig.get_path("include"), sysconfig.get_path("platinclude")]


def _numpy() -> Sequence[str]:
    return [np.get_include()]


def _loaded(library: Path) -> Any:
    spec = importlib.util.spec_from_file_location(NAME, library)
    if spec is None or spec.loader is None:
        raise ImportError(f"{library} is no extension module here")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
