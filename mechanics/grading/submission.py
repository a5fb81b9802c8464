"""What a student hands in, as things that `check` reads.

    a.tex, a.txt, a.md, a.m    text        a.c, a.h    C        a.ipynb    its cells
    a.py    its last function that is no part of another, or the one that is asked for, which is run

Code in Python is only run where that is allowed.
"""

import inspect
import json
import re
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import CodeType, FunctionType, ModuleType
from typing import Any

from mechanics.claims.code.python_call import Unsaid
from mechanics.claims.read import file_text
from mechanics.errors import InputError
from mechanics.grading.file_level import different_elsewhere, libraries_unchanged, used_by

GONE = re.compile(
    r"<!--.*?(?:-->|\Z)|~~.*?~~|^\[//\]: #[^\n]*"
    r"|<(?P<struck>del|s|strike)\b[^>]*>.*?</(?P=struck)>",
    re.DOTALL | re.MULTILINE,
)
"""What a page in Markdown does not show, and what its author has struck out."""
RUN = "Python is only run where that is allowed: --run-python (run_python=True)"


def things_in(path: Path, *, function: str | None = None, run_python: bool = False) -> list[Any]:
    """Texts, paths and functions, in order.

    Parameters
    ----------
    function : str, optional
        Of a Python file or notebook; when not given, the last one that is no part of another.
    run_python : bool
        Whether code in Python may be run.

    Raises
    ------
    InputError
        When there is nothing that can be read.
    """
    suffix = path.suffix.lower()
    if suffix == ".py":
        return [_function(path, file_text(path), function, run_python)]
    if suffix == ".ipynb":
        return _cells(path, function, run_python)
    return [path]


def _cells(path: Path, function: str | None, run_python: bool) -> list[Any]:
    """The text of all cells of prose together, and the function of those of code."""
    try:
        cells = json.loads(file_text(path))["cells"]
        pairs = [(cell["cell_type"], "".join(cell["source"])) for cell in cells]
    except (ValueError, KeyError, TypeError) as error:
        raise InputError(f"file {path}: it is no notebook: {type(error).__name__}") from None
    shown = (GONE.sub("", text) for kind, text in pairs if kind == "markdown")
    prose = "\n\n".join(text for text in shown if text.strip())
    code = [text for kind, text in pairs if kind == "code"]
    beside = [text for kind, text in pairs if kind == "raw"]
    beside += [words.lstrip("# ") for text in code for words in COMMENT.findall(text)]
    # Commented code is no equation that is handed in.
    said = (text for text in beside if "=" not in text)
    found: list[Any] = ["\n\n".join((prose, *said))] if "=" in prose else []
    if any("def " in text for text in code) and (run_python or not found):
        own = _function(path, _runnable(code), function, run_python)
        told = "\n".join(line for text in (prose, *beside) for line in text.splitlines())
        getattr(own, "__func__", own).__dict__["__prose__"] = told
        found.append(own)
    if not found:
        raise InputError(f"file {path}: no cell has an equation or a function")
    return found


COMMENT = re.compile(r"#[^\n]*")
MAGIC = re.compile(
    r"^[ \t]*(?:%(?:matplotlib|config|load_ext|autoreload|pip)|!pip)\b[^\n]*", re.MULTILINE
)
"""Lines of a notebook's own language that change no name."""


def _runnable(cells: list[str]) -> str:
    """The code of all cells, in order; lines that only set the notebook up are left out."""
    return "\n".join(MAGIC.sub("pass", text) for text in cells)


def _function(path: Path, code: str, function: str | None, run_python: bool) -> Any:
    if not run_python:
        raise InputError(f"file {path}: {RUN}")
    module = ModuleType("submission")
    names = vars(module)
    names["__file__"] = str(path)
    before = sys.modules.get("submission")
    sys.modules["submission"] = module  # where a dataclass looks for what its annotations say
    try:
        with libraries_unchanged():
            exec(compile(code, str(path), "exec"), names)  # in a worker, as the caller allows
    except InputError as error:
        raise InputError(f"file {path}: {error}") from None
    except Exception as error:
        raise InputError(f"file {path}: it ends in {type(error).__name__}: {error}") from None
    finally:
        del sys.modules["submission"]
        if before is not None:
            sys.modules["submission"] = before
    own = [
        n for n, v in names.items() if isinstance(v, FunctionType) and v.__module__ == "submission"
    ]
    space = names
    if not own:
        names, own = _methods(path, names)
    chosen = function or (_last(names, own) if own else "")
    if chosen not in own:
        told = f"it has {', '.join(own)}" if own else "it has none"
        raise InputError(f"file {path}: there is no function {chosen or 'to check'}: {told}")
    if strange := sorted(different_elsewhere(code) & used_by(space, chosen or "")):
        raise InputError(
            f"file {path}: {strange[0]} depends on where the file is run: write what it is"
        )
    return names[chosen]


def _last(names: Mapping[str, Any], own: Sequence[str]) -> str:
    """The last function that no other one speaks of, as these are parts of it."""
    parts = {
        name
        for one in own
        if isinstance(names[one], FunctionType)
        for name in _spoken(names[one].__code__) - {one}
    }
    return next((n for n in reversed(own) if n not in parts and _takes(names[n])), own[-1])


def _spoken(code: CodeType) -> set[str]:
    """Names of others in a function, and in those that are defined in it."""
    inner = [_spoken(part) for part in code.co_consts if isinstance(part, CodeType)]
    return {*code.co_names}.union(*inner)


def _takes(thing: Any) -> bool:
    """Whether it has an argument; a function without one is a program."""
    return not isinstance(thing, FunctionType) or thing.__code__.co_argcount > 0


def _placeholders(kind: type, names: Mapping[str, Any]) -> dict[str, Any]:
    """Numbers for what an object is made with, for which the scene's parameters are to stand.

    What is to be of a class of the file is one that is made so.
    """
    found: dict[str, Any] = {}
    for name, one in inspect.signature(kind).parameters.items():
        if one.kind is not one.POSITIONAL_OR_KEYWORD or one.default is not one.empty:
            continue
        inner = names.get(one.annotation, one.annotation)
        if isinstance(inner, type) and inner.__module__ == "submission" and inner is not kind:
            found[name] = inner(**_placeholders(inner, names))
        else:
            found[name] = Unsaid(1.5 + len(found) * 0.37)
            found[name].name = name
    return found


def _methods(path: Path, names: dict[str, Any]) -> tuple[dict[str, Any], list[str]]:
    """Methods of the last class, of an object that is made with numbers that nobody said."""
    classes = [v for v in names.values() if isinstance(v, type) and v.__module__ == "submission"]
    if not classes:
        return names, []
    own = [n for n, v in vars(classes[-1]).items() if isinstance(v, FunctionType) and n[0] != "_"]
    if not own:
        return names, []
    try:
        made = classes[-1](**_placeholders(classes[-1], names))
    except Exception as error:
        words = f"{classes[-1].__name__}() ends in {type(error).__name__}: {error}"
        raise InputError(f"file {path}: {words}: have a function, or values for all") from None
    return {name: getattr(made, name) for name in own}, own
