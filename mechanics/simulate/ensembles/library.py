"""A method for a model as machine code: composed, compiled once, called on several threads.

Every thread takes a part of the motions, one behind the other, and memory of its own. A motion is
computed in the same way wherever it stands, so the results do not depend on the parts.
"""

import ctypes
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise

import numpy as np

from mechanics.compiled.machine.library import load
from mechanics.compiled.machine.native import affordable
from mechanics.compiled.machine.vectorised import settings
from mechanics.compiled.right_hand_side import Held
from mechanics.simulate.ensembles.text import text

Source = Callable[[Held], str]
Loader = Callable[[str, str, str], ctypes.CDLL]

ALIGNED = 64
"""Bytes of the widest vectors."""
# Products that are added are one operation where the machine has it.
FUSED = "-ffp-contract=fast"


class Library:
    """A compiled method.

    Parameters
    ----------
    of : Held
        y' from the state and from what is held.
    moving : int
        Entries of the state whose errors count: the first ones.
    source : callable
        Of the function, to C text that follows the arithmetic of lanes.
    loaded : callable
        Of that text, the compiler and its settings, to a library.

    Attributes
    ----------
    text, flags : str
        What was compiled, and how.

    Raises
    ------
    CompilerError
        If the compiler refuses the code; the message carries its words.
    """

    def __init__(
        self, of: Held, moving: int, compiler: str, source: Source, loaded: Loader = load
    ) -> None:
        size, held = of.sizes
        self.text = "\n".join([
            text("lanes.h"),
            f"enum {{ SIZE = {size}, HELD = {held}, MOVING = {moving} }};",
            source(of),
        ])  # fmt: skip
        self.flags = f"{affordable(settings(compiler), of.routine.operations)} {FUSED}"
        library = loaded(self.text, compiler, self.flags)
        self._march = library.mechanics_march
        self._march.restype = None
        library.mechanics_room.restype = ctypes.c_int64
        self._room = int(library.mechanics_room())

    def march(
        self, per_motion: Sequence[np.ndarray], call: Callable[..., None], threads: int
    ) -> None:
        """Call the function for parts of the motions.

        Parameters
        ----------
        per_motion : arrays with one row a motion, contiguous
        call : callable
            Of the C function, the number of motions, addresses of their rows, and of memory.
        """
        count = len(per_motion[0])
        bounds = np.linspace(0, count, threads + 1).astype(int).tolist()

        def part(first: int, last: int) -> None:
            memory = np.empty(self._room + ALIGNED, dtype=np.uint8)
            address = memory.ctypes.data
            rows = [at(array[first:last]) for array in per_motion]
            room = ctypes.c_void_p(address + -address % ALIGNED)
            call(self._march, ctypes.c_int64(last - first), rows, room)

        spans = [(a, b) for a, b in pairwise(bounds) if b > a]
        if len(spans) == 1:
            part(*spans[0])
            return
        with ThreadPoolExecutor(len(spans) or 1) as pool:
            for done in [pool.submit(part, *span) for span in spans]:
                done.result()


def at(array: np.ndarray) -> ctypes.c_void_p:
    """Address of an array."""
    return ctypes.c_void_p(array.ctypes.data)
