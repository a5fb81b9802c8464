"""One state at a time, with nothing between the arrays and the machine code.

    model.forward_dynamics(q, u, p)        NumPy arrays of doubles, one-dimensional and contiguous

Whatever else is given (lists, batches, names with values, a wrong shape), and whatever a check
would refuse, is left to the way that converts, checks and explains.
"""

from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from mechanics.compiled.c.status import WATCHED
from mechanics.compiled.calls.functions import Functions
from mechanics.compiled.graphs import MATRICES
from mechanics.compiled.machine.native import NativeKernel
from mechanics.errors import ValueMissingError

Call = Callable[..., Any]
"""Takes the arrays of the inputs, gives what was asked, or None."""


class Asked(NamedTuple):
    """What a call gives: outputs of a function, as a tuple where there are several."""

    function: str
    outputs: tuple[str, ...]
    checked: bool = False


CALLS: Mapping[str, Asked] = {
    "forward_dynamics": Asked("forward_dynamics", ("ud",), checked=True),
    "unchecked": Asked("forward_dynamics", ("ud",)),
    "multipliers": Asked("forward_dynamics", ("multipliers",), checked=True),
    "mass_matrix": Asked("mass_matrix", ("mass_matrix",)),
    "forcing": Asked("forcing", ("forcing",)),
    "residual": Asked("residual", ("residual",)),
    "inverse_dynamics": Asked("inverse_dynamics", ("forces",)),
    "coordinate_rates": Asked("coordinate_rates", ("qd",)),
    "energy": Asked("energy", ("kinetic", "potential", "total")),
}


class OneState(dict[str, Call]):
    """The calls by name, each made ready when it first gets a single state."""

    def __init__(self, model: Functions) -> None:
        super().__init__()
        self._model = model

    def __missing__(self, name: str) -> Call:
        def first(*arrays: Any) -> Any:
            if not all(a is None or (type(a) is np.ndarray and a.ndim == 1) for a in arrays):
                return None
            self[name] = _call(self._model, CALLS[name])
            return self[name](*arrays)

        return first


def _never(*arrays: Any) -> None:
    """Where there is nothing faster."""


def _call(model: Functions, asked: Asked) -> Call:
    name = f"{asked.function}{WATCHED}" if asked.checked else asked.function
    code, kernel = model.program(name), model.kernel(name)
    if not isinstance(kernel, NativeKernel) or kernel.extension is None:
        return _never
    known = dict(standards(model))
    return kernel.extension.Caller(
        kernel.address,
        tuple((size, known.get(group)) for group, size in code.inputs),
        tuple(
            (rows, columns, 2 if out in MATRICES else 1, out in asked.outputs)
            for out, (rows, columns) in code.shapes
        ),
        asked.checked,
        kernel,
    )


def standards(model: Functions) -> Iterator[tuple[str, np.ndarray]]:
    """Arrays that are used where none are given."""
    try:
        yield "p", model.typical
    except ValueMissingError:
        # It is named to whoever gives no parameters.
        return
