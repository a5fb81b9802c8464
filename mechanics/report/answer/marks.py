r"""The source of a statement, cut where it is wrong.

M g \cos \theta + k x    edits at 4..8    ->    "M g ", [\cos], " \theta + k x"
"""

from collections.abc import Sequence
from dataclasses import dataclass

from mechanics.blame.result import Edit

UNSEEN = "\N{REPLACEMENT CHARACTER}"


AROUND = 120
"""Characters beside an edit that are shown of a very long piece."""


@dataclass(frozen=True)
class Piece:
    """A part of a source; `edit` is what has to be done to it, None where it may stay."""

    text: str
    edit: Edit | None = None


def pieces(source: str, edits: Sequence[Edit] = ()) -> tuple[Piece, ...]:
    """A source cut at the spans of edits.

    Parameters
    ----------
    source : str
    edits : sequence of Edit
        Those without a span, and those whose span meets one before it or leaves the source, cut
        nothing.

    Returns
    -------
    tuple of Piece
        Their texts together are the source; the piece of a missing term is empty.
    """
    found, end = [], 0
    placed = [(edit.span, edit) for edit in edits if edit.span is not None]
    for (start, stop), edit in sorted(placed, key=lambda entry: entry[0]):
        if not end <= start <= stop <= len(source):
            continue
        if start > end:
            found.append(Piece(source[end:start]))
        found.append(Piece(source[start:stop], edit))
        end = stop
    if end < len(source) or not found:
        found.append(Piece(source[end:]))
    return tuple(found)


def printable(text: str) -> str:
    """A text of as many characters without those that move the cursor or give orders.

    What stands in a file of somebody else must not reach a terminal as an escape sequence.
    """
    return "".join(
        " " if c in "\n\t\r" else c if c.isprintable() or c == " " else UNSEEN for c in text
    )


def shortened(found: Sequence[Piece]) -> tuple[Piece, ...]:
    """Pieces of which the right ones keep their ends only, where they are very long."""
    kept = []
    last = len(found) - 1
    for n, piece in enumerate(found):
        text = piece.text
        if piece.edit is None and len(text) > 3 * AROUND:
            head = text[: AROUND if n else 0] if last else text[: 2 * AROUND]
            tail = text[len(text) - AROUND :] if n < last else ""
            text = f"{head}...{tail}"
        kept.append(Piece(text, piece.edit))
    return tuple(kept)
