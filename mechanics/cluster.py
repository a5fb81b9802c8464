"""Workers for parts of a task: Dask's, on a cluster or on this machine.

    with workers("tcp://head:8786") as team:   team.executor.submit(function, argument)
    with workers(processes=2) as team:         the same, by a scheduler and workers of its own

Dask starts again what a lost worker had under way, and a worker in the place of one that ended.
"""

import asyncio
import logging
import tempfile
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import CancelledError, Executor
from contextlib import AbstractContextManager, ExitStack, contextmanager, nullcontext
from dataclasses import dataclass
from typing import Any, TypeVar

from mechanics.errors import InputError

T = TypeVar("T")
PATIENCE = 10
"""Seconds for a scheduler to answer."""
ADDRESS = "tcp://host:8786"


@dataclass(frozen=True)
class Team:
    """Workers.

    Attributes
    ----------
    executor : concurrent.futures.Executor
    size : callable
        How many parts they work on at a time now; workers may come and go.
    here : bool
        Whether they run on this machine, with its disk.
    """

    executor: Executor
    size: Callable[[], int]
    here: bool = True


@contextmanager
def workers(cluster: str | None = None, processes: int | None = None) -> Iterator[Team]:
    """Workers of a cluster, or so many processes on this machine.

    Parameters
    ----------
    cluster : str, optional
        Address of a scheduler of Dask's.
    processes : int, optional

    Raises
    ------
    InputError
        Where ``distributed`` is not installed, there is no such scheduler, it has no workers, it
        went away, or a part ended one worker after the other.
    """
    if (cluster is None) == (processes is None):
        raise InputError("cluster and processes: give one of them")
    if processes is not None and processes < 1:
        raise InputError(f"processes: {processes} found: at least 1 is needed")
    distributed = _distributed()
    with ExitStack() as stack:
        client = stack.enter_context(_client(distributed, cluster, processes, stack))
        try:
            yield Team(
                client.get_executor(), lambda: sum(client.ncores().values()), cluster is None
            )
        except distributed.scheduler.KilledWorker as error:
            raise InputError(
                f"workers: a part ended {error.allowed_failures + 1} workers, the last one at"
                f" {error.last_worker.address}: it may need more memory than they have"
            ) from None
        except (
            CancelledError, asyncio.CancelledError, distributed.client.FutureCancelledError,
            OSError,
        ):  # fmt: skip
            raise InputError(
                f"cluster {cluster or 'of processes'}: its scheduler went away: what is written"
                " stays, and the same call goes on"
            ) from None


def team_of(cluster: str | None, processes: int | None) -> AbstractContextManager[Team | None]:
    """Workers where a person asks for them, else none."""
    if cluster is None and processes is None:
        return nullcontext()
    return workers(cluster, processes)


def spread(
    team: Team | None, function: Callable[..., T], arguments: Iterable[Any], *more: Any
) -> Iterator[T]:
    """A function of each argument, in their order; computed here where there is no team."""
    if team is None:
        yield from (function(argument, *more) for argument in arguments)
        return
    waiting = [team.executor.submit(function, argument, *more) for argument in arguments]
    for future in waiting:
        yield future.result()


def _distributed() -> Any:
    try:
        import distributed
    except ImportError:
        raise InputError(
            "workers need Dask's distributed, which is not installed: run pip install"
            " 'mechanics[cluster]', here and where the workers are"
        ) from None
    # What goes wrong is told in one line; its loggers print tracebacks.
    logging.getLogger("distributed").setLevel(logging.CRITICAL)
    return distributed


def _client(distributed: Any, cluster: str | None, processes: int | None, stack: ExitStack) -> Any:
    if cluster is None:
        folder = stack.enter_context(tempfile.TemporaryDirectory(prefix="mechanics-"))
        local = distributed.LocalCluster(
            n_workers=processes, threads_per_worker=1, dashboard_address=None,
            local_directory=folder, silence_logs=logging.CRITICAL,
        )  # fmt: skip
        # Results come from the workers, not by way of the scheduler: half the copies.
        return distributed.Client(
            stack.enter_context(local), set_as_default=False, direct_to_workers=True
        )
    try:
        client = distributed.Client(cluster, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        words = (str(error).splitlines() or [type(error).__name__])[0]
        raise InputError(
            f"cluster {cluster}: no scheduler answers there ({words}): start one with `dask"
            f" scheduler`, and give its address, as in {ADDRESS}"
        ) from None
    if not client.ncores():
        client.close()
        raise InputError(
            f"cluster {cluster}: it has no workers: start them with `dask worker {cluster}`"
        )
    return client
