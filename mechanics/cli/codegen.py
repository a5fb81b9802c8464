"""`mechanics codegen`: a folder of C99, with what is proved about it."""

import json
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape

from mechanics.cli.load import SystemArgument, is_file, load
from mechanics.cli.values import (
    FixOption,
    RouteOption,
    assignments,
)
from mechanics.compiled import compile
from mechanics.crosscheck import derive
from mechanics.export import write_c
from mechanics.export.atomic import named
from mechanics.export.evidence.chain import NO_COMPILER
from mechanics.export.folder import MANIFEST
from mechanics.export.prefix import free_prefix
from mechanics.kernel import Verdict


def codegen(
    system: SystemArgument,
    out: Annotated[
        Path,
        typer.Option("--out", "-o", metavar="DIR", help="Folder to write.", parser=named),
    ],
    route: RouteOption = "free_body",
    fix: FixOption = None,
    outputs: Annotated[
        str, typer.Option(metavar="NAME,...", help="Functions to write; all by default.")
    ] = "",
    precision: Annotated[
        str, typer.Option(metavar="double|single|both", help="Precision of the numbers in C.")
    ] = "double",
    batch: Annotated[
        bool,
        typer.Option("--batch/--no-batch", help="Write functions of many states at once, too."),
    ] = True,
    name: Annotated[
        str | None,
        typer.Option(help="Prefix of files and functions; SYSTEM by default."),
    ] = None,
    form: Annotated[
        str, typer.Option(help="Form of forward dynamics: auto, fewest, recursive, ...")
    ] = "auto",
) -> None:
    """Write the equations as C99: a folder that builds, tests and installs alone.

    `mechanics codegen elastic_pendulum -o elastic_pendulum_c`

    `mechanics codegen elastic_pendulum -o small_c --fix g=9.81 --outputs forward_dynamics,energy`

    `mechanics codegen elastic_pendulum -o chip_c --precision single --no-batch`

    `cmake -S elastic_pendulum_c -B build && cmake --build build && ctest --test-dir build`

    It holds headers with the order and unit of every entry, self-tests, a CMake package, a
    pkg-config file, a Python loader and a manifest. Parameters that are fixed are no longer inputs;
    what a zero multiplies is left out. What an earlier call wrote into the folder is replaced;
    files of others stay as they are. The form of forward dynamics is the one with the fewest
    operations that rounds well, unless `--form` forces one; the manifest tells which.

    The folder is written when everything is proved: whole, or not at all. Exit code 1, and no
    folder, if something is REFUTED; 3 if something is UNDECIDED.
    """
    loaded = load(system)
    scene = loaded.scene()
    name = free_prefix(loaded.name) if name is None else name
    fixed = assignments(fix or [], "--fix")
    asked = [name.strip() for name in outputs.split(",")] if outputs else None
    with Console(stderr=True).status("deriving"):
        model = compile(derive(scene, route), form=form, fixed=fixed, outputs=asked)
        built_in = None if is_file(system) else system
        files = write_c(
            model, out, name=name, precision=precision, batch=batch, system=built_in
        )  # fmt: skip
    for path in files:
        typer.echo(str(path))
    _told(out)


def _told(folder: Path) -> None:
    """What is not shown of the code: UNDECIDED is exit code 3. What is REFUTED is not written."""
    content = json.loads((folder / MANIFEST).read_text(encoding="utf-8"))
    found = [finding for step in content["chain"]["steps"] for finding in step["findings"]]
    doubtful = [finding for finding in found if finding["verdict"] == Verdict.UNDECIDED.name]
    if NO_COMPILER in content["chain"]["not_done"]:
        typer.echo(f"not checked here: {NO_COMPILER}", err=True)
    for finding in doubtful:
        words = f"{finding['verdict']} {finding['subject']}: {finding['evidence']}"
        Console(stderr=True, soft_wrap=True).print(escape(words))
    if doubtful:
        raise typer.Exit(3)
