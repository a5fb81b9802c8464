"""Markdown around formulas in a plain text: blanked, place by place.

**Energy:**  `V = m*g*x`  - **w = x'**: its rate        ->        V = m*g*x        w = x'

Only marks that no formula begins with: a power never begins a line.
"""

import re
from collections.abc import Iterator

FENCE = re.compile(r"^[ \t]*(?:```|~~~)[ \t]*[\w+-]*[ \t]*$", re.MULTILINE)
CODE = re.compile(r"(?<!`)`(?P<inside>[^`\n]+)`(?!`)")
BOLD = re.compile(
    r"^(?P<before>[ \t]*(?:[-*+\u2022][ \t]+|\d+\.[ \t]+)?)"
    r"\*\*(?P<inside>[^\s*](?:[^*\n]*[^\s*])?)\*\*"
    r"(?P<behind>(?:[ \t]*[:\u2013\u2014][^\n=]*)?)[ \t]*$",
    re.MULTILINE,
)
"""What is emphasised at the beginning of a line, alone or with words behind a colon."""


ITEM = re.compile(
    r"^[ \t]*(?P<mark>[-\u2013])[ \t]+(?P<code>`?)(?P<left>[^\n=]*?)[ \t]*=", re.MULTILINE
)
ALONE = re.compile(r"[^\s+\-*^]+")
"""A left side that is one name or derivative: nobody writes a minus and a blank before it."""
WORDS = re.compile(r"[^\W\d_]{2,}[ \t]+[^\W\d_]{2,}")
GOES_ON = re.compile(r"[-+*/=^(\u2212][ \t]*$|^(?=[^\n]*[*/^'()\u00b2])[^=:\n]*$")
"""A line whose formula goes on in the next one."""


def without_dashes(text: str) -> str:
    """The text with blanks for dashes that are the marks of a list and no minus signs, and for
    lines whose dash may be either.

    Parameters
    ----------
    text : str
    """
    out = list(text)
    for item in _items(text):
        out[item.start("mark")] = " "
    for at, _ in doubtful_dashes(text):
        end = text.find("\n", at)
        end = len(text) if end < 0 else end
        out[at:end] = " " * (end - at)
    return "".join(out)


def doubtful_dashes(text: str) -> Iterator[tuple[int, str]]:
    """Dashes that may be a minus or the mark of a list: their places, and what is to be done.

    Parameters
    ----------
    text : str
    """
    items = _items(text)
    for item in items if len(items) == 1 else ():
        if not item["code"] and not ALONE.fullmatch(item["left"]):
            yield (
                item.start("mark"),
                "the dash may be a minus or the mark of a list: write no blank behind a minus, and"
                " leave the mark out",
            )


def _items(text: str) -> list[re.Match[str]]:
    """Lines with an equation of their own that begin with a dash and a blank.

    One alone between equations without a dash is no item of a list, but begins with a minus.
    """
    items = [
        item for item in ITEM.finditer(text)
        if not WORDS.search(item["left"]) and not _follows(text, item.start())
    ]  # fmt: skip
    beside = len(items) == 1 and any("=" in line for line in _beside(text, items[0].start()))
    return [] if beside else items


def _beside(text: str, start: int) -> tuple[str, str]:
    """The lines before and behind that of a place."""
    before = text[:start].removesuffix("\n").rpartition("\n")[2]
    return before, text[start:].partition("\n")[2].partition("\n")[0]


def _follows(text: str, start: int) -> bool:
    """Whether what stands before a line goes on in it."""
    return GOES_ON.search(_beside(text, start)[0]) is not None


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
