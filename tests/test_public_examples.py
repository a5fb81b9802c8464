"""Public functions have examples, which are right for who has written `from mechanics import *`."""

import doctest
import importlib.util
import inspect
from pathlib import Path

import pytest

import mechanics

PUBLIC = {name: getattr(mechanics, name) for name in mechanics.__all__}
FUNCTIONS = [name for name in PUBLIC if inspect.isfunction(PUBLIC[name])]
SECONDS = ("extremes", "trade")
"""What measures takes longer than a default test may."""
ENGINES = {"from_mjcf": "mujoco"}
"""What somebody may not have."""


def test_every_public_function_has_an_example() -> None:
    heading = "\nExamples\n--------\n"
    without = [name for name in FUNCTIONS if heading not in str(inspect.getdoc(PUBLIC[name]))]
    assert not without


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=pytest.mark.campaign if name in SECONDS else ())
        for name in FUNCTIONS
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
    assert f"{name}(" in "".join(step.source for step in example.examples)
    assert any(step.want for step in example.examples)
