"""A program as a machine runs it: its values in the order of evaluation, its inputs in arrays.

    node k = operation(earlier nodes)        outputs[o][e] = node        f(q[2], p[5]) -> ud[2]

A canonical program has no order of its own, and equal programs are one; of a routine, C is printed
statement by statement, and every operation is rounded as it stands.
"""

from array import array
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from mechanics.program.branches import Choice, Parts, build
from mechanics.program.builder import Builder
from mechanics.program.builder import Node as Built
from mechanics.program.interpret import interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.program.operations import ARITY, CONSTANT, DIVIDE, INPUT, OPERATIONS, SELECT
from mechanics.program.program import Program, reachable

Sizes = tuple[tuple[str, int], ...]
Shapes = tuple[tuple[str, tuple[int, int]], ...]


class Node(NamedTuple):
    """One value: its operation in the table, and earlier nodes; (array, entry) for an input."""

    operation: int
    operands: tuple[int, ...]
    constant: Fraction | None = None


@dataclass(frozen=True)
class Routine:
    """A program with the arrays of a function.

    Attributes
    ----------
    program : Program
        Its inputs are the entries of all arrays, one after the other; its outputs stand by name.
    inputs : tuple of (str, int)
        Name and number of entries of each input.
    shapes : tuple of (str, (int, int))
        Name and shape of each output, whose entries stand column by column.
    """

    name: str
    program: Program
    inputs: Sizes
    shapes: Shapes

    @cached_property
    def nodes(self) -> tuple[Node, ...]:
        """The values in the order of evaluation."""
        code, (first, second, third) = self.program, self.program.operands
        places = [(i, k) for i, (_, size) in enumerate(self.inputs) for k in range(size)]
        found = []
        for number, operation in enumerate(code.operations):
            if operation == CONSTANT:
                found.append(Node(operation, (), code.constants[first[number]]))
            elif operation == INPUT:
                found.append(Node(operation, places[first[number]]))
            else:
                operands = (first[number], second[number], third[number])[: ARITY[operation]]
                found.append(Node(operation, operands))
        return tuple(found)

    @property
    def outputs(self) -> tuple[tuple[int, ...], ...]:
        """Node of each entry of each output."""
        return tuple(self.program.outputs[name] for name, _ in self.shapes)

    @property
    def operations(self) -> int:
        """Number of arithmetic operations and function calls."""
        return self.program.count

    @property
    def divisions(self) -> int:
        """Number of divisions."""
        return self.program.operations.count(DIVIDE)

    def operands(self, number: int) -> tuple[int, ...]:
        """Nodes that a node is computed from; none for an input."""
        node = self.nodes[number]
        return () if node.operation == INPUT else node.operands


def entries_of(inputs: Sizes) -> tuple[str, ...]:
    """Names of the entries of arrays: ``q[0]``, ``q[1]``, ..."""
    return tuple(f"{name}[{k}]" for name, size in inputs for k in range(size))


def routine(
    name: str,
    nodes: Sequence[Node],
    outputs: Sequence[Sequence[int]],
    inputs: Sizes,
    shapes: Shapes,
) -> Routine:
    """The routine of nodes in the order of evaluation."""
    starts = np.cumsum([0, *(size for _, size in inputs)]).tolist()
    columns = array("i"), array("i"), array("i")
    constants: list[Fraction] = []
    for node in nodes:
        row = [*node.operands, 0, 0, 0][:3]
        if node.operation == CONSTANT:
            row = [len(constants), 0, 0]
            constants.append(node.constant or Fraction(0))
        elif node.operation == INPUT:
            row = [starts[node.operands[0]] + node.operands[1], 0, 0]
        for column, place in zip(columns, row, strict=True):
            column.append(place)
    stored = {out: tuple(places) for (out, _), places in zip(shapes, outputs, strict=True)}
    operations = bytes(node.operation for node in nodes)
    program = Program(entries_of(inputs), operations, columns, tuple(constants), (), stored)
    return Routine(name, program, tuple(inputs), tuple(shapes))


def built(
    name: str,
    builder: Builder,
    outputs: Mapping[str, Sequence[Built]],
    inputs: Sizes,
    shapes: Shapes,
) -> Routine:
    """The routine of nodes of a builder, in the order in which they were made."""
    operations, (first, second, third) = builder.operations, builder.operands
    roots = [node.number for nodes in outputs.values() for node in nodes]
    needed = reachable(builder, roots)
    new = {number: k for k, number in enumerate(needed)}
    place = {f"{array}[{k}]": (i, k) for i, (array, size) in enumerate(inputs) for k in range(size)}
    nodes: list[Node] = []
    for n in needed:
        code = operations[n]
        if code == CONSTANT:
            nodes.append(Node(code, (), builder.constants[first[n]]))
        elif code == INPUT:
            nodes.append(Node(code, place[builder.inputs[first[n]]]))
        else:
            operands = (first[n], second[n], third[n])[: ARITY[code]]
            nodes.append(Node(code, tuple(new[operand] for operand in operands)))
    stored = [[new[node.number] for node in outputs[out]] for out, _ in shapes]
    return routine(name, nodes, stored, inputs, shapes)


def nodes_of(
    builder: Builder,
    code: Routine,
    inputs: Mapping[str, Sequence[Built]],
    wanted: Sequence[int],
    constants: Mapping[Fraction, Built] | None = None,
) -> tuple[Built, ...]:
    """Some values of a routine as nodes of a builder, each branch under its condition.

    Parameters
    ----------
    inputs : mapping of str to sequence of Node
        Entries of the arrays that are needed.
    constants : mapping of Fraction to Node, optional
        What some of its constants stand for.
    """
    stand_for = constants or {}

    def expand(number: int) -> Parts | Choice:
        operation, operands, constant = code.nodes[number]
        if constant is not None:
            found = stand_for.get(constant)
            node = builder.constant(constant) if found is None else found
            return Parts((), lambda: node.number)
        if operation == INPUT:
            array, entry = operands
            return Parts((), lambda: inputs[code.inputs[array][0]][entry].number)
        if operation == SELECT:
            return Choice(*operands)
        name = OPERATIONS[operation].name

        def apply(*numbers: int) -> int:
            return builder.call(name, *(Built(builder, n) for n in numbers)).number

        return Parts(operands, apply)

    return build(builder, wanted, expand)


def run(code: Routine, columns: Sequence[Sequence[Any]], kind: type) -> list[tuple[Any, ...]]:
    """Evaluate with NumPy at many states at once, every operation rounded to `kind`.

    Parameters
    ----------
    columns : for every input, for every entry, an array of its values, or a scalar
    kind : NumPy floating type
        float32, float64 or longdouble.

    Returns
    -------
    For every output, for every entry, an array or scalar.
    """
    values = _interpreted(code.program, columns, kind)
    return [values[name] for name, _ in code.shapes]


def every_value(code: Routine, columns: Sequence[Sequence[Any]], kind: type) -> tuple[Any, ...]:
    """All values in the order of evaluation; see `run`."""
    every = replace(code.program, outputs={"every": tuple(range(len(code.program)))})
    return _interpreted(every, columns, kind)["every"]


def _interpreted(
    program: Program, columns: Sequence[Sequence[Any]], kind: type
) -> dict[str, tuple[Any, ...]]:
    flat: list[Any] = [np.asarray(column, dtype=kind) for group in columns for column in group]
    inputs = dict(zip(program.inputs, flat, strict=True))
    with np.errstate(all="ignore"):
        return interpret(program, Arrays(kind), inputs, release=False)
