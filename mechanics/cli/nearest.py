"""The name that somebody meant who wrote one that there is not."""

from collections.abc import Iterable
from difflib import get_close_matches


def meant(name: str, known: Iterable[str]) -> str:
    """A question to add to a message, or nothing where no name is near.

    Examples
    --------
    >>> meant("thta", ["x", "theta"])
    ": did you mean 'theta'?"
    >>> meant("nothing", ["x", "theta"])
    ''
    """
    near = get_close_matches(name, list(known), n=1, cutoff=0.7)
    return f": did you mean {near[0]!r}?" if near else ""
