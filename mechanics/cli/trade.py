"""`mechanics trade`: what speed costs in accuracy, measured."""

import json
import os
import sys
from functools import partial
from itertools import groupby, zip_longest
from pathlib import Path
from statistics import median
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from mechanics.cli.ensemble import ClusterOption, ProcessesOption
from mechanics.cli.files import JsonOption, refuse_unwritable, write, write_file
from mechanics.cli.load import SystemArgument, load
from mechanics.cli.values import RouteOption, SettingsOption, points, sorted_out
from mechanics.cluster import team_of
from mechanics.crosscheck import derive, derive_textbook
from mechanics.report.trade import trade_html
from mechanics.report.trade_plot import standalone
from mechanics.simulate.file_names import writable
from mechanics.trade import Trade
from mechanics.trade import trade as measure
from mechanics.trade.choice import LINEARIZED
from mechanics.trade.least import DECLARED, LeastModel
from mechanics.trade.recommend import milliseconds
from mechanics.trade.record import to_record

LEGEND = (
    "Times are for one second of motion, in the sentences below for all of it. Other states: what"
    " 99.9 % of {states} are expected to stay below. Forms write the same forward dynamics in other"
    " ways, which differ in time and rounding."
)
WIDE = 130
"""Columns that the whole table takes."""


def trade(
    system: SystemArgument,
    horizon: Annotated[float, typer.Option(help="Length of the motion in s.")] = 10.0,
    settings: SettingsOption = None,
    target: Annotated[
        list[float] | None,
        typer.Option(
            metavar="ERROR", help="Largest error allowed; may be repeated; else 1e-3, 1e-6, 1e-9."
        ),
    ] = None,
    report: Annotated[
        Path | None, typer.Option(metavar="FILE.html", help="Write tables and plot for a browser.")
    ] = None,
    json_file: JsonOption = None,
    plot: Annotated[
        Path | None, typer.Option(metavar="FILE.svg", help="Write the work-precision plot.")
    ] = None,
    route: RouteOption = "kane",
    cluster: ClusterOption = None,
    processes: ProcessesOption = None,
) -> None:
    """Measure what integrators, precisions, forms and simpler models cost and how far they err.

    `mechanics trade elastic_pendulum --target 1e-6 --report trade.html`

    `mechanics trade elastic_pendulum --set theta=0.5 --horizon 100 --json -`

    `mechanics trade elastic_pendulum --plot work_precision.svg`

    Errors are measured against a solution with thirty digits, times side by side in one process.
    For each target it names the cheapest choice that meets it, from the example and from many other
    initial states near it, which workers share. The last table says which simpler model is enough.
    """
    _checked(report, json_file, plot)
    scene = load(system).scene()
    initial, parameters, inputs = sorted_out(scene, points(settings or [], "--set"))
    with (
        team_of(cluster, processes) as team,
        Console(stderr=True).status("deriving") as status,
    ):
        equations = derive(scene, route)
        # Leaving out parts of a scene that stays a program takes a derivation for each of them.
        again = partial(derive_textbook, route=route)
        found = measure(
            equations,
            horizon,
            initial=initial,
            parameters=parameters,
            inputs=inputs,
            target=target or None,
            derive=None if equations.textbook is None else again,
            progress=lambda words, share: status.update(f"{share:.0%} {escape(words)}"),
            team=team,
        )
    if report is not None:
        write_file(trade_html(found), report)
    if plot is not None:
        write_file(standalone(found), plot)
    if json_file is not None:
        write(json.dumps(to_record(found), allow_nan=False), json_file)
    if json_file != "-":
        # What is not a terminal has the width that it is given.
        wide = not sys.stdout.isatty() and "COLUMNS" not in os.environ
        _print(Console(width=WIDE if wide else None), found)


def _checked(report: Path | None, json_file: str | None, plot: Path | None) -> None:
    """Bad file names are refused before the work is done."""
    if report is not None:
        writable(report, (".html",))
    if plot is not None:
        writable(plot, (".svg",))
    refuse_unwritable(json_file)


def _print(console: Console, found: Trade) -> None:
    stick = found.yardstick
    console.print(f"\n[bold]{escape(found.title)}[/] over {found.horizon:g} s, {found.backend}")
    for words in (*found.notes, *stick.verified_by, stick.growth):
        console.print(f"  {escape(words)}", style="dim")
    console.print(f"  error: {stick.norm}\n", style="dim")
    console.print(_front(found, console.width >= WIDE))
    console.print(f"  {escape(LEGEND.format(states=found.family.words))}", style="dim")
    console.print()
    for pick in found.recommendations:
        style = "" if pick.choice is not None else "yellow"
        console.print(f"{escape(pick.reason)}\n", style=style)
    console.print(_costs(found))
    console.print("  A call: what Python takes for a run besides its steps.", style="dim")
    console.print()
    if found.least is not None:
        _print_least(console, found.least)
    for name, why in found.left_out.items():
        console.print(f"not measured: {escape(name)}: {escape(why)}", style="dim")


def _print_least(console: Console, least: LeastModel) -> None:
    console.print(_models(least))
    for row in least.fidelities:
        if row.words and row.name != LINEARIZED:
            console.print(f"  {escape(row.words)}")
    console.print()
    groups = groupby(least.amplitudes, key=lambda row: row.place)
    for note, (_, rows) in zip_longest(least.notes, groups, fillvalue=("", ())):
        console.print(f"{escape(str(note))}")
        for amplitude in rows:
            console.print(f"  {escape(amplitude.words)}")


def _front(found: Trade, wide: bool) -> Table:
    """Choices that no other beats, the fastest first; the last columns where there is room."""
    table = Table(box=None, pad_edge=False)
    more = ("at the end", "evaluations", "energy drift", "quartiles") if wide else ()
    for name in ("choice", "time for 1 s", "largest error", "other states below", *more):
        table.add_column(name, justify="left" if name == "choice" else "right")
    for m in found.front:
        bound, (low, high) = found.bound(m.choice), m.spread
        rest = (
            f"{m.error_end:.1e}",
            str(m.evaluations),
            "" if m.energy_drift is None else f"{m.energy_drift:.1e}",
            f"{milliseconds(low)} to {milliseconds(high)}{', noise' if m.noisy else ''}",
        )
        table.add_row(
            m.choice.words,
            milliseconds(m.time),
            f"{m.error_largest:.1e}",
            "" if bound is None else f"{bound:.1e}",
            *(rest if wide else ()),
        )
    return table


def _costs(found: Trade) -> Table:
    """What is recommended, its cost told apart; the second half by the C alone."""
    table = Table(box=None, pad_edge=False)
    for name in ("target", "for", "choice", "a call", "a step in C", "operations for 1 s", "bytes"):
        table.add_column(name, justify="left" if name in ("for", "choice") else "right")
    for who, picks in (("Python", found.recommendations), ("embedding", found.embedded)):
        for pick in picks:
            if pick.choice is None:
                table.add_row(f"{pick.target:.0e}", who, "none")
                continue
            cost = found.costs[pick.choice]
            step = "" if cost.step is None else milliseconds(cost.step)
            table.add_row(
                f"{pick.target:.0e}", who, pick.choice.words,
                "" if cost.call is None else milliseconds(cost.call),
                f"{step} an evaluation" if step and cost.counted == "evaluation" else step,
                "" if cost.operations is None else f"{cost.operations:.3g}",
                "" if cost.memory is None else str(cost.memory),
            )  # fmt: skip
    return table


def _models(least: LeastModel) -> Table:
    table = Table("model", box=None, pad_edge=False)
    for name in ("operations", "time for 1 s", "error"):
        table.add_column(name, justify="right")
    for row in least.fidelities:
        declared = row.name in (LINEARIZED, DECLARED)
        table.add_row(
            row.name if declared else f"without {row.name}",
            str(row.operations or ""),
            milliseconds(median(row.seconds)) if row.seconds else "",
            f"{row.error:.1e}",
        )
    return table
