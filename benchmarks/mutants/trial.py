"""One mutant, in a copy of the tree: forked from a process that has imported everything else."""

import gc
import io
import json
import os
import resource
import shutil
import sys
from collections.abc import Callable, Sequence
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from time import process_time
from types import FrameType

from benchmarks.mutants.operators import Mutant

ROOT = Path(__file__).resolve().parents[2]
COPIED = ("mechanics", "systems", "tests", "benchmarks")
SECONDS, LONG, MEMORY = 120, 3600, 4 << 30
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


class Calls:
    """Which functions each test calls, and how long it takes: a plugin of pytest."""

    def __init__(self, folder: Path) -> None:
        self.root = f"{folder / 'mechanics'}/"
        self.tests: dict[str, tuple[float, list[str]]] = {}

    def pytest_runtest_protocol(self, item, nextitem) -> bool:
        """Run one test, and keep what it called."""
        from _pytest.runner import runtestprotocol

        called: set[str] = set()

        def seen(frame: FrameType, event: str, argument: object) -> None:
            code = frame.f_code
            if code.co_filename.startswith(self.root):
                called.add(f"{code.co_filename.removeprefix(self.root)}:{code.co_qualname}")

        start = process_time()
        sys.settrace(seen)
        try:
            reports = runtestprotocol(item, nextitem=nextitem)
        finally:
            sys.settrace(None)
        if not all(report.passed or report.skipped for report in reports):
            raise RuntimeError(f"{item.nodeid} fails without a mutant: mend it")
        self.tests[item.nodeid] = process_time() - start, sorted(called)
        return True


def record_calls(folder: Path, tests: Sequence[str]) -> dict[str, tuple[float, list[str]]]:
    """Seconds and functions of every test, each function as ``path:name``.

    Raises
    ------
    RuntimeError
        If one fails without a mutant.
    """
    kept = folder / "calls.json"

    def run() -> int:
        calls = Calls(folder)
        status = _run(folder, tests, calls)
        kept.write_text(json.dumps(calls.tests), encoding="utf-8")
        return status

    if _forked(run) != 0:
        raise RuntimeError(f"{' '.join(tests)}: they fail without a mutant: mend them")
    return json.loads(kept.read_text(encoding="utf-8"))


def survives(folder: Path, mutant: Mutant, tests: Sequence[str]) -> bool:
    """Whether all tests pass with a mutant in place."""
    path = folder / "mechanics" / mutant.path
    text = path.read_text(encoding="utf-8")
    path.write_text(mutant.apply(text), encoding="utf-8")
    try:
        return _forked(lambda: _run(folder, tests)) == 0
    finally:
        path.write_text(text, encoding="utf-8")


def _forked(run: Callable[[], int]) -> int:
    """The status of a function that is run in a process of its own."""
    child = os.fork()
    if child == 0:
        status = 1
        try:
            status = run()
        finally:
            os._exit(status)
    return os.waitpid(child, 0)[1]


def _run(folder: Path, tests: Sequence[str], *plugins: object) -> int:
    import pytest

    os.setpgid(0, 0)
    os.chdir(folder)
    seconds = LONG if plugins else SECONDS
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
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
        return int(pytest.main([*options, *wanted, *tests], plugins=list(plugins)))
