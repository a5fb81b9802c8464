"""`mechanics simulate` and `mechanics codegen`: what compiled equations are used for."""

import json
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape

from mechanics.cli.load import SystemArgument, is_file, load
from mechanics.cli.progress import working
from mechanics.cli.values import (
    BeyondOption,
    FixOption,
    RouteOption,
    SettingsOption,
    assignments,
    points,
    sorted_out,
)
from mechanics.compiled import compile
from mechanics.crosscheck import derive
from mechanics.errors import InputError
from mechanics.export import write_c
from mechanics.export.atomic import named, replaced_file
from mechanics.export.folder import MANIFEST
from mechanics.export.prefix import free_prefix
from mechanics.kernel import Verdict
from mechanics.report.animation import animation
from mechanics.simulate import Ending, with_reactions, write_plot, write_table
from mechanics.simulate.files import SUFFIXES, writable
from mechanics.trade.accurate import simulate as run


def simulate(
    system: SystemArgument,
    out: Annotated[
        Path | None, typer.Option(metavar="FILE.csv|.parquet", help="File of the samples.")
    ] = None,
    duration: Annotated[float, typer.Option(help="In s.")] = 10.0,
    settings: SettingsOption = None,
    plot: Annotated[Path | None, typer.Option(metavar="FILE.svg", help="Draw the motion.")] = None,
    animate: Annotated[
        Path | None, typer.Option(metavar="FILE.svg", help="Draw the scene as it moves.")
    ] = None,
    samples: Annotated[int, typer.Option(min=2, help="Number of samples.")] = 501,
    accuracy: Annotated[
        float | None,
        typer.Option(metavar="ERROR", help="Choose the cheapest method with at most this error."),
    ] = None,
    route: Annotated[
        str | None,
        typer.Option(help="Route that derives the equations: kane, or free_body for reactions."),
    ] = None,
    reactions: Annotated[
        bool, typer.Option("--reactions", help="Add a column for each reaction of the scene.")
    ] = False,
    beyond_domain: BeyondOption = False,
) -> None:
    """Integrate the equations of motion; write the samples, or draw the motion.

    `mechanics simulate elastic_pendulum --duration 10 --set theta=2.5 --out motion.csv`

    `mechanics simulate elastic_pendulum --duration 5 --animate motion.svg`

    `mechanics simulate elastic_pendulum --accuracy 1e-8 --out motion.csv`

    `mechanics simulate elastic_pendulum --reactions --out motion.csv`

    `mechanics simulate four_bar --set q1=0.5 --out motion.parquet --plot motion.svg`

    Values that are not set are the example's and the typical ones. In a scene with constraints the
    initial values are made consistent: what is set is kept, the rest is solved for, and the branch
    is named. Exit code 3 when the motion had to end early; what was integrated is written. It ends
    where a condition of the scene ceases to hold, unless `--beyond-domain` is given.

    How large the error is likely to be is estimated by a second, coarser run. Where errors grow so
    fast that no digit is right in the end, it says from when on.

    With `--accuracy`, integrators are measured against a reference first, the cheapest that meets
    it is used, and the error is estimated by a second run with a finer setting.
    """
    # Bad file names are refused before the work is done.
    if out is None and animate is None and plot is None:
        raise InputError("simulate: nothing to write: add --out FILE.csv, --plot or --animate")
    for path, suffixes in ((out, SUFFIXES), (plot, (".svg",)), (animate, (".svg",))):
        if path is not None:
            writable(path, suffixes)
    scene = load(system).scene()
    initial, parameters, inputs = sorted_out(scene, points(settings or [], "--set"))
    with Console(stderr=True).status("deriving"):
        model = compile(derive(scene, route or ("free_body" if reactions else "kane")))
    with working("integrating") as progress:
        found = run(
            model,
            duration,
            initial=initial,
            parameters=parameters,
            inputs=inputs,
            samples=samples,
            accuracy=accuracy,
            progress=progress,
            beyond_domain=beyond_domain,
        )
        if reactions:
            found = with_reactions(found, model)
        if out is not None:
            with replaced_file(out) as fresh:
                write_table(found, fresh)
        if plot is not None:
            with replaced_file(plot) as fresh:
                write_plot(found, fresh)
        if animate is not None:
            with replaced_file(animate) as fresh:
                fresh.write_text(animation(scene, found.times, found.coordinates), encoding="utf-8")
    console = Console()
    console.print(f"{escape(found.title)}: {escape(found.reason)}")
    for crossing in found.crossings if found.ending is not Ending.LEFT_DOMAIN else ():
        console.print(escape(f"t = {crossing.time:.6g} s: {crossing.sentence}"))
    if found.branch:
        console.print(escape(found.branch))
    for name, value in found.drift.items():
        console.print(f"largest drift of {escape(name)} before projection: {value:.1e}")
    if found.error_estimate is not None:
        console.print(escape(found.accuracy))
    if found.conservative:
        console.print(f"largest relative change of the energy: {found.energy_drift:.1e}")
    if out is not None:
        console.print(f"wrote {len(found.times)} samples to {escape(str(out))}")
    if animate is not None:
        console.print(f"wrote the moving picture to {escape(str(animate))}")
    if found.ending is not Ending.COMPLETE:
        raise typer.Exit(3)


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
    """Whatever is UNDECIDED about the code: exit code 3. What is REFUTED is not written."""
    content = json.loads((folder / MANIFEST).read_text(encoding="utf-8"))
    found = [finding for step in content["chain"]["steps"] for finding in step["findings"]]
    doubtful = [finding for finding in found if finding["verdict"] == Verdict.UNDECIDED.name]
    for finding in doubtful:
        words = f"{finding['verdict']} {finding['subject']}: {finding['evidence']}"
        Console(stderr=True, soft_wrap=True).print(escape(words))
    if doubtful:
        raise typer.Exit(3)
