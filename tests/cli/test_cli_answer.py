"""`mechanics check`: the page, silence, colour, pipes and errors in one line."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from rich.cells import cell_len

SEVEN = "M*L/2*x''*cos(theta) + M*L**2/3*theta'' + M*g*L/2*sin(theta) = 0"
COMMAND = [sys.executable, "-c", "from mechanics.cli import main; main()", "check"]


@pytest.fixture
def right(tmp_path: Path) -> Path:
    path = tmp_path / "right.txt"
    path.write_text(SEVEN, encoding="utf-8")
    return path


@pytest.fixture
def wrong(tmp_path: Path) -> Path:
    path = tmp_path / "wrong.txt"
    path.write_text(f"{SEVEN}\n{SEVEN.replace('sin', 'cos')}\n", encoding="utf-8")
    return path


def test_a_page_is_written(run, wrong: Path, tmp_path: Path) -> None:
    page = tmp_path / "answer.html"
    ran = run("check", "elastic_pendulum", wrong, "--report", page)
    assert ran.code == 1
    text = page.read_text(encoding="utf-8")
    assert text.startswith("<!DOCTYPE html>")
    assert "What follows from the scene" in text
    assert ran.out.splitlines()[-1] == "1 PROVED, 1 REFUTED"


@pytest.mark.parametrize(("name", "code"), [("right", 0), ("wrong", 1)])
def test_quiet_prints_nothing_and_the_exit_code_tells(
    run, request: pytest.FixtureRequest, name: str, code: int, tmp_path: Path
) -> None:
    data = tmp_path / "answer.json"
    path = request.getfixturevalue(name)
    ran = run("check", "elastic_pendulum", path, "--quiet", "--json", data)
    assert (ran.code, ran.out, ran.err) == (code, "", "")
    assert json.loads(data.read_text(encoding="utf-8"))["ok"] is (code == 0)


def test_a_short_right_statement_is_one_line(
    run, right: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(right.parent)
    right.write_text("x'' = x''*(M + m)/(M + m)  % (1)", encoding="utf-8")
    ran = run("check", "elastic_pendulum", right.name)
    assert ran.out.splitlines()[0] == "UNDECIDED  (1)  right.txt, line 1  x'' = x''*(M + m)/(M + m)"
    right.write_text(SEVEN, encoding="utf-8")
    ran = run("check", "elastic_pendulum", right.name)
    assert ran.code == 0
    assert ran.out.splitlines() == ["PROVED  1  right.txt, line 1", f"    {SEVEN}"]


@pytest.mark.campaign
@pytest.mark.sample(1)
@pytest.mark.parametrize(
    ("environment", "coloured"),
    [({}, False), ({"FORCE_COLOR": "1"}, True), ({"FORCE_COLOR": "1", "NO_COLOR": "1"}, False)],
    ids=["pipe", "forced", "no colour"],
)
def test_colour_goes_to_terminals_only(
    wrong: Path, environment: dict[str, str], coloured: bool
) -> None:
    kept = {k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "FORCE_COLOR", "COLUMNS")}
    done = subprocess.run(
        [*COMMAND, "elastic_pendulum", str(wrong)],
        capture_output=True, text=True, timeout=120, check=False,
        env={**kept, **environment, "TERM": "xterm-256color"},
    )  # fmt: skip
    assert done.returncode == 1
    # Bold and dim are no colours; 31 is red.
    assert ("\x1b[1;31m" in done.stdout or "\x1b[31m" in done.stdout) is coloured
    if not environment:
        assert done.stderr == ""
        assert "\x1b" not in done.stdout
        assert max(map(cell_len, done.stdout.splitlines())) <= 80


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("--report", "no_such_folder/a.html"), "there is no folder no_such_folder"),
        (("--report", "."), "it is a folder: name a file in it"),
        (("--json", "no_such_folder/a.json"), "there is no folder no_such_folder"),
        (("--convention", "x"), "the conventions are other vertical"),
        (("--no-such-option",), "No such option"),
    ],
)
def test_errors_are_one_line(run, right: Path, options: tuple[str, ...], words: str) -> None:
    ran = run("check", "elastic_pendulum", right, *options)
    assert ran.code == 2
    assert ran.out == ""
    assert words in ran.err
    assert len(ran.err.strip().splitlines()) == 1
    assert ran.err.startswith("error: ")


def test_help_names_the_exit_codes(run) -> None:
    ran = run("check", "--help")
    assert ran.code == 0
    words = " ".join(ran.out.replace("│", " ").split())
    for part in ("0 when all is PROVED", "1 when something is REFUTED", "3 when something is in",
                 "2 for bad input", "--report", "--json", "--quiet"):  # fmt: skip
        assert part in words, part
