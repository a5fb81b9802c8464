"""`mechanics extremes`: how far every quantity goes before something breaks."""

import json
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from mechanics.cli.ensemble import ClusterOption, ProcessesOption
from mechanics.cli.files import JsonOption, refuse_unwritable, write, write_file
from mechanics.cli.load import load
from mechanics.cli.values import RouteOption
from mechanics.cluster import spread, workers
from mechanics.crosscheck import derive
from mechanics.extremes import CAUSES, Cause, Extremes, to_record
from mechanics.extremes import extremes as walk
from mechanics.extremes.result import PRECISIONS, End
from mechanics.report.extremes import extremes_html
from mechanics.report.extremes_plot import heat_plot
from mechanics.scene import Scene
from mechanics.scene.json.read import from_json
from mechanics.scene.json.write import to_json
from mechanics.scene.system import Path as Along
from mechanics.scene.system import System
from mechanics.simulate.file_names import writable


def extremes(
    names: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[SYSTEM]...",
            help="Names, `pendulum_chain(5)`, or .py files with a function scene();"
            " the first three systems and their variants when none is given.",
            show_default=False,
        ),
    ] = None,
    report: Annotated[
        Path | None, typer.Option(metavar="FILE.html", help="Write the map for a browser.")
    ] = None,
    json_file: JsonOption = None,
    plot: Annotated[
        Path | None,
        typer.Option(metavar="FILE.svg", help="Write one pair of maps of the first system."),
    ] = None,
    route: RouteOption = "kane",
    form: Annotated[
        list[str] | None, typer.Option(help="Form of forward dynamics; all when not given.")
    ] = None,
    cluster: ClusterOption = None,
    processes: ProcessesOption = None,
) -> None:
    """Find where compiled equations lose accuracy: along every parameter, coordinate and speed.

    `mechanics extremes elastic_pendulum --report extremes.html`

    `mechanics extremes rolling_disc --plot extremes.svg`

    `mechanics extremes 'pendulum_chain(5)' rolling_disc --json -`

    Errors are measured against enclosed accelerations, in double and in single precision, for every
    form of forward dynamics. With workers, each takes a system.
    """
    if plot is not None:
        writable(plot, (".svg",))
    refuse_unwritable(report, json_file)
    loaded = [load(name) for name in names] if names else _every()
    with Console(stderr=True).status("walking") as status:
        forms = tuple(form or ())
        if cluster is None and processes is None:
            results = []
            for system in loaded:
                status.update(f"{escape(system.name)}: deriving and walking")
                scene = system.scene()
                results.append(walked((scene, system.name, system.paths), route, forms))
        else:
            status.update(f"walking {len(loaded)} systems")
            with workers(cluster, processes) as team:
                texts = [(json.dumps(to_json(s.scene())), s.name, s.paths) for s in loaded]
                results = list(spread(team, walked, texts, route, forms))
        if plot is not None:
            write_file(heat_plot(results[0]), plot)
        if report is not None:
            status.update(f"writing {report.name}")
            write_file(extremes_html(results), report)
    if json_file is not None:
        record = {"systems": [to_record(found) for found in results]}
        text = json.dumps(record, allow_nan=False, separators=(",", ":"))
        write(text, json_file)
    if json_file != "-":
        _summary(Console(), results)


def walked(
    what: tuple[Scene | str, str, tuple[Along, ...]], route: str, forms: tuple[str, ...]
) -> Extremes:
    """The map of a scene, or of its JSON, which is what travels."""
    scene, name, paths = what
    made = from_json(scene) if isinstance(scene, str) else scene
    assert isinstance(made, Scene)
    return walk(derive(made, route), name=name, paths=paths, forms=forms)


def _every() -> list[System]:
    from systems import SEED, VARIANTS

    return [*SEED, *VARIANTS]


def _summary(console: Console, results: Sequence[Extremes]) -> None:
    for found in results:
        console.print(
            f"\n[bold]{escape(found.system)}[/]  {found.points} points, equations by {found.route},"
            f" default form {found.default}"
        )
        console.print(_forms(found))
        console.print(_domain(found))


def _forms(found: Extremes) -> Table:
    table = Table("form", "precision", "backward error", "what broke", box=None, pad_edge=False)
    for form in found.forms:
        for precision in PRECISIONS:
            counts: Counter[int] = Counter()
            for visited in found.visited:
                counts.update(visited.figure(form, precision).causes.tolist())
            broken = [
                f"{cause.name.lower()} {counts[i]}"
                for i, cause in enumerate(CAUSES)
                if counts[i] and cause not in (Cause.ACCURATE, Cause.INPUT)
            ]
            table.add_row(form, precision, f"{found.worst(form, precision):.3g}", ", ".join(broken))
    return table


def _domain(found: Extremes) -> Table:
    table = Table(
        "quantity", "usual", "accurate from", "to", "below", "above", box=None, pad_edge=False
    )
    for reach in found.reaches:
        if (reach.form, reach.precision) == (found.default, "double"):
            ends = [_end(end) for end in (reach.below, reach.above)]
            table.add_row(
                f"{reach.name} {reach.unit}".strip(), f"{reach.usual:.3g}", f"{reach.low:.3g}",
                f"{reach.high:.3g}", *ends,
            )  # fmt: skip
    return table


def _end(end: End) -> str:
    if end.cause is Cause.ACCURATE:
        return ""
    return end.cause.name.lower() + (f" in {end.where}" if end.where else "")
