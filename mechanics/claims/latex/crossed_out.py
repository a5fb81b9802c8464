r"""A factor that is crossed out in every term of an equation: it may as well stand there.

\cancel{m}\ddot q - \cancel{m} a = \cancel{m} g    ->    {m}\ddot q - {m} a = {m} g

Anything else that is crossed out may be left out, or be zero: that is not read.
"""

import re
from itertools import pairwise

from mechanics.claims.brackets import depth, pieces

CROSSED = re.compile(r"\\cancel(?=\s*\{(?P<what>[^{}]*)\}(?!\s*[\^_']))")
ROW = re.compile(
    r"\\\\|\$+|\\[\[\]()]|\\(?:begin|end)\s*\{[^{}]*\}|\n[ \t]*\n"
    r"|\\(?:implies|iff|Rightarrow|Leftrightarrow|therefore|quad|qquad)(?![A-Za-z])"
)
SIGNS = "-+=\u2212"
OPENS, CLOSES = "({[", ")}]"
EMPTY = re.compile(r"[\s&.,;]*")


def without_crossings(text: str) -> str:
    r"""The text with blanks for ``\cancel`` where that is a factor of all terms of a row."""
    if "\\cancel" not in text:
        return text
    bounds = [0, *(at for m in ROW.finditer(text) for at in m.span()), len(text)]
    parts = [text[start:end] for start, end in pairwise(bounds)]
    return "".join(CROSSED.sub(_blank, part) if _is_common(part) else part for part in parts)


def _blank(match: re.Match[str]) -> str:
    return " " * len(match[0])


def _is_common(row: str) -> bool:
    """Whether one factor is crossed out in each term, but for a zero alone on its side."""
    if "\\over" in row:
        return False
    crossed = [_factors(term) for term in _terms(row)]
    return bool(crossed) and len({*crossed}) == 1 and len(crossed[0]) == 1


def _factors(term: str) -> tuple[str, ...]:
    """What is crossed out as a factor of a whole term; nothing where an argument or divisor is."""
    factors = []
    for match in CROSSED.finditer(term):
        before = term[: match.start()]
        if depth(term, match.start(), OPENS, CLOSES) > 0 or before.rstrip().endswith("/"):
            return ()
        factors.append(match["what"])
    return tuple(factors)


def _terms(row: str) -> list[str]:
    """What stands between signs outside of all brackets."""
    terms = (term for _, term in pieces(row, SIGNS, OPENS, CLOSES))
    return [term for term in terms if not EMPTY.fullmatch(term) and term.strip(" &.,\n\t") != "0"]
