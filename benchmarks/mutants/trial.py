"""Mutants one at a time, each in a process of its own, until a test fails.

Tests are collected once. What stands in a function is changed in a fork of that process, as
`benchmarks.faults` does it, and only tests that call the function are run, the quickest first. What
stands outside of functions is changed in a copy of the tree, before the package is imported.
"""

import gc
import json
import os
import resource
import shutil
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from functools import _lru_cache_wrapper
from math import ceil, inf
from pathlib import Path
from tempfile import TemporaryDirectory
from time import process_time
from types import FrameType
from typing import Any

import pytest

from benchmarks.faults.fault import code_of, function_of
from benchmarks.mutants.covering import tests_of
from benchmarks.mutants.operators import Mutant

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "mechanics"
COPIED = ("mechanics", "systems", "tests", "benchmarks")
SECONDS, MEMORY = 20, 4 << 30
"""Of processor time, beside what they take without a mutant, and bytes that tests of one may take;
more counts as noticed. All tests of a folder may take ten times as long."""
ENOUGH = 6.0
"""Seconds of tests that call a function, the quickest first; the others only see survivors."""
FORGOTTEN = tuple(f"mechanics.{part}." for part in
                  ("kernel", "program", "checks", "kinematics", "routes"))  # fmt: skip
OPTIONS = ["-x", "-q", "-p", "no:cacheprovider", "--import-mode=importlib", "-o", "addopts=",
           "-m", "not campaign and not browser"]  # fmt: skip

Report = Callable[[Mutant, bool], None]
Calls = dict[str, tuple[float, list[str]]]


class Planting:
    """A plugin of pytest that plants mutants where tests would be run."""

    def __init__(
        self, mutants: Sequence[Mutant], report: Report, folder: Path, enough: float
    ) -> None:
        self.mutants, self.report, self.enough = mutants, report, enough
        self.kept = folder / "calls.json"

    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        """Try each mutant in a fork, which has what was collected."""
        items = {item.nodeid: item for item in session.items}
        with quiet():
            if forked(lambda: self._record(session.items)) != 0:
                raise RuntimeError("a test fails without a mutant: mend it")
        calls: Calls = json.loads(self.kept.read_text(encoding="utf-8"))

        def times(names: Iterable[str]) -> int:
            return ceil(sum(calls[name][0] for name in names))

        for mutant in self.mutants:
            first, every = (callers(calls, mutant, enough) for enough in (self.enough, inf))
            # What the quickest do not notice the others may.
            alive = all(
                self._survives(mutant, [items[name] for name in names], SECONDS + times(names))
                for names in (first, every[len(first) :])
                if names
            )
            self.report(mutant, alive)
        return True

    def _record(self, items: Sequence[pytest.Item]) -> int:
        """Seconds and functions of every test, each function as ``path:name``."""
        root, found, kept = f"{PACKAGE}/", {}, caches()
        for item in items:
            called: set[str] = set()

            def seen(frame: FrameType, event: str, argument: object, called: set = called) -> None:
                code = frame.f_code
                if code.co_filename.startswith(root):
                    called.add(f"{code.co_filename.removeprefix(root)}:{code.co_qualname}")

            for cache in kept:
                cache.cache_clear()
            start = process_time()
            sys.settrace(seen)
            passed = passes(item)
            sys.settrace(None)
            if not passed:
                return 1
            found[item.nodeid] = process_time() - start, sorted(called)
        self.kept.write_text(json.dumps(found), encoding="utf-8")
        return 0

    def _survives(self, mutant: Mutant, items: Iterable[pytest.Item], seconds: int) -> bool:
        with quiet():
            return forked(lambda: self._try(mutant, items, seconds)) == 0

    def _try(self, mutant: Mutant, items: Iterable[pytest.Item], seconds: int) -> int:
        limit(seconds)
        module = "mechanics." + mutant.path.removesuffix(".py").replace("/", ".")
        text = (PACKAGE / mutant.path).read_text(encoding="utf-8")
        function = function_of(module, mutant.function)
        function.__code__ = code_of(mutant.apply(text), mutant.path, mutant.function)
        return 0 if all(map(passes, items)) else 1


def callers(calls: Calls, mutant: Mutant, enough: float = inf) -> list[str]:
    """Tests that call the function of a mutant, the quickest first, as long as there is time."""
    name = f"{mutant.path}:{mutant.function}"
    found = {
        test: seconds
        for test, (seconds, called) in calls.items()
        if any(one == name or one.startswith(f"{name}.") for one in called)
    }
    total, chosen = 0.0, []
    for test in sorted(found, key=lambda test: found[test]):
        total += found[test]
        if total > enough and chosen:
            break
        chosen.append(test)
    return chosen


def caches() -> list[_lru_cache_wrapper]:
    """Caches of functions, to be emptied so that what a test needs is called in it.

    Canaries are decided once all the same.
    """
    found = []
    for thing in gc.get_objects():
        if isinstance(thing, _lru_cache_wrapper):
            # One of a partial function has no name.
            name, module = getattr(thing, "__name__", ""), getattr(thing, "__module__", None)
            if name != "check_canaries" and str(module).startswith(FORGOTTEN):
                found.append(thing)
    return found


def passes(item: pytest.Item) -> bool:
    """Whether one test passes."""
    from _pytest.runner import runtestprotocol

    reports = runtestprotocol(item, log=False, nextitem=None)
    return all(report.passed or report.skipped for report in reports)


def try_functions(
    mutants: Sequence[Mutant], tests: Sequence[str], report: Report, enough: float = ENOUGH
) -> None:
    """Try mutants in functions, all covered by the same test files.

    Raises
    ------
    RuntimeError
        If a test cannot be collected, or fails without a mutant.
    """
    by_key = {mutant.key: mutant for mutant in mutants}
    reader, writer = os.pipe()

    def tell(mutant: Mutant, alive: bool) -> None:
        os.write(writer, f"{mutant.key} {int(alive)}\n".encode())

    def run() -> int:
        os.close(reader)
        with TemporaryDirectory() as name, quiet():
            plugin = Planting(mutants, tell, Path(name), enough)
            paths = [str(ROOT / test) for test in tests]
            return int(pytest.main([*OPTIONS, *paths], plugins=[plugin]))

    # In a process of its own, so that the next tests are collected where nothing is imported.
    child = os.fork()
    if child == 0:
        status = 1
        try:
            status = run()
        finally:
            os._exit(status)
    os.close(writer)
    with os.fdopen(reader) as lines:
        for line in lines:
            key, alive = line.split()
            report(by_key[key], alive == "1")
    status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    if status not in (0, pytest.ExitCode.NO_TESTS_COLLECTED):
        raise RuntimeError(
            f"{' '.join(tests)}: pytest ends with {status}: run them without mutants"
        )


def try_files(mutants: Iterable[Mutant], report: Report) -> None:
    """Try mutants outside of functions, each in a copy of the tree."""
    with TemporaryDirectory() as name:
        folder = Path(name)
        for part in COPIED:
            ignored = shutil.ignore_patterns("__pycache__", ".hypothesis")
            shutil.copytree(ROOT / part, folder / part, ignore=ignored)
        for part in ("pyproject.toml", "README.md"):
            shutil.copy(ROOT / part, folder)
        for mutant in mutants:
            path = folder / "mechanics" / mutant.path
            text = path.read_text(encoding="utf-8")
            path.write_text(mutant.apply(text), encoding="utf-8")
            tests = tests_of(mutant.path)
            with quiet():
                status = forked(lambda tests=tests: _whole(folder, tests))
            path.write_text(text, encoding="utf-8")
            report(mutant, status == 0)


def tried(
    part: tuple[Sequence[Mutant], Sequence[str]], enough: float
) -> list[tuple[str, bool]]:  # fmt: skip
    """On a worker, in a process of its own: keys of mutants, and whether each survives.

    Parameters
    ----------
    part : (sequence of Mutant, sequence of str)
        Mutants in functions and their test files, or others without any.
    """
    found: list[tuple[str, bool]] = []

    def report(mutant: Mutant, alive: bool) -> None:
        found.append((mutant.key, alive))

    warm_up()
    mutants, tests = part
    if tests:
        try_functions(mutants, tests, report, enough)
    else:
        try_files(mutants, report)
    return found


def _whole(folder: Path, tests: Sequence[str]) -> int:
    limit(10 * SECONDS)
    os.chdir(folder)
    sys.dont_write_bytecode = True
    sys.path[:] = [str(folder), *(p for p in sys.path if Path(p or ".").resolve() != ROOT)]
    for name in [n for n in sys.modules if n.partition(".")[0] in COPIED]:
        del sys.modules[name]
    os.environ["PYTHONPATH"] = str(folder)
    return int(pytest.main([*OPTIONS, *tests]))


def warm_up() -> None:
    """Import what tests need but this package."""
    import casadi
    import flint
    import hypothesis
    import scipy.linalg
    import sympy.physics.mechanics

    # A test that is slow for others is not wrong, and draws what it always draws.
    hypothesis.settings.register_profile("mutants", derandomize=True, deadline=None, database=None)
    hypothesis.settings.load_profile("mutants")
    loaded: tuple[Any, ...] = (casadi, flint, scipy, sympy)
    if "mechanics" in sys.modules or not all(loaded):
        raise RuntimeError("the package is imported already: its mutants would not be")


def limit(seconds: int) -> None:
    """End this process where it takes too much."""
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


@contextmanager
def quiet() -> Iterator[None]:
    """Nothing that a fork prints is shown."""
    sys.stdout.flush()
    kept = [os.dup(1), os.dup(2)]
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, 1)
    os.dup2(null, 2)
    try:
        yield
    finally:
        for number, old in enumerate(kept, 1):
            os.dup2(old, number)
            os.close(old)
        os.close(null)


def forked(run: Callable[[], int]) -> int:
    """The status of a function that is run in a process of its own."""
    child = os.fork()
    if child == 0:
        status = 1
        try:
            status = run()
        finally:
            os._exit(status)
    return os.waitpid(child, 0)[1]
