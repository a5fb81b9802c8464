"""What was generated, from what and by what, and what was shown about it: manifest.json."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from hashlib import sha256
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from mechanics.compiled.translation_validation.kernel import Kernel
from mechanics.export.contents import Contents

TOOLS = ("mechanics", "casadi", "sympy", "python-flint")


def manifest(
    contents: Contents,
    prefix: str,
    files: Mapping[str, str],
    kernels: Sequence[Kernel] = (),
    chain: Mapping[str, Any] | None = None,
    system: str | None = None,
    form: str | None = None,
    reciprocals: bool = True,
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
    form : str, optional
        Of forward dynamics.
    reciprocals : bool
        Whether divisors are shared.
    """
    content = {
        **described(contents, prefix),
        "system": system,
        "form": form,
        "reciprocals": reciprocals,
        "kernels": kernel_records(kernels),
        "chain": chain or {},
        "files": {file: sha256(text.encode("utf-8")).hexdigest() for file, text in files.items()},
        "versions": {tool: version_of(tool) for tool in TOOLS},
    }
    return json.dumps(content, indent=2, ensure_ascii=False) + "\n"


def described(contents: Contents, prefix: str) -> dict[str, Any]:
    """What the manifest says of the functions: everything that scene and graphs give again."""
    return {
        "scene": contents.scene,
        "route": contents.route,
        "prefix": prefix,
        "fixed": dict(contents.fixed),
        "arrays": {
            array: [{"name": e.name, "unit": e.unit, "meaning": e.meaning} for e in entries]
            for array, entries in contents.arrays.items()
        },
        "functions": {
            name: {
                "operations": code.operations,
                "divisions": code.divisions,
                "inputs": dict(code.inputs),
                "outputs": {out: list(shape) for out, shape in code.shapes},
            }
            for name, code in contents.programs.items()
        },
    }


def kernel_records(kernels: Sequence[Kernel]) -> list[dict[str, Any]]:
    """What the manifest says of each C function."""
    return [{k: v for k, v in asdict(one).items() if v is not None} for one in kernels]


def version_of(tool: str) -> str:
    """Version of an installed package, in words."""
    try:
        return version(tool)
    except PackageNotFoundError:
        # A source tree that is used without being installed.
        return "not installed"
