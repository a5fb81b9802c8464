"""A function run in a process of its own, within limits of processor time and memory.

    outcomes(function, [one, two, ...], Limits(seconds=5, megabytes=500))    ->    values, Stopped

What a person hands in may take for ever or all memory; a worker that does is stopped, and nothing
is said of what it was given. The process is a copy of the caller's, so that what is derived is
derived once.
"""

import multiprocessing
import os
import pickle
import signal
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import redirect_stdout
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from pathlib import Path
from typing import Any, Generic, TypeVar

from mechanics.errors import InputError, MechanicsError

T = TypeVar("T")

PATIENCE = 12
"""Seconds on the clock for each second of processor time: a worker that waits is stopped, too."""

EXCESS = 24
"""Processor seconds beyond the limit, by which a worker that ignores its signal is killed."""


@dataclass(frozen=True)
class Limits:
    """What a worker may take.

    Attributes
    ----------
    seconds : float
        Of processor time.
    megabytes : int
        Of memory, beside what the caller has already.
    """

    seconds: float = 5.0
    megabytes: int = 500


@dataclass(frozen=True)
class Stopped:
    """A worker that came to no result.

    Attributes
    ----------
    reason : str
        ``"it took more than 5 s"``.
    """

    reason: str


@dataclass(frozen=True)
class Failed:
    """A worker whose function raised an error of this package."""

    message: str


class _TimeLimit(BaseException):
    """The processor time is over; no handler of exceptions on the way takes it."""


@dataclass(frozen=True, eq=False)
class _Job(Generic[T]):
    index: int
    process: BaseProcess
    answer: Connection
    start: float


def outcomes(
    function: Callable[[T], Any], arguments: Sequence[T], limits: Limits, jobs: int = 1
) -> Iterator[tuple[int, Any]]:
    """Place of each argument and what became of it, as they end.

    Parameters
    ----------
    function : callable
        Of one argument; what it returns has to be picklable.
    arguments : sequence
    limits : Limits
        Of each worker.
    jobs : int
        Workers at a time.

    Yields
    ------
    (int, Any)
        What was returned; `Stopped` for a worker that exceeded a limit or died, `Failed` for one
        whose function raised a `MechanicsError`.

    Raises
    ------
    InputError
        Where a system has no such processes.
    """
    if "fork" not in multiprocessing.get_all_start_methods():
        raise InputError("workers with limits need fork, which this system does not have")
    waiting = list(enumerate(arguments))[::-1]
    running: list[_Job[T]] = []
    try:
        while waiting or running:
            while waiting and len(running) < jobs:
                running.append(_started(function, *waiting.pop(), limits))
            wait([job.answer for job in running], timeout=0.2)
            still = []
            for job in running:
                late = time.monotonic() - job.start > PATIENCE * limits.seconds
                if job.answer.poll() or not job.process.is_alive() or late:
                    yield job.index, _outcome(job, limits)
                else:
                    still.append(job)
            running = still
    finally:
        for job in running:
            job.process.kill()


def _started(function: Callable[[T], Any], index: int, argument: T, limits: Limits) -> _Job[T]:
    context = multiprocessing.get_context("fork")
    ours, theirs = context.Pipe(duplex=False)
    process = context.Process(target=_work, args=(function, argument, theirs, limits), daemon=True)
    process.start()
    theirs.close()
    return _Job(index, process, ours, time.monotonic())


def _work(function: Callable[[T], Any], argument: T, answer: Connection, limits: Limits) -> None:
    """In the worker: limit it, run, send what became of it."""
    _limit(limits)
    try:
        with redirect_stdout(sys.stderr):  # the answer alone is on stdout
            outcome: Any = function(argument)
        data = pickle.dumps(outcome)
    except MechanicsError as error:
        data = pickle.dumps(Failed(str(error)))
    except MemoryError:
        data = pickle.dumps(_of_memory(limits))
    except _TimeLimit:
        data = pickle.dumps(_of_time(limits))
    except RecursionError:
        data = pickle.dumps(Stopped("it is nested too deeply"))
    answer.send_bytes(data)
    answer.close()
    os._exit(0)


def _limit(limits: Limits) -> None:
    import resource  # which Windows does not have, and no fork either

    def too_long(*_: object) -> None:
        raise _TimeLimit

    signal.signal(signal.SIGPROF, too_long)
    signal.setitimer(signal.ITIMER_PROF, limits.seconds)
    hard = int(limits.seconds) + EXCESS
    resource.setrlimit(resource.RLIMIT_CPU, (hard, hard))
    resource.setrlimit(resource.RLIMIT_AS, 2 * (_size() + limits.megabytes * 2**20,))


def _size() -> int:
    """Bytes of addresses that this process has."""
    statm = Path("/proc/self/statm")
    if not statm.exists():
        return 2**32
    return int(statm.read_text().split()[0]) * os.sysconf("SC_PAGE_SIZE")


def _outcome(job: _Job[T], limits: Limits) -> Any:
    """What a worker sent; why it is stopped, where it sent nothing."""
    try:
        if job.answer.poll():
            return pickle.loads(job.answer.recv_bytes())
    except EOFError:
        pass  # it died while it was sending
    finally:
        job.answer.close()
        job.process.kill()
        job.process.join()
    if time.monotonic() - job.start > PATIENCE * limits.seconds:
        return _of_time(limits)
    code = job.process.exitcode
    return Stopped(f"its process ended with code {code}" if code else "its process ended")


def _of_time(limits: Limits) -> Stopped:
    return Stopped(f"it took more than {limits.seconds:g} s")


def _of_memory(limits: Limits) -> Stopped:
    return Stopped(f"it took more than {limits.megabytes} MB")
