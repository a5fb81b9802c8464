"""Lines of a text: equations with one side or more, each with the place where it stands."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from mechanics.reading.tree import Node

PRODUCT = "is read as the product"
"""In a note on letters that stand side by side."""


@dataclass(frozen=True)
class Line:
    """One equation or expression as a person wrote it.

    Attributes
    ----------
    sides : tuple of Node
        One or more.
    tag : str
        ``"(6)"``, or empty.
    at : int
        Where it begins in the text.
    source : str
        The text of it.
    notes : tuple of str
        How what can be read in two ways was read.
    """

    sides: tuple[Node, ...]
    tag: str
    at: int
    source: str
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Unread:
    """A part of a text that cannot be read; `words` is one line with its place."""

    source: str
    words: str
    at: int
    tag: str = ""


@dataclass(frozen=True)
class Aside:
    """A part of a text that says nothing to be judged, as the value of a parameter."""

    words: str
    at: int


Entry = Line | Unread | Aside
"""What a reader finds in a text."""


def told_once(lines: Sequence[Entry]) -> tuple[list[Entry], list[str]]:
    """The lines, and apart from them how letters were parted: it is the same in all of them."""
    told: dict[str, None] = {}
    found: list[Entry] = []
    for line in lines:
        if isinstance(line, Line):
            told |= dict.fromkeys(note for note in line.notes if PRODUCT in note)
            line = replace(line, notes=tuple(note for note in line.notes if note not in told))
        found.append(line)
    return found, list(told)
