"""The form of forward dynamics that takes the fewest operations and rounds well.

    full(n) = n (n + 1)(n + 8)/3 - 4 n      operations of L D L^T of a full n x n system

A form that starts from the bodies needs no matrix. Where there are many unknowns and it takes fewer
operations than elimination alone would of a full matrix, that is not even written out; otherwise
both are, and counted.
"""

from collections.abc import Iterator
from contextlib import suppress

import casadi as ca

from mechanics.compiled.forms.members import (
    RECURSIVE,
    ROUNDINGS,
    SPARSE,
    Form,
    digits_lost,
    preferred,
)
from mechanics.compiled.forms.system import System
from mechanics.compiled.program import operations
from mechanics.errors import ExpressionError, SingularError

Written = tuple[Form, ca.SX]

FEW = 6
"""Unknowns up to which all forms are written out."""


def chosen(system: System) -> Written:
    """The form, and the graph of (u', lambda).

    The cheapest whose backward error is below `ROUNDINGS`; where none is, the cheapest of those
    that round best, to a decimal digit.
    """
    found = list(_from_bodies(system))
    n = len(system.equations.unknowns)
    if found and n > FEW and operations(found[0][1]) < full(n) and _trusted(system, found[0]):
        return found[0]
    usual = preferred(system.equations)
    found.append((usual, usual.solve(system)))
    if len(found) == 1:
        return found[0]
    found.sort(key=lambda written: operations(written[1]))
    errors = []
    for written in found:
        errors.append(system.error(written[1]))
        if errors[-1] < ROUNDINGS:
            return written
    return min(zip(found, errors, strict=True), key=lambda pair: digits_lost(pair[1]))[0]


def _from_bodies(system: System) -> Iterator[Written]:
    """What can be written without K; what cannot is left to the other forms."""
    for form in (RECURSIVE, SPARSE):
        if not form.inapplicable(system.equations):
            with suppress(ExpressionError, SingularError):
                yield form, form.solve(system)


def _trusted(system: System, written: Written) -> bool:
    """Whether it rounds well, or K has not been written out, which trying it would need."""
    return not system.equations.split or system.error(written[1]) < ROUNDINGS


def full(n: int) -> int:
    """Operations of L D L^T of a full system, a division counted twice.

    Step k, with k - 1 rows left, takes 2 (k - 1) for the factors, k (k - 1) for the entries,
    2 (k - 1) for the right side, and 2 + 2 (k - 1) to go back.
    """
    return n * (n + 1) * (n + 8) // 3 - 4 * n
