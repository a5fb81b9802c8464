"""Words of messages: what to write instead of a name that there is not; numbers of things."""

from collections.abc import Iterable
from difflib import get_close_matches

FEW = 8
"""Names that are listed beside the nearest one."""


def instead(name: str, names: Iterable[str], kind: str) -> str:
    """What to write instead of a name that there is not: the nearest one, or any.

    Parameters
    ----------
    name : str
    names : iterable of str
        Those that there are.
    kind : str
        What they are, in the plural.

    Examples
    --------
    >>> instead("thta", ["x", "theta"], "coordinates")
    "did you mean 'theta'? the coordinates are x, theta"
    >>> instead("nothing", ["x", "theta"], "coordinates")
    'the coordinates are x, theta'
    """
    listed = list(names)
    there = f"the {kind} are {', '.join(listed)}" if listed else f"there are no {kind}"
    near = get_close_matches(name, listed, n=1)
    if near and len(listed) > FEW:
        return f"did you mean {near[0]!r}?"
    return f"did you mean {near[0]!r}? {there}" if near else there


def plural(count: int, noun: str) -> str:
    """A number and what is counted: "1 body", "2 bodies"."""
    many = f"{noun[:-1]}ies" if noun.endswith("y") else f"{noun}s"
    return f"{count} {noun if count == 1 else many}"
