r"""LaTeX before it is parsed: what only marks or labels a formula is blanked, place by place.

    \boxed{a = b}  % result        \underbrace{F}_{\text{drive}}        ->        a = b        {F}

No character moves, so that messages name the right place.
"""

import re

from mechanics.claims.latex.comments import blank, without_hidden
from mechanics.claims.latex.over_lines import on_one_line

MARKS = re.compile(
    r"\\(boxed|fbox|framebox|underbrace|overbrace|underline|shove(?:left|right)|smash|math[rl]lap|"
    r"ensuremath|[hv]?phantom|color|(?:textcolor|colorbox)\s*\{[^{}]{0,40}\})\s*\{"
)
BOLD_ZERO = re.compile(r"\\(?:mathbf|boldsymbol|bm|vec)(?=\s*\{?\s*0(?!\d))")
LABEL = re.compile(r"\s*[_^]\s*\{")


def prepared(text: str) -> str:
    """The text with blanks for comments, frames, and braces under formulas with their labels.

    Raises
    ------
    Refused
        Where it is not known what is printed.
    """
    text = BOLD_ZERO.sub(lambda m: " " * len(m[0]), on_one_line(without_hidden(text)))
    marks = list(MARKS.finditer(text))
    if not marks:
        return text
    closed = _closed(text)
    out = list(text)
    for mark in marks:
        end = closed.get(mark.end() - 1)
        if end is None:
            continue
        if mark[1] == "color" or mark[1].endswith("phantom"):
            blank(out, mark.start(), end + 1)
            continue
        braced = mark[1].endswith("brace")
        blank(out, mark.start(), mark.end() - braced)
        if not braced:
            blank(out, end, end + 1)
            continue
        label = LABEL.match(text, end + 1)
        below = closed.get(label.end() - 1) if label else None
        if label and below is not None:
            blank(out, label.start(), below + 1)
    return "".join(out)


def _closed(text: str) -> dict[int, int]:
    """Where each opening brace is closed."""
    found: dict[int, int] = {}
    opened: list[int] = []
    for match in re.finditer(r"(?<!\\)[{}]", text):
        if match[0] == "{":
            opened.append(match.start())
        elif opened:
            found[opened.pop()] = match.start()
    return found
