"""`mechanics verify`: generated code once more, from its files alone.

Nothing that the folder names is run: its manifest may name a system that comes with the program, a
file is run where the person names it.
"""

import json
import sys
from collections import Counter
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape

from mechanics.cli.excerpt import excerpt_of_c
from mechanics.cli.files import JsonOption, write
from mechanics.cli.findings import STYLES, counted, explain
from mechanics.cli.load import CALL, built_in, load
from mechanics.compiled.reduced import FILE
from mechanics.crosscheck import derive
from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.export.evidence.read import Folder, read_folder
from mechanics.export.evidence.record import chain_record
from mechanics.export.evidence.verify import NO_PHYSICS, Again, Outcome, Verification
from mechanics.export.evidence.verify import verify as check
from mechanics.kernel import Verdict, same
from mechanics.reduce.model import reduced_graphs
from mechanics.reduce.record import record_text, repeat

ASKED = "give --scene FILE"
SHOWN_FINDINGS = 12
"""Findings that are explained; of more there is only the number."""


def verify(
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="Written by mechanics codegen.")],
    scene: Annotated[
        str | None,
        typer.Option(
            metavar="SYSTEM",
            help="FILE.py, FILE.py:function or a name; by default the built-in system of that"
            " name in the manifest.",
        ),
    ] = None,
    measure: Annotated[
        bool, typer.Option("--compile/--no-compile", help="Compile it and compare values, too.")
    ] = True,
    json_file: JsonOption = None,
) -> None:
    """Prove the C in a folder again, from the physics to the machine code.

    `mechanics verify elastic_pendulum_c`

    `mechanics verify my_system_c --scene my_system.py`

    The equations are derived again. In exact arithmetic they, the stored programs and the text of
    the C have to be the same functions. The error of the inline sine and cosine is bounded, and
    what every compiler on this machine makes of the C is compared with correctly rounded values.
    The name of a built-in system is in the manifest; for another one give `--scene FILE`. Nothing
    in the folder is run.

    A changed file is named; C that was only formatted passes. Files beyond the manifest are named.

    Exit code: 0 when all is shown; 1 when something is REFUTED; 3 when something is UNDECIDED, the
    scene is not known, a file is missing, an unchecked one was changed, or a build may read one
    that the manifest does not list; 2 for bad input, such as a file that cannot be read.
    """
    errors = Console(stderr=True)
    with errors.status("reading") as status:
        read = read_folder(folder)
        equations, remark = _derived(read, scene)
        again = None if equations is None else _reduced(read, equations)
        found = check(read, equations, measure, lambda words: status.update(escape(words)), again)
    console = Console(soft_wrap=not sys.stdout.isatty())
    if json_file is not None:
        _write(found, json_file)
    if json_file != "-":
        _print(console, found, remark)
    if found.outcome is not Outcome.SHOWN:
        raise typer.Exit(found.outcome.value)


def _derived(folder: Folder, scene: str | None) -> tuple[Equations | None, str]:
    """The equations derived again, or why they are not."""
    if scene is not None:
        return derive(load(scene).scene(), folder.route), ""
    name = folder.system
    if name is None:
        return None, f"the manifest names no system that comes with the program: {ASKED}"
    try:
        system = built_in(name)
    except InputError:
        return None, f"the manifest's {name[:40]!r} is none that comes with the program: {ASKED}"
    size = CALL.fullmatch(name)
    if size and int(size[2] or size[3]) > len(folder.evidence.known.symbols["q"]):
        # A scene of any size would take its time before it turns out to be another one.
        return None, f"the manifest's {name[:40]!r} has more coordinates than the folder"
    try:
        return derive(system.scene(), folder.route), ""
    except InputError as error:
        return None, f"the manifest's {error}"


def _reduced(folder: Folder, equations: Equations) -> Again | None:
    """A reduced model, reduced again as its record says; None for any other."""
    if FILE not in folder.texts:
        return None
    text = folder.texts[FILE]
    found = repeat(text, equations)
    words = "repeating the reduction gives the same record"
    told = same(FILE, text, record_text(found), words)
    return Again(reduced_graphs(found), (found.finding, told))


def _write(found: Verification, file: str) -> None:
    record = {
        "outcome": found.outcome.name,
        "changed": list(found.folder.changed),
        "missing": list(found.folder.missing),
        "beyond_manifest": list(found.folder.beyond),
        **chain_record(found.chain),
    }
    write(json.dumps(record, indent=2, ensure_ascii=False), file)


def _print(console: Console, found: Verification, remark: str) -> None:
    folder = found.folder
    console.print(f"[bold]{escape(str(folder.path))}[/]  {escape(str(folder.manifest['scene']))}")
    for title, findings in found.chain.steps:
        console.print(f"  {escape(title)}: {counted(findings)}")
    worst = max(found.chain.measured, key=lambda one: one.ulp_terms, default=None)
    if worst is not None:
        states = sum(one.states for one in found.chain.measured)
        console.print(
            f"  largest error {worst.ulp_terms:.3g} ulp of the sum of the terms,"
            f" {worst.symbol}, {worst.compiler}; {states} comparisons of states",
            markup=False,
        )
    _tell_files(console, found)
    for sentence in found.chain.not_done:
        console.print(f"[yellow]not checked here[/]: {escape(sentence)}")
    if remark:
        console.print(f"[yellow]UNDECIDED[/] physics: {NO_PHYSICS}: {escape(remark)}")
    bad = [
        finding
        for _, findings in found.chain.steps
        for finding in findings
        if finding.verdict in (Verdict.REFUTED, Verdict.UNDECIDED)
    ]
    before = ""
    for finding in bad[:SHOWN_FINDINGS]:
        explain(console, finding)
        place = excerpt_of_c(f"{finding.subject}: {finding.evidence}", folder.texts)
        if place and place != before:
            console.print(f"[dim]{escape(place)}[/]")
        before = place
    if len(bad) > SHOWN_FINDINGS:
        counts = Counter(finding.verdict for finding in bad[SHOWN_FINDINGS:])
        words = ", ".join(f"[{STYLES[v]}]{n} more {v.name}[/]" for v, n in counts.items())
        console.print(words)


def _tell_files(console: Console, found: Verification) -> None:
    folder = found.folder
    for name in folder.missing:
        console.print(f"[bold red]missing[/] {escape(name)}")
    for name in folder.changed:
        nobody = ": no step checks it" if name in found.unvouched else ", see the findings below"
        console.print(
            f"[yellow]changed[/] {escape(name)}: its hash differs from the manifest's{nobody}"
        )
    if folder.beyond:
        names = escape(", ".join(folder.beyond))
        console.print(f"beyond the manifest, and no build reads it: {names}")
    if not folder.changed and not folder.missing:
        console.print(f"  {len(folder.texts)} files have the hashes of the manifest")
