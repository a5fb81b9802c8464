"""What asks a command to end, ends it as Ctrl-C does: every block that cleans up is left in order.

Python itself does so for SIGINT only. SIGTERM, of `kill` and `timeout`, and SIGHUP, of a terminal
that is closed, would end the process where it stands and leave compilers and their files.
"""

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import NoReturn

from rich.console import Console
from rich.markup import escape

ENDING = tuple(getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name))

AGAIN = "what is not announced above is not written; the same command begins again"


@contextmanager
def told_when_stopped() -> Iterator[None]:
    """One line for a command that is asked to end: what is written, and how to go on.

    It is the note of what ends it, where a command that writes as it goes has added one.
    """
    try:
        yield
    except (KeyboardInterrupt, SystemExit) as stop:
        if isinstance(stop, KeyboardInterrupt) or stop.code in _codes():
            words = "; ".join(getattr(stop, "__notes__", ())) or AGAIN
            Console(stderr=True, soft_wrap=True, highlight=False).print(escape(f"stopped: {words}"))
        raise


def _codes() -> tuple[int, ...]:
    return tuple(128 + number for number in ENDING)


def end_in_order() -> None:
    """Raise SystemExit, with 128 and the number of the signal, where the process would just end.

    A signal that is ignored, as SIGHUP under `nohup`, stays ignored.
    """
    if threading.current_thread() is not threading.main_thread():
        return  # Python gives signals to the main thread, and takes handlers from it only.
    for number in ENDING:
        if signal.getsignal(number) is signal.SIG_DFL:
            signal.signal(number, _end)


def _end(number: int, frame: FrameType | None) -> NoReturn:
    # What cleans up is not interrupted again.
    for other in (*ENDING, signal.SIGINT):
        signal.signal(other, signal.SIG_IGN)
    raise SystemExit(128 + number)
