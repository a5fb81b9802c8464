"""`mechanics systems` and `mechanics crosscheck`."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape
from rich.table import Column, Table

from mechanics.cli.files import JsonOption, refuse_unwritable, write, write_file
from mechanics.cli.findings import counted, explain
from mechanics.cli.lines import fitted
from mechanics.cli.load import load
from mechanics.crosscheck import CrossCheck
from mechanics.crosscheck import crosscheck as check
from mechanics.crosscheck.by_sympy import METHODS
from mechanics.crosscheck.routes import named_routes
from mechanics.crosscheck.system import DEFAULT_STATES
from mechanics.equations import Side
from mechanics.extremes.result import STABLE
from mechanics.kernel import Verdict
from mechanics.report.html import to_html
from mechanics.report.json_report import to_json
from mechanics.report.result import SystemResult
from mechanics.scene.system import System

LONGEST_EQUATION = 240
"""Characters up to which an equation is printed: three lines of a terminal."""


def systems() -> None:
    """List the systems that come with the program.

    `mechanics systems`

    `mechanics systems | grep pendulum`
    """
    from systems import GROUPS

    name = Column("system", no_wrap=True)
    table = Table(name, "scene", "coordinates", "published rows", box=None, pad_edge=False)
    for title, group in GROUPS:
        table.add_row(f"[dim]{title}[/dim]")
        for system in group:
            scene = system.scene()
            names = ", ".join(q.name for q in scene.q)
            table.add_row(f"  {system.name}", scene.name, names, str(len(system.published)))
    Console().print(table)


def crosscheck(
    names: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[SYSTEM]...",
            help="Names, `pendulum_chain(10)`, or .py files with a function scene();"
            " elastic_pendulum, rocker and two_mass_chain when none is given.",
            show_default=False,
        ),
    ] = None,
    report: Annotated[
        Path | None, typer.Option(metavar="FILE.html", help="Write a report for a browser.")
    ] = None,
    json_file: JsonOption = None,
    routes: Annotated[
        str, typer.Option(help="Routes to use, separated by commas; all when not given.")
    ] = "",
    states: Annotated[
        int, typer.Option(min=0, help="Random states for the residuals of compiled functions.")
    ] = DEFAULT_STATES,
    coq: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR", help="Write theorems for Coq, and have coqc check them, where it is."
        ),
    ] = None,
    verbose: Annotated[
        bool, typer.Option("--verbose", "-v", help="Print what each route took, too.")
    ] = False,
) -> None:
    """Derive systems by four routes and prove that they agree with each other and their source.

    `mechanics crosscheck`

    `mechanics crosscheck rocker --report rocker.html`

    `mechanics crosscheck 'pendulum_chain(10)' my_system.py --json -`

    `mechanics crosscheck elastic_pendulum --coq theorems`

    Exit code: 0 when all is PROVED or CERTIFIED, 1 when something is REFUTED, 3 when something is
    UNDECIDED or only SUPPORTED, 2 for bad input. Checks that are done with numbers alone can be no
    more than SUPPORTED; for them SUPPORTED is enough.
    """
    chosen = tuple(name.strip() for name in routes.split(",") if name.strip())
    named_routes(chosen)
    refuse_unwritable(report, json_file)
    loaded = [load(name) for name in names] if names else _seed()
    errors = Console(stderr=True)
    results = []
    with errors.status("") as status:
        for system in loaded:
            options = CrossCheck(chosen, states, report is not None, status.update)
            results.append(check(system, options))
        if report is not None:
            status.update(f"writing {report.name}")
            write_file(to_html(results), report)
    if json_file is not None:
        write(json.dumps(to_json(results), indent=2, ensure_ascii=False), json_file)
    if json_file != "-":
        _summary(Console(), results, verbose)
    accepted = coq is None or all([_theorems(system, coq) for system in loaded])
    if json_file != "-":
        closing = closing_line(results, report)
        Console().print(f"[bold]{escape(closing)}[/]", soft_wrap=True)
    raise typer.Exit(exit_code(results) or (0 if accepted else 3))


def _theorems(system: System, folder: Path) -> bool:
    """Write theorems about a system; whether coqc accepts them, or is not there."""
    from mechanics.coq import checked, write_coq

    console = Console()
    target = folder / "".join(c if c.isalnum() else "_" for c in system.name)
    with Console(stderr=True).status(f"{system.name}: writing theorems"):
        written = write_coq(system, target)
    for entry in written:
        if entry.path is None:
            console.print(escape(f"left out: {entry.name}: {entry.reason}"))
    files = [entry for entry in written if entry.path is not None]
    with Console(stderr=True).status(f"{system.name}: coqc"):
        found = checked(files)
    if found is None:
        console.print(
            escape(f"{len(files)} theorems in {target}: coqc, which checks them, is not here")
        )
        return True
    refused = [entry for entry in found if entry.reason]
    words = f"{len(files)} theorems in {target}: coqc accepts {len(files) - len(refused)}"
    console.print(escape(words))
    for entry in refused:
        console.print(escape(f"refused: {entry.name}: {entry.reason}"))
    return not refused


def exit_code(results: Sequence[SystemResult]) -> int:
    """0: all shown; 1: something refuted; 3: something in doubt."""
    verdicts = {finding.verdict for result in results for finding in result.open}
    if Verdict.REFUTED in verdicts:
        return 1
    return 0 if all(result.ok for result in results) else 3


def closing_line(results: Sequence[SystemResult], report: Path | None = None) -> str:
    """The verdict on everything, and where the report is."""
    count = sum(len(result.claims) for result in results)
    failed = sum(len(result.open) for result in results)
    if not count:
        words = "Nothing was checked."
    elif failed:
        words = f"{failed} of {count} checks did not pass."
    else:
        words = f"All {count} checks passed."
    return words if report is None else f"{words} The report is {report}."


def _seed() -> list:
    from systems import SEED

    return list(SEED)


def _summary(console: Console, results: Sequence[SystemResult], verbose: bool) -> None:
    for result in results:
        console.print(f"\n[bold]{escape(result.name)}[/]  {escape(result.scene.name)}")
        for equation in equations_of(result):
            console.print(escape(fitted(equation, console.width)), soft_wrap=True)
        if verbose:
            _timings(console, result)
        for title, findings in result.groups.items():
            if findings:
                apart = ", not counted below" if findings is result.witnesses else ""
                console.print(f"{title}: {counted(findings)}{apart}")
        if result.compiled:
            worst = max(result.compiled, key=lambda entry: entry.max_eps)
            rounding = worst.max_eps < STABLE
            console.print(
                f"compiled residuals: at most {worst.max_eps:.2f} epsilon of the sum of the terms"
                f" at {worst.states} states ({escape(worst.subject)}): "
                f"{'a few roundings' if rounding else 'mechanics extremes shows where and why'}"
            )
        for remark in result.remarks:
            console.print(escape(remark), style="dim")
        for finding in (*result.open, *(cause for cause in result.causes if cause.shown)):
            explain(console, finding)


def equations_of(result: SystemResult) -> list[str]:
    """What every route arrives at, where that is short enough for a terminal."""
    lines = [f"  {_sum(line.left)} = {_sum(line.right)}" for line in result.form]
    if max(map(len, lines), default=0) > LONGEST_EQUATION:
        return [f"  mechanics derive {result.name} --route kane prints its equations"]
    return lines


def _sum(side: Side) -> str:
    if not isinstance(side, tuple):
        return str(side)
    return " + ".join(str(term.value) for term in side).replace("+ -", "- ")


def _timings(console: Console, result: SystemResult) -> None:
    table = Table("route", "seconds", "operations", box=None, pad_edge=False)
    for name, column in result.columns.items():
        words = (f"{column.seconds:.3f}", str(column.operations))
        table.add_row(column_name(name), *(("-", column.absent) if column.absent else words))
    console.print(table)


def column_name(name: str) -> str:
    """A route for people, with what derived it where two did: ``kane (SymPy)``."""
    route = name.removesuffix("_sympy")
    if route not in METHODS:
        return name
    return f"{route} ({'SymPy' if name != route else 'program'})"
