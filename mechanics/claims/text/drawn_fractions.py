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
    r"^(?P<above>[^\n=]*\S[^\n=]*)\n(?P<left>[^\n=]*\S[^\n=]*?)[ \t]*="
    r"[ \t]*[\u2500\u2501\u2014_-]{4,}[ \t]*\n(?P<below>[^\n=]*\S[^\n=]*)$",
    re.MULTILINE,
)

Read = Callable[[str, int], list[Entry]]
"""Lines of a part of a text, which begins at a place."""


def without_drawn(clean: str, read: Read) -> tuple[str, list[Entry]]:
    """The text with blanks for drawn fractions, and these as equations.

    Parameters
    ----------
    clean : str
    read : callable
    """
    found: list[Entry] = []

    def taken(match: re.Match[str]) -> str:
        parts = [read(match[name], match.start(name)) for name in ("left", "above", "below")]
        sides = [
            one[0].sides[0] for one in parts
            if len(one) == 1 and isinstance(one[0], Line) and len(one[0].sides) == 1
        ]  # fmt: skip
        if len(sides) < len(parts):
            return match[0]
        left, above, below = sides
        notes = tuple(n for one in parts for e in one if isinstance(e, Line) for n in e.notes)
        source = " ".join(f"{match['left']} = ({match['above']}) / ({match['below']})".split())
        right = product(above.at, [above, inverse(below)])
        found.append(Line((left, right), "", match.start("left"), source, notes))
        return re.sub(r"[^\n]", " ", match[0])

    return DRAWN.sub(taken, clean), found
