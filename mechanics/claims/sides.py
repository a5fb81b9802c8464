"""The sides of a line as they were built: their shape, what they hold, which comes first.

v = a w = x'    with a and w unknown:    x' is what v stands for
"""

from collections.abc import Sequence

from sympy import S
from sympy.matrices import MatrixBase

from mechanics.claims.build import Builder, Value
from mechanics.claims.lines import Line
from mechanics.claims.partials import PARTIAL
from mechanics.claims.place import Refused
from mechanics.claims.tree import Call, Name, Node, Rate, names, parts


def known_first(builder: Builder, line: Line) -> tuple[tuple[Value, ...], Node]:
    """The sides of a definition, one without names that nothing explains first, and its tree."""
    built: list[tuple[bool, Value, Node]] = []
    for side in line.sides[1:]:
        before = len(builder.unknown)
        value = builder(side)
        built.append((len(builder.unknown) > before, value, side))
    built.sort(key=lambda entry: entry[0])
    return tuple(value for _, value, _ in built), built[0][2]


def distinct(sides: tuple[Value, ...]) -> tuple[Value, ...]:
    """The sides without those that are there twice, of which two are left: x'' = w' = ... ."""
    found = tuple(dict.fromkeys(sides))
    return found if len(found) > 1 else sides[:2]


def held(builder: Builder, sides: Sequence[Node]) -> list[str]:
    """Names that an equation holds when it is built: in N - N = 0 there is none.

    Parameters
    ----------
    builder : Builder
        That knows no definitions.
    sides : sequence of Node
    """
    every = [name.name for side in sides for name in names(side)]
    if len(sides) != 2 or any(differentiates(side) for side in sides):
        return every  # what a name stands for may move
    try:
        left, right = (builder(side) for side in sides)
    except Refused:
        return every
    if not scalar((left, right)):
        return every
    return [name for name in every if holds(left - right, name)]


def differentiates(node: Node) -> bool:
    """Whether a rate of more than a name, or a partial derivative, is taken in a tree."""
    partial = isinstance(node, Call) and node.function == PARTIAL
    return partial or isinstance(node, Rate) or any(map(differentiates, parts(node)))


def is_named(node: Node, name: str) -> bool:
    """Whether a side is this name."""
    return isinstance(node, Name) and node.name == name


def holds(side: Value, name: str) -> bool:
    """Whether a side holds a name that nothing explains, with or without primes."""
    return any(symbol.name.rstrip("'") == name for symbol in side.free_symbols)


def entries(sides: Sequence[Value]) -> list[tuple[int, tuple[Value, ...]]]:
    """What an equation of matrices says, entry by entry, with the number of each.

    Entries that are the same on all sides say nothing: they are left out, unless all are.
    """
    size = max(len(side) for side in sides if isinstance(side, MatrixBase))
    every = [
        (i + 1, tuple(side[i] if isinstance(side, MatrixBase) else S.Zero for side in sides))
        for i in range(size)
    ]
    return [(i, e) for i, e in every if len(set(e)) > 1 or len(e) == 1] or every


def shape(side: Value) -> tuple[int, int] | None:
    """Of a matrix."""
    return side.shape if isinstance(side, MatrixBase) else None


def scalar(sides: Sequence[Value]) -> bool:
    """Whether no side is a matrix."""
    return not any(isinstance(side, MatrixBase) for side in sides)
