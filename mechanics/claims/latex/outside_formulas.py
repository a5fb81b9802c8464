r"""Equations that stand outside of every formula that was found: they are told, not passed over.

Then \ddot x = -x holds.        \begin{unknown} \ddot x = -x \end{unknown}
"""

import re
from collections.abc import Iterator, Sequence

from mechanics.claims.latex.blocks import INLINE, Block, claims
from mechanics.claims.names import GREEK

MATHEMATICAL = re.compile(
    r"\\(?:d{1,4}ot|[dt]?frac|partial|sin|cos|tan|left)(?![A-Za-z])"
    r"|\\begin\s*\{(?:[bpvBV]?matrix|array|d?cases|aligned|split)\}"
    rf"|\\(?:var)?(?:{'|'.join(sorted(GREEK))})(?![A-Za-z])|(?<!\\)\^"
    # Quotation marks stand before a blank or a letter: I theta'' = ...
    r"|(?<![\w'`])[A-Za-z]\w{0,9}'{2,3}\s*[-+=*/]|\\ensuremath(?![A-Za-z])"
)
"""What TeX takes in a formula only."""
BETWEEN = re.compile(r"\$?\s*=\s*\$?")
"""Of an equation whose sides are formulas of their own: $a$ = $b$."""
PARAGRAPH = re.compile(r"\n\s*\n")


def stray(text: str, found: Sequence[Block]) -> Iterator[tuple[int, int]]:
    """Where a paragraph of prose holds what may be an equation, from its first command on."""
    at = 0
    for block in (*found, Block(len(text), len(text))):
        if at and BETWEEN.fullmatch(text[at : block.start].strip()):
            yield at, block.start
        yield from _stray(text, at, block.start)
        at = max(at, block.end)


def within(text: str, block: Block) -> Iterator[tuple[int, int]]:
    r"""Where words in a display hold an equation of their own: ``\text{and $a = b$}``."""
    for match in () if block.inline else INLINE.finditer(text, block.start, block.end):
        if claims(match[0]):
            yield match.span()


def _stray(text: str, start: int, end: int) -> Iterator[tuple[int, int]]:
    while start < end:
        gap = PARAGRAPH.search(text, start, end)
        stop = gap.start() if gap else end
        first = MATHEMATICAL.search(text, start, stop)
        if first is not None and claims(text[start:stop]):
            yield first.start(), stop
        start = gap.end() if gap else end
