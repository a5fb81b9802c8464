r"""A person's LaTeX without what is no mathematics, wrong and right parts marked.

M \frac{L^{2}}{12} \ddot{\theta} + k x    ->    M \frac{L^{2}}{{\class{wrong}{12}...}} ... + k x
"""

import re
from collections.abc import Sequence

from mechanics.report.answer.marks import Piece

NO_MATHEMATICS = re.compile(
    r"\\(?:tag|label)\s*\*?\s*\{[^{}]*\}|\\(?:nonumber|notag|limits|nolimits|displaystyle)\b"
    r"|\\(?:begin|end)\s*\{(?![^{}]*(?:matrix|array|cases))[^{}]*\}|(?<!\\)\$"
)
TABLE = re.compile(r"\\begin\s*\{[^{}]*(?:matrix|array|cases)")
ALIGNED = re.compile(r"(?<!\\)&")
SIGNS = re.compile(r"[-+=]")


def marked(found: Sequence[Piece]) -> str:
    """LaTeX of pieces: what is wrong in the class ``wrong``, with ``right`` beside it."""
    table = bool(TABLE.search("".join(piece.text for piece in found)))
    return "".join(
        clean(piece.text, table) if piece.edit is None else both(piece.text, piece.edit.right)
        for piece in found
    )


def clean(latex: str, table: bool | None = None) -> str:
    """LaTeX without its numbers, labels and alignment, but of a table."""
    bare = NO_MATHEMATICS.sub(" ", latex)
    kept = bool(TABLE.search(bare)) if table is None else table
    return bare if kept else ALIGNED.sub(" ", bare)


def both(wrong: str, right: str) -> str:
    """LaTeX of a wrong part and the right one beside it."""
    parts = [
        rf"\class{{{name}}}{{{_infix(clean(text))}}}"
        for name, text in (("wrong", wrong), ("right", right))
        if text.strip()
    ]
    both = "".join(parts)
    # In a group of their own two parts are one argument; signs alone have to stay signs.
    return both if SIGNS.fullmatch(wrong.strip()) else f"{{{both}}}"


def _infix(latex: str) -> str:
    """A term with its sign, which is spaced as one between two terms."""
    signed = SIGNS.match(latex.strip()) and not SIGNS.fullmatch(latex.strip())
    return f"{{}}{latex}" if signed else latex
