"""equations.json: what was derived, as `Derived` or `DerivedProgram` has it.

    {"scene": ..., "symbols": [["L", "positive"], ...], "nodes": [["symbol", 0], ...],
     "groups": {"q": [0, 1], ...}, "left": [[12, 17], [17, 20]], "right": [31, 32], ...}

Numbers in the parts are places among the nodes; those in the groups are places among the symbols.
What was derived as a program stands as one, in the format of `mechanics.program.json_format`.

    {"scene": ..., "symbols": ..., "groups": ..., "inputs": ["q1", ...], "operations": [...],
     "outputs": {"rows": [41, 57], ...}}
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

from sympy import Expr, Matrix, Symbol

from mechanics.compiled.custody.derived import Derived, Known
from mechanics.compiled.custody.derived_program import GROUPS, DerivedProgram
from mechanics.errors import ExpressionError, InputError
from mechanics.export.evidence.expressions import Writer, index, read_nodes, read_symbols
from mechanics.program import Program
from mechanics.program.json_format import FORMAT, read, write

FILE = "equations.json"
MATRICES = ("left", "right", "mass", "forcing")
COLUMNS = ("rates", "linear", "angular")
SCALARS = ("kinetic", "potential")


def equations_text(known: Known) -> str:
    """Text of the file."""
    writer = Writer()
    groups = {g: [writer.symbol(s) for s in known.symbols[g]] for g in GROUPS}
    content: dict[str, Any] = {
        "scene": known.scene,
        "route": known.route,
        "groups": groups,
        "time": known.time,
        "fixed": _pairs(writer, tuple(known.fixed.items())),
    }
    if isinstance(known, DerivedProgram):
        content |= _program(known.program)
        return lines({**content, "symbols": writer.symbols, "nodes": writer.nodes})
    content["unknowns"] = [writer.symbol(symbol) for symbol in known.unknowns]
    content["reactions"] = _pairs(writer, known.reactions)
    for name in MATRICES:
        matrix = getattr(known, name)
        rows = [[writer.add(matrix[i, j]) for j in range(matrix.cols)] for i in range(matrix.rows)]
        content[name] = [matrix.cols, rows]
    for name in COLUMNS:
        content[name] = [writer.add(entry) for entry in getattr(known, name)]
    for name in SCALARS:
        content[name] = writer.add(getattr(known, name))
    return lines({**content, "symbols": writer.symbols, "nodes": writer.nodes})


def _program(program: Program) -> dict[str, Any]:
    whole = json.loads(write(program))
    return {
        "inputs": whole["inputs"], "operations": whole["nodes"], "outputs": whole["outputs"],
    }  # fmt: skip


def _pairs(writer: Writer, pairs: Sequence[tuple[Symbol, Expr]]) -> list[list[int]]:
    return [[writer.symbol(symbol), writer.add(value)] for symbol, value in pairs]


def lines(content: dict[str, Any]) -> str:
    """JSON with one line an entry, so that a change is seen where it is."""
    parts = []
    for name, value in content.items():
        if isinstance(value, list) and value and isinstance(value[0], list):
            rows = ",\n  ".join(json.dumps(row, ensure_ascii=False) for row in value)
            text = f"[\n  {rows}\n ]"
        else:
            text = json.dumps(value, ensure_ascii=False)
        parts.append(f" {json.dumps(name)}: {text}")
    return "{\n" + ",\n".join(parts) + "\n}\n"


def read_equations(content: Any) -> Known:
    """What a file says that was derived.

    Parameters
    ----------
    content : object
        As `json.loads` gives it.

    Raises
    ------
    ExpressionError
        If it is not what `equations_text` writes; what is odd is named.
    """
    try:
        return _read(content)
    except InputError as error:
        raise ExpressionError(str(error)) from None
    except (KeyError, TypeError, ValueError, AttributeError, IndexError) as error:
        if isinstance(error, ExpressionError):
            raise
        words = f"{type(error).__name__} {error}"
        raise ExpressionError(f"it is not what was derived: {words}") from None


def _read(content: Any) -> Known:
    symbols = read_symbols(content["symbols"])
    nodes = read_nodes(content["nodes"], symbols)

    def symbol(place: Any) -> Symbol:
        return symbols[index(place, len(symbols))]

    def expression(place: Any) -> Expr:
        found = nodes[index(place, len(nodes))]
        if not isinstance(found, Expr):
            raise ExpressionError(f"node {place} is no expression")
        return found

    def pairs(records: Any) -> tuple[tuple[Symbol, Expr], ...]:
        return tuple((symbol(one), expression(two)) for one, two in records)

    def matrix(record: Any) -> Matrix:
        columns, rows = record
        flat = [expression(place) for row in rows for place in row]
        return Matrix(len(rows), index(columns, 10_000), flat)

    time = content["time"]
    groups = {g: tuple(symbol(place) for place in content["groups"][g]) for g in GROUPS}
    if time is not None:
        index(time, len(groups["inputs"]))
    if "operations" in content:
        return DerivedProgram(
            scene=str(content["scene"]),
            route=str(content["route"]),
            symbols=groups,
            fixed=dict(pairs(content["fixed"])),
            time=time,
            program=_read_program(content, groups),
        )
    return Derived(
        scene=str(content["scene"]),
        route=str(content["route"]),
        symbols=groups,
        fixed=dict(pairs(content["fixed"])),
        time=time,
        unknowns=tuple(symbol(place) for place in content["unknowns"]),
        reactions=pairs(content["reactions"]),
        **{name: matrix(content[name]) for name in MATRICES},
        **{name: tuple(map(expression, content[name])) for name in COLUMNS},
        **{name: expression(content[name]) for name in SCALARS},
    )


def _read_program(content: Any, groups: Mapping[str, Sequence[Symbol]]) -> Program:
    whole = {"format": FORMAT, "inputs": content["inputs"], "nodes": content["operations"]}
    program = read(json.dumps({**whole, "outputs": content["outputs"]}))
    n = len(groups["ud"])
    sizes = {
        "rows": n, "conjugate": n, "constraints": len(groups["multipliers"]),
        "rates": len(groups["q"]), "kinetic": 1, "potential": 1, "linear": 3, "angular": 3,
        "generalized": n, "reactions": len(groups["reactions"]),
    }  # fmt: skip
    for name, size in sizes.items():
        if len(program.outputs.get(name, ())) != size:
            raise ExpressionError(f"{name}: {size} entries are expected")
    return program
