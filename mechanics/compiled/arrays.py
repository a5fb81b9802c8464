"""The arrays of a model as graphs: their entries, and the numbers that no double holds."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import casadi as ca
import sympy

from mechanics.compiled.quantities import STATE, Quantities
from mechanics.program.casadi_printer import nearest

GROUPS = (*STATE, "ud", "multipliers")


@dataclass(frozen=True, eq=False)
class Arrays:
    """Columns of graph symbols, and named constants.

    Attributes
    ----------
    quantities : Quantities
        What the entries are.
    columns : mapping of str to casadi.SX
        By name, with the step h.
    constants : dict of Expr to casadi.SX
        Numbers that no double holds, as they are found.
    """

    quantities: Quantities
    columns: Mapping[str, ca.SX]
    constants: dict[sympy.Expr, ca.SX] = field(default_factory=dict)

    @cached_property
    def table(self) -> dict[sympy.Symbol, ca.SX]:
        """The entry of each symbol."""
        return {
            entry.symbol: self.columns[name][i]
            for name in GROUPS
            for i, entry in enumerate(getattr(self.quantities, name))
        }

    @property
    def named(self) -> ca.SX:
        """The named constants as a column."""
        return ca.vertcat(*self.constants.values()) if self.constants else ca.SX(0, 1)

    def bound(self, graphs: list[ca.SX]) -> list[ca.SX]:
        """Graphs with the nearest doubles in place of named constants."""
        if not self.constants:
            return graphs
        values = ca.DM([nearest(constant) for constant in self.constants])
        return ca.substitute(graphs, [self.named], [ca.SX(values)])


def arrays_of(quantities: Quantities) -> Arrays:
    """New graph symbols for every entry."""
    sizes = {name: len(getattr(quantities, name)) for name in GROUPS} | {"h": 1}
    return Arrays(quantities, {name: ca.SX.sym(name, size) for name, size in sizes.items()})
