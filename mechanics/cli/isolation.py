"""A command in a process of its own that has to send its exit code: one that just ends has none.

    main --fork--> command: runs a person's code, judges, prints --pipe--> its exit code

Code may end the process that runs it (`os._exit(0)`, a signal, a thread), and 0 would then read as
a proof. Where a system has no fork, the command runs where it is. It is no sandbox.
"""

import os
import signal
import sys
from collections.abc import Callable

from mechanics.cli.interrupts import ENDING


def answered(command: Callable[[], int]) -> int | None:
    """The exit code that a command sends; None where its process ended before that.

    Parameters
    ----------
    command : callable
        Returns its exit code.
    """
    if not hasattr(os, "fork"):
        return command()
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reader)
        _send(command, writer)
    os.close(writer)
    before = {number: signal.getsignal(number) for number in (signal.SIGINT, *ENDING)}
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # a terminal interrupts the command itself
    for number in ENDING:
        signal.signal(number, lambda which, _: os.kill(child, which))
    with os.fdopen(reader) as answer:
        line = answer.readline()
    os.waitpid(child, 0)
    for number, handler in before.items():
        signal.signal(number, handler)
    return int(line) if line.endswith("\n") else None


def _send(command: Callable[[], int], writer: int) -> None:
    """In the child: run, send the exit code, and end, whatever was raised."""
    code: object = None
    try:
        code = command()
    except SystemExit as stop:
        code = stop.code or None  # to exit with 0 is no verdict
    finally:
        if isinstance(code, int):
            sys.stdout.flush()
            sys.stderr.flush()
            os.write(writer, f"{code}\n".encode())
        os._exit(1)
