"""NAME_loader.py: Python that calls the C of the folder.

Its template, `mechanics.export.loader_template`, is a module in its own right, so that it is
checked like any other; here its tables are filled in.
"""

import inspect
import json
import re
from collections.abc import Mapping, Sequence
from typing import Any

from mechanics.compiled.graphs import MATRICES
from mechanics.export import loader_template
from mechanics.export.contents import Contents
from mechanics.export.precision import Part
from mechanics.program.routine import Routine

LINE = 80
_TABLES = re.compile(
    r"(# What was generated:).*?\n(.*?)(# End of what was generated.\n)", re.DOTALL
)


def loader(contents: Contents, name: str, parts: Sequence[Part], many: Sequence[str]) -> str:
    """Text of the module.

    Parameters
    ----------
    name : str
        Of the library.
    parts : sequence of Part
        The precisions that are written.
    many : sequence of str
        Functions that are there for many states, too.
    """
    arrays = {
        array: tuple((e.name, e.unit, e.meaning) for e in entries)
        for array, entries in contents.arrays.items()
    }
    parameters = [entry.name for entry in contents.arrays["p"]]
    typical = dict(zip(parameters, contents.typical, strict=True)) if contents.typical else {}
    tables: dict[str, Any] = {
        "NAME": name,
        "PREFIXES": {part.precision: part.prefix for part in parts},
        "ARRAYS": arrays,
        "TYPICAL": typical,
        "FUNCTIONS": _functions(contents.programs),
    }
    tables["BATCH"] = tuple(many)
    ends = ("", "_batch") if many else ("",)
    tables["SOURCES"] = {
        part.precision: tuple(f"{part.prefix}{end}.c" for end in ends) for part in parts
    }
    text = inspect.getsource(loader_template)
    first = next(iter(contents.programs))
    inputs, outputs = tables["FUNCTIONS"][first]
    words = {
        "NAME": name,
        "FUNCTION": first,
        "GIVEN": ", ".join(f"{group}={[0.1] * size}" for group, size in inputs if group != "p"),
        "OUTPUT": outputs[0][0],
    }
    text = re.sub(r"@(\w+)@", lambda found: words[found[1]], text)
    written = "".join(f"{table} = {_literal(value)}\n" for table, value in tables.items())
    return _TABLES.sub(lambda found: f"# What was generated.\n{written}{found[3]}", text)


def _functions(programs: Mapping[str, Routine]) -> dict[str, Any]:
    functions = {}
    for function, code in programs.items():
        functions[function] = (
            tuple((group, size) for group, size in code.inputs if size),
            tuple((out, _shape(out, shape)) for out, shape in code.shapes if 0 not in shape),
        )
    return functions


def _shape(output: str, shape: tuple[int, int]) -> tuple[int, ...]:
    return shape if output in MATRICES else shape[:1]


def _literal(value: Any, indent: int = 0) -> str:
    """Python text of nested tuples and dictionaries, one entry a line where a line is too short."""
    if not isinstance(value, dict | tuple) or not value or indent + len(repr(value)) < LINE:
        return _quoted(value)
    space = " " * (indent + 4)
    if isinstance(value, dict):
        rows = [
            f"{space}{_quoted(key)}: {_literal(each, indent + 4)},\n" for key, each in value.items()
        ]
        return "{\n" + "".join(rows) + " " * indent + "}"
    rows = [f"{space}{_literal(each, indent + 4)},\n" for each in value]
    return "(\n" + "".join(rows) + " " * indent + ")"


def _quoted(value: Any) -> str:
    """``repr`` with double quotes, which a text of JSON has, too."""
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, tuple):
        inside = ", ".join(map(_quoted, value))
        return f"({inside},)" if len(value) == 1 else f"({inside})"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_quoted(k)}: {_quoted(v)}" for k, v in value.items()) + "}"
    return repr(value)
