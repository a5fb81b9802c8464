"""What asks a command to end, ends it as Ctrl-C does: every block that cleans up is left in order.

Python itself does so for SIGINT only. SIGTERM, of `kill` and `timeout`, and SIGHUP, of a terminal
that is closed, would end the process where it stands and leave compilers and their files.
"""

import signal
import threading
from types import FrameType
from typing import NoReturn

ENDING = tuple(getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name))


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
