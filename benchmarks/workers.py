"""Workers for campaigns: ``--processes N`` or ``--cluster tcp://...``.

Workers elsewhere need this repository, installed with the extra ``cluster``, as their folder. The
package is not imported before workers are asked for: its mutants need a process without it.
"""

from __future__ import annotations

import argparse
import pickle
import subprocess
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from mechanics.cluster import Team

T = TypeVar("T")


def add_options(parser: argparse.ArgumentParser) -> None:
    """Let a person ask for workers."""
    either = parser.add_mutually_exclusive_group()
    either.add_argument("--processes", type=int, metavar="N", help="workers on this machine")
    either.add_argument("--cluster", metavar="tcp://host:8786", help="scheduler of Dask's")


def team(options: argparse.Namespace) -> AbstractContextManager[Team | None]:
    """The workers that were asked for."""
    from mechanics.cluster import team_of

    return team_of(options.cluster, options.processes)


def spread_alone(
    some: Team | None, function: Callable[..., T], arguments: Iterable[Any], *more: Any
) -> Iterator[T]:
    """As `spread`, but each argument in a process of its own on the worker.

    The worker's own threads draw random numbers, and whoever watches what a person's code changes
    takes that for the code's.
    """
    from mechanics.cluster import spread

    if some is None:
        return spread(None, function, arguments, *more)
    return spread(some, _alone, [(function, argument, *more) for argument in arguments])


def _alone(call: tuple[Any, ...]) -> Any:
    ran = subprocess.run(
        [sys.executable, "-m", "benchmarks.workers"],
        input=pickle.dumps(call), stdout=subprocess.PIPE, check=True,
    )  # fmt: skip
    return pickle.loads(ran.stdout)


def _answer() -> None:
    """The other end of `_alone`; what is printed goes to the errors."""
    function, *given = pickle.load(sys.stdin.buffer)
    answers, sys.stdout = sys.stdout.buffer, sys.stderr
    answers.write(pickle.dumps(function(*given)))


if __name__ == "__main__":
    _answer()
