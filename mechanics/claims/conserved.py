"""First integrals: what a line says to be constant has the rate zero.

p_psi = I3 (psi' + phi' cos(theta)) = const    ->    p_psi = I3 (...)    and    d/dt I3 (...) = 0
"""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from fractions import Fraction

from mechanics.claims.latex.item import rate_of
from mechanics.claims.lines import Entry, Line
from mechanics.claims.names import Naming
from mechanics.claims.tree import Name, Node, Number, ended

WORDS = ("const", "constant", "konst", "cst")
NOTE = "what is constant has the rate zero"


def with_first_integrals(lines: Iterable[Entry], naming: Naming) -> Iterator[Entry]:
    """The lines, those that end in ``= const`` as what they say of the rate.

    Parameters
    ----------
    lines : iterable of Entry
    naming : Naming
        A scene or person that has a name const means that.
    """
    for line in lines:
        last = line.sides[-1] if isinstance(line, Line) and len(line.sides) > 1 else None
        if not isinstance(line, Line) or last is None or not _constant(last, naming):
            yield line
            continue
        *others, whole = line.sides[:-1]
        if others:
            yield replace(line, sides=(*others, whole))
        still = ended(Number(last.at, Fraction(0)), last.end)
        sides = (ended(rate_of(whole, 1, whole.at), whole.end), still)
        yield replace(line, sides=sides, notes=(*line.notes, NOTE), others=())


def _constant(side: Node, naming: Naming) -> bool:
    if not isinstance(side, Name) or side.order or side.name.lower() not in WORDS:
        return False
    return not naming.knows(side.name)
