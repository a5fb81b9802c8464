"""A CasADi graph called through its buffers, which costs microseconds and not fifty of them."""

from collections.abc import Sequence

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.machine.virtual import VirtualKernel

Array = NDArray[np.float64]


class Call:
    """Outputs as a function of the columns `inputs`.

    Parameters
    ----------
    inputs : sequence of casadi.SX
        Columns of symbols.
    *outputs : casadi.SX
        Dense graphs in these symbols.
    """

    def __init__(self, inputs: Sequence[ca.SX], *outputs: ca.SX) -> None:
        self._inputs = [np.zeros(group.numel()) for group in inputs]
        # CasADi keeps matrices column by column.
        self._outputs = [np.zeros(out.shape, order="F") for out in outputs]
        flat = [out.reshape(-1, order="F") for out in self._outputs]
        function = ca.Function("bound", list(inputs), list(outputs))
        self._run = VirtualKernel(function).bound(self._inputs, flat)

    def __call__(self, *groups: Array) -> list[Array]:
        """Values of the outputs, new arrays, for values of the inputs."""
        for cell, group in zip(self._inputs, groups, strict=True):
            cell[:] = group
        self._run()
        return [out.copy() for out in self._outputs]
