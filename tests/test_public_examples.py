"""Public functions have examples, which are right for who has written `from mechanics import *`."""

import doctest
import importlib.util
import inspect
from pathlib import Path

import pytest

import mechanics

PUBLIC = {name: getattr(mechanics, name) for name in mechanics.__all__}
RESULTS = {"CrossCheck", "Finding", "MechanicsError", "Verdict", "Witness"}
"""Classes that the examples of `check` and `crosscheck` show, and that nobody has to make."""
CLASSES = sorted({name for name in PUBLIC if inspect.isclass(PUBLIC[name])} - RESULTS)
FUNCTIONS = [name for name in PUBLIC if inspect.isfunction(PUBLIC[name])]
SECONDS = ("extremes", "trade")
"""What measures takes longer than a default test may."""
MAKERS = {"Equations": "derive", "Model": "compile"}
"""What makes an object of a class."""
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
