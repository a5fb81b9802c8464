"""One mutant, in a copy of the tree: forked from a process that has imported everything else."""

import gc
import io
import os
import resource
import shutil
import sys
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path

from benchmarks.mutants.operators import Mutant

ROOT = Path(__file__).resolve().parents[2]
COPIED = ("mechanics", "systems", "tests", "benchmarks")
SECONDS, MEMORY = 120, 4 << 30
"""Of processor time and bytes that the tests of one mutant may take; more counts as noticed."""


def copy_tree(folder: Path) -> None:
    """Copy what is tested, and its tests."""
    for name in COPIED:
        ignored = shutil.ignore_patterns("__pycache__", ".hypothesis")
        shutil.copytree(ROOT / name, folder / name, ignore=ignored)
    for name in ("pyproject.toml", "README.md"):
        shutil.copy(ROOT / name, folder)


def warm_up() -> None:
    """Import what every test needs but this package, and collect no garbage of it."""
    import _pytest.assertion.rewrite
    import casadi
    import flint
    import hypothesis
    import numpy
    import pytest
    import scipy.linalg
    import sympy.physics.mechanics

    # A test that is slow for others is not wrong, and draws what it always draws.
    hypothesis.settings.register_profile("mutants", derandomize=True, deadline=None, database=None)
    hypothesis.settings.load_profile("mutants")
    loaded = (casadi, flint, numpy, pytest, scipy, sympy, _pytest)
    if any(name.partition(".")[0] == "mechanics" for name in sys.modules) or not all(loaded):
        raise RuntimeError("the package is imported already: its mutants would not be")
    gc.freeze()


def survives(folder: Path, mutant: Mutant | None, tests: tuple[str, ...]) -> bool:
    """Whether all tests pass with a mutant in place; without one, whether they pass at all."""
    path = folder / "mechanics" / mutant.path if mutant else None
    text = path.read_text(encoding="utf-8") if path else ""
    if mutant and path:
        path.write_text(mutant.apply(text), encoding="utf-8")
    child = os.fork()
    if child == 0:
        status = 1
        try:
            status = _run(folder, tests)
        finally:
            os._exit(status)
    _, ended = os.waitpid(child, 0)
    if path:
        path.write_text(text, encoding="utf-8")
    return ended == 0


def _run(folder: Path, tests: tuple[str, ...]) -> int:
    import pytest

    os.setpgid(0, 0)
    os.chdir(folder)
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    sys.dont_write_bytecode = True
    sys.path[:] = [str(folder), *(p for p in sys.path if Path(p or ".").resolve() != ROOT)]
    for name in [n for n in sys.modules if n.partition(".")[0] == "benchmarks"]:
        del sys.modules[name]
    os.environ["PYTHONPATH"] = str(folder)
    os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
    options = ["-x", "-q", "-p", "no:cacheprovider", "--import-mode=importlib"]
    wanted = ["-m", "not campaign and not browser", "-o", "addopts="]
    with redirect_stdout(io.StringIO()), redirect_stderr(io.StringIO()):
        return int(pytest.main([*options, *wanted, *tests]))
