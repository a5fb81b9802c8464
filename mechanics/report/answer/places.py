"""Where in a formula the edits belong that somebody names by their texts alone.

3*k + 3*m/3, write 2 for 3, repaired 3*k + 2*m/3    ->    the second 3
"""

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import product
from math import prod

from mechanics.blame.result import Edit, Mistake
from mechanics.report.answer.marks import pieces

MANY = 300
"""Ways to place edits that are tried."""

UNIT = re.compile(r"1/(\d+)")


def placed(formula: str, edits: Sequence[Edit], repaired: str = "") -> tuple[Edit, ...]:
    """Edits with their spans: where they make of the formula what it is when repaired.

    Where no places do, an edit gets one if what it changes stands there as often as it is changed;
    anything else would be a guess.
    """
    options = [[*_plain(formula, edit), *_shorter(formula, edit)] for edit in edits]
    if all(options) and prod(map(len, options)) <= MANY:
        wanted = "".join(repaired.split())
        for made in product(*options):
            if "".join(applied(formula, made).split()) == wanted:
                return made
    found: list[Edit] = []
    for edit in edits:
        places = [p for p in _plain(formula, edit) if not _powered(formula, p)]
        alone = len(places) == sum(other.written == edit.written for other in edits)
        # Equal edits get their places in turn.
        turn = sum(other.written == edit.written for other in found)
        found.append(places[turn] if alone and places else edit)
    return tuple(found)


def applied(source: str, edits: Sequence[Edit]) -> str:
    """A source with the right parts in place of the wrong ones."""
    cut = pieces(source, edits)
    return "".join(piece.text if piece.edit is None else piece.edit.right for piece in cut)


def _powered(formula: str, edit: Edit) -> bool:
    """Whether what an edit changes is the base of a power."""
    return edit.span is not None and formula.startswith("**", edit.span[1])


def _plain(formula: str, edit: Edit) -> list[Edit]:
    """The edit wherever what it changes stands by itself."""
    if not edit.written:
        return []
    whole = rf"(?<![\w.]){re.escape(edit.written)}(?![\w.(])"
    return [replace(edit, span=match.span()) for match in re.finditer(whole, formula)]


def _shorter(formula: str, edit: Edit) -> list[Edit]:
    """The same change told by less: of what is divided by, or of the sign before a term."""
    old, new = UNIT.fullmatch(edit.written), UNIT.fullmatch(edit.right)
    if old and new:
        below = rf"(?<=/){old[1]}(?![\w.])"
        return [
            replace(edit, written=old[1], right=new[1], span=match.span())
            for match in re.finditer(below, formula)
        ]
    if edit.mistake is not Mistake.SIGN or not edit.written:
        return []
    term = edit.written.removeprefix("-").strip()
    before = rf"[-+](?= {re.escape(term)}(?![\w.(]))"
    return [
        replace(edit, written=match[0], right="-" if match[0] == "+" else "+", span=match.span())
        for match in re.finditer(before, formula)
    ]
