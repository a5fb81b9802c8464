"""`mechanics simulate`: a motion, its samples, its plot."""

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape

from mechanics.cli.load import SystemArgument, load
from mechanics.cli.progress import working
from mechanics.cli.values import (
    BeyondOption,
    SettingsOption,
    points,
    sorted_out,
)
from mechanics.compiled import compile
from mechanics.crosscheck import derive
from mechanics.errors import InputError
from mechanics.export.atomic import replaced_file
from mechanics.report.motion import supported
from mechanics.simulate import Ending, with_reactions, write_plot, write_table
from mechanics.simulate.file_names import writable
from mechanics.simulate.files import SUFFIXES
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
        Path | None,
        typer.Option(
            metavar="FILE.svg|.html|.gif",
            help="Draw the scene as it moves; a page shows its curves, too.",
        ),
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

    `mechanics simulate elastic_pendulum --duration 5 --animate motion.html`

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
    for path, suffixes in ((out, SUFFIXES), (plot, (".svg",))):
        if path is not None:
            writable(path, suffixes)
    if animate is not None:
        supported(animate)
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
            slower = found.animate(animate)
    console = Console()
    console.print(f"{escape(found.title)}: {escape(found.reason)}")
    if model.compiler is None:
        console.print(f"functions are evaluated by {model.backend}, which is slower")
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
        if slower:
            console.print(escape(slower))
    if found.ending is not Ending.COMPLETE:
        raise typer.Exit(3)
