"""M, C and G as three functions of a file, which are an equation only together.

getM(q)   getC(q, qd)   getG(q)     ->     getM_getC_getG(q, qd), which returns all three

Where nothing but inputs drives a scene, M and C are all of it, and G is zero.
"""

import inspect
import re
from collections.abc import Callable, Iterable, Sequence
from types import FunctionType
from typing import Any

from mechanics.claims.code.energy_names import MASSES
from mechanics.claims.code.function_names import spoken
from mechanics.claims.code.outputs import is_settled
from mechanics.claims.code.translation.python_page import Page, joined
from mechanics.scene import Gravity, Scene

TURNING = re.compile(r"c|coriolis(?: (?:and )?centri\w+)?(?: (?:matrix|vector|terms?|forces?))?")
FIELD = re.compile(r"g|gravity(?: (?:vector|terms?|forces?))?")
"""What functions of the second and third part are called, without `get_`."""


def together(functions: Sequence[Callable[..., Any]], origin: str, scene: Scene) -> tuple[Any, ...]:
    """One function for three that return M, C and G by their names; else these.

    Parameters
    ----------
    functions : sequence of callable
        Of one page.
    origin : str
        The author's file.
    scene : Scene
    """
    parts: dict[str, FunctionType] = {}
    for one in functions:
        if isinstance(one, FunctionType):
            parts.setdefault(_part(one.__name__), one)
    drifts = is_settled(scene) and not any(isinstance(load, Gravity) for load in scene.loads)
    free = drifts and parts.keys() == {"M", "C"}
    if len(functions) != len(parts) or not (free or parts.keys() == {"M", "C", "G"}):
        return tuple(functions)
    ordered = [parts[letter] for letter in "MCG" if letter in parts]
    takes = {one: [*inspect.signature(one).parameters] for one in ordered}
    every = [*dict.fromkeys(name for names in takes.values() for name in names)]
    names = [one.__name__ for one in ordered]
    title = "_".join(names)
    if {*every} & {*names}:
        return tuple(functions)
    held = [_free(letter, {*every, *names}) for letter in "MCG"]
    page = Page()
    page.put(1, 0, f"def {title}({joined(every)}):", opens=True)
    for name, one in zip(held, ordered, strict=False):
        page.lines.append(f"    {name} = {one.__name__}({joined(takes[one])})")
    if free:
        page.lines.append(f"    {held[-1]} = 0*{held[0]}[:, 0]")
    page.lines.append(f"    return {joined(held)}")
    made = page.module(f"{title} of {origin}", {one.__name__: one for one in ordered})
    return (made[title],)


def parts_of(title: str, names: Iterable[str]) -> tuple[str, ...]:
    """Names of the functions that one of this name puts together; its own for any other.

    Parameters
    ----------
    title : str
    names : iterable of str
        Of all functions of the page.
    """
    letters = {_part(name): name for name in names}
    ordered = [letters[letter] for letter in "MCG" if letter in letters]
    whole = (ordered, [name for name in ordered if _part(name) != "G"])
    return next((tuple(some) for some in whole if "_".join(some) == title), (title,))


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
