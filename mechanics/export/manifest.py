"""What was generated, from what and by what, and what was shown about it: manifest.json."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from hashlib import sha256
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from mechanics.compiled import Model
from mechanics.compiled.custody.kernel import Kernel
from mechanics.export.header import array_entries, used_arrays

TOOLS = ("mechanics", "casadi", "sympy", "python-flint")


def manifest(
    model: Model,
    prefix: str,
    names: Sequence[str],
    files: Mapping[str, str],
    kernels: Sequence[Kernel] = (),
    chain: Mapping[str, Any] | None = None,
    system: str | None = None,
) -> str:
    """Text of the manifest.

    Parameters
    ----------
    files : mapping of file name to text
        The other files; their SHA-256 goes in.
    kernels : sequence of Kernel
        The C functions, and which function of the model each is.
    chain : mapping, optional
        What was shown, see `mechanics.export.evidence`.
    system : str, optional
        Name of the built-in system.
    """
    content: dict[str, Any] = {
        "scene": model.equations.scene.name,
        "system": system,
        "route": model.equations.route,
        "form": model.form if "forward_dynamics" in names else None,
        "prefix": prefix,
        "reciprocals": model.programs.reciprocals,
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
                "divisions": model.program(name).divisions,
                "inputs": {group: size for group, size in model.program(name).inputs},
                "outputs": {out: list(shape) for out, shape in model.program(name).shapes},
            }
            for name in names
        },
        "kernels": [_kernel(kernel) for kernel in kernels],
        "chain": chain or {},
        "files": {file: sha256(text.encode("utf-8")).hexdigest() for file, text in files.items()},
        "versions": {tool: version_of(tool) for tool in TOOLS},
    }
    return json.dumps(content, indent=2, ensure_ascii=False) + "\n"


def _kernel(kernel: Kernel) -> dict[str, Any]:
    found = asdict(kernel)
    return {name: value for name, value in found.items() if value is not None}


def version_of(tool: str) -> str:
    """Version of an installed package, in words."""
    try:
        return version(tool)
    except PackageNotFoundError:
        # A source tree that is used without being installed.
        return "not installed"
