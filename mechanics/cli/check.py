"""`mechanics check`."""

import inspect
import json
import re
import sys
from contextlib import redirect_stdout
from pathlib import Path
from typing import Annotated, Any

import typer
from rich.console import Console

from mechanics.claims.code.black_box import INTEGRATORS, BlackBox
from mechanics.claims.read import file_text
from mechanics.cli.files import JsonOption, refuse_unwritable, write, write_file
from mechanics.cli.load import SystemArgument, load, run_file
from mechanics.cli.values import JudgedAtOption, names_of, points
from mechanics.errors import InputError
from mechanics.grading.other_functions import unjudged_functions
from mechanics.judge.check import check as run
from mechanics.judge.check_json import to_json
from mechanics.judge.sources import Around, Beside, on_the_file
from mechanics.kernel import Verdict
from mechanics.report.answer.check import Check
from mechanics.report.answer.page import check_html

NOT_A_NAME = re.compile(r"[^A-Za-z0-9]+")


def check(
    system: SystemArgument,
    files: Annotated[
        list[str],
        typer.Argument(metavar="FILE...", help="LaTeX, text, C, file.py:function, or -."),
    ],
    name: Annotated[
        list[str] | None,
        typer.Option(
            "--name", metavar="MINE=SCENE'S", help="The scene's name for a name of yours."
        ),
    ] = None,
    notation: Annotated[
        str | None, typer.Option(metavar="latex|text", help="Detected when not given.")
    ] = None,
    about: Annotated[
        str | None,
        typer.Option(help="What every statement is: 'kinetic energy', 'mass matrix', ..."),
    ] = None,
    convention: Annotated[
        list[str] | None,
        typer.Option(
            help="How you count, where the scene counts otherwise: 'upward vertical clockwise',"
            " 'relative angles', 'half-length of L', ...; an unknown one lists all."
        ),
    ] = None,
    function: Annotated[
        str | None,
        typer.Option(
            metavar="NAME",
            help="Function of C, C++, MATLAB or Julia; where not given, one that no other calls.",
        ),
    ] = None,
    black_box: Annotated[
        bool, typer.Option("--black-box", help="Call Python functions, do not read them: no proof.")
    ] = False,
    value: JudgedAtOption = None,
    where: Annotated[
        list[str] | None,
        typer.Option(metavar="'cos(q) > 0'", help="Judge only where this inequality holds."),
    ] = None,
    only: Annotated[
        list[str] | None,
        typer.Option(
            metavar="WHAT",
            help="Judge only this: '(6)', 'line 12', 'lines 5-8', theta_ddot on the left; formulas"
            " sets sentences aside.",
        ),
    ] = None,
    step: Annotated[float, typer.Option(min=0, help="Time step of a black box, in s.")] = 0.0,
    integrator: Annotated[
        str | None,
        typer.Option(help="Its integrator: euler (where not given), 'semi-implicit euler' or rk4."),
    ] = None,
    blame: Annotated[
        bool,
        typer.Option("--blame/--no-blame", help="Look for the wrong term."),
    ] = True,
    report: Annotated[
        Path | None,
        typer.Option(metavar="FILE.html", help="Write the answer as a page for a browser."),
    ] = None,
    json_file: JsonOption = None,
    quiet: Annotated[
        bool, typer.Option("--quiet", "-q", help="Print nothing; the exit code is the answer.")
    ] = False,
) -> None:
    """Check your own equations of motion, energies, reactions or mass matrix.

    `mechanics check elastic_pendulum equations.tex --report answer.html`

    `mechanics check rocker mine.txt --name phi=theta --json -`

    `mechanics check elastic_pendulum simulator.py:rate --name 'state=x theta x_dot theta_dot'`

    `mechanics check acrobot control.c --function accelerations`

    `mechanics check rod_pendulum chapter.tex --only '(6)' --only 'lines 40-44'`

    `mechanics check rod_pendulum sim.py:step --black-box --value m=1 --step 0.01 --value l=2`

    Each equation gets a verdict; a wrong one the smallest change that makes it right, the
    differences term by term, and a state at which its sides differ. Names are matched to those of
    the scene; what was guessed is printed. Rows may be scaled, combined and swapped. LaTeX, text
    and C are read, never run; `file.py:function` runs that file, so give your own. Exit code: 0
    when all is PROVED or CERTIFIED, 1 when something is REFUTED, 3 when something is in doubt,
    2 for bad input.
    """
    refuse_unwritable(report, json_file)
    scene = load(system).scene()
    parts = [part for file in files for part in _parts(file)]
    values = points(value or [], "--value", " or 2*pi")
    if black_box:
        inside = {n: float(v) for n, v in values.items()}
        parts = [p for p in parts if not isinstance(p, Beside | Around)]
        if not any(map(callable, parts)):
            raise InputError(
                "--black-box calls functions of Python, and there is none: write file.py:function"
            )
        advance = integrator or INTEGRATORS[0]
        parts = [BlackBox(p, inside, step, advance) if callable(p) else p for p in parts]
        values = {}
    elif step or integrator:
        option = "--step" if step else "--integrator"
        raise InputError(f"{option} belongs to a black box: add --black-box, or leave it out")
    status = Console(stderr=True).status(f"checking against {scene.name}")
    with status, redirect_stdout(sys.stderr):  # functions are traced, and may print
        found = run(
            scene, parts, names=names_of(name or []), notation=notation, about=about,
            convention=convention or (), function=function, values=values, where=where or (),
            only=only or (), blame=blame,
        )  # fmt: skip
    _refuse_absent(names_of(name or []), parts, [*(where or []), *(convention or [])], found)
    if report is not None:
        write_file(check_html(found), report)
    if json_file is not None:
        write(json.dumps(to_json(found), indent=2, ensure_ascii=False), json_file)
    if json_file != "-" and not quiet:
        Console(highlight=False, emoji=False).print(found)
    if found.verdict is Verdict.REFUTED:
        raise typer.Exit(1)
    raise typer.Exit(0 if found.ok else 3)


def _parts(file: str) -> list[Any]:
    """A text, the path of a file, or a function of a person's own Python file, which is run."""
    if file == "-":
        return [sys.stdin.read()]
    path, colon, name = file.rpartition(":")
    if not (colon and path.endswith(".py")):
        if file.endswith(".py"):
            raise InputError(f"file {file}: name the function to check: {file}:function")
        return [Path(file)]
    function = _named(run_file(Path(path)), name, path)
    code, own = file_text(Path(path)), frozenset((name.rpartition(".")[2],))
    around = Around(code, own, tuple(unjudged_functions(code, own)))
    return [function, *on_the_file(code), around]


def _named(module: Any, name: str, path: str) -> Any:
    """A function of a file, or a method of an object or class in it: ``Cart.rates``."""
    found = module
    for part in name.split("."):
        above, found = found, getattr(found, part, None)
        if found is None:
            raise InputError(f"file {path}: it has no {name}")
    if isinstance(above, type) and inspect.isfunction(found):
        raise InputError(
            f"file {path}: {name} is a method: name one of an object, for example by a line"
            f" rates = {above.__name__}().{found.__name__} at its end"
        )
    return found


def _refuse_absent(names: dict[str, str], parts: list[Any], more: list[str], found: Check) -> None:
    """Refuse a name that is given a meaning and stands in none of the texts.

    Letters and digits are compared, so that braces of LaTeX do not matter. What is no text in ASCII
    may spell a name otherwise, and is not looked into; nor is what stands for a quantity. Functions
    may take names from other files.
    """
    texts = [text for part in parts if (text := _text(part))]
    if not all(text.isascii() for text in texts):
        return
    plain = NOT_A_NAME.sub("", " ".join([*texts, *more]))
    used = {match.name for match in found.names}
    for mine, theirs in names.items():
        unread = " " not in theirs and mine.isascii() and NOT_A_NAME.sub("", mine) not in plain
        if unread and mine not in used:
            known = ", ".join(match.name for match in found.names)
            raise InputError(f"--name {mine}={theirs}: no text has {mine!r}: it has {known}")


def _text(part: Any) -> str:
    if isinstance(part, Path):
        return file_text(part)
    if isinstance(part, Around):
        return part.code
    return part if isinstance(part, str) else ""
