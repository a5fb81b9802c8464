"""First integrals: what a line says to be constant has the rate zero.

p_psi = I3 (psi' + phi' cos(theta)) = const    ->    p_psi = I3 (...)    and    d/dt I3 (...) = 0
$E = ...$ is conserved                         ->    E = ...    and    d/dt (...) = 0
"""

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from fractions import Fraction

from mechanics.claims.latex.item import rate_of
from mechanics.claims.lines import Entry, Line
from mechanics.claims.names import Naming
from mechanics.claims.tree import Name, Node, Number, ended, names

CONSTANT = ("const", "constant", "konst", "cst")
NOTE = "what is constant has the rate zero"
SAID = re.compile(
    r"(?:(?!\$|\\\]|\\end\b).)*(?:\$\$?|\\\]|\\end\s*\{[a-z]+\*?\})"
    r"\s*(?:,\s*which\s+)?is\s+(?:(?:thus|therefore|also|then|hence|a)\s+)*"
    r"(?:conserved|constant|(?:first\s+)?integral)\b",
    re.DOTALL,
)
"""Behind a formula in a sentence, or a display."""


def with_first_integrals(lines: Iterable[Entry], naming: Naming, text: str) -> Iterator[Entry]:
    """The lines; those that end in ``= const``, or are called so, with what that says of the rate.

    Parameters
    ----------
    lines : iterable of Entry
    naming : Naming
        A scene or person that has a name const means that.
    text : str
        In which the lines stand.
    """
    for line in lines:
        line = _unnamed(line, naming)
        last = line.sides[-1] if isinstance(line, Line) and len(line.sides) > 1 else None
        if not isinstance(line, Line) or last is None or not _constant(last, naming):
            yield line
            if isinstance(line, Line) and _moves(line, naming) and SAID.match(text, line.at):
                yield _kept(line, line.sides[-1])
            continue
        *others, whole = line.sides[:-1]
        if others:
            yield replace(line, sides=(*others, whole))
        yield _kept(line, whole)


def _unnamed(line: Entry, naming: Naming) -> Entry:
    """The line without what it calls a constant: ``... = const = c``."""
    if not isinstance(line, Line) or len(line.sides) < 3:
        return line
    *_, constant, last = line.sides
    called = isinstance(last, Name) and not last.order and not naming.knows(last.name)
    return replace(line, sides=line.sides[:-1]) if called and _constant(constant, naming) else line


def _kept(line: Line, whole: Node) -> Line:
    """That the rate of a side is zero."""
    still = ended(Number(whole.at, Fraction(0)), whole.end)
    sides = (ended(rate_of(whole, 1, whole.at), whole.end), still)
    return replace(line, sides=sides, notes=(*line.notes, NOTE), others=())


def _moves(line: Line, naming: Naming) -> bool:
    """Whether something that moves stands on its right."""
    every = names(line.sides[-1])
    return len(line.sides) > 1 and any(n.order or naming.is_function(n.name) for n in every)


def _constant(side: Node, naming: Naming) -> bool:
    if not isinstance(side, Name) or side.order or side.name.lower() not in CONSTANT:
        return False
    return not naming.knows(side.name)
