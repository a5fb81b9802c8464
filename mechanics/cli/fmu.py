"""`mechanics fmu`: equations as a functional mock-up unit."""

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console

from mechanics.cli.load import SystemArgument, load
from mechanics.cli.values import (
    BeyondOption,
    FixOption,
    RouteOption,
    assignments,
    points,
    sorted_out,
)
from mechanics.compiled import compile
from mechanics.crosscheck import derive
from mechanics.crosscheck.fmu import unit_start
from mechanics.export.atomic import named
from mechanics.export.fmu import write_unit


def fmu(
    system: SystemArgument,
    out: Annotated[
        Path,
        typer.Option("--out", "-o", metavar="NAME.fmu", help="File to write.", parser=named),
    ],
    settings: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="NAME=VALUE", help="Start value, parameter or input."),
    ] = None,
    fix: FixOption = None,
    route: RouteOption = "free_body",
    step: Annotated[
        float | None, typer.Option(help="Longest internal step of co-simulation, in s.")
    ] = None,
    beyond_domain: BeyondOption = False,
) -> None:
    """Write the equations as an FMU: FMI 3.0, for model exchange and co-simulation.

    `mechanics fmu elastic_pendulum -o elastic_pendulum.fmu --set theta=2.5`

    `mechanics fmu rocker -o rocker.fmu --fix g=9.81 && fmpy validate rocker.fmu`

    The unit holds its C sources and, where there is a compiler, the library for this machine. What
    is set are start values, which can be set again in the importer; what is fixed is a number for
    good. Outputs are coordinates, speeds, accelerations, reactions, energies, and the margins of
    the conditions of validity: where one ceases to hold, the unit asks to end the simulation. The C
    functions are read back and compared with the graphs, and these with what was derived, in exact
    arithmetic, before the unit is written; exit code 1, and no file, if one is REFUTED, 3 if one is
    UNDECIDED.
    """
    scene = load(system).scene()
    initial, parameters, inputs = sorted_out(scene, points(settings or [], "--set"))
    fixed = assignments(fix or [], "--fix")
    with Console(stderr=True).status("deriving"):
        model = compile(derive(scene, route), fixed=fixed)
        start = unit_start(model, initial, parameters, inputs, step, beyond_domain)
        findings = write_unit(model, out, start, model.compiler)
    for finding in findings:
        typer.echo(f"{finding.subject}: {finding.verdict.name}")
    typer.echo(str(out))
    if model.compiler is None:
        typer.echo("no C compiler here: it holds the sources only, to be compiled by the importer")
    if not all(finding.shown for finding in findings):
        raise typer.Exit(3)
