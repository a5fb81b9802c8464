"""Where in a formula the edits belong that somebody names by their texts alone.

3*k + 3*m/3, write 2 for 3, repaired 3*k + 2*m/3    ->    the second 3
"""

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import product
from math import prod

from mechanics.blame.result import Edit
from mechanics.report.answer.marks import pieces

BESIDE, POWER = r"[\w.(]", r"|\*\*"
"""What goes on behind a name or number, and what makes a power of it."""

MANY = 200
"""Ways to place edits that are tried."""


def placed(formula: str, edits: Sequence[Edit], repaired: str = "") -> tuple[Edit, ...]:
    """Edits with their spans: where they make of the formula what it is when repaired.

    Where no places do, an edit gets one if what it changes stands there as often as it is changed;
    anything else would be a guess.
    """
    known = [_places(formula, edit.written, BESIDE) for edit in edits]
    if all(known) and prod(map(len, known)) <= MANY:
        wanted = "".join(repaired.split())
        for spans in product(*known):
            made = tuple(replace(e, span=s) for e, s in zip(edits, spans, strict=True))
            if "".join(applied(formula, made).split()) == wanted:
                return made
    found: list[Edit] = []
    for edit in edits:
        places = _places(formula, edit.written, BESIDE + POWER)
        same = [other for other in edits if other.written == edit.written]
        alone = len(places) == len(same)
        # Equal edits get their places in turn.
        turn = sum(other.written == edit.written for other in found)
        found.append(replace(edit, span=places[turn]) if alone and places else edit)
    return tuple(found)


def applied(source: str, edits: Sequence[Edit]) -> str:
    """A source with the right parts in place of the wrong ones."""
    cut = pieces(source, edits)
    return "".join(piece.text if piece.edit is None else piece.edit.right for piece in cut)


def _places(formula: str, written: str, behind: str) -> list[tuple[int, int]]:
    """Where a part stands by itself, with nothing of that kind behind it."""
    if not written:
        return []
    whole = rf"(?<![\w.]){re.escape(written)}(?!{behind})"
    return [match.span() for match in re.finditer(whole, formula)]
