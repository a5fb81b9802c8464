"""M, C and G as three functions of a file, which are an equation only together.

getM(q)   getC(q, qd)   getG(q)     ->     getM_getC_getG(q, qd), which returns all three
"""

import inspect
import re
from collections.abc import Callable, Sequence
from types import FunctionType
from typing import Any

from mechanics.claims.code.outputs import MASSES, spoken
from mechanics.claims.code.python_page import Page, joined

TURNING = re.compile(r"c|coriolis(?: (?:and )?centri\w+)?(?: (?:matrix|vector|terms?|forces?))?")
FIELD = re.compile(r"g|gravity(?: (?:vector|terms?|forces?))?")
"""What functions of the second and third part are called, without `get_`."""


def together(functions: Sequence[Callable[..., Any]], origin: str) -> tuple[Any, ...]:
    """One function for three that return M, C and G by their names; else these.

    Parameters
    ----------
    functions : sequence of callable
        Of one page.
    origin : str
        The author's file.
    """
    parts: dict[str, FunctionType] = {}
    for one in functions:
        if isinstance(one, FunctionType):
            parts.setdefault(_part(one.__name__), one)
    if len(functions) != len(parts) or parts.keys() != {"M", "C", "G"}:
        return tuple(functions)
    ordered = [parts[letter] for letter in "MCG"]
    takes = {one: [*inspect.signature(one).parameters] for one in ordered}
    every = [*dict.fromkeys(name for names in takes.values() for name in names)]
    names = [one.__name__ for one in ordered]
    title = "_".join(names)
    if {*every} & {*names}:
        return tuple(functions)
    held = [_free(letter, {*every, *names}) for letter in "MCG"]
    page = Page()
    page.put(1, 0, f"def {title}({joined(every)}):", opens=True)
    for name, one in zip(held, ordered, strict=True):
        page.lines.append(f"    {name} = {one.__name__}({joined(takes[one])})")
    page.lines.append(f"    return {joined(held)}")
    made = page.module(f"{title} of {origin}", {one.__name__: one for one in ordered})
    return (made[title],)


def _part(title: str) -> str:
    """The letter of what a function returns by its own name; the name itself for another one."""
    words = spoken(title)
    if words in MASSES:
        return "M"
    letters = (("C", TURNING), ("G", FIELD))
    return next((letter for letter, pattern in letters if pattern.fullmatch(words)), title)


def _free(letter: str, taken: set[str]) -> str:
    """A name that begins with a letter, and that nothing else has."""
    while letter in taken:
        letter += "_"
    return letter
