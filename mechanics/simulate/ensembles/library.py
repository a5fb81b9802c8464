"""A method for a model as machine code: composed, compiled once, called on several threads.

Every thread takes a part of the motions, one behind the other, and memory of its own. A motion is
computed in the same way wherever it stands, so the results do not depend on the parts.
"""

import ctypes
from collections.abc import Callable, Hashable, Sequence
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from weakref import WeakKeyDictionary

import casadi as ca
import numpy as np

from mechanics.compiled.machine.library import load
from mechanics.compiled.machine.native import affordable
from mechanics.compiled.machine.vectorised import settings
from mechanics.compiled.model import Model
from mechanics.simulate.ensembles.text import text
from mechanics.simulate.integrators.rate import rate_function

Source = Callable[[ca.Function], str]

ALIGNED = 64
"""Bytes of the widest vectors."""
# Products that are added are one operation where the machine has it.
FUSED = "-ffp-contract=fast"

_functions: WeakKeyDictionary[Model, ca.Function] = WeakKeyDictionary()
_libraries: WeakKeyDictionary[Model, dict[Hashable, "Library"]] = WeakKeyDictionary()


def ensemble_function(model: Model) -> ca.Function:
    """``rate(y, held)``: y' from the state, with t as its last entry if it is held, and the rest.

    What is held are the inputs without t, and the parameters.
    """
    if model not in _functions:
        function, names = rate_function(model), model.entries["inputs"]
        y, w, p = function.sx_in()
        state, given = y, w
        rates = function(y, w, p)
        if timed(model):
            time = w[names.index("t")]
            state, rates = ca.vertcat(y, time), ca.vertcat(rates, 1)
            given = ca.vertcat(*(w[i] for i, name in enumerate(names) if name != "t"))
        held = ca.vertcat(given, p)
        _functions[model] = ca.Function(
            "rate", [state, held], [ca.densify(rates)], ["y", "held"], ["yd"]
        )
    return _functions[model]


def timed(model: Model) -> bool:
    """Whether the time is among the inputs."""
    return "t" in model.entries["inputs"]


class Library:
    """A compiled method.

    Parameters
    ----------
    function : casadi.Function
        y' from the state and from what is held.
    moving : int
        Entries of the state whose errors count: the first ones.
    compiler : str
    source : callable
        Of the function, to C text that follows the arithmetic of lanes.

    Attributes
    ----------
    text, flags : str
        What was compiled, and how.

    Raises
    ------
    CompilerError
        If the compiler refuses the code; the message carries its words.
    """

    def __init__(self, function: ca.Function, moving: int, compiler: str, source: Source) -> None:
        size, held = function.numel_in(0), function.numel_in(1)
        self.text = "\n".join([
            text("lanes.h"),
            f"enum {{ SIZE = {size}, HELD = {held}, MOVING = {moving} }};",
            source(function),
        ])  # fmt: skip
        self.flags = f"{affordable(settings(compiler), function.n_instructions())} {FUSED}"
        library = load(self.text, compiler, self.flags)
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
        threads : int
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


def library(model: Model, key: Hashable, source: Source) -> Library:
    """The method for a model that has a compiler, kept with it.

    Parameters
    ----------
    key : hashable
        Of the method.
    """
    known = _libraries.setdefault(model, {})
    if key not in known:
        function = ensemble_function(model)
        moving = function.numel_in(0) - timed(model)
        known[key] = Library(function, moving, model.compiler or "", source)
    return known[key]
