"""In which order edits are made: cost saved for error spent, level by level.

    d_k = (dy/dx_k) change_k / scale        error of edit k at a state, to first order           (1)
    k   in the order of max |d_k| / saved_k, as long as all of them keep within a level         (2)

Levels rise to what is allowed, and each goes on where the one before ended, so that what is made
for a small error is made for a larger one, too. States are drawn, and propose the order only;
whether edits keep within a level is measured by what bounds them at all states.
"""

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from mechanics.program import Builder, Node, Program
from mechanics.program import operations as op
from mechanics.program.derivatives import gradient
from mechanics.program.differences import with_one_difference
from mechanics.program.interpret import Nodes, interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.program.operations import ARITY, ENTRY, INPUT
from mechanics.program.program import reachable
from mechanics.reduce.edits import Edit, Edits, Kind, nodes, values
from mechanics.reduce.proof import Box

Array = NDArray[np.float64]

STATES, SEED = 256, 1
LEAST = -6
"""Decade of the first level."""
Measure = Callable[[Edits, float], Array]


@dataclass(frozen=True)
class Start:
    """What is to be reduced.

    Attributes
    ----------
    program : Program
        Without linear systems.
    box : mapping of str to (Fraction, Fraction)
    edits : tuple of Edit
        What may be done.
    """

    program: Program
    box: Box
    edits: tuple[Edit, ...]

    @property
    def numbers(self) -> dict[str, Fraction]:
        """Inputs that have one value."""
        return {name: low for name, (low, high) in self.box.items() if low == high}

    def reduced(self, edits: Mapping[int, Kind]) -> Program:
        """The program with edits made and numbers in it."""
        builder = Builder()
        found = nodes(self.program, builder, constants(builder, self.numbers), edits)
        outputs = {name: [found[k] for k in ns] for name, ns in self.program.outputs.items()}
        free = [name for name in self.program.inputs if name not in self.numbers]
        return with_one_difference(builder.program(outputs, free))


def constants(builder: Builder, numbers: Mapping[str, Fraction]) -> dict[str, Node]:
    """Numbers as nodes."""
    return {name: builder.constant(value) for name, value in numbers.items()}


def operations(program: Program) -> int:
    """Operations that depend on an input; what numbers alone decide is computed beforehand."""
    moving = bytearray(len(program))
    for number, code in enumerate(program.operations):
        moving[number] = code == INPUT or any(moving[k] for k in program.operands_of(number))
    codes = zip(program.operations, moving, strict=True)
    return sum(moves and ARITY[code] > 0 and code != ENTRY for code, moves in codes)


def states(box: Box) -> dict[str, Array]:
    """Values of the inputs at drawn states of a box, half of them in its corners."""
    draws = np.random.default_rng(SEED)
    found: dict[str, Array] = {}
    for name, (low, high) in sorted(box.items()):
        inner = draws.uniform(float(low), float(high), STATES)
        ends = np.where(draws.random(STATES) < 0.5, float(low), float(high))
        found[name] = np.where(np.arange(STATES) % 2, inner, ends)
    return found


def outputs_at(program: Program, inputs: Mapping[str, Array]) -> Array:
    """Outputs at states, (outputs, states)."""
    with np.errstate(all="ignore"):
        found = interpret(program, Arrays(), inputs)
        flat = [value for entries in found.values() for value in entries]
        return np.stack([np.broadcast_to(value, STATES) for value in flat])


def sequence(start: Start, unit: Array, error: float, measure: Measure) -> tuple[list[Edit], int]:
    """Edits in the order in which they are made, as many as keep within an error.

    Besides, how many more keep within it by themselves at all states that were drawn, while no
    bound of it is known.

    Parameters
    ----------
    unit : (outputs,) array
        What is one for the deviation of each output; 0 where it must not deviate at all.
    measure : callable
        Of edits and a level: what no deviation is larger than, for each output, well enough to
        know whether it is beyond the level in units; infinite where that is not known.
    """
    inputs = states(start.box)
    made: dict[int, Kind] = {}
    order: list[Edit] = []
    reached: list[float] = []
    refused: dict[Edit, float] = {}
    count = operations(start.reduced({}))

    def worst(trial: Edits, level: float) -> float:
        found = measure(trial, level)
        with np.errstate(all="ignore"):
            return float(np.max(np.where(found > 0, found / unit, 0.0), initial=0.0))

    for level in levels(error):
        for edit in _ranked(start, made, inputs, unit, level):
            # With more edits made, it will hardly take less than when it was too much.
            if refused.get(edit, 0.0) > level:
                continue
            trial = {**made, edit.node: edit.kind}
            fewer = operations(start.reduced(trial))
            if fewer >= count:
                continue
            now = worst(trial, level)
            if now > level:
                refused[edit] = now
                continue
            made, count = trial, fewer
            order.append(edit)
            reached.append(now)
    most = max((k for k, now in enumerate(reached, 1) if now <= error), default=0)
    unproved = sum(now > error and edit not in order for edit, now in refused.items())
    return order[:most], unproved


def levels(error: float) -> Iterator[float]:
    """0, then 1, 2 and 5 of each decade, the last of them not below the error."""
    yield 0.0
    for exponent in range(LEAST, 2):
        for digit in (1, 2, 5):
            level = float(f"{digit}e{exponent}")
            if level >= error:
                if error > 0:
                    yield level
                return
            yield level


def _ranked(
    start: Start, made: Edits, inputs: Mapping[str, Array], unit: Array, level: float
) -> list[Edit]:
    """Edits that save something and whose own error is not too large, equation (2)."""
    builder = Builder()
    images = nodes(start.program, builder, constants(builder, start.numbers), made)
    cost = Cost(builder, [images[k] for k in start.program.roots])
    left = [(e, cost.saved(start, images, e)) for e in start.edits if e.node not in made]
    left = [(edit, amount) for edit, amount in left if amount > 0]
    if not left:
        return []
    moved = _moved(start, made, inputs, [edit for edit, _ in left])
    with np.errstate(all="ignore"):
        sizes = np.where(moved != 0, np.abs(moved) / unit[:, None, None], 0.0).max(axis=(0, 2))
    sizes = np.where(np.isfinite(sizes), sizes, np.inf)
    # A few units of rounding are no error.
    small = sizes <= max(level, 1e-13)
    ranks = np.argsort(sizes / [amount for _, amount in left], kind="stable")
    return [left[k][0] for k in ranks if small[k]]


def _moved(
    start: Start, made: Mapping[int, Kind], inputs: Mapping[str, Array], edits: Sequence[Edit]
) -> Array:
    """Equation (1): (outputs, edits, states)."""
    program, builder = start.program, Builder()
    pushes = {edit.node: builder.input(f"push {edit.node}") for edit in edits}

    def pushed(number: int, node: Node) -> Node:
        return node + pushes[number] if number in pushes else node

    given = {name: builder.input(name) for name in program.inputs}
    found = values(program, Nodes(builder), given, made, pushed)
    wanted = [pushes[edit.node] for edit in edits]
    slopes = [slope for k in program.roots for slope in gradient([found[k]], [1], wanted)]
    changes = [_change(program, found, edit) for edit in edits]
    whole = builder.program({"slopes": slopes, "changes": changes})
    still = {node_name: np.zeros(STATES) for node_name in whole.inputs if node_name not in inputs}
    table = outputs_at(whole, {**inputs, **still})
    count = len(edits)
    with np.errstate(all="ignore"):
        return table[:-count].reshape(-1, count, STATES) * table[-count:]


def _change(program: Program, found: Sequence[Node], edit: Edit) -> Node:
    """What an edit adds to its node."""
    node = found[edit.node]
    operands = [found[k] for k in program.operands_of(edit.node)]
    if edit.kind is Kind.ZERO:
        return -node
    if edit.kind is Kind.ONE:
        return 1 - node
    if edit.kind is Kind.ANGLE:
        return operands[0] - node
    first, second = operands
    if edit.kind is Kind.SECOND:
        return -first
    return second if program.operations[edit.node] == op.SUBTRACT else -second


class Cost:
    """How many operations an edit takes away, from who needs what."""

    def __init__(self, builder: Builder, roots: Sequence[Node]) -> None:
        self.builder = builder
        self.needed = set(reachable(builder, [root.number for root in roots]))
        self.uses = Counter(
            k for number in self.needed for k in set(builder.operands_of(number))
        )  # fmt: skip
        self.uses.update(root.number for root in roots)

    def saved(self, start: Start, images: Sequence[Node], edit: Edit) -> int:
        """Operations that nothing needs afterwards; 0 where it changes nothing."""
        node = images[edit.node]
        if node.number not in self.needed or node.constant is not None:
            return 0
        kept = {images[k] for k in start.program.operands_of(edit.node)}
        kept = set() if edit.kind in (Kind.ZERO, Kind.ONE) else kept
        if edit.kind in (Kind.FIRST, Kind.SECOND):
            operands = [images[k] for k in start.program.operands_of(edit.node)]
            kept = {operands[edit.kind is Kind.SECOND]}
        if node in kept:
            return 0
        # A sum or product with what becomes a number is an operation less, too.
        above = self.uses[node.number] if edit.kind in (Kind.ZERO, Kind.ONE) else 0
        return above + self._cone(node.number, {k.number for k in kept})

    def _cone(self, top: int, kept: set[int]) -> int:
        """A node and what it alone needs."""
        builder, left, total = self.builder, Counter[int](), 0
        waiting = [top]
        while waiting:
            number = waiting.pop()
            total += ARITY[builder.operations[number]] > 0
            for k in set(builder.operands_of(number)) - kept:
                left[k] += 1
                if left[k] == self.uses[k]:
                    waiting.append(k)
        return total
