"""`mechanics compare`: a scene beside other engines, and why they differ."""

import json
import sys
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from mechanics.cli.files import JsonOption, refuse_unwritable, write
from mechanics.cli.findings import STYLES
from mechanics.cli.load import load
from mechanics.cli.values import assignments
from mechanics.compare import Comparison, installed
from mechanics.compare import compare as run
from mechanics.compare.compare import STATES
from mechanics.compare.record import to_record, told
from mechanics.errors import InputError

FILES = (".urdf", ".xml")


def compare(
    model: Annotated[
        str, typer.Argument(metavar="MODEL", help="A name, a .py file, a URDF or an MJCF file.")
    ],
    against: Annotated[
        str, typer.Option(metavar="ENGINE,...", help="Engines; by default those that are here.")
    ] = "",
    value: Annotated[
        list[str] | None, typer.Option(metavar="NAME=VALUE", help="Value of a parameter.")
    ] = None,
    states: Annotated[int, typer.Option(min=2, help="Number of random states.")] = STATES,
    json_file: JsonOption = None,
) -> None:
    """Compare a model with other engines, and name the cause where they differ.

    `mechanics compare arm_puma560 --against pinocchio,mujoco`

    `mechanics compare arm.urdf --against mujoco --json -`

    Compared are mass matrix, bias, inverse and forward dynamics, energies and Jacobians, at random
    states. Both sides read a file by themselves; for a scene the engine's model is made from it.
    Exit code: 0 when all agree but
    for rounding, 1 when something differs, 2 for bad input.
    """
    refuse_unwritable(json_file)
    # The other side takes 1.5708 for what it is.
    scene = load(model, multiples=False).scene()
    file = Path(model) if Path(model).suffix in FILES else None
    values = {name: float(number) for name, number in assignments(value or [], "--value").items()}
    names = [name.strip() for name in against.split(",") if name.strip()] or [*installed()]
    found: list[Comparison] = []
    refused: dict[str, str] = {}
    for name in names:
        try:
            with Console(stderr=True).status(f"comparing {scene.name} with {name}"):
                found.append(run(scene, name, values=values, states=states, file=file))
        except InputError as error:
            refused[name] = str(error)
    if not found:
        raise InputError(
            "; ".join(dict.fromkeys(refused.values())) or "no engine is installed: pip install pin"
        )
    if json_file is not None:
        write(json.dumps([to_record(f) for f in found], indent=2, allow_nan=False), json_file)
    if json_file != "-":
        for comparison in found:
            _print(
                Console(highlight=False, emoji=False, soft_wrap=not sys.stdout.isatty()), comparison
            )
    if refused and against:
        raise InputError("; ".join(dict.fromkeys(refused.values())))
    for words in refused.values():
        typer.echo(f"not compared: {words}", err=True)
    raise typer.Exit(0 if all(comparison.agree for comparison in found) else 1)


def _print(console: Console, found: Comparison) -> None:
    console.print(f"\n[bold]{escape(found.scene)}[/] and {escape(found.against)}")
    table = Table("quantity", box=None, pad_edge=False)
    for name in ("largest difference", "rounding", ""):
        table.add_column(name, justify="right" if name else "left")
    for row in found.rows:
        unit = f" {row.unit}" if row.unit else ""
        apart = f"{row.difference:.1e}{unit}" if row.alike else "other shapes"
        verdict = row.finding.verdict
        style = STYLES[verdict]
        table.add_row(row.quantity, apart, f"{row.allowed:.1e}", f"[{style}]{verdict.name}[/]")
    console.print(table)
    for line in told(found):
        console.print(escape(line))
