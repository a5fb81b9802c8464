"""What the texts of a folder say of its functions: names, units and meanings of entries, programs.

Headers, loader and manifest are printed from this. Who writes a folder takes it of the model; who
verifies one, of a scene that was derived again and of the graphs of the folder.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sympy import Symbol

from mechanics.compiled import Model
from mechanics.compiled.graphs import STATE
from mechanics.compiled.programs.hoist import CONSTANTS, PREPARE
from mechanics.compiled.programs.of_model import PARTS
from mechanics.compiled.quantities import Quantities, Quantity
from mechanics.errors import ValueMissingError
from mechanics.program.operations import DIVIDE, INPUT
from mechanics.program.routine import Routine

ARRAYS = {
    "q": "generalized coordinates q",
    "u": "generalized speeds u",
    "ud": "rates of the speeds, u'",
    "inputs": "inputs",
    "p": "parameters",
    "c": "constants: what prepare makes of the parameters",
    "multipliers": "multipliers: reactions that maintain the constraints",
    "reactions": "reactions",
    "h": "time",
}
"""Every array that a function may read or write, with its title."""


@dataclass(frozen=True)
class Contents:
    """What is said of the functions of a folder.

    Attributes
    ----------
    arrays : mapping of str to tuple of Quantity
        Entries of the arrays that the functions read or write, in the order of `ARRAYS`.
    typical : tuple of float
        Of the parameters; empty where one has none.
    fixed : mapping of str to str
        Exact values of parameters that are numbers.
    programs : mapping of str to Routine
        What the functions are printed from.
    divisions : int
        Of all functions before divisors were shared.
    """

    scene: str
    route: str
    arrays: Mapping[str, tuple[Quantity, ...]]
    typical: tuple[float, ...]
    fixed: Mapping[str, str]
    programs: Mapping[str, Routine]
    divisions: int

    def names(self, function: str) -> dict[str, tuple[str, ...]]:
        """Names of the entries of every input of a function."""
        groups = [group for group, _ in self.programs[function].inputs]
        return {group: tuple(entry.name for entry in self.arrays[group]) for group in groups}


def contents_of(model: Model, names: Sequence[str]) -> Contents:
    """What a model says of its functions."""
    programs = {name: model.program(name) for name in names}
    graphs = [model.casadi.routine(name) for name in names if name not in PARTS]
    fixed = {name: str(value) for name, value in sorted(model.fixed.items())}
    return of_quantities(
        model.equations.scene.name, model.equations.route, model.quantities, fixed, programs,
        sum(graph.divisions for graph in graphs),
    )  # fmt: skip


def of_quantities(
    scene: str,
    route: str,
    quantities: Quantities,
    fixed: Mapping[str, str],
    programs: Mapping[str, Routine],
    divisions: int,
) -> Contents:
    """The same from its parts, see `Contents`."""
    used = {*STATE}
    for code in programs.values():
        used |= {array for array, _ in (*code.inputs, *code.shapes)}
    arrays = {
        array: _constants(programs[PREPARE], quantities.p)
        if array == CONSTANTS
        else getattr(quantities, array)
        for array in ARRAYS
        if array in used
    }
    try:
        typical = quantities.typical
    except ValueMissingError:
        typical = ()
    return Contents(scene, route, arrays, typical, fixed, programs, divisions)


def _constants(prepare: Routine, p: Sequence[Quantity]) -> tuple[Quantity, ...]:
    """The entries of c: parameters that are passed on, and values without a unit of theirs."""
    found: list[Quantity] = []
    for place, at in enumerate(prepare.outputs[0]):
        node = prepare.nodes[at]
        inverted = node.operation == DIVIDE and prepare.nodes[node.operands[0]].constant == 1
        of = prepare.nodes[node.operands[1]] if inverted else node
        passed = of.operation == INPUT and of.constant is None
        own = p[of.operands[1]] if passed else None
        if own is not None and not inverted:
            found.append(own)
        else:
            name = f"c{place}" if own is None else f"over_{own.name}"
            found.append(Quantity(Symbol(name), "", "made of parameters"))
    return tuple(found)
