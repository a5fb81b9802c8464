"""Fractions that are drawn with a line of their own in plain text.

          -g sin(theta)
theta'' = -------------
                l
"""

import re
from collections.abc import Callable

from mechanics.claims.lines import Entry, Line
from mechanics.claims.tree import inverse, product

DRAWN = re.compile(
    r"^(?P<above>[^\n=]*)\n(?P<left>[^\n=]*)=[ \t]*[\u2500\u2501\u2014_-]{4,}[ \t]*\n"
    r"(?P<below>[^\n=]*)$",
    re.MULTILINE,
)
"""A line above, a name and a line of dashes, a line below."""

NAMES = ("left", "above", "below")
Read = Callable[[str, int], list[Entry]]
"""Lines of a part of a text, which begins at a place."""


def without_drawn(text: str, clean: str, read: Read) -> tuple[str, list[Entry]]:
    """The clean text with blanks for drawn fractions, and these as equations.

    Parameters
    ----------
    text : str
        As it was typed: a line of dashes ends no line that goes on.
    clean : str
        The same, place by place, without comments.
    read : callable
    """
    found: list[Entry] = []
    for match in DRAWN.finditer(text):
        if not all(match[name].strip() for name in NAMES):
            continue
        spans = [match.span(name) for name in NAMES]
        parts = [read(clean[start:end], start) for start, end in spans]
        sides = [
            one[0].sides[0] for one in parts
            if len(one) == 1 and isinstance(one[0], Line) and len(one[0].sides) == 1
        ]  # fmt: skip
        if len(sides) < len(parts):
            continue
        left, above, below = sides
        notes = tuple(n for one in parts for e in one if isinstance(e, Line) for n in e.notes)
        source = " ".join(
            f"{match['left'].rstrip()} = ({match['above']}) / ({match['below']})".split()
        )
        right = product(above.at, [above, inverse(below)])
        found.append(Line((left, right), "", match.start("left"), source, notes))
        start, end = match.span()
        clean = clean[:start] + re.sub(r"[^\n]", " ", clean[start:end]) + clean[end:]
    return clean, found
