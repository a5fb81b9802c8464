"""The known mistakes, one entry each."""

from collections.abc import Callable, Iterator

from mechanics.blame.mistakes import friction, held, inertia, loads, speeds, substituted
from mechanics.blame.mistakes.slip import Right, Slip

KNOWN: tuple[Callable[[Right], Iterator[Slip]], ...] = (
    loads.slips,
    friction.slips,
    inertia.slips,
    speeds.slips,
    held.slips,
    substituted.slips,
)
"""Mistakes of a whole derivation; those of one equation are in `turning`."""
