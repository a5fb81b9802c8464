"""Many states at once, with nothing between the arrays and the batch kernel.

    model.forward_dynamics(q, u, p)        (batch, n) arrays of doubles, of any strides

Whatever else is given (lists, fewer states, parameters of their own, a wrong shape), and whatever a
check would refuse, is left to the way that converts, checks and explains.
"""

from typing import Any

from mechanics.compiled.calls.functions import Functions
from mechanics.compiled.calls.many_states import MANY
from mechanics.compiled.calls.one_state import Call, standards
from mechanics.compiled.machine.direct import direct_calls

DYNAMICS = "forward_dynamics"


class ManyStates(dict[tuple[bool, bool], Call]):
    """Forward dynamics, each variant made ready when it is first called.

    With a check or without, and with one array of inputs for all states or one for each.
    """

    def __init__(self, model: Functions) -> None:
        super().__init__()
        self._model = model

    def __missing__(self, variant: tuple[bool, bool]) -> Call:
        def first(*arrays: Any) -> Any:
            if len(arrays[0]) < MANY:
                return None
            self[variant] = _call(self._model, *variant)
            return self[variant](*arrays)

        return first


def _never(*arrays: Any) -> None:
    """Where there is nothing faster."""


def _call(model: Functions, checked: bool, one_input: bool) -> Call:
    code = model.program(DYNAMICS)
    shared = ("p", "inputs") if one_input else ("p",)
    kernel = model.batch_kernel(DYNAMICS, shared=shared, checked=checked)
    sizes = [rows * cols for _, (rows, cols) in code.shapes]
    extension = None if model.compiler is None else direct_calls(model.compiler).module
    # Multipliers are an output of their own.
    if kernel is None or extension is None or any(sizes[1:]):
        return _never
    known = dict(standards(model))
    inputs = tuple((size, group in shared, known.get(group)) for group, size in code.inputs)
    return extension.States(kernel.address, inputs, sizes[0], MANY, checked, kernel)
