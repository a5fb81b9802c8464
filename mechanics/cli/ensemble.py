"""`mechanics ensemble`: many motions, to a folder, on one machine or on many."""

from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape

from mechanics.cli.load import SystemArgument, load
from mechanics.cli.progress import working
from mechanics.cli.values import (
    BeyondOption,
    RouteOption,
    SettingsOption,
    malformed,
    pairs,
    points,
    sorted_out,
)
from mechanics.cluster import Team, workers
from mechanics.compiled import compile
from mechanics.crosscheck import derive
from mechanics.errors import InputError
from mechanics.simulate import write_ensemble

ClusterOption = Annotated[
    str | None,
    typer.Option(metavar="tcp://...", help="Address of a Dask scheduler, whose workers compute."),
]
ProcessesOption = Annotated[
    int | None,
    typer.Option(min=1, metavar="N", help="Number of worker processes on this machine, by Dask."),
]


def ensemble(
    system: SystemArgument,
    vary: Annotated[
        list[str],
        typer.Option(
            metavar="NAME=FROM:TO:COUNT", help="Initial value, parameter or input over a range."
        ),
    ],
    out: Annotated[Path, typer.Option(metavar="FOLDER", help="Folder of the Parquet files.")],
    duration: Annotated[float, typer.Option(help="In s.")] = 10.0,
    settings: SettingsOption = None,
    samples: Annotated[
        int, typer.Option(min=2, help="Times at which states are written; 2: the end only.")
    ] = 2,
    tolerance: Annotated[
        float | None, typer.Option(help="Error over a thousand steps; 1e-9 unless --step is given.")
    ] = None,
    step: Annotated[float | None, typer.Option(help="Fixed steps, in s.")] = None,
    method: Annotated[
        str, typer.Option(help="auto, taylor, dop853; with a step rk4, rk5, rk8.")
    ] = "auto",
    cluster: ClusterOption = None,
    processes: ProcessesOption = None,
    threads: Annotated[int, typer.Option(min=1, metavar="N", help="Threads of this process.")] = 1,
    part: Annotated[
        int | None, typer.Option(min=1, help="Motions in a file; chosen when not given.")
    ] = None,
    route: RouteOption = "kane",
    beyond_domain: BeyondOption = False,
) -> None:
    """Integrate many motions, on one machine or on many; write them to a folder of Parquet.

    `mechanics ensemble elastic_pendulum --vary theta=2.4:2.6:10000 --out pendulums`

    `mechanics ensemble elastic_pendulum --vary theta=2.4:2.6:100 --vary M=1:2:100 --out grid
    --samples 101 --processes 2`

    `mechanics ensemble elastic_pendulum --vary theta=0:pi:1000000 --out many
    --cluster tcp://head:8786`

    All combinations of what is varied are integrated.

    `FOLDER/motions` has one row for each motion: what is varied, the last state, how it ended. With
    `--samples`, `FOLDER/samples` has one row for each motion and time. Memory does not grow with
    their number. After an interruption the same command continues. The results do not depend, to
    the last bit, on workers, threads and parts. Exit code 3 when a motion had to end early.
    """
    if (cluster is not None) + (processes is not None) + (threads > 1) > 1:
        raise InputError("--cluster, --processes and --threads: give one of them")
    grid = ranges(vary)
    scene = load(system).scene()
    # The varied names are read once as single values, so that a wrong one is told with the others.
    first = points([f"{name}={low}" for name, (low, _, _) in grid.items()], "--vary")
    sorted_out(scene, first)
    initial, parameters, inputs = sorted_out(scene, points(settings or [], "--set"))
    with Console(stderr=True).status("deriving"):
        model = compile(derive(scene, route))
    with (
        goes_on(out),
        _team(cluster, processes, threads) as team,
        working("integrating") as progress,
    ):
        found = write_ensemble(
            model, duration, out, grid, initial=initial, parameters=parameters, inputs=inputs,
            samples=samples, tolerance=tolerance, step=step, method=method,
            beyond_domain=beyond_domain, executor=team.executor, workers=team.size, here=team.here,
            part=part, progress=progress,
        )  # fmt: skip
    console = Console(soft_wrap=True)
    console.print(escape(f"{scene.name}: {found.method}"))
    if found.before:
        console.print(f"{found.before} motions were there already")
    for ending, count in found.endings.items():
        console.print(f"{count} of {found.motions} motions: {ending}")
    if len(found.machines) > 1:
        console.print(
            escape(
                f"machines of several kinds, which round differently: {'; '.join(found.machines)}"
            )
        )
    console.print(f"wrote {escape(str(out))}")
    if not found.complete:
        raise typer.Exit(3)


@contextmanager
def goes_on(out: Path) -> Iterator[None]:
    """Say how much is there, where it is stopped."""
    try:
        yield
    except (KeyboardInterrupt, SystemExit) as stop:
        count = sum(1 for _ in out.glob("motions/*.parquet"))
        stop.add_note(
            f"{count} files are in {out / 'motions'}; the same command goes on from there"
        )
        raise


@contextmanager
def _team(cluster: str | None, processes: int | None, threads: int) -> Iterator[Team]:
    if cluster is not None or processes is not None:
        with workers(cluster, processes) as team:
            yield team
    else:
        with ThreadPoolExecutor(threads) as pool:
            yield Team(pool, lambda: threads)


def ranges(entries: Sequence[str]) -> dict[str, tuple[float, float, int]]:
    """Read ``name=from:to:count``; numbers as for ``--set``.

    Raises
    ------
    InputError
        For an entry that is none, and a name given twice.
    """
    form = "name=from:to:count", "theta=2.4:2.6:1000"
    table: dict[str, tuple[float, float, int]] = {}
    for name, text, entry in pairs(entries, "--vary", *form):
        ends = text.split(":")
        if len(ends) != 3 or not ends[2].strip().isdecimal():
            raise malformed("--vary", entry, *form)
        low, high = (float(points([f"{name}={end}"], "--vary")[name]) for end in ends[:2])
        table[name] = low, high, int(ends[2]) if len(ends[2].strip()) < 20 else 10**20
    return table
