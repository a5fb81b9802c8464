"""Public functions have examples, which are right for who has written `from mechanics import *`."""

import doctest
import importlib
import importlib.util
import inspect
import re
from pathlib import Path
from typing import Any

import pytest

import mechanics
from mechanics.linear import Linear
from mechanics.report.answer.check import Check
from mechanics.report.result import SystemResult
from mechanics.simulate import Trajectory

PUBLIC = {name: getattr(mechanics, name) for name in mechanics.__all__}
RESULTS = {"CrossCheck", "Finding", "MechanicsError", "Verdict", "Witness"}
"""Classes that the examples of `check` and `crosscheck` show, and that nobody has to make."""
CLASSES = sorted({name for name in PUBLIC if inspect.isclass(PUBLIC[name])} - RESULTS)
FUNCTIONS = [name for name in PUBLIC if inspect.isfunction(PUBLIC[name])]
SECONDS = ("extremes", "trade")
"""What measures takes longer than a default test may."""
MAKERS = {"Equations": "derive", "Model": "compile"}
"""What makes an object of a class."""
HANDED_ON = (Check, Linear, SystemResult, Trajectory)
"""What functions give back, and nobody has to make or import."""
ROOT = Path(__file__).parents[1]
ENGINES = {"from_mjcf": "mujoco"}
"""What somebody may not have."""


def test_every_public_function_and_class_has_an_example() -> None:
    heading = "\nExamples\n--------\n"
    without = [
        name for name in (*FUNCTIONS, *CLASSES) if heading not in str(inspect.getdoc(PUBLIC[name]))
    ]
    assert not without


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=pytest.mark.campaign if name in SECONDS else ())
        for name in (*FUNCTIONS, *CLASSES)
    ],
)
def test_examples_are_right(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    if name in ENGINES and importlib.util.find_spec(ENGINES[name]) is None:
        pytest.skip(f"{ENGINES[name]} is not installed")
    monkeypatch.chdir(tmp_path)
    finder = doctest.DocTestFinder(recurse=False)
    (example,) = finder.find(PUBLIC[name], name, globs={**PUBLIC})
    told: list[str] = []
    outcome = doctest.DocTestRunner(verbose=False).run(example, out=told.append)
    assert outcome.failed == 0, "".join(told)
    # An example calls what it is the example of, and shows what comes out.
    source = "".join(step.source for step in example.examples)
    assert f"{MAKERS.get(name, name)}(" in source
    assert any(step.want for step in example.examples)


@pytest.mark.parametrize("result", HANDED_ON, ids=lambda result: result.__name__)
def test_examples_of_results_are_right(result: type) -> None:
    (example,) = doctest.DocTestFinder(recurse=False).find(result, globs={**PUBLIC})
    wrong: list[str] = []
    outcome = doctest.DocTestRunner(verbose=False).run(example, out=wrong.append)
    assert outcome.attempted > 0
    assert outcome.failed == 0, "".join(wrong)


def test_the_reference_has_everything_public_and_every_result() -> None:
    pages = "".join(page.read_text("utf-8") for page in (ROOT / "docs/reference").glob("*.md"))
    entries = set(re.findall(r"auto(?:function|class):: (\S+)", pages))
    shown = [inspect.unwrap(_entry(entry)) for entry in entries]
    wanted = [PUBLIC[name] for name in (*FUNCTIONS, *CLASSES, *RESULTS)]
    missing = [made.__name__ for made in (*wanted, *HANDED_ON) if made not in shown]
    assert not missing


def _entry(path: str) -> Any:
    module, _, name = path.rpartition(".")
    return getattr(importlib.import_module(module), name)


def test_help_names_what_is_public_and_nothing_else() -> None:
    lines = str(mechanics.__doc__).splitlines()
    named = {
        word for line in lines if re.match(r"    \w.*  ", line)
        for word in line.strip().split("  ")[0].split()
    }  # fmt: skip
    assert named <= {*PUBLIC}
    assert {*FUNCTIONS} <= named


@pytest.mark.parametrize("name", CLASSES)
def test_public_methods_are_called_in_an_example(name: str) -> None:
    made = PUBLIC[name]
    methods = {
        key: member
        for key, member in vars(made).items()
        if inspect.isfunction(member) and not key.startswith("_")
    }
    examples = str(inspect.getdoc(made)).partition("Examples\n--------\n")[2]
    own = {key for key, member in methods.items() if ">>> " in str(inspect.getdoc(member))}
    assert [key for key in methods if f".{key}(" not in examples and key not in own] == []
