"""Lines of a text: equations with one side or more, each with the place where it stands."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from mechanics.claims.names import Naming
from mechanics.claims.tree import Name, Node, names

FIELD = re.compile(r"=\s*[^\W\d]\w*\.[^\W\d]")
"""What a field of a record gives to a name."""
NOT_USED = "values in the code are not used"
"""In a note on a parameter that a person's code gives a value."""
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
    others : tuple of (str, tuple of Node)
        Other ways to read it, in words, and its sides then.
    """

    sides: tuple[Node, ...]
    tag: str
    at: int
    source: str
    notes: tuple[str, ...] = ()
    others: tuple[tuple[str, tuple[Node, ...]], ...] = ()
    unjudged: tuple[str, ...] = ()


@dataclass(frozen=True)
class Unread:
    """A part of a text, from `at` on, that cannot be read, and why: `words` about `where`."""

    source: str
    at: int
    where: int
    words: str
    tag: str = ""


@dataclass(frozen=True)
class Aside:
    """A part of a text that says nothing to be judged, as the value of a parameter."""

    words: str
    at: int


def gives(line: Line, naming: Naming) -> bool:
    """Whether an equation sets a name to a number, or parameters to each other.

    The rate of what the scene does not have is given no value: that E' = 0 is a claim on E.
    """
    if len(line.sides) < 2:
        return False
    plain = [side for side in line.sides if isinstance(side, Name)]
    if any(side.order and naming.lookup(side.name) is None for side in plain):
        return False
    numbers = [side for side in line.sides if not names(side)]
    if len(plain) + len(numbers) < len(line.sides) or not plain:
        return False
    return bool(numbers) or all(naming.is_function(side.name) is False for side in plain)


def gives_constants(line: Line, naming: Naming) -> bool:
    """Whether all that it sets are parameters: a reaction that is given a value is a claim."""
    plain = [side.name for side in line.sides if isinstance(side, Name)]
    if FIELD.search(line.source) and len({naming.lookup(name) for name in plain}) > 1:
        return False  # m = p.l
    return gives(line, naming) and all(is_constant(name, naming) for name in plain)


def gives_an_input(line: Line, naming: Naming) -> bool:
    """Whether a name of an input is set to a number: in code that is an example, too."""
    left, *others = line.sides
    found = naming.lookup(left.name) if isinstance(left, Name) and not left.order else None
    inputs = {symbol.name for symbol in naming.vocabulary.scene.input_symbols}
    is_input = found is not None and not found[1] and found[0] in inputs
    return is_input and len(others) == 1 and not names(others[0])


def is_constant(name: str, naming: Naming) -> bool:
    """Whether a name is that of a parameter of the scene."""
    found = naming.lookup(name)
    if found is None or naming.is_function(name) is not False:
        return False
    return found[0] not in naming.vocabulary.reactions


def value(source: str, at: int) -> Aside:
    """The value of a parameter, which says nothing that could be judged."""
    words = " ".join(source.split())
    return Aside(f"{words[:60]}: values and lists in the text are not used", at)


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
