"""A CasADi function called through its buffers, which costs microseconds and not fifty of them."""

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.machine.virtual import VirtualKernel

Array = NDArray[np.float64]


class Call:
    """Outputs of a CasADi function as arrays, from its inputs, which are columns."""

    def __init__(self, function: ca.Function) -> None:
        self._inputs = [np.zeros(function.numel_in(i)) for i in range(function.n_in())]
        # CasADi keeps matrices column by column.
        sizes = [function.size_out(i) for i in range(function.n_out())]
        self._outputs = [np.zeros(size, order="F") for size in sizes]
        flat = [out.reshape(-1, order="F") for out in self._outputs]
        self._run = VirtualKernel(function).bound(self._inputs, flat)

    def __call__(self, *groups: Array) -> list[Array]:
        """Values of the outputs, new arrays, for values of the inputs."""
        for cell, group in zip(self._inputs, groups, strict=True):
            cell[:] = group
        self._run()
        return [out.copy() for out in self._outputs]
