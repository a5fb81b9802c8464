"""A process that answers calls of tools within limits of processor time and memory.

    server -- {"tool": "check", "arguments": {...}} --> worker
    server <-- {"answer": {...}} or {"refused": "..."} -- worker

What somebody sends may be made to take for ever. A worker that passes a limit is stopped by the
operating system, and the compilers that it started with it; its call is not judged, and the next
one finds a new worker, which knows no scenes yet. Limits hold where the system has them: not on
Windows.
"""

import json
import os
import signal
import subprocess
import sys
from importlib import import_module
from threading import Lock
from time import process_time
from typing import Any

from mechanics.cli.tools import Tools
from mechanics.errors import InputError, MechanicsError

SECONDS = 120
"""Of processor time, for one call."""
GIGABYTES = 4.0
"""Of memory."""


class Worker:
    """Starts a process for the calls of `Tools`, and another one where that was stopped.

    Parameters
    ----------
    seconds : int
        Processor time of one call.
    gigabytes : float
        Memory.
    """

    def __init__(self, seconds: int = SECONDS, gigabytes: float = GIGABYTES) -> None:
        self.seconds, self.gigabytes = seconds, gigabytes
        self._lock = Lock()
        self._process: subprocess.Popen[str] | None = None

    def start(self) -> subprocess.Popen[str]:
        """The process, started where there is none."""
        if self._process is None:
            command = [sys.executable, "-m", __name__, str(self.seconds), str(self.gigabytes)]
            root = os.pathsep.join(path for path in sys.path if path)
            self._process = subprocess.Popen(
                command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, encoding="utf-8",
                env={**os.environ, "PYTHONPATH": root},
            )  # fmt: skip
        return self._process

    def call(self, tool: str, arguments: dict[str, Any]) -> Any:
        """What a tool answers.

        Raises
        ------
        InputError
            What it refuses; or that the call passed a limit and was not judged.
        """
        with self._lock:
            process = self.start()
            assert process.stdin is not None
            assert process.stdout is not None
            try:
                process.stdin.write(json.dumps({"tool": tool, "arguments": arguments}) + "\n")
                process.stdin.flush()
                line = process.stdout.readline()
            except BrokenPipeError:
                line = ""
            if not line:
                raise InputError(f"{tool}: not judged: {self._end()}")
        found = json.loads(line)
        if "refused" in found:
            raise InputError(found["refused"])
        return found["answer"]

    def _end(self) -> str:
        """Why the process has ended."""
        process, self._process = self.start(), None
        process.communicate()
        if -process.returncode == getattr(signal, "SIGXCPU", None):
            return f"it took more than {self.seconds} s of processor time: ask for less"
        if process.returncode == 1:
            return "it failed, which is a defect of this program: standard error says where"
        return f"its process ended ({process.returncode}): ask for less"

    def stop(self) -> None:
        """End the process."""
        if self._process is not None:
            self._process.kill()
            self._end()


def limit(seconds: int, gigabytes: float | None = None) -> None:
    """From now on so much processor time, and so much memory, of this process."""
    if os.name != "posix":
        return
    resource = import_module("resource")
    _, most = resource.getrlimit(resource.RLIMIT_CPU)
    resource.setrlimit(resource.RLIMIT_CPU, (int(process_time()) + 1 + seconds, most))
    if gigabytes is not None:
        size = int(gigabytes * 2**30)
        resource.setrlimit(resource.RLIMIT_DATA, (size, size))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def answer(tools: Tools, call: dict[str, Any]) -> dict[str, Any]:
    """What a tool answers or refuses, in one line."""
    try:
        return {"answer": getattr(tools, call["tool"])(**call["arguments"])}
    except MechanicsError as error:
        return {"refused": " ".join(str(error).split())}
    except RecursionError:
        return {"refused": "nested too deeply"}
    except MemoryError:
        return {"refused": f"{call['tool']}: not judged: it needs too much memory: ask for less"}


def main() -> None:
    """Answer calls, a line each, until there are no more."""
    seconds, gigabytes = int(sys.argv[1]), float(sys.argv[2])
    limit(seconds, gigabytes)
    # Whatever prints must not come between the answers.
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    tools = Tools()
    for line in sys.stdin:
        limit(seconds)
        print(json.dumps(answer(tools, json.loads(line))), file=answers, flush=True)


if __name__ == "__main__":
    main()
