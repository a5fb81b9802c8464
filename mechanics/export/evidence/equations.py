"""equations.json: what was derived, as `Derived` has it.

    {"scene": ..., "symbols": [["L", "positive"], ...], "groups": {"q": [0, 1], ...},
     "inputs": ["q1", ...], "operations": [...], "outputs": {"rows": [41, 57], ...}}

Numbers in the groups are places among the symbols. What was derived stands as a program in the
format of `mechanics.program.json_format`, values of fixed parameters as `nodes`.
"""

import json
from collections.abc import Mapping, Sequence
from typing import Any

from sympy import Expr, Symbol

from mechanics.compiled.translation_validation.derived import GROUPS, Derived
from mechanics.errors import ExpressionError, InputError
from mechanics.export.evidence.expressions import Writer, index, read_nodes, read_symbols
from mechanics.program import Program
from mechanics.program.json_format import FORMAT, read, write

FILE = "equations.json"


def equations_text(known: Derived) -> str:
    """Text of the file."""
    writer = Writer()
    groups = {g: [writer.symbol(s) for s in known.symbols[g]] for g in GROUPS}
    content: dict[str, Any] = {
        "scene": known.scene,
        "route": known.route,
        "groups": groups,
        "time": known.time,
        "fixed": _pairs(writer, sorted(known.fixed.items(), key=lambda pair: pair[0].name)),
    }
    content |= _program(known.program)
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


def read_equations(content: Any) -> Derived:
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


def _read(content: Any) -> Derived:
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

    time = content["time"]
    groups = {g: tuple(symbol(place) for place in content["groups"][g]) for g in GROUPS}
    if time is not None:
        index(time, len(groups["inputs"]))
    return Derived(
        scene=str(content["scene"]),
        route=str(content["route"]),
        symbols=groups,
        fixed=dict(pairs(content["fixed"])),
        time=time,
        program=_read_program(content, groups),
    )


def _read_program(content: Any, groups: Mapping[str, Sequence[Symbol]]) -> Program:
    whole = {"format": FORMAT, "inputs": content["inputs"], "nodes": content["operations"]}
    program = read(json.dumps({**whole, "outputs": content["outputs"]}))
    n, found = len(groups["ud"]), {name: len(nodes) for name, nodes in program.outputs.items()}
    size = n + len(groups["multipliers"])
    rows = found.get("rows", 0)
    sizes = {
        "closing": size - rows, "residual": size, "mass": n * rows, "forcing": rows,
        "rates": len(groups["q"]), "kinetic": 1, "potential": 1, "linear": 3, "angular": 3,
        "generalized": n, "reactions": len(groups["reactions"]),
        **({"forces": n} if "forces" in found else {}),
    }  # fmt: skip
    for name, size in sizes.items():
        if found.get(name, 0) != size:
            raise ExpressionError(f"{name}: {size} entries are expected")
    return program
