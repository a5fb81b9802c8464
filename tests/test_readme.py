"""The README and the pages of docs stay true: examples run and print what is said, files exist."""

import contextlib
import importlib
import io
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import mechanics
from mechanics.cli.app import COMMANDS, command
from systems import elastic_pendulum

ROOT = Path(__file__).parents[1]
PAGES = {
    path: path.read_text(encoding="utf-8")
    for path in (ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md")))
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
    links = [link for link in re.findall(r"\]\(([^)\s]+)\)", PAGES[path]) if "://" not in link]
    assert [link for link in links if not leads_somewhere(path, link)] == []


def leads_somewhere(path: Path, link: str) -> bool:
    """Whether a page has what a link in it names: a file, and a heading of it."""
    name, _, anchor = link.partition("#")
    file = Path(os.path.normpath(path.parent / name)) if name else path
    return file.exists() and (not anchor or anchor in headings(PAGES[file]))


def headings(page: str) -> set[str]:
    """Anchors of a page, as GitHub and Sphinx make them."""
    titles = re.findall(r"^#+ (.*)$", re.sub(r"^```.*?^```", "", page, flags=re.M | re.S), re.M)
    return {re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-") for title in titles}


def test_a_link_that_leads_nowhere_is_seen() -> None:
    page = ROOT / "docs" / "tutorials" / "chip.md"
    assert leads_somewhere(page, "../systems.md#joints")
    assert not leads_somewhere(page, "../systems.md#hinges")
    assert not leads_somewhere(page, "systems.md")


def test_the_readme_is_read_in_one_sitting() -> None:
    assert README.count("\n") <= 120


PARTS = re.compile(r"<!-- (file|session|example|output): ([^>]+) -->\n```\w*\n(.*?)```", re.DOTALL)


@pytest.mark.campaign
@pytest.mark.parametrize(
    "path", [path for path in PAGES if "session: " in PAGES[path]], ids=lambda path: path.stem
)
def test_a_tutorial_does_what_it_says(
    path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Files are written, commands and examples run, in the order of the page."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setenv("PATH", str(Path(sys.executable).parent), prepend=os.pathsep)
    monkeypatch.setenv("COLUMNS", "80")
    for needed in NEEDED.get(path.stem, ()):
        Path(needed).write_text(block(f"file: {needed}"), encoding="utf-8")
    printed = ""
    for kind, name, text in PARTS.findall(PAGES[path]):
        if kind == "file":
            Path(name).write_text(text, encoding="utf-8")
        elif kind == "session":
            for command_line, wanted in re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", text, re.M):
                told = subprocess.run(command_line, shell=True, capture_output=True, text=True)
                assert same(wanted, told.stdout), told.stdout + told.stderr
        elif kind == "example":
            with contextlib.redirect_stdout(io.StringIO()) as stream:
                exec(compile(text, path.name, "exec"), {"__name__": "example"})
            printed = stream.getvalue()
        else:
            assert printed == text


NEEDED = {"integrator": ("pendulum.py",)}
"""Files of other tutorials that one begins with."""


def same(wanted: str, found: str) -> bool:
    """Whether a text is as wanted; a line ``...`` stands for any lines, ... in one for words."""
    lines = [line.rstrip() for line in wanted.splitlines()]
    pattern = "".join(
        r"(?:.*\n)*" if line == "..." else re.escape(line).replace(r"\.\.\.", ".*") + r"[ ]*\n"
        for line in lines
    )
    return (
        re.fullmatch(pattern, found if found.endswith("\n") else found + "\n" * bool(found))
        is not None
    )


def test_the_text_of_a_session_may_leave_lines_out() -> None:
    assert same("a\n...\nc\n", "a\nb\nb\nc\n")
    assert same("took ... s\n", "took 3 s\n")
    assert not same("a\nc\n", "a\nb\nc\n")
    assert not same("a.c\n", "abc\n")


@pytest.mark.campaign
def test_equations_on_the_page_of_the_four_routes_are_right() -> None:
    """The numbered equations (6) and (7), as they stand there."""
    page = PAGES[ROOT / "docs" / "explanation" / "routes.md"]
    numbered = re.findall(r"\$\$ (.*?\\tag\{[67]\}) \$\$", page)
    found = mechanics.check(elastic_pendulum.scene(), "\n".join(numbered), notation="latex")
    assert len(numbered) == 2
    assert found.ok


def test_every_public_name_is_in_the_reference() -> None:
    pages = "".join(text for path, text in PAGES.items() if path.parent.name == "reference")
    objects = {getattr(mechanics, name) for name in mechanics.__all__ if name != "ROUTES"}
    directives = re.findall(r"\.\. auto\w+:: (\S+)\.(\w+)", pages)
    documented = {getattr(importlib.import_module(module), name) for module, name in directives}
    assert objects <= documented
    assert "`mechanics.ROUTES`" in pages


def test_commands_and_options_that_pages_name_are_known() -> None:
    named = {
        (name, option)
        for page in PAGES.values()
        for name, rest in CALLED.findall(page)
        for option in ("", *re.findall(r"--[a-z][a-z-]*", rest))
    }
    assert len(named) > 20
    options = {
        name: {o for p in command(name).params for o in (*p.opts, *p.secondary_opts)}
        | {"", "--help"}
        for group in COMMANDS.values()
        for name in group
    }
    unknown = {(name, option) for name, option in named if option not in options.get(name, ())}
    assert not unknown


def test_the_answer_to_wrong_equations_is_what_the_readme_says() -> None:
    found = mechanics.check(elastic_pendulum.scene(), block("file: mine.tex"), notation="latex")
    printed = str(found).splitlines()
    assert set(block("output: check").splitlines()) <= set(printed)
