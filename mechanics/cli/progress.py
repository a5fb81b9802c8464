"""A progress bar on standard error, for work that takes longer than a second."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

from mechanics.clock import Stopwatch

PATIENCE = 1.0
"""Seconds after which a bar is worth its noise."""


@contextmanager
def working(words: str) -> Iterator[Callable[[float], None]]:
    """A callback that is told the share that is done, from 0 to 1.

    Parameters
    ----------
    words : str
        What is being done.
    """
    watch, shown = Stopwatch(), False
    bar = Progress(
        TextColumn("{task.description}"),
        BarColumn(),
        TimeRemainingColumn(),
        console=Console(stderr=True),
        transient=True,
    )
    task = bar.add_task(words, total=1.0)

    def tell(share: float) -> None:
        nonlocal shown
        if not shown and watch.seconds > PATIENCE:
            bar.start()
            shown = True
        if shown:
            bar.update(task, completed=share)

    try:
        yield tell
    finally:
        # Stopping a bar that was not shown prints an empty line.
        if shown:
            bar.stop()
