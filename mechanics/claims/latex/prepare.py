r"""LaTeX before it is parsed: what only marks or labels a formula is blanked, place by place.

    \boxed{a = b}  % result        \underbrace{F}_{\text{drive}}        ->        a = b        {F}

No character moves, so that messages name the right place.
"""

import re
from collections.abc import Iterator

from mechanics.claims.latex.comments import blank, without_hidden
from mechanics.claims.latex.crossed_out import without_crossings
from mechanics.claims.latex.over_lines import on_one_line
from mechanics.claims.place import Refused

COLOURS = "black|red|blue|green|orange|purple|magenta|brown|violet|teal|cyan|darkgray|gray"
"""In which a formula is seen on white paper."""
MARKS = re.compile(
    r"\\(boxed|fbox|framebox|underbrace|overbrace|underline|shove(?:left|right)|smash|math[rl]lap|"
    rf"ensuremath|[hv]?phantom|color(?=\s*\{{\s*(?:{COLOURS})\s*\}})"
    rf"|textcolor\s*\{{\s*(?:{COLOURS})\s*\}})\s*\{{"
)
SMALL = re.compile(
    r"[-+]\s*(?:\\order|\\mathcal\s*\{?\s*O\s*\}?)\s*(?:\\left\s*)?\([^()]{0,40}[A-Za-z][^()]{0,40}\)"
)
"""What is left out of a series: + O(theta^2), no term of an equation."""
DECIMAL = re.compile(r"(?<![\d.,}])(?:0\{,\}\d+|\d+\{,\}(?!\d{3}(?!\d))\d+)(?![\d{])")
"""A number with a comma; three digits behind it may be thousands, which are not read."""
COMMA = re.compile(
    r"(?<=[=+\-(&{])\s*\d+,\d+(?=\s*(?:\\[dtc]?frac(?![A-Za-z])|\\cdot(?![A-Za-z])|[A-Za-z]))(?![A-Za-z]\s*[,)])"
)
"""A number with a comma before what it multiplies: 1,5\\frac{g}{l}."""
BOLD_ZERO = re.compile(r"\\(?:mathbf|boldsymbol|bm|vec)(?=\s*\{?\s*0(?!\d))")
SHORT = (re.compile(r"\bK\.E\.(?!\w)"), "E_k "), (re.compile(r"\bP\.E\.(?!\w)"), "E_p ")
"""Energies by their initials, which are no products."""
LEADER = re.compile(
    r"(?<=[\w})])\s*\\[cl]?dots\s*(?:[A-Z]|[A-Za-z]?_?\{?\d\}?)\s*(?=\$\$|\\\]|\\end\s*\{equation)"
)
"""Dots up to the label of a display."""
REPEATED = re.compile(
    r"(?P<sign>[-+])(?:\s|\\[,;:! ]|&)*\\\\(?:\s*\[[^\[\]]*\])?"
    r"(?:\s|&|\{\}|~|\\q?quad|\\[,;:! ])*(?P=sign)"
)
"""A sign at the end of a line and again where the next begins: one sign."""
DOTS = re.compile(
    r"\\mathop\s*\{(?P<one>[^{}]*)\}\s*\\limits\s*\^\s*\{?\s*(?P<dots>\.{1,3})\s*\}?"
    r"|\\(?:overset|stackrel)\s*\{\s*(?P<over>\.{1,3}|(?:\\cdot\s*){1,3})\}\s*\{(?P<two>[^{}]*)\}"
)
"""Dots that are set above a letter."""
BOLD = re.compile(r"(?<=\{)\s*\\(?:bf|it|boldmath)(?![A-Za-z])")
"""A font from here on: {\\bf q}."""
NEW_LINE = re.compile(r"\\newline(?![A-Za-z])")
"""Between rows, as some Markdown needs it."""
OF_TIME = re.compile(r"(?<=[\w}])\{\s*\\left\s*\(\s*t\s*\\right\s*\)\s*\}")
"""How SymPy prints a function of time: \\theta{\\left(t \\right)} is no product."""
LABEL = re.compile(r"\s*[_^]\s*\{")
CONDITION = re.compile(
    r"\\(?:text(?:rm|it|normal|sf|bf|up)?|[mh]box)\s*\{(?P<words>[^{}]*\b(?:for|at|when|if|whenever|near)"
    r"\s*:?)\s*\}(?P<gap>(?:\\q?quad(?![A-Za-z])|\\[,;:! ]|~|\s)*)"
    r"(?P<value>\\?(?:d{1,3}ot\s*\{?\s*\\?)?[A-Za-z]+(?:_(?:\w|\{\w+\}))?\}?\s*=\s*"
    r"[-+]?\s*(?:\d+(?:\.\d+)?|\\pi)(?:\s*/\s*\d+)?)(?!\s*(?:[-+*/^=(\w]|\\(?:cdot|frac|sin|cos)))"
)
"""Where an equation holds, behind it: \\text{for}\\quad \\theta = 0 is no equation of its own."""
BOXES = re.compile(r"\\(?:text(?:rm|it|normal|sf|bf|up)?|[mh]box|intertext)\s*\{")
FORMULA = re.compile(r"(?<!\\)\$(?P<one>[^$]*)\$|\\\((?P<two>[^()]*)\\\)")
OPERATOR = re.compile(r"\s*(?:[-+*/=^_\u2212]|\\(?:cdot|times|frac|pm)(?![A-Za-z]))")
WORDS = re.compile(r"\\(?:text(?:rm|it)?|mathrm|mbox)\s*\{[^{}]*\}|[^A-Za-z0-9\\]")


OPTION = re.compile(r"^[ \t]+:(?:label|name|nowrap|no-wrap|class):[^\n$\\]*$", re.MULTILINE)
"""Of a formula in reStructuredText, which prints nothing but a number."""


def prepared(text: str) -> str:
    """The text with blanks for comments, frames, and braces under formulas with their labels.

    Raises
    ------
    Refused
        Where it is not known what is printed.
    """
    text = BOLD_ZERO.sub(lambda m: " " * len(m[0]), on_one_line(without_hidden(text)))
    text = without_crossings(LEADER.sub(lambda m: " " * len(m[0]), text))
    text = REPEATED.sub(lambda m: m[0].replace(m["sign"], " ", 1), text)
    if ".. math::" in text:
        text = OPTION.sub(lambda m: " " * len(m[0]), text)
    text = BOLD.sub(lambda m: " " * len(m[0]), DOTS.sub(_dotted, text))
    text = DECIMAL.sub(lambda m: m[0].replace("{,}", ".").ljust(len(m[0])), text)
    text = COMMA.sub(lambda m: m[0].replace(",", "."), text)
    text = OF_TIME.sub(lambda m: "(t)".ljust(len(m[0])), text)
    text = NEW_LINE.sub(r"\\\\      ", text)
    text = SMALL.sub(lambda m: " " * len(m[0]), text)
    text = CONDITION.sub(lambda m: " " * len(m[0]), text)
    for initials, name in SHORT:
        text = initials.sub(name, text)
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


def _dotted(match: re.Match[str]) -> str:
    marks = match["dots"] or match["over"].replace("\\cdot", ".").replace(" ", "")
    letter = match["one"] or match["two"] or ""
    return f"\\{'d' * len(marks)}ot{{{letter}}}".ljust(len(match[0]))


def labels(text: str) -> Iterator[tuple[int, int]]:
    r"""Where labels of braces stand: ``\\underbrace{F}_{= 0}``."""
    text = on_one_line(without_hidden(text))
    closed = _closed(text)
    for mark in MARKS.finditer(text):
        label = LABEL.match(text, closed.get(mark.end() - 1, len(text)) + 1)
        end = closed.get(label.end() - 1) if label else None
        if label is not None and end is not None and mark[1].endswith("brace"):
            yield label.end(), end


def states(label: str) -> bool:
    """Whether a label says something of its own, as an equation does; 0 is what it comes to."""
    return ("=" in label and bool(WORDS.sub("", label))) or label.strip() == "0"


def without_boxes(text: str, start: int, end: int) -> str:
    r"""A display in which ``\\mbox{$-F$}``, which is printed as a part of it, is -F.

    Raises
    ------
    Refused
        Where words stand beside a formula with an operator: what it belongs to is not known.
    """
    boxes = list(BOXES.finditer(text, start, end))
    if not any(FORMULA.search(text, box.end(), end) for box in boxes):
        return text
    closed = _closed(text)
    out = list(text)
    for box in boxes:
        last = closed.get(box.end() - 1, end)
        inside = text[box.end() : last]
        formula = FORMULA.fullmatch(inside.strip())
        if formula is None:
            for part in FORMULA.finditer(inside):
                if OPERATOR.match(part["one"] or part["two"] or ""):
                    words = "a formula inside \\text or \\mbox: write it outside"
                    raise Refused(box.end() + part.start(), words)
            continue
        name = "one" if formula["one"] is not None else "two"
        begin = box.end() + len(inside) - len(inside.lstrip())
        blank(out, box.start(), begin + formula.start(name))
        blank(out, begin + formula.end(name), last + 1)
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
