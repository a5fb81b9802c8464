"""graphs.json: the functions as they were before they became C, operation by operation.

    {"functions": [["energy", 0, {...}], ...], "rates": 1, "exact": [...]}

    functions  what the C is printed from: its constants are doubles
    exact      the graphs that are proved, by number: constants are exact, or entries of the input
               ``constants``, whose values stand as a program

An operation is ["multiply", 3, 5], of earlier ones, by its name in the table of operations; a
constant is ["constant", "1/3"], entry 1 of the first input ["input", 0, 1].
"""

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from mechanics.compiled.translation_validation.code import Code
from mechanics.compiled.translation_validation.prove import Graph
from mechanics.errors import ExpressionError
from mechanics.export.evidence.equations import lines
from mechanics.export.evidence.values import NUMBER, index, read_values, reading, values_record
from mechanics.program.constants import is_double
from mechanics.program.operations import BY_NAME, CONSTANT, INPUT, OPERATIONS
from mechanics.program.routine import Node, Routine, routine

FILE = "graphs.json"
RATES = "rates"
"""The graph that the step is made of; no function of the folder."""
MOST = 100_000
"""Entries of an array."""


def graphs_text(graphs: Mapping[str, Graph], rates: Code | None) -> str:
    """Text of the file."""
    # Parts of one function share its graph.
    codes = {id(graph.code): graph.code for graph in graphs.values()}
    if rates is not None:
        codes[id(rates)] = rates
    place = {key: i for i, key in enumerate(codes)}
    content: dict[str, Any] = {
        "functions": [
            [name, place[id(graph.code)], _routine(graph.written)] for name, graph in graphs.items()
        ],
        "rates": None if rates is None else place[id(rates)],
        "exact": [
            [{**_routine(c.routine), "constants": values_record(c.constants)}]
            for c in codes.values()
        ],
    }
    return lines(content)


def _routine(code: Routine) -> dict[str, Any]:
    return {
        "name": code.name,
        "inputs": [list(group) for group in code.inputs],
        "shapes": [[name, list(shape)] for name, shape in code.shapes],
        "outputs": [list(nodes) for nodes in code.outputs],
        "nodes": [_node(node) for node in code.nodes],
    }


def _node(node: Node) -> list[Any]:
    name = OPERATIONS[node.operation].name
    return [name, *node.operands] if node.constant is None else [name, str(node.constant)]


def read_graphs(content: Any) -> tuple[dict[str, Graph], Code | None]:
    """The graphs of a file by name of function, and that of the rates.

    Raises
    ------
    ExpressionError
        If it is not what `graphs_text` writes; what is odd is named.
    """
    with reading("it does not hold the graphs"):
        codes = [_read_code(record) for (record,) in content["exact"]]
        found = {
            str(name): Graph(codes[index(place, len(codes))], _read_written(record))
            for name, place, record in content["functions"]
        }
        rates = content["rates"]
        return found, None if rates is None else codes[index(rates, len(codes))]


def _read_code(record: Any) -> Code:
    found, constants = _read(record), read_values(record["constants"])
    if not found.inputs or found.inputs[-1][1] != len(constants):
        raise ExpressionError(f"{found.name}: its last input are {len(constants)} constants")
    return Code(found, constants)


def _read_written(record: Any) -> Routine:
    found = _read(record)
    for number, node in enumerate(found.nodes):
        if node.constant is not None and not is_double(node.constant):
            raise ExpressionError(f"node {number}: {node.constant} is no double")
    return found


def _read(record: Any) -> Routine:
    inputs = tuple((str(name), index(size, MOST)) for name, size in record["inputs"])
    shapes = tuple(
        (str(name), (index(rows, MOST), index(columns, MOST)))
        for name, (rows, columns) in record["shapes"]
    )
    nodes = [_read_node(node, n, inputs) for n, node in enumerate(record["nodes"])]
    outputs = [[index(place, len(nodes)) for place in places] for places in record["outputs"]]
    for (name, (rows, columns)), places in zip(shapes, outputs, strict=True):
        if len(places) != rows * columns:
            raise ExpressionError(f"output {name}: {rows * columns} entries are expected")
    return routine(str(record["name"]), nodes, outputs, inputs, shapes)


def _read_node(record: Any, number: int, inputs: tuple[tuple[str, int], ...]) -> Node:
    name, *rest = record
    if name == OPERATIONS[CONSTANT].name:
        (text,) = rest
        if not NUMBER.match(text):
            raise ExpressionError(f"node {number}: {text[:40]} is no number")
        return Node(CONSTANT, (), Fraction(text))
    if name == OPERATIONS[INPUT].name:
        group, entry = rest
        place = index(group, len(inputs))
        return Node(INPUT, (place, index(entry, inputs[place][1])))
    row = BY_NAME.get(str(name))
    if row is None or not row.c or not row.arity or row.arity != len(rest):
        raise ExpressionError(
            f"node {number}: there is no operation {str(name)[:40]} of {len(rest)}"
        )
    return Node(row.code, tuple(index(place, number) for place in rest))
