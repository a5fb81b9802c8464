"""The known mistakes, one entry each."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property

from mechanics.blame.mistakes import (
    forgotten_constraints,
    friction,
    inertia,
    loads,
    speeds,
    substituted_constraint,
)
from mechanics.blame.mistakes.fault_model import Right, Slip

KNOWN: tuple[Callable[[Right], Iterator[Slip]], ...] = (
    loads.slips,
    friction.slips,
    inertia.slips,
    speeds.slips,
    forgotten_constraints.slips,
    substituted_constraint.slips,
)
"""Mistakes of a whole derivation; those of one equation are in `turning`."""


@dataclass(frozen=True, eq=False, repr=False)
class Mistakes:
    """The known mistakes of one derivation.

    Attributes
    ----------
    right : Right
    """

    right: Right

    @cached_property
    def slips(self) -> tuple[Slip, ...]:
        """Every known mistake that its scene lets one make."""
        return tuple(slip for known in KNOWN for slip in known(self.right))
