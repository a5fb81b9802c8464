"""Lines of a text, read again as it becomes known what its names mean.

f(x) = ...  ->  f is a function: f(x) is no product        th  ->  theta, by the best guess
"""

from collections.abc import Callable, Sequence
from dataclasses import replace

from mechanics.claims.arguments import applied
from mechanics.claims.columns import with_columns, with_entries
from mechanics.claims.definitions import apart, definitions, momenta, own, turned, used, with_rates
from mechanics.claims.energy_terms import energy_terms
from mechanics.claims.guess import guess
from mechanics.claims.laws import without_laws
from mechanics.claims.lines import Entry, Line
from mechanics.claims.names import Match, Naming
from mechanics.claims.partials import canonical
from mechanics.claims.reaction_letters import other_letters
from mechanics.claims.sines import with_sines
from mechanics.claims.spelled_rates import key
from mechanics.claims.text.elements import with_states
from mechanics.claims.tree import Name, Node
from mechanics.claims.unread_names import unread_names
from mechanics.scene.symbols import DOTS

Read = Callable[[Naming], Sequence[Entry]]
"""Makes lines, given how names are to be understood."""


def named(
    read: Read, naming: Naming, text: str, beside: Sequence[tuple[int, str]]
) -> tuple[Naming, list[Entry]]:
    """What all names mean, and the lines under these meanings.

    Parameters
    ----------
    beside : sequence of (int, str)
        What is no part of the formulas, as comments.
    """
    lines = _lines(read, naming, text)
    energies = energy_terms(lines, naming)
    if functions := applied(lines, naming) | energies:
        naming = replace(naming, applied=functions)
        lines = _lines(read, naming, text)
    if others := other_letters(lines, naming):
        naming = replace(naming, others=others)
        lines = _lines(read, naming, text)
    lines, entries = with_states(lines, naming)
    naming = replace(naming, guessed=entries)
    lines = without_laws(lines, naming)
    naming = replace(naming, unread=unread_names(lines, beside, text))
    open_names = [name for name in used(lines) if name.name not in energies]
    guessed = guess(naming, open_names, own(lines, naming))
    found = momenta(lines, replace(naming, guessed=(*entries, *guessed)))
    of = "the generalized momentum, by what it is defined as"
    guessed += tuple(Match(n, base + DOTS[order], of) for n, (base, order) in found.items())
    trees = {name: line.sides[1] for name, line in definitions(lines, naming).items()}
    if guessed or trees:
        plain = replace(naming, guessed=(), own=trees)
        naming = replace(naming, guessed=(*entries, *guessed), own=trees)
        lines, _ = with_states(_lines(read, naming, text), plain)
        lines = without_laws(lines, naming)
    return naming, lines


def _lines(read: Read, naming: Naming, text: str) -> list[Entry]:
    whole = [
        _without_determinant(line) if isinstance(line, Line) else line
        for line in read(naming)
    ]  # fmt: skip
    lines = with_rates(apart(with_entries(whole, naming), naming), naming)
    lines = turned(lines, naming)
    own = {*definitions(lines, naming), *(_left(line) for line in lines)}
    lines = [
        replace(line, sides=_once([canonical(s, naming, own) for s in line.sides]))
        if isinstance(line, Line) else line
        for line in lines
    ]  # fmt: skip
    return with_columns(with_sines(lines, naming, text), naming)


def _once(sides: list[Node]) -> tuple[Node, ...]:
    """The sides but those that are the first name again: p = dL/dq' = m q', where dL/dq' is p."""
    first, *rest = sides
    name = (key(first.name), first.order) if isinstance(first, Name) else None
    kept = [s for s in rest if not (isinstance(s, Name) and (key(s.name), s.order) == name)]
    return (first, *kept) if kept else tuple(sides)


def _without_determinant(line: Line) -> Line:
    r"""The line without ``\det M`` between a name and what it is: D = \det M = a c - b^2."""
    kept = tuple(s for s in line.sides if not (isinstance(s, Name) and s.name.startswith("det(")))
    if len(kept) < 2 or len(kept) == len(line.sides):
        return line
    words = f"the side that is a determinant in {line.source}"
    return replace(line, sides=kept, unjudged=(*line.unjudged, words))


def _left(line: Entry) -> str:
    """The name that stands alone on the left side of an equation."""
    left = line.sides[0] if isinstance(line, Line) and len(line.sides) > 1 else None
    return left.name if isinstance(left, Name) else ""
