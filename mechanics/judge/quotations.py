r"""Quotations in Markdown: which ones are plainly text of the page.

### Pendulum
> $$\ddot\theta = \ldots$$           set off, and said by the page: read

>! ..., > [!note]- ..., > > ...      folded away, or an answer to somebody: not read

Ann wrote:
> $$\ddot\theta = \ldots$$           beside words of the page: not read, it may be Ann's
"""

import re
from collections.abc import Iterator, Sequence
from itertools import groupby

from mechanics.judge.phrases import words

QUOTED = re.compile(r"^[ \t]*>[ \t]*", re.MULTILINE)
INSIDE = re.compile(r"[>!]|[-\u2013\u2014]{1,3}[ \t]*[^\W\da-z_]\w*[^$=\\:]*$")
"""A quotation inside, a spoiler, or who says it."""
CALLOUT = re.compile(r"\[!(?P<name>\w+)\](?P<folded>[-+]?)")
SHOWN = words("""
    note tip info abstract summary example important definition theorem lemma proof solution
    success hint
""")
"""Callouts that state what they hold."""
NO_WORDS = re.compile(r"#{1,6}[ \t]|[-=*_]{3,}[ \t]*$|\$\$|\\\[|\\\]|\\(?:begin|end)\b")
"""How a heading, a rule or a display begins."""


def foreign_quotation(text: str) -> bool:
    """Whether a text has a quotation that may hide what it holds, or may be somebody else's."""
    lines = [line for line in text.splitlines() if line.strip()]
    runs = [(is_one, list(run)) for is_one, run in groupby(lines, _is_quoted)]
    return any(is_one and _foreign(runs, k) for k, (is_one, _) in enumerate(runs))


def _is_quoted(line: str) -> bool:
    return QUOTED.match(line) is not None


def _foreign(runs: Sequence[tuple[bool, list[str]]], place: int) -> bool:
    inside = [QUOTED.sub("", line, count=1) for line in runs[place][1]]
    if any(INSIDE.match(line) or not _shown(line) for line in inside):
        return True
    equations = any("=" in line for line in inside)
    return equations and not all(NO_WORDS.match(line) for line in _around(runs, place))


def _shown(line: str) -> bool:
    """Whether a line begins no callout that folds, asks or warns."""
    callout = CALLOUT.match(line)
    return callout is None or (callout["name"].lower() in SHOWN and callout["folded"] != "-")


def _around(runs: Sequence[tuple[bool, list[str]]], place: int) -> Iterator[str]:
    """The lines before and after a quotation."""
    if place:
        yield runs[place - 1][1][-1].strip()
    if place + 1 < len(runs):
        yield runs[place + 1][1][0].strip()
