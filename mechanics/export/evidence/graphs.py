"""graphs.json: the CasADi graphs of the functions, operation by operation.

    {"functions": {"energy": {"exact": {...}, "written": {...}}, ...},
     "symbols": [...], "nodes": [...]}

    exact      the graph that is proved: numbers that no double holds are exact (["number", "1/3"])
               or entries of ["constant", i], whose values are places among the nodes of the file
    written    what the C is printed from: the graph with doubles (["double", "0x1.8p+1"]),
               rewritten for speed

An operation is ["multiply", 3, 5], of earlier ones; ["input", 0, 1] is entry 1 of the first input.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import casadi as ca

from mechanics.compiled.custody.code import Code
from mechanics.compiled.custody.prove import Graph
from mechanics.compiled.programs.operations import OPERATIONS
from mechanics.compiled.programs.program import Node as ProgramNode
from mechanics.compiled.programs.program import Program
from mechanics.errors import ExpressionError
from mechanics.export.evidence.equations import lines
from mechanics.export.evidence.expressions import (
    NUMBER,
    Writer,
    index,
    read_nodes,
    read_symbols,
)
from mechanics.program.casadi_reader import Instruction as Node

FILE = "graphs.json"
RATES = "rates"
"""The graph that the step is made of; no function of the folder."""

NAMES = {
    getattr(ca, name): name.removeprefix("OP_").lower()
    for name in sorted(dir(ca))
    if name.startswith("OP_") and getattr(ca, name) in OPERATIONS
}
OPS = {name: op for op, name in NAMES.items()}
BINARY = frozenset({
    ca.OP_ADD, ca.OP_SUB, ca.OP_MUL, ca.OP_DIV, ca.OP_POW, ca.OP_CONSTPOW, ca.OP_LT, ca.OP_LE,
    ca.OP_EQ, ca.OP_NE, ca.OP_AND, ca.OP_OR, ca.OP_FMIN, ca.OP_FMAX, ca.OP_ATAN2, ca.OP_HYPOT,
    ca.OP_COPYSIGN, ca.OP_IF_ELSE_ZERO,
})  # fmt: skip


def graphs_text(graphs: Mapping[str, Graph], rates: Code | None) -> str:
    """Text of the file."""
    writer = Writer()
    # Parts of one function share its graph.
    codes = {id(graph.code): graph.code for graph in graphs.values()}
    if rates is not None:
        codes[id(rates)] = rates
    place = {key: i for i, key in enumerate(codes)}
    content: dict[str, Any] = {
        "functions": [
            [name, place[id(graph.code)], _program(graph.written)] for name, graph in graphs.items()
        ],
        "rates": None if rates is None else place[id(rates)],
        "exact": [[_code(code, writer)] for code in codes.values()],
        "symbols": writer.symbols,
        "nodes": writer.nodes,
    }
    return lines(content)


def _code(code: Code, writer: Writer) -> dict[str, Any]:
    last = len(code.inputs)
    nodes: list[list[Any]] = []
    for node in code.nodes:
        if node.constant is not None:
            nodes.append(["number", str(node.constant)])
        elif node.op == ca.OP_INPUT:
            group, entry = node.operands
            nodes.append(["constant", entry] if group == last else ["input", group, entry])
        else:
            nodes.append([NAMES[node.op], *node.operands])
    constants = [writer.add(constant) for constant in code.constants]
    return {**_shape(code), "constants": constants, "nodes": nodes}


def _program(code: Program) -> dict[str, Any]:
    nodes: list[list[Any]] = []
    for op, operands, constant in code.nodes:
        if constant is not None:
            nodes.append(["double", float(constant).hex()])
        elif op == ca.OP_INPUT:
            nodes.append(["input", *operands])
        else:
            nodes.append([NAMES[op], *operands])
    return {**_shape(code), "nodes": nodes}


def _shape(code: Code | Program) -> dict[str, Any]:
    return {
        "name": code.name,
        "inputs": [list(group) for group in code.inputs],
        "shapes": [[name, list(shape)] for name, shape in code.shapes],
        "outputs": [list(nodes) for nodes in code.outputs],
    }


def read_graphs(content: Any) -> tuple[dict[str, Graph], Code | None]:
    """The graphs of a file by name of function, and that of the rates.

    Raises
    ------
    ExpressionError
        If it is not what `graphs_text` writes; what is odd is named.
    """
    try:
        constants = read_nodes(content["nodes"], read_symbols(content["symbols"]))
        codes = [_read_code(record, constants) for (record,) in content["exact"]]
        found = {
            str(name): Graph(codes[index(place, len(codes))], _read_program(record))
            for name, place, record in content["functions"]
        }
        rates = content["rates"]
        return found, None if rates is None else codes[index(rates, len(codes))]
    except (KeyError, TypeError, ValueError, AttributeError, IndexError) as error:
        if isinstance(error, ExpressionError):
            raise
        words = f"{type(error).__name__} {error}"
        raise ExpressionError(f"it does not hold the graphs: {words}") from None


def _read_code(record: Any, expressions: list[Any]) -> Code:
    shape = _read_shape(record)
    constants = tuple(expressions[index(i, len(expressions))] for i in record["constants"])
    inputs = [*(size for _, size in shape["inputs"]), len(constants)]
    nodes: list[Node] = []
    for number, (name, *rest) in enumerate(record["nodes"]):
        if name == "number":
            (text,) = rest
            if not NUMBER.match(text):
                raise ExpressionError(f"node {number}: {text[:40]} is no number")
            nodes.append(Node(ca.OP_CONST, (), Fraction(text)))
            continue
        if name == "constant":
            name, rest = "input", [len(inputs) - 1, *rest]
        op, operands = _operation(name, rest, number, inputs)
        nodes.append(Node(op, operands, None))
    _check_outputs(shape, len(nodes))
    return Code(nodes=tuple(nodes), constants=constants, **shape)


def _read_program(record: Any) -> Program:
    shape = _read_shape(record)
    inputs = [size for _, size in shape["inputs"]]
    nodes: list[ProgramNode] = []
    for number, (name, *rest) in enumerate(record["nodes"]):
        if name == "double":
            (text,) = rest
            value = float.fromhex(text)
            if value - value != 0:
                raise ExpressionError(f"node {number}: {text} is no number")
            nodes.append(ProgramNode(ca.OP_CONST, (), value))
            continue
        op, operands = _operation(name, rest, number, inputs)
        nodes.append(ProgramNode(op, operands, None))
    _check_outputs(shape, len(nodes))
    return Program(nodes=tuple(nodes), **shape)


def _operation(
    name: Any, rest: list[Any], number: int, inputs: list[int]
) -> tuple[int, tuple[int, ...]]:
    if name == "input":
        group, entry = rest
        return ca.OP_INPUT, (index(group, len(inputs)), index(entry, inputs[group]))
    if name not in OPS or len(rest) != (2 if OPS[name] in BINARY else 1):
        raise ExpressionError(
            f"node {number}: there is no operation {str(name)[:40]} of {len(rest)}"
        )
    return OPS[name], tuple(index(place, number) for place in rest)


def _read_shape(record: Any) -> dict[str, Any]:
    return {
        "name": str(record["name"]),
        "inputs": tuple((str(name), index(size, 100_000)) for name, size in record["inputs"]),
        "shapes": tuple(
            (str(name), (index(rows, 100_000), index(columns, 100_000)))
            for name, (rows, columns) in record["shapes"]
        ),
        "outputs": tuple(tuple(nodes) for nodes in record["outputs"]),
    }


def _check_outputs(shape: Mapping[str, Any], size: int) -> None:
    for (name, (rows, columns)), nodes in zip(shape["shapes"], shape["outputs"], strict=True):
        if len(nodes) != rows * columns:
            raise ExpressionError(f"output {name}: {rows * columns} entries are expected")
        for node in nodes:
            index(node, size)
