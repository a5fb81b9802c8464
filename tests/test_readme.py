"""The README and the pages of docs stay true: examples run and print what is said, files exist."""

import contextlib
import io
import re
from pathlib import Path
from typing import Any

import pytest

import mechanics
from mechanics.cli.app import COMMANDS, command
from systems import elastic_pendulum

ROOT = Path(__file__).parents[1]
PAGES = {
    path: path.read_text(encoding="utf-8")
    for path in (ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md")))
}
README = PAGES[ROOT / "README.md"]
CALLED = re.compile(r"(?:`|^|&& )(?:\.venv/bin/)?mechanics ([a-z-]+)((?: [^`\n]*)?)", re.MULTILINE)
"""A command and its arguments, in a line of a block or between backquotes."""


def block(marker: str) -> str:
    """The fenced block under a marker comment, of one page."""
    pattern = re.compile(rf"<!-- {marker} -->\n```\w*\n(.*?)```", re.DOTALL)
    found = [match for page in PAGES.values() for match in pattern.finditer(page)]
    assert len(found) == 1, f"{len(found)} blocks are marked {marker}"
    return found[0][1]


@pytest.mark.parametrize(
    "name",
    [
        "python",
        "space",
        "acados",
        *(
            pytest.param(name, marks=pytest.mark.campaign)
            for name in ("models", "mpc", "lqr", "half car", "arm")
        ),
    ],
)
def test_an_example_prints_what_the_readme_says(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
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


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.stem)
def test_files_that_a_page_links_exist(path: Path) -> None:
    links = re.findall(r"\]\(([^)#]+)\)", PAGES[path])
    missing = [link for link in links if "://" not in link and not (path.parent / link).exists()]
    assert not missing


def test_the_readme_is_read_in_one_sitting_and_lists_every_page() -> None:
    assert README.count("\n") <= 250
    listed = re.findall(r"\]\((docs/[^)]+)\)", README)
    assert {ROOT / link for link in listed} == {path for path in PAGES if path.name != "README.md"}


def test_commands_and_options_that_pages_name_are_known() -> None:
    named = {
        (name, option)
        for page in PAGES.values()
        for name, rest in CALLED.findall(page)
        for option in ("", *re.findall(r"--[a-z][a-z-]*", rest))
    }
    assert len(named) > 40
    options = {
        name: {o for p in command(name).params for o in (*p.opts, *p.secondary_opts)}
        | {"", "--help"}
        for name in COMMANDS
    }
    unknown = {(name, option) for name, option in named if option not in options.get(name, ())}
    assert not unknown


def test_the_answer_to_wrong_equations_is_what_the_readme_says() -> None:
    found = mechanics.check(elastic_pendulum.scene(), block("file: mine.tex"), notation="latex")
    printed = str(found).splitlines()
    assert set(block("output: check").splitlines()) <= set(printed)
