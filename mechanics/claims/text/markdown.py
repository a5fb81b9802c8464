"""Markdown around formulas in a plain text: blanked, place by place.

**Energy:**  `V = m*g*x`  - **w = x'**: its rate        ->        V = m*g*x        w = x'

Only marks that no formula begins with: a power never begins a line.
"""

import re

FENCE = re.compile(r"^[ \t]*(?:```|~~~)[ \t]*[\w+-]*[ \t]*$", re.MULTILINE)
CODE = re.compile(r"(?<!`)`(?P<inside>[^`\n]+)`(?!`)")
BOLD = re.compile(
    r"^(?P<before>[ \t]*(?:[-*+\u2022][ \t]+|\d+\.[ \t]+)?)"
    r"\*\*(?P<inside>[^\s*](?:[^*\n]*[^\s*])?)\*\*"
    r"(?P<behind>(?:[ \t]*[:\u2013\u2014][^\n=]*)?)[ \t]*$",
    re.MULTILINE,
)
"""What is emphasised at the beginning of a line, alone or with words behind a colon."""


def without_markdown(text: str) -> str:
    """The text with blanks for its marks, and for emphasised words that are no formula."""
    text = FENCE.sub(_blank, text)
    text = CODE.sub(lambda m: f" {m['inside']} ", text)
    return BOLD.sub(_formula, text)


def _blank(match: re.Match[str]) -> str:
    return " " * len(match[0])


def _formula(match: re.Match[str]) -> str:
    """What is emphasised, where it is an equation."""
    if "=" not in match["inside"]:
        return _blank(match)
    before = " " * (len(match["before"]) + 2)
    return f"{before}{match['inside']}".ljust(len(match[0]))
