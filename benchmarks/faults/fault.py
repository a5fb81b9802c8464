"""A fault: a change in the text of one function, made in a process that has imported it."""

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from importlib import import_module
from inspect import getsource, unwrap
from types import CodeType, FunctionType
from typing import Any


@dataclass(frozen=True)
class Fault:
    """One fault.

    Attributes
    ----------
    module : str
        Dotted name.
    old, new : str
        A piece of the text of one of its functions that occurs once in the module, and what stands
        there instead.
    what : str
        The mistake in words; the name of the fault.
    """

    module: str
    old: str
    new: str
    what: str


def plant(fault: Fault) -> None:
    """Give the function the code of its changed text: all who hold it hold the fault."""
    function, code = planted(fault)
    function.__code__ = code


def planted(fault: Fault) -> tuple[FunctionType, CodeType]:
    """The function that is to be changed, and its changed code.

    Raises
    ------
    LookupError
        When the old piece does not occur exactly once, or not in a function.
    """
    module = import_module(fault.module)
    text = getsource(module)
    count = text.count(fault.old)
    if count != 1:
        raise LookupError(
            f"fault {fault.what!r}: {fault.old!r} occurs {count} times in {fault.module}, not once:"
            " the text has changed, so correct or drop the row"
        )
    line = 1 + text[: text.index(fault.old.strip())].count("\n")
    names = [
        name
        for name, node in _functions(ast.parse(text))
        if node.lineno <= line <= (node.end_lineno or line)
    ]
    if len(names) != 1:
        raise LookupError(f"fault {fault.what!r}: {fault.old!r} is in no function: change one")
    changed = text.replace(fault.old, fault.new)
    return function_of(fault.module, names[0]), code_of(changed, str(module.__file__), names[0])


def place_of(code: CodeType) -> str:
    """File and qualified name."""
    return f"{code.co_filename}:{code.co_qualname}"


def code_of(text: str, path: str, name: str) -> CodeType:
    """The code of a function in the text of a module, by its qualified name."""
    whole = compile(text, path, "exec")
    return next(code for code in _codes(whole) if code.co_qualname == name)


def _functions(node: ast.AST, prefix: str = "") -> Iterator[tuple[str, ast.FunctionDef]]:
    """Functions of a module and methods of its classes, by qualified name."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.FunctionDef):
            yield prefix + child.name, child
        elif isinstance(child, ast.ClassDef):
            yield from _functions(child, f"{prefix}{child.name}.")


def _codes(code: CodeType) -> Iterator[CodeType]:
    for part in code.co_consts:
        if isinstance(part, CodeType):
            yield part
            yield from _codes(part)


def function_of(module: str, name: str) -> FunctionType:
    """The function object itself, out of what wraps it."""
    *owners, last = name.split(".")
    place: Any = import_module(module)
    for owner in owners:
        place = getattr(place, owner)
    found = vars(place)[last]
    if isinstance(found, property):
        found = found.fget
    elif isinstance(found, cached_property):
        found = found.func
    elif isinstance(found, staticmethod | classmethod):
        found = found.__func__
    function: FunctionType = unwrap(found)
    return function
