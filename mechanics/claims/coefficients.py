"""Whether an entry of a matrix is written as the coefficient that it is: M_12 theta'' + ... .

So it is the equation that says what it is, in whatever unit. In 1/2 M_12 theta'', or beside another
term with theta'', it has a value of its own.
"""

from collections.abc import Sequence

from mechanics.claims.lines import Entry, Line
from mechanics.claims.names import Naming
from mechanics.claims.tree import Name, Node, Product, Sum, Table, names, parts


def is_coefficient(name: str, definition: Line, lines: Sequence[Entry], naming: Naming) -> bool:
    """Whether lines have a name alone in a table, or with an acceleration that stands once."""
    others = [line for line in lines if isinstance(line, Line) and line is not definition]
    return all(
        _is_alone(name, side, line, naming)
        for line in others for side in line.sides if _holds(side, name)
    )  # fmt: skip


def _holds(node: Node, name: str) -> bool:
    return any(one.name == name for one in names(node))


def _is_alone(name: str, side: Node, line: Line, naming: Naming) -> bool:
    if isinstance(side, Name):
        return side is line.sides[0]
    tables = [side]
    while tables:
        node = tables.pop()
        if isinstance(node, Table):
            cells = [cell for row in node.rows for cell in row if _holds(cell, name)]
            return all(isinstance(cell, Name) for cell in cells)
        tables += [part for part in parts(node) if _holds(part, name)]
    every = [term for one in line.sides for term in _terms(one)]
    for term in (term for term in every if _holds(term, name)):
        factors = term.factors if isinstance(term, Product) else ()
        if len(factors) != 2 or not all(isinstance(one, Name) for one in factors):
            return False
        moving = {_acceleration(one, naming) for one in names(term)} - {""}
        rest = [one for other in every if other is not term for one in names(other)]
        if len(moving) != 1 or moving & {_acceleration(one, naming) for one in rest}:
            return False
    return True


def _terms(side: Node) -> Sequence[Node]:
    return side.terms if isinstance(side, Sum) else (side,)


def _acceleration(name: Name, naming: Naming) -> str:
    """The coordinate of which a name is the acceleration; empty for any other name."""
    found = naming.lookup(name.name)
    return found[0] if found is not None and found[1] + name.order == 2 else ""
