"""Laws with many cases: a fixed sample of them runs by default, the rest is a campaign.

``@pytest.mark.sample(n)`` leaves a law n of its cases, and those about the systems of the seed;
the others get the marker ``campaign``. ``--cases N`` leaves a law N cases, those of its sample that
run by default among them; all of a campaign where it has the marker ``every_case``. Both draw by a
hash of the name of a case, so that every run on every machine has the same ones; those with the
marker ``long`` come last. ``--draws N`` is how many random mechanisms a campaign draws.
"""

import gc
import os
import shutil
import sys
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator
from functools import cache, lru_cache
from hashlib import sha256
from importlib import import_module
from typing import Any

import pytest
from hypothesis import settings

from mechanics.cli.app import COLLECTED
from mechanics.compiled.machine.native import find_compiler
from mechanics.scene import Scene
from systems import EVERY, SEED

# What is drawn is the same in every run, and a busy machine fails nothing.
settings.register_profile("fixed", derandomize=True, deadline=None)
settings.load_profile("fixed")

# As the command does.
gc.set_threshold(COLLECTED)

# Nobody changes a scene of a test: each that is built in is built once a process, and derived once
# for statements about it, before a module of tests takes the functions. A new one is made by
# `scene.__wrapped__()`.
for _system in EVERY:
    _once = cache(_system.scene)
    setattr(sys.modules[_system.scene.__module__], _system.scene.__name__, _once)
    object.__setattr__(_system, "scene", _once)
_check = import_module("mechanics.judge.check")
_check.derived = lru_cache(maxsize=64)(_check.derived)

OF_THE_SEED = {system.name for system in SEED}


def pytest_addoption(parser: pytest.Parser) -> None:
    words = "of a law, at most N cases with those of its sample"
    parser.addoption("--cases", type=int, default=sys.maxsize, metavar="N", help=words)
    words = "mechanisms that the campaign of random ones draws"
    parser.addoption("--draws", type=int, default=8, metavar="N", help=words)


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    for cases in by_law(item for item in items if item.get_closest_marker("sample")):
        (most,) = cases[0].get_closest_marker("sample").args
        for case in drawn(case for case in cases if not is_of_the_seed(case))[most:]:
            case.add_marker("campaign")
    beyond: set[pytest.Item] = set()
    for cases in by_law(items):
        rest = [case for case in cases if case.get_closest_marker("campaign")]
        if rest and not rest[0].get_closest_marker("every_case"):
            # A sample that runs by default counts; what is a campaign by its own mark is one more.
            own = len(cases) - len(rest) if rest[0].get_closest_marker("sample") else 0
            beyond.update(drawn(rest)[max(0, config.getoption("cases") - own) :])
    config.hook.pytest_deselected(items=list(beyond))
    items[:] = [item for item in items if item not in beyond]


def by_law(items: Iterable[pytest.Item]) -> list[list[pytest.Item]]:
    """Cases of the same test, together."""
    laws = defaultdict(list)
    for item in items:
        laws[item.nodeid.partition("[")[0]].append(item)
    return list(laws.values())


def drawn(cases: Iterable[pytest.Item]) -> list[pytest.Item]:
    """Cases in the order of their hashes; laws in one file draw the same systems, derived once."""
    return sorted(
        cases,
        key=lambda case: (
            case.get_closest_marker("long") is not None,
            sha256(name_of(case).encode()).digest(),
        ),
    )


def name_of(case: pytest.Item) -> str:
    """File and parameters of a case, without the name of its law."""
    return f"{case.path.name} {case.callspec.id if hasattr(case, 'callspec') else ''}"


def is_of_the_seed(case: pytest.Item) -> bool:
    """Whether a case is about a system of the seed, given by its name or as it is."""
    values = [getattr(value, "name", value) for value in case.callspec.params.values()]
    return any(isinstance(value, str) and value in OF_THE_SEED for value in values)


@pytest.fixture(scope="session", autouse=True)
def derived_once() -> Iterator[None]:
    """Nobody changes a scene of a test: `check` derives it, and tries it as declared, once."""
    module = import_module("mechanics.judge.check")
    reference = module._reference
    once = lru_cache(maxsize=64)(reference)

    def remembered(scene: Any) -> Any:
        return once(scene) if isinstance(scene, Scene) else reference(scene)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(module, "_reference", remembered)
        yield


@pytest.fixture(scope="session")
def compiler() -> str:
    """The C compiler of this machine."""
    found = find_compiler()
    if found is None:
        pytest.skip("no C compiler here")
    return found


@pytest.fixture(scope="session")
def needed() -> Callable[[str], str]:
    """Path of a tool; what is not installed is skipped, and fails in CI."""

    def path(tool: str) -> str:
        found = shutil.which(tool)
        if found is None and os.environ.get("MECHANICS_CI"):
            pytest.fail(f"{tool} is not installed: .ci/run has a table of packages")
        if found is None:
            pytest.skip(f"no {tool} here")
        return found

    return path


@pytest.fixture(params=["gcc", "clang"])
def each(request: pytest.FixtureRequest, needed: Callable[[str], str]) -> str:
    """Each C compiler in turn."""
    return needed(request.param)
