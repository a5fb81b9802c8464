r"""What stands side by side where columns and matrices are written by one letter.

\omega \times J \omega        a vector product, where both sides may be columns
M(q) = ...                    M, which depends on q
"""

from collections.abc import Sequence
from dataclasses import replace

from mechanics.claims.arguments import told
from mechanics.claims.latex.item import Item
from mechanics.claims.names import COORDINATES, Naming
from mechanics.claims.tree import Name, Node, Table, names

CROSS = r"\times"
BY_ARGUMENT = "{name}'({by}) is read as the derivative of {name} by {by}"
DEPENDS = "{name}(...) is read as {name}, which depends on what is in brackets"


def vectors(naming: Naming, factors: Sequence[Node], rest: Sequence[Item]) -> bool:
    """Whether what stands on both sides may be a column: it holds one, or an unknown name."""

    def may_be_column(node: Node) -> bool:
        unknown = any(not naming.knows(name.name) for name in names(node))
        return isinstance(node, Table) or unknown

    right = [part for item in rest for part in (item.node, *item.arguments)]
    return any(map(may_be_column, factors)) and any(
        part is not None and may_be_column(part) for part in right
    )


def applied(items: list[Item], naming: Naming, notes: list[str]) -> list[Item]:
    """The left of a definition: ``M(q)`` with M unknown is M, which depends on q."""
    if len(items) != 2 or items[1].kind != "bracket" or items[1].power is not None:
        return items
    name, inside = items[0].node, items[1].arguments
    if not isinstance(name, Name) or naming.knows(name.name) or is_time(items[1]):
        return items
    if not all(
        isinstance(a, Name) and (a.name in COORDINATES or naming.is_function(a.name))
        for a in inside
    ):
        return items
    notes.append(DEPENDS.format(name=name.name))
    given = told(naming, name.name, inside)
    return [replace(items[0], node=replace(name, given=given))]


def is_time(item: Item) -> bool:
    """Whether an item is ``(t)``."""
    if item.kind != "bracket" or len(item.arguments) != 1:
        return False
    inside = item.arguments[0]
    return isinstance(inside, Name) and inside.name == "t" and inside.order == 0
