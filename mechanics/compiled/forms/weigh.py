"""What speaks for one way to write a solution: few operations, and few digits lost.

    weight = operations * 2^digits        digits: decimal ones beyond `ROUNDINGS`, rounded up

A division counts as two operations. A form that loses a digit more, at the wildest states that are
tried, has to take less than half of the operations.
"""

from collections.abc import Iterable
from math import ceil, inf, isfinite, log10

import casadi as ca

from mechanics.compiled.forms.operations import operations
from mechanics.compiled.forms.system import System

ROUNDINGS = 8.0
"""Backward error that no form is blamed for, in roundings."""

MOST = 8
"""Digits beyond which it makes no difference: the equations are singular at some of the states."""


def digits_lost(error: float) -> float:
    """Decimal digits beyond the roundings that are allowed, in whole numbers, at most `MOST`.

    Infinite where at one of the states there is no solution at all.
    """
    if not isfinite(error):
        return inf
    return min(ceil(log10(max(error / ROUNDINGS, 1.0))), MOST)


def lightest(system: System, graphs: Iterable[ca.SX]) -> ca.SX:
    """The graph of least weight; errors are tried only as long as they can decide.

    Where K is not written out, operations decide.
    """
    counted = sorted(((operations(graph), graph) for graph in graphs), key=lambda pair: pair[0])
    best, least = counted[0][1], inf
    if not system.small:
        return best
    for count, graph in counted:
        if count >= least:
            break
        weight = count * 2.0 ** digits_lost(system.error(graph))
        if weight < least:
            best, least = graph, weight
    return best
