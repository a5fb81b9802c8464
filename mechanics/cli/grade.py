"""`mechanics grade`."""

import json
import os
import re
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.progress import Progress
from rich.table import Table

from mechanics.cli.files import JsonOption, refuse_unwritable, write, write_file
from mechanics.cli.load import load
from mechanics.cli.values import JudgedAtOption, assignments, names_of
from mechanics.errors import InputError
from mechanics.grading.grade import REQUIRE, RIGHT, UNJUDGED
from mechanics.grading.group import Group, grade_files
from mechanics.grading.page import group_csv, group_html
from mechanics.report.answer.sentences import quoted
from mechanics.worker import Limits


def grade(
    key: Annotated[str, typer.Argument(metavar="KEY", help="A name or a .py file of the scene.")],
    files: Annotated[
        list[Path],
        typer.Argument(metavar="FILE...", help="LaTeX, text, C, notebooks, Python; or folders."),
    ],
    require: Annotated[
        str, typer.Option(help=f"{'; '.join(f'{word}: {what}' for word, what in REQUIRE.items())}.")
    ] = "all",
    name: Annotated[
        list[str] | None,
        typer.Option(
            "--name", metavar="MINE=SCENE'S", help="The scene's name for a name of theirs."
        ),
    ] = None,
    function: Annotated[
        str | None, typer.Option(metavar="NAME", help="Function of code; by default the last one.")
    ] = None,
    value: JudgedAtOption = None,
    run_python: Annotated[
        bool, typer.Option("--run-python", help="Run code in Python. Limits are no sandbox.")
    ] = False,
    seconds: Annotated[float, typer.Option(min=0.1, help="Processor time for each.")] = 5.0,
    megabytes: Annotated[int, typer.Option(min=50, help="Memory for each.")] = 500,
    jobs: Annotated[int, typer.Option(min=1, help="Submissions at a time.")] = os.cpu_count() or 1,
    csv: Annotated[
        str | None, typer.Option(metavar="FILE|-", help="Write a table; - for the screen.")
    ] = None,
    json_file: JsonOption = None,
    report: Annotated[
        Path | None,
        typer.Option(metavar="FOLDER", help="Write index.html, and a page for each submission."),
    ] = None,
) -> None:
    """Grade many submissions against one key, each in a process of its own within limits.

    `mechanics grade elastic_pendulum submissions/*.tex --csv grades.csv --report grades`

    `mechanics grade rod_pendulum submissions --require motion --json -`

    Each submission gets a score by statements, the smallest change that makes it right, a hint that
    does not give the answer away, what is missing, and how it was read. One that takes too much
    time or memory gets no verdict. Exit code: 0 when all are right, 1 when one is wrong or
    incomplete, 3 when one is in doubt or has no verdict, 2 for bad input.
    """
    refuse_unwritable(csv, json_file)
    if report is not None and report.exists() and not report.is_dir():
        raise InputError(f"folder {report}: it is a file: name a folder")
    scene, paths = load(key).scene(), _files(files)
    options = {"names": names_of(name or []), "values": assignments(value or [], "--value")}
    with Progress(console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task(f"grading against {scene.name}", total=len(paths))
        found = grade_files(
            scene, paths, require=require, pages=report is not None, function=function,
            run_python=run_python, jobs=jobs, limits=Limits(seconds, megabytes), options=options,
            done=lambda: progress.advance(task),
        )  # fmt: skip
    _write(found, csv, json_file, report)
    if "-" not in (csv, json_file):
        Console(highlight=False, emoji=False).print(_table(found))
    raise typer.Exit(_exit_code(found))


def _files(given: list[Path]) -> list[Path]:
    """Files, and those in folders, in order."""
    found: list[Path] = []
    for path in given:
        if path.is_dir():
            found += sorted(p for p in path.iterdir() if p.is_file() and p.name[0] != ".")
        elif path.is_file():
            found.append(path)
        else:
            raise InputError(f"file {path}: it is not there: name a file or folder")
    return found


def _write(found: Group, csv: str | None, json_file: str | None, report: Path | None) -> None:
    if csv is not None:
        write(group_csv(found).rstrip("\n"), csv)
    if json_file is not None:
        grades = [one.to_json() for one in found.grades]
        plain = {"scene": found.scene.name, "grades": grades, "mistakes": dict(found.mistakes)}
        write(json.dumps(plain, indent=2, ensure_ascii=False), json_file)
    if report is not None:
        report.mkdir(parents=True, exist_ok=True)
        links = [f"{k:03}-{_plain(one.name)}.html" for k, one in enumerate(found.grades, start=1)]
        for link, one in zip(links, found.grades, strict=True):
            if one.page:
                write_file(one.page, report / link)
        write_file(group_html(found, links), report / "index.html")


def _plain(name: str) -> str:
    return re.sub(r"[^A-Za-z0-9._-]+", "_", name)


def _table(found: Group) -> Table:
    table = Table("submission", "score", "verdict", "hint", box=None, pad_edge=False)
    for one in found.grades:
        score = "" if one.score is None else f"{100 * one.score:.0f} %"
        words = one.hint or "; ".join(one.remarks if one.score is None else ())
        table.add_row(one.name, score, one.verdict, words)
        for line in quoted(one.unjudged):
            table.add_row("", "", "", line)
    return table


def _exit_code(found: Group) -> int:
    verdicts = {one.verdict for one in found.grades}
    if verdicts <= {RIGHT}:
        return 0
    return 3 if verdicts <= {RIGHT, "in doubt", UNJUDGED} else 1
