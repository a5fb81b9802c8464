"""What was generated, from what and by what: manifest.json."""

import json
from collections.abc import Mapping, Sequence
from hashlib import sha256
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from mechanics.compiled import Model
from mechanics.export.header import array_entries, used_arrays

TOOLS = ("mechanics", "casadi", "sympy", "python-flint")


def manifest(model: Model, prefix: str, names: Sequence[str], files: Mapping[str, str]) -> str:
    """Text of the manifest.

    Parameters
    ----------
    files : mapping of file name to text
        The other files; their SHA-256 goes in.
    """
    content: dict[str, Any] = {
        "scene": model.equations.scene.name,
        "route": model.equations.route,
        "prefix": prefix,
        "fixed": {parameter: str(value) for parameter, value in sorted(model.fixed.items())},
        "arrays": {
            array: [
                {"name": e.name, "unit": e.unit, "meaning": e.meaning}
                for e in array_entries(model, array)
            ]
            for array in used_arrays(model, names)
        },
        "functions": {
            name: {
                "operations": model.program(name).operations,
                "inputs": {group: size for group, size in model.program(name).inputs},
                "outputs": {out: list(shape) for out, shape in model.program(name).shapes},
            }
            for name in names
        },
        "files": {file: sha256(text.encode("utf-8")).hexdigest() for file, text in files.items()},
        "versions": {tool: _version(tool) for tool in TOOLS},
    }
    return json.dumps(content, indent=2, ensure_ascii=False) + "\n"


def _version(tool: str) -> str:
    try:
        return version(tool)
    except PackageNotFoundError:
        # A source tree that is used without being installed.
        return "not installed"
