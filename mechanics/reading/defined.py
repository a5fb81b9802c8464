"""Which names the lines of a person use, and which they define themselves.

T = L - 2 x        T is defined where the scene has no such name
"""

from collections.abc import Sequence

from mechanics.reading.about import ENERGY_NAMES
from mechanics.reading.lines import Line, Unread
from mechanics.reading.names import Naming
from mechanics.reading.tree import Name, names


def used(lines: Sequence[Line | Unread]) -> list[Name]:
    """Every name, in order."""
    return [
        n for line in lines if isinstance(line, Line) for side in line.sides for n in names(side)
    ]


def own(lines: Sequence[Line | Unread], naming: Naming) -> list[str]:
    """Names that lines define."""
    return [
        line.sides[0].name
        for line in lines
        if isinstance(line, Line) and defines(line, naming) and isinstance(line.sides[0], Name)
    ]


def defines(line: Line, naming: Naming) -> bool:
    """Whether a name that nothing explains stands alone on the left."""
    left = line.sides[0]
    return (
        len(line.sides) > 1
        and isinstance(left, Name)
        and left.order == 0
        and not naming.knows(left.name)
    )


def needed(lines: Sequence[Line | Unread]) -> frozenset[str]:
    """Names that lines use which are no definitions of energies themselves."""
    found: set[str] = set()
    for line in lines:
        if isinstance(line, Line):
            left = line.sides[0]
            if not (isinstance(left, Name) and left.name in ENERGY_NAMES and len(line.sides) > 1):
                found |= {name.name for side in line.sides for name in names(side)}
    return frozenset(found)
