"""`mechanics reduce`: what may be left out of an output, and how much that changes it at most."""

import json
import sys
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape

from mechanics.cli.files import JsonOption, refuse_unwritable, write
from mechanics.cli.findings import explain
from mechanics.cli.load import SystemArgument, is_file, load
from mechanics.cli.values import RouteOption, pairs
from mechanics.crosscheck import derive
from mechanics.export import write_c
from mechanics.export.atomic import named
from mechanics.export.prefix import free_prefix
from mechanics.kernel import Verdict
from mechanics.program.listing import listing
from mechanics.reduce import Reduction, reduced_model
from mechanics.reduce import reduce as find
from mechanics.reduce.proof import BOXES
from mechanics.reduce.record import record

LISTED = 60
"""Operations up to which a reduced output is printed."""
UNBOUNDED = ", and may be unbounded in the box"
SHOWN = 12
"""Things left out that are printed; the others are in the JSON."""


def reduce(
    system: SystemArgument,
    error: Annotated[
        str, typer.Option(help="Allowed error, as a share of each output's size in the box.")
    ],
    of: Annotated[
        str, typer.Option(metavar="OUTPUT", help="forward_dynamics, inverse_dynamics, ...")
    ] = "forward_dynamics",
    over: Annotated[
        list[str] | None,
        typer.Option(metavar="RANGE", help="'theta in [-1, 1]': range of a quantity, one each."),
    ] = None,
    settings: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="NAME=VALUE", help="A quantity with one value in the box."),
    ] = None,
    absolute: Annotated[
        bool, typer.Option("--absolute", help="The error is absolute, in the unit of the output.")
    ] = False,
    out: Annotated[
        Path | None,
        typer.Option("--out", "-o", metavar="DIR", help="Write the reduced model as C.",
                     parser=named),
    ] = None,
    json_file: JsonOption = None,
    boxes: Annotated[
        int, typer.Option(min=1, help="Examine at most so many parts of the box.")
    ] = BOXES,
    route: RouteOption = "kane",
) -> None:  # fmt: skip
    """Find what may be left out of an output over a box, with a proved bound of the change.

    `mechanics reduce elastic_pendulum --error 0.05 --over "theta in [-0.2, 0.2]"
    --over "theta_dot in [-1, 1]" --over "x in [-0.1, 0.1]"`

    `mechanics reduce rocker --error 1e-2 --over "theta in [-0.1, 0.1]"
    --over "theta_dot in [-1, 1]" --over "f in [-5, 5]" -o rocker_c`

    Terms, parameters, couplings of the mass matrix, products of speeds, sines and cosines of
    small angles are left out as long as the output changes by no more than the error at any point
    of the box. Parameters without a range are at their typical values; coordinates, speeds, their
    rates and inputs need a range each where the output depends on them, but for the inputs of
    inverse dynamics, which are 0.

    Exit code: 0 when the bound is PROVED, 3 when it is UNDECIDED, 2 for bad input.
    """
    refuse_unwritable(json_file)
    loaded = load(system)
    scene = loaded.scene()
    values = {name: text for name, text, _ in pairs(settings or [], "--set")}
    with Console(stderr=True).status("deriving") as status:
        equations = derive(scene, route)
        found = find(
            equations, error, of=of, over=over or (), values=values, absolute=absolute,
            boxes=boxes, progress=lambda words: status.update(escape(words)),
        )  # fmt: skip
        if out is not None:
            status.update("writing")
            built_in = None if is_file(system) else system
            write_c(
                reduced_model(found), out, name=free_prefix(f"{loaded.name}_reduced"),
                system=built_in,
            )  # fmt: skip
    if json_file is not None:
        write(json.dumps(record(found), indent=1, ensure_ascii=False), json_file)
    if json_file != "-":
        _print(Console(soft_wrap=not sys.stdout.isatty(), highlight=False), found, out)
    if found.finding.verdict is not Verdict.PROVED:
        raise typer.Exit(3)


def _print(console: Console, found: Reduction, out: Path | None) -> None:
    told = record(found)
    console.print(
        f"[bold]{escape(told['scene'])}[/], {found.of}: {found.after} operations instead of"
        f" {found.before}, with numbers for parameters without a range"
    )
    for row in told["outputs"]:
        console.print(
            f"  {row['output']}: changes by {row['bound']:.3g} at most;"
            f" it reaches {row['size']:.3g}"
            f"{'' if row['bounded'] else UNBOUNDED}",
            markup=False,
        )
    for entry in told["dropped"][:SHOWN]:
        console.print(f"  left out: {entry}", markup=False)
    if not found.edits:
        console.print("  nothing is left out: whatever saves operations is beyond the error")
    if len(told["dropped"]) > SHOWN:
        console.print(f"  and {len(told['dropped']) - SHOWN} more, see --json", markup=False)
    if found.unproved:
        console.print(
            f"  not left out: {found.unproved} that stay within the error at the states drawn, each"
            " by itself; with the rest no bound is known",
            markup=False,
        )
    numbers = {symbol.name: value for symbol, value in found.fixed.items()}
    for title in ("parameters", "couplings"):
        for kind in ("dropped", "kept"):
            names = [name for name in told[title][kind] if kind == "dropped" or name not in numbers]
            if names:
                console.print(f"  {title} {kind}: {', '.join(names)}", markup=False)
    if values := [f"{n} = {numbers[n]}" for n in told["parameters"]["kept"] if n in numbers]:
        console.print(f"  parameters as numbers: {', '.join(values)}", markup=False)
    if found.edits and found.after <= LISTED:
        lines = listing(found.program)
        rows = [(str(name), str(value)) for name, value in lines.lines]
        entries = (str(value) for group in lines.outputs.values() for value in group)
        rows += zip(found.outputs, entries, strict=True)
        for name, value in rows:
            console.print(f"    {name} = {value}", markup=False)
    explain(console, found.finding)
    if out is not None:
        console.print(f"wrote {out}", markup=False)
