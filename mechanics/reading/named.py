"""Lines of a text, read again as it becomes known what its names mean.

f(x) = ...  ->  f is a function: f(x) is no product        th  ->  theta, by the best guess
"""

from collections.abc import Callable, Sequence
from dataclasses import replace

from mechanics.reading.arguments import applied
from mechanics.reading.columns import with_columns
from mechanics.reading.defined import own, turned, used
from mechanics.reading.guess import guess
from mechanics.reading.lines import Entry
from mechanics.reading.names import Naming

Read = Callable[[Naming], Sequence[Entry]]
"""Makes lines, given how names are to be understood."""


def named(read: Read, naming: Naming) -> tuple[Naming, list[Entry]]:
    """What all names mean, and the lines under these meanings."""
    lines = _lines(read, naming)
    if functions := applied(lines, naming):
        naming = replace(naming, applied=functions)
        lines = _lines(read, naming)
    if guessed := guess(naming, used(lines), own(lines, naming)):
        naming = replace(naming, guessed=guessed)
        lines = _lines(read, naming)
    return naming, lines


def _lines(read: Read, naming: Naming) -> list[Entry]:
    return with_columns(turned(read(naming), naming), naming)
