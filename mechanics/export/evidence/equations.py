"""equations.json: what was derived, as `Derived` has it.

    {"scene": ..., "symbols": [["L", "positive"], ...], "groups": {"q": [0, 1], ...},
     "inputs": ["q1", ...], "operations": [...], "outputs": {"rows": [41, 57], ...}}

Numbers in the groups are places among the symbols. What was derived stands as a program in the
format of `mechanics.program.json_format`, values of fixed parameters as another one.
"""

import json
from collections.abc import Mapping, Sequence
from typing import Any

from sympy import Symbol

from mechanics.compiled.translation_validation.derived import GROUPS, Derived
from mechanics.errors import ExpressionError
from mechanics.export.evidence.values import (
    index,
    read_symbols,
    read_values,
    reading,
    symbol_record,
    values_record,
)
from mechanics.program import Program
from mechanics.program.json_format import FORMAT, read, write

FILE = "equations.json"


def equations_text(known: Derived) -> str:
    """Text of the file."""
    fixed = dict(sorted(known.fixed.items(), key=lambda pair: pair[0].name))
    places: dict[Symbol, int] = {}
    for symbol in (*(s for g in GROUPS for s in known.symbols[g]), *fixed):
        places.setdefault(symbol, len(places))
    content: dict[str, Any] = {
        "scene": known.scene,
        "route": known.route,
        "groups": {g: [places[s] for s in known.symbols[g]] for g in GROUPS},
        "time": known.time,
        "fixed": [places[symbol] for symbol in fixed],
        "values": values_record(list(fixed.values())),
    }
    content |= _program(known.program)
    return lines({**content, "symbols": [symbol_record(symbol) for symbol in places]})


def _program(program: Program) -> dict[str, Any]:
    whole = json.loads(write(program))
    return {
        "inputs": whole["inputs"], "operations": whole["nodes"], "outputs": whole["outputs"],
    }  # fmt: skip


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
    with reading("it is not what was derived"):
        return _read(content)


def _read(content: Any) -> Derived:
    symbols = read_symbols(content["symbols"])

    def symbol(place: Any) -> Symbol:
        return symbols[index(place, len(symbols))]

    time = content["time"]
    groups = {g: tuple(symbol(place) for place in content["groups"][g]) for g in GROUPS}
    if time is not None:
        index(time, len(groups["inputs"]))
    return Derived(
        scene=str(content["scene"]),
        route=str(content["route"]),
        symbols=groups,
        fixed=dict(zip(map(symbol, content["fixed"]), read_values(content["values"]), strict=True)),
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
