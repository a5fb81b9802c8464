"""Motions in parts, on the workers of an executor: few at a time are under way.

    number of a part --submit--> worker --> its result, as it ends        LIMIT at a time

A part is a pure function of its motions, and a motion is computed in the same way wherever it
stands: neither the parts, nor their order, nor who computed them can be seen in a result.
"""

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from itertools import islice
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from mechanics.simulate.ensembles.run import Found
from mechanics.simulate.ensembles.task import Task, integrate, to_text

Array = NDArray[np.float64]
S = TypeVar("S")
T = TypeVar("T")
PARTS, LEAST, MOST = 64, 256, 65536
"""Into how many parts motions are divided, and how many a part has at least and at most."""
LIMIT = 256
"""Parts under way."""


def spread(executor: Executor, task: Task, start: Array, held: Array) -> Found:
    """What `integrated` finds, by the workers of an executor.

    Parameters
    ----------
    executor : concurrent.futures.Executor
    start, held : arrays, shapes (batch, size) and (batch, k)
    """
    text, count = to_text(task), len(start)
    many = min(max(-(-count // PARTS), LEAST), MOST)
    bounds = {k: (first, min(first + many, count))
              for k, first in enumerate(range(0, count, many))}  # fmt: skip

    def submit(k: int) -> Future[Found]:
        first, last = bounds[k]
        return executor.submit(integrate, text, start[first:last], held[first:last])

    parts = dict(under_way(submit, bounds, lambda: LIMIT))
    if not parts:
        return integrate(text, start, held)
    return Found(*(np.concatenate(columns) for columns in zip(
        *(parts[k] for k in bounds), strict=True)))  # fmt: skip


def under_way(
    submit: Callable[[S], "Future[T]"], parts: Iterable[S], limit: Callable[[], int]
) -> Iterator[tuple[S, T]]:
    """Each part and its result, as they end.

    Parameters
    ----------
    submit : callable
        Of a part.
    parts : iterable
    limit : callable
        How many may be under way now.

    Raises
    ------
    Exception
        What a part raised; the others are cancelled.
    """
    left, running = iter(parts), dict[Future[T], S]()
    try:
        while True:
            room = max(1, limit()) - len(running)
            for part in islice(left, max(0, room)):
                running[submit(part)] = part
            if not running:
                return
            done, _ = wait(running, return_when=FIRST_COMPLETED)
            for future in done:
                yield running.pop(future), future.result()
    finally:
        for future in running:
            future.cancel()
