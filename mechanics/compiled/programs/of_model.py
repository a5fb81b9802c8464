"""The programs of a model, which C is printed from: CasADi graphs, written for speed.

NAME                        the graph, several quotients by one divisor with one division
prepare                     what forward dynamics use of the parameters only, c = h(p)
forward_dynamics_prepared   the rest of them, with c in place of p
NAME_watched                with what must be finite as one more output
"""

from collections.abc import Sequence
from functools import cached_property

from sympy import Symbol

from mechanics.compiled.c.status import WATCHED, with_watched
from mechanics.compiled.graphs import Graphs
from mechanics.compiled.programs.common_denominators import gathered
from mechanics.compiled.programs.hoist import CONSTANTS, PREPARE, PREPARED, Hoisted, hoisted
from mechanics.compiled.programs.reciprocals import with_reciprocals
from mechanics.compiled.quantities import Quantity
from mechanics.program.routine import Routine

WHOLE = "forward_dynamics"
"""The function that is there in two parts, too."""
PARTS = (PREPARE, f"{WHOLE}{PREPARED}")
"""Their names."""


class Programs:
    """Programs by name, each made when it is first asked for.

    Parameters
    ----------
    reciprocals : bool
        Whether quotients by one divisor are gathered where they are added, and several are
        products with its reciprocal.
    """

    def __init__(self, graphs: Graphs, reciprocals: bool = True) -> None:
        self._graphs, self.reciprocals = graphs, reciprocals
        self._made: dict[str, Routine] = {}
        self._names: dict[str, dict[str, tuple[str, ...]]] = {}

    def __getitem__(self, name: str) -> Routine:
        if name not in self._made:
            self._made[name] = self._program(name)
        return self._made[name]

    def _program(self, name: str) -> Routine:
        if name.endswith(WATCHED):
            return with_watched(self[name.removesuffix(WATCHED)])
        if name in PARTS:
            return self.hoisted.prepare if name == PREPARE else self.hoisted.prepared
        code = self._graphs.routine(name)
        return with_reciprocals(gathered(code)) if self.reciprocals else code

    @cached_property
    def hoisted(self) -> Hoisted:
        """Forward dynamics in two parts, the first of which depends on the parameters only."""
        return hoisted(self[WHOLE], self.entries)

    def written(self, names: Sequence[str] | None = None) -> tuple[str, ...]:
        """Names of functions to write: by default all; of the two parts, both or none."""
        if names is None:
            every = tuple(self._graphs)
            return (*every, *PARTS) if WHOLE in every and self.hoisted.names else every
        wholes = tuple(name for name in names if name not in PARTS)
        return (*wholes, *PARTS) if len(wholes) < len(names) else wholes

    @cached_property
    def constants(self) -> tuple[Quantity, ...]:
        """The entries of c: parameters that are passed on, and values without a unit of theirs."""
        known = {entry.name: entry for entry in self._graphs.quantities.p}
        return tuple(
            known.get(name, Quantity(Symbol(name), "", "made of parameters"))
            for name in self.hoisted.names
        )

    @cached_property
    def entries(self) -> dict[str, tuple[str, ...]]:
        """Names of the entries of every input but c."""
        groups = ("q", "u", "inputs", "p", "ud", "multipliers", "h")
        return {g: tuple(e.name for e in getattr(self._graphs.quantities, g)) for g in groups}

    def names(self, name: str) -> dict[str, tuple[str, ...]]:
        """Names of the entries of every input of a function."""
        if name not in self._names:
            groups = [group for group, _ in self[name].inputs]
            self._names[name] = {
                g: self.hoisted.names if g == CONSTANTS else self.entries[g] for g in groups
            }
        return self._names[name]
