"""M, C and G as three functions of a file, which are an equation only together.

getM(q)   getC(q, qd)   getG(q)     ->     getM_getC_getG(q, qd), which returns all three
"""

import inspect
import linecache
import re
from collections.abc import Callable, Sequence
from types import FunctionType
from typing import Any

from mechanics.claims.code.outputs import MASSES, spoken

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
    space = ordered[0].__globals__
    if (
        {*every} & {*names}
        or title in space
        or any(one.__globals__ is not space for one in parts.values())
    ):
        return tuple(functions)
    held = [_free(letter, {*every, *space}) for letter in "MCG"]
    lines = [f"def {title}({', '.join(every)}):"]
    lines += [
        f"    {name} = {one.__name__}({', '.join(takes[one])})"
        for name, one in zip(held, ordered, strict=True)
    ]
    lines.append(f"    return {', '.join(held)}")
    place = f"{origin} ({title})"
    text = "\n".join(lines) + "\n"
    linecache.cache[place] = (len(text), None, text.splitlines(keepends=True), place)
    exec(compile(text, place, "exec"), space)
    return (space[title],)


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
