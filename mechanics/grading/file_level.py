"""What a file of Python changes when it is run, and which of its names a function uses.

math.sin = g        makes other functions mean something else
"""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from types import FunctionType
from typing import Any

from mechanics.claims.code.python.file_names import globals_of
from mechanics.errors import InputError

LIBRARIES = ("builtins", "math", "cmath", "operator", "functools", "numpy", "scipy", "mechanics")


@contextmanager
def libraries_unchanged() -> Iterator[None]:
    """Put back what is changed in modules of libraries.

    Raises
    ------
    InputError
        When something was.
    """
    modules = [m for n, m in sys.modules.items() if n.partition(".")[0] in LIBRARIES]
    before = [dict(vars(module)) for module in modules]
    yield
    changed = []
    for module, values in zip(modules, before, strict=True):
        for name, value in values.items():
            if name != "__warningregistry__" and vars(module).get(name, before) is not value:
                changed.append(f"{module.__name__}.{name}")
                setattr(module, name, value)
    if changed:
        raise InputError(f"it changes {changed[0]}, which is not its own: leave that out")


def used_by(names: dict[str, Any], chosen: str) -> set[str]:
    """Names of a file that one of its functions uses, and what it calls."""
    classes = [thing for thing in names.values() if isinstance(thing, type)]
    found, todo = {chosen}, [names[chosen]] if chosen in names else classes
    while todo:
        thing = todo.pop()
        parts = vars(type(thing)).values() if not isinstance(thing, FunctionType) else (thing,)
        for part in (*parts, *(vars(thing).values() if isinstance(thing, type) else ())):
            new = globals_of(part.__code__) - found if isinstance(part, FunctionType) else set()
            found |= new
            todo += [names[name] for name in new if name in names]
    return found
