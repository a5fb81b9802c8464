"""What functions of a person's own depend on: they are used for that, and for nothing else.

f(x, y) = x - y    ->    f(x, y), f(x) and f are the same        f(y, x), f(2 x), f(0) are not known
"""

from collections.abc import Mapping, Sequence

from mechanics.claims.lines import Entry, Line
from mechanics.claims.names import Naming, column
from mechanics.claims.place import Refused
from mechanics.claims.tree import Name, Node, constant, names


def told(naming: Naming, name: str, arguments: Sequence[Node]) -> tuple[str, ...]:
    """What stands in the brackets behind a function, by the scene's names; a column is its entries.

    Raises
    ------
    Refused
        For what is no name: the value of a function elsewhere.
    """
    found: list[str] = []
    for one in arguments:
        if not isinstance(one, Name):
            words = f"{name} of what is no name is not supported: write out what {name} is there"
            raise Refused(one.at, words)
        for entry in column(naming, one.name) or (one.name,):
            base, order = naming.lookup(entry) or (entry, 0)
            found.append(base + "'" * (order + one.order))
    return tuple(found)


def at_one_time(naming: Naming, name: Name, argument: Node) -> None:
    """Refuse ``x(0)``, which is no product.

    Raises
    ------
    Refused
        For a number behind what moves, and for zero behind any name.
    """
    number = constant(argument)
    if number == 0 or (number is not None and naming.is_function(name.name)):
        words = f"{name.name}({number}) is a value at one time, or a product: write \\cdot or *"
        raise Refused(argument.at, words)


def applied(lines: Sequence[Entry], naming: Naming) -> frozenset[str]:
    """Names that lines define as functions of what stands behind them."""
    return frozenset(
        left.name
        for left in (line.sides[0] for line in lines if isinstance(line, Line))
        if isinstance(left, Name) and left.given and not naming.knows(left.name)
    )


def applied_alike(sides: Sequence[Node], defined: Mapping[str, Line]) -> None:
    """Refuse a function of a person's own where it is taken of something else.

    Raises
    ------
    Refused
        With what the function is defined of, and what it is taken of.
    """
    for name in (n for side in sides for n in names(side)):
        left = defined[name.name].sides[0] if name.name in defined else None
        if not isinstance(left, Name) or not name.given or not left.given:
            continue
        short, long = sorted((name.given, left.given), key=len)
        rest = iter(long)
        if not all(one in rest for one in short):
            one, other = ", ".join(left.given), ", ".join(name.given)
            words = f"{name.name} is defined with the arguments ({one}) and used with ({other})"
            raise Refused(name.at, f"{words}: write out what it is")
