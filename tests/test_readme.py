"""The README stays true: its example runs, prints what it says, and its files exist."""

import contextlib
import io
import re
from pathlib import Path
from typing import Any

import pytest

import mechanics
from systems import elastic_pendulum

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def block(marker: str) -> str:
    """The fenced block under a marker comment."""
    found = re.search(rf"<!-- {marker} -->\n```\w*\n(.*?)```", README, re.DOTALL)
    assert found is not None, f"README.md has no block marked {marker}"
    return found[1]


@pytest.mark.parametrize("name", ["python", "space"])
def test_an_example_prints_what_the_readme_says(name: str) -> None:
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(block(f"example: {name}"), "README.md", "exec"), {"__name__": "example"})
    assert printed.getvalue() == block(f"output: {name}")


@pytest.mark.campaign
def test_the_scene_of_the_python_example_can_be_exported(tmp_path: Path) -> None:
    names: dict[str, Any] = {"__name__": "example"}
    with contextlib.redirect_stdout(io.StringIO()):
        exec(compile(block("example: python"), "README.md", "exec"), names)
    model = mechanics.compile(mechanics.derive(names["scene"]))
    # What is refuted raises.
    assert mechanics.write_c(model, tmp_path / "pendulum")
    assert (tmp_path / "pendulum" / "manifest.json").exists()


def test_files_that_the_readme_links_exist() -> None:
    links = re.findall(r"\]\(([^)#]+)\)", README)
    assert links
    missing = [link for link in links if "://" not in link and not (ROOT / link).exists()]
    assert not missing


def test_the_answer_to_wrong_equations_is_what_the_readme_says() -> None:
    found = mechanics.check(elastic_pendulum.scene(), block("file: mine.tex"), notation="latex")
    printed = str(found).splitlines()
    assert set(block("output: check").splitlines()) <= set(printed)
