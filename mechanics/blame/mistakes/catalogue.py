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
from mechanics.blame.mistakes.fault_model import Fault, Right

KNOWN: tuple[Callable[[Right], Iterator[Fault]], ...] = (
    loads.faults,
    friction.faults,
    inertia.faults,
    speeds.faults,
    forgotten_constraints.faults,
    substituted_constraint.faults,
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
    def faults(self) -> tuple[Fault, ...]:
        """Every known mistake that its scene lets one make."""
        return tuple(fault for known in KNOWN for fault in known(self.right))
