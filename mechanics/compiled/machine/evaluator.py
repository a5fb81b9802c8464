"""What evaluates a graph: machine code where there is a compiler, else CasADi or NumPy.

Compiler settings trade speed for accuracy and belong to the evaluator: with -ffast-math the
operations are no longer those of the graph, one rounding each, in its order.
"""

import casadi as ca
import numpy as np

from mechanics.compiled.c.source import Entries
from mechanics.compiled.machine.native import NativeKernel
from mechanics.compiled.machine.virtual import NumpyKernel, VirtualKernel
from mechanics.program.routine import Routine

Kernel = NativeKernel | VirtualKernel | NumpyKernel

FLAGS = ("-O2", "-O3 -march=native", "-O3 -march=native -ffast-math")
"""Compiler settings that are compared with each other; the first is the default."""


def evaluator(
    function: ca.Function | None,
    code: Routine,
    entries: Entries,
    kind: type[np.floating],
    compiler: str | None,
    flags: str = FLAGS[0],
) -> Kernel:
    """The evaluator of a function in a precision; C is compiled here.

    Parameters
    ----------
    function : casadi.Function or None
        Dense SX function; None where there is a program only.
    code : Routine
        Its instructions.
    entries : mapping of str to tuple of str
        For each input the names of its entries.
    kind : numpy.float64 or numpy.float32
    compiler : str or None
        Without a compiler, doubles run on CasADi's virtual machine and singles in NumPy.
    flags : str
        For the compiler, as in `FLAGS`; other settings are passed on as they are.
    """
    if compiler is not None:
        return NativeKernel(code, entries, kind, compiler, flags)
    if function is not None and kind is np.float64:
        return VirtualKernel(function)
    return NumpyKernel(code, kind)
