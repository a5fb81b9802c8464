"""Code that returns the next state by explicit Euler, entry by entry, as the rates it steps with.

    zn(1) = z(1) + h*z(2)    ->    zn(1) = z(2), where zn(1) is the rate of z(1)

Any other way to step is not read.
"""

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction

from mechanics.claims.lines import Aside, Entry, Line, Unread
from mechanics.claims.tree import (
    Name,
    Node,
    Number,
    Product,
    Sum,
    Table,
    constant,
    ended,
    names,
    product,
    total,
    with_parts,
)

NOT_READ = "it returns the next state, not by explicit Euler with one step: write the rates"

Place = Callable[[Node, str], int | None]
"""The number of a node among the entries of an array."""


def with_rates(
    lines: Sequence[Entry], returned: str, state: str, first: int, place: Place
) -> list[Entry]:
    """The lines; those where most entries of what is returned add to the state are a step.

    Parameters
    ----------
    lines : sequence of Entry
    returned, state : str
        Arrays.
    first : int
        The number of the first entry.
    place : callable
    """
    pairs = [line for line in lines if isinstance(line, Line) and len(line.sides) == 2]
    own = {
        line.sides[0].name: index for line in pairs
        if isinstance(line.sides[0], Name) and (index := place(line.sides[1], state)) is not None
    }  # fmt: skip

    def added(cell: Node, index: int) -> tuple[Node, ...]:
        """The terms beside the entry of the state; none where it is no term."""
        terms = cell.terms if isinstance(cell, Sum) else ()
        of = [own.get(t.name) if isinstance(t, Name) and not t.order else None for t in terms]
        here = [k for k, t in enumerate(terms) if index in (place(t, state), of[k])]
        return (*terms[: here[0]], *terms[here[0] + 1 :]) if len(here) == 1 else ()

    rests: dict[int, list[tuple[Node, ...]]] = {}
    for line in pairs:
        left, right = line.sides
        index = place(left, returned)
        if index is not None:
            rests[id(line)] = [added(right, index)]
        elif isinstance(left, Name) and left.name == returned and isinstance(right, Table):
            rests[id(line)] = [added(c, first + i) for i, c in enumerate(_cells(right))]
    every = [rest for cells in rests.values() for rest in cells]
    if not every or 2 * sum(map(bool, every)) < len(every):
        return list(lines)
    used = [name.name for line in pairs for name in names(line.sides[1])]
    back = any(place(name, returned) is not None for line in pairs for name in names(line.sides[1]))
    steps = _common([term for rest in every for term in rest])
    once = [s for s in steps if used.count(s) == sum(map(len, every))]
    step = once[0] if len(once) == 1 and all(every) and not back else ""

    def stepped(line: Entry) -> Entry:
        if not isinstance(line, Line):
            return line
        if id(line) not in rests:
            left = line.sides[0]
            number = len(line.sides) == 2 and constant(line.sides[1]) is not None
            # Beside a step that is not read no number is a claim: h = 0.01 is no length.
            if isinstance(left, Name) and (left.name == step or (number and not step)):
                return Aside(f"{line.source[:60]}: of the step", line.at)
            return line
        if not step:
            return Unread(line.source, line.at, line.at, NOT_READ, line.tag)
        left, right = line.sides
        rates = [
            ended(total(cell.at, [_without(term, step) for term in rest]), cell.end)
            for cell, rest in zip(_cells(right), rests[id(line)], strict=True)
        ]
        side = rates[0]
        if isinstance(right, Table):
            side = ended(with_parts(right, tuple(rates)), right.end)
        notes = (*line.notes, f"the next state by explicit Euler, step {step}")
        return replace(line, sides=(left, side), notes=notes)

    return [stepped(line) for line in lines]


def _cells(node: Node) -> list[Node]:
    return [cell for row in node.rows for cell in row] if isinstance(node, Table) else [node]


def _factors(term: Node) -> list[Node]:
    if not isinstance(term, Product):
        return [term]
    return [inner for factor in term.factors for inner in _factors(factor)]


def _common(terms: Sequence[Node]) -> list[str]:
    """Names that each term has as a factor once."""
    counts = [
        Counter(f.name for f in _factors(term) if isinstance(f, Name) and not f.order)
        for term in terms
    ]
    return [name for name in counts[0] if all(count[name] == 1 for count in counts)]


def _without(term: Node, step: str) -> Node:
    rest = [f for f in _factors(term) if not (isinstance(f, Name) and f.name == step)]
    return ended(product(term.at, rest or [Number(term.at, Fraction(1))]), term.end)
