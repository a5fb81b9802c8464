"""A step, stage by stage: its graph is cut at every slope.

    k1 = f(y),    k2 = f(y + h/2 K1),    k3 = f(y + h/2 K2),    k4 = f(y + h K3)
    y(t + h) = y + h/6 (K1 + 2 K2 + 2 K3 + K4)                         for every K

The degree of a step is that of f to the fourth power, and with eight freedoms beyond every prime;
that of each of these equations is the degree of f. The slopes are found in the graph by their
values at a point of a finite field, which proposes only: what holds for every K holds for the
slopes that the graph has. A slope that is not found stays what f says.

Source: cuts at internal equivalences, Kuehlmann and Krohm, Equivalence checking using cuts and
heaps, DAC 1997.
"""

from collections.abc import Iterator, Mapping, Sequence

from mechanics.compiled.translation_validation.code import Code
from mechanics.compiled.translation_validation.physics import Entry, Physics
from mechanics.compiled.translation_validation.step import composed
from mechanics.program import Builder, Node
from mechanics.program.interpret import Nodes
from mechanics.program.operations import ARITY, OPERATIONS
from mechanics.program.program import reachable
from mechanics.program.residues import Residues


def cut_at_slopes(
    physics: Physics, outputs: Mapping[str, Sequence[Node]], rates: Code
) -> Iterator[Entry]:
    """The equations above.

    Parameters
    ----------
    outputs : mapping of str to sequence of Node
        Of the graph of the step.
    rates : Code
        From q, u, inputs, p to qd and ud.
    """
    builder, given, time = physics.builder, physics.inputs, physics.known.time
    slopes: list[Node] = []

    def noted(found: list[Node]) -> list[Node]:
        slopes.extend(found)
        return found

    composed(builder, rates, time, given, noted)
    ends = [node for nodes in outputs.values() for node in nodes]
    places = _places(builder, ends, slopes)
    unknowns: dict[int, Node] = {}
    entries: list[Entry] = []
    before = 0

    def cut(stage: list[Node]) -> list[Node]:
        nonlocal before
        here = {i: places[before + i] for i in range(len(stage)) if before + i in places}
        before += len(stage)
        parts = _replaced(builder, [place for place, _ in here.values()], unknowns)
        free = list(stage)
        for (i, (place, sign)), part in zip(here.items(), parts, strict=True):
            entries.append((f"slope {before + i}", part * sign, stage[i]))
            unknowns[place.number] = builder.input(f"slope at {place.number}")
            free[i] = unknowns[place.number] * sign
        return free

    expected = composed(builder, rates, time, given, cut)
    yield from entries
    sides = iter(_replaced(builder, ends, unknowns))
    for output, nodes in expected.items():
        for i, node in enumerate(nodes):
            yield f"{output}[{i}]", next(sides), node


def _places(
    builder: Builder, ends: Sequence[Node], slopes: Sequence[Node]
) -> dict[int, tuple[Node, int]]:
    """Where the graph has a slope, and with which sign, by the number of the slope."""
    numbers = reachable(builder, [node.number for node in ends])
    inner = [Node(builder, n) for n in numbers if ARITY[builder.operations[n]]]
    residues = Residues(builder)
    places: dict[int, tuple[Node, int]] = {}
    for node, value in zip(inner, residues.values(inner), strict=True):
        places.setdefault(-value % residues.prime, (node, -1))
        if places.get(value, (node, -1))[1] < 0:
            places[value] = node, 1
    values = residues.values(list(slopes))
    return {i: places[value] for i, value in enumerate(values) if value and value in places}


def _replaced(
    builder: Builder, nodes: Sequence[Node], unknowns: Mapping[int, Node]
) -> list[Node]:  # fmt: skip
    """The nodes with unknowns for some inner ones, by their numbers."""
    operations, values = Nodes(builder).operations, dict(unknowns)
    for number in reachable(builder, [node.number for node in nodes]):
        if number not in values:
            operands = [values[n] for n in builder.operands_of(number)]
            name = OPERATIONS[builder.operations[number]].name
            values[number] = operations[name](*operands) if operands else Node(builder, number)
    return [values[node.number] for node in nodes]
