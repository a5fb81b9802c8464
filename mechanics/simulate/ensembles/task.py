"""What a worker gets, as text: the programs of a right-hand side, a method, and the times.

    {"format": ..., "version": ..., "written": {...}, "program": {...}, "moving": 4,
     "method": ["taylor", 1e-12, 1000000], "times": [0.0, 10.0]}

Numbers stand so that they are read back as the same doubles. The worker compiles the programs, once
a machine; it needs no scene, and derives nothing.
"""

import json
import platform
import subprocess
from functools import cache, lru_cache
from hashlib import sha256
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.machine.native import find_compiler
from mechanics.compiled.machine.shared_libraries import load_shared
from mechanics.compiled.right_hand_side import Held
from mechanics.errors import CompilerError, InputError
from mechanics.program.json_format import read, write
from mechanics.program.routine import Routine
from mechanics.simulate.ensembles.library import Library
from mechanics.simulate.ensembles.run import SOURCES, Found, Method, integrated

Array = NDArray[np.float64]
FORMAT = "mechanics ensemble 1"
RATE = "rate"


class Task(NamedTuple):
    """What is integrated, and how.

    Attributes
    ----------
    held : Held
        The right-hand side.
    moving : int
        Entries of its state that are coordinates and speeds: all, or all but the time.
    times : array, shape (N,)
        In s.
    """

    held: Held
    moving: int
    method: Method
    times: Array


def to_text(task: Task) -> str:
    """A task in JSON."""
    (_, size), (_, count) = task.held.routine.inputs
    whole = {
        "format": FORMAT,
        "sizes": [size, count],
        "written": json.loads(write(task.held.routine.program)),
        "program": json.loads(write(task.held.program)),
        "moving": task.moving,
        "method": list(task.method),
        "times": task.times.tolist(),
    }
    return json.dumps(whole, separators=(",", ":"))


@lru_cache(maxsize=8)
def from_text(text: str) -> Task:
    """A task from JSON; what was read last is kept.

    Raises
    ------
    InputError
        For a text of another version of this package.
    """
    whole = json.loads(text)
    if whole.get("format") != FORMAT:
        raise InputError(
            f"worker {platform.node()}: {FORMAT!r} is read there, {whole.get('format')!r} found:"
            " install the same version of mechanics everywhere"
        )
    written, program = (read(json.dumps(whole[name])) for name in ("written", "program"))
    size, count = whole["sizes"]
    code = Routine(RATE, written, (("y", size), ("held", count)), (("yd", (size, 1)),))
    name, by, budget = whole["method"]
    return Task(Held(code, program), whole["moving"], Method(name, by, budget),
                np.array(whole["times"]))  # fmt: skip


def integrate(text: str, start: Array, held: Array) -> Found:
    """On a worker: compile what is not compiled yet on this machine, and integrate.

    Raises
    ------
    CompilerError
        If there is no C compiler here, or it refuses the code.
    """
    task = from_text(text)
    return integrated(
        _library(text), task.method, np.ascontiguousarray(start), np.ascontiguousarray(held),
        task.times, 1,
    )  # fmt: skip


@lru_cache(maxsize=8)
def _library(text: str) -> Library:
    compiler = find_compiler()
    if compiler is None:
        raise CompilerError(
            f"machine {platform.node()}: it has no C compiler, which an ensemble in a folder or by"
            " an executor needs: install gcc or clang there, or set CC to one"
        )
    task = from_text(text)
    return Library(task.held, task.moving, compiler, SOURCES[task.method.name], load_shared)


@cache
def machine() -> str:
    """What rounds here: processor and compiler. Where they are equal, so are all bits."""
    compiler = find_compiler()
    words = [platform.machine()]
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.exists():
        lines = cpuinfo.read_text(encoding="utf-8", errors="replace").splitlines()
        flags = next((line for line in lines if line.startswith(("flags", "Features"))), "")
        words.append(f"features {sha256(flags.encode()).hexdigest()[:8]}")
    if compiler is not None:
        said = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=False)
        words.append((said.stdout.splitlines() or [compiler])[0])
    return ", ".join(words)
