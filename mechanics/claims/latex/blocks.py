r"""Where the formulas of a document stand.

    prose $c = \cos\theta$ prose \[ \ddot x = c \] prose        a text without $ and \[ is a formula

What is displayed is read, and inline what is an equation: its value of a parameter is no claim.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace

from mechanics.claims.latex.comments import as_signs, is_source, without_comments_in_prose

OPENS = re.compile(
    r"\$\$|(?<!\\)\\\[|^[ \t]*(?P<fence>`{3,})[ \t]*math[ \t]*$"
    r"|^[ \t]*(?P<copy>\{[ \t]*\\displaystyle)(?![A-Za-z])"
    r"|^(?P<indent>[ \t]*)\.\.[ \t]+math::[ \t]*|\\begin\s*\{"
    r"(?P<env>(?:equation|align|gather|multline|eqnarray|flalign|displaymath|math|dmath)\*?|"
    r"(?:alignat|IEEEeqnarray)\*?(?=\}\s*\{[\w\s]{0,20}(?P<columns>\})?))\}",
    re.MULTILINE,
)
INLINE = re.compile(
    r":math:`(?P<role>[^`]+)`|(?<!#)##(?P<hash>[^#\n]+)##(?!#)|(?<![\\$])\$(?P<one>(?:[^$\n]|\n(?!\s*\n))+)\$(?!\$)|(?<!\\)\\\((?P<two>(?:[^$\\]|\\[^()\[\]])+)\\\)"
    r"|\\\\\((?P<three>(?:[^$\\]|\\[^\\()\[\]])+)\\\\\)"
)

BRACES = r"\{(?:[^{}]|\{[^{}]*\})*\}"
NAME = (
    r"(?!\\d*dot)\\?[A-Za-z]+(?:\s?\{\s?\\?[A-Za-z]+\s?\})?"
    rf"(?:\s?_\s?(?:{BRACES}|\\?\w+))?"
)
RATE = rf"(?:\\dot\s?\{{\s?{NAME}\s?\}}|(?:\\dot\s?)?{NAME})"
SPACE = r"(?:\\[,;:! ]|~|\s)*"
FONT = (
    r"\\(?:(?:mathrm|text|textrm|rm|unit|si|SI|mathsf|operatorname)\s?\{(?:[^{}]|\{[^{}]*\})*\}"
    r"|mathrm\s[A-Za-z]|rm\s[A-Za-z]+)"
)
UNIT = (
    rf"(?:{FONT}(?:\s?\^\s?(?:\d|\{{\s?-?\d\s?\}}))?|/|\\cdot|\\degree|\^\s?\{{?\s?\\circ\s?\}}?)"
)
NUMBER = r"[-+\u2212]?\s?\d[\d.,]*(?:\s?(?:\\cdot|\\times)\s?10\s?\^\s?(?:\d|\{\s?-?\d+\s?\}))?"
BRACKET = r"(?:\\left\s?)?(?:\(|\[|\\\{)[^=+*/()\[\]]*,[^=+*/()\[\]]*(?:\\right\s?)?(?:\)|\]|\\\})"
SET = r"\\mathbb\s?\{?\s?[A-Z]\s?\}?(?:\s?[\^_]\s?(?:\w|\{[\w\s+]*\}))*"
"""The real numbers, a circle, and powers of them."""
VALUES = (
    re.compile(rf"{NAME}{SPACE}={SPACE}{NUMBER}{SPACE}{UNIT}(?:{SPACE}{UNIT})*{SPACE}[.,;]?"),
    re.compile(rf"{NAME}{SPACE}={SPACE}\\(?:SI|qty)\s?\{{\s?{NUMBER}\s?\}}\s?{BRACES}[.,;]?"),
    re.compile(rf"{RATE}{SPACE}\(\s?(?:0|t_0|t_\{{0\}})\s?\){SPACE}=[^=]*"),
    re.compile(rf"{NAME}{SPACE}={SPACE}{SET}(?:{SPACE}\\times{SPACE}{SET})*{SPACE}[.,;]?"),
    re.compile(rf"{NAME}{SPACE}={SPACE}{BRACKET}\s?(?:\^\s?\{{?\s?\\?[A-Za-z]+\s?\}}?)?\s?[.,;]?"),
)
"""A number with its unit, a value at the beginning, a set of numbers, a list of names."""
BESIDE = re.compile(r"[\w$)][ \t,:;(*_-]*\Z")
"""Words in the same line: some Markdown marks formulas in prose so, too: the mass $$m$$."""
GOES_ON = re.compile(r"[\s&]*=(?![\s&]*\Z)")
FARTHEST = 120
"""Characters between two displays of which the second goes on from the first."""
LONGEST_VALUE = 200
ONE = ("multline", "dmath")
ALIGNED = re.compile(r"\\begin\s*\{(aligned|gathered|split)\}.*?\\end\s*\{\1\}", re.DOTALL)
RELATED = re.compile(r"=|\\equiv(?![A-Za-z])")


@dataclass(frozen=True)
class Block:
    """A part of a text.

    Attributes
    ----------
    start, end : int
    inline : bool
        Whether it stands in prose.
    closed : bool
        Whether its end was found.
    one : bool
        Whether all its lines are one equation.
    bare : bool
        Whether it is a text that marks no formula, so that its lines mean something.
    """

    start: int
    end: int
    inline: bool = False
    closed: bool = True
    one: bool = False
    bare: bool = False


def blocks(text: str) -> list[Block]:
    """Formulas in their order; all of a text that marks none."""
    shown = list(_displays(text))
    inline = list(_inline(text, shown))
    if not shown:
        whole = sum(block.end - block.start + 2 for block in inline) >= len(text.strip())
        if whole and inline:
            return [Block(block.start, block.end) for block in inline]
    if not inline and not any(block.closed for block in shown):
        return _aligned(text) or [Block(0, len(text), bare=True)]
    found = sorted((*shown, *inline), key=lambda block: block.start)
    kept = [block for block in found if text[block.start : block.end].strip()]
    return kept


def page(text: str) -> str:
    """A page as LaTeX: its percent signs outside of formulas begin no comment."""
    if "%" not in text or is_source(text):
        return text
    marked = [b for b in blocks(as_signs(text)) if not b.bare and b.closed]
    if not marked:
        return text
    return without_comments_in_prose(text, ((b.start, b.end) for b in marked))


def continued(text: str, found: list[Block]) -> tuple[str, list[Block]]:
    """The text, and its formulas; one display that begins with = goes on from the one before.

    What stands between the two is blanked, place by place.
    """
    kept: list[Block] = []
    for block in found:
        last = kept[-1] if kept else None
        goes_on = last is not None and not last.inline and not block.inline and last.closed
        if last is None or not goes_on or not GOES_ON.match(text, block.start, block.end):
            kept.append(block)
            continue
        between = text[last.end : block.start]
        if len(between) > FARTHEST or "#" in between or r"\item" in between or last.one:
            kept.append(block)
            continue
        blank = "".join(c if c == "\n" else " " for c in between)
        text = text[: last.end] + blank + text[block.start :]
        kept[-1] = replace(last, end=block.end, closed=block.closed)
    return text, kept


def _aligned(text: str) -> list[Block]:
    """Parts of a display that stand without one, as in Markdown, in nothing but words."""
    found = list(ALIGNED.finditer(text))
    between = ALIGNED.sub(" ", text)
    if not found or RELATED.search(between) or "\\" in between or not between.strip():
        return []
    return [Block(*match.span()) for match in found]


def _displays(text: str) -> Iterator[Block]:
    """What stands between the beginning and the end of a display.

    What ends a display is looked for once where it is missing: its time is linear in the text.
    """
    missing: set[str] = set()
    at = 0
    while opens := OPENS.search(text, at):
        at = max(opens.end(), opens.end("columns"))
        ends = _ends(opens)
        if ends in missing:
            continue
        closes = re.compile(ends).search(text, at)
        if closes is None:
            missing.add(ends)
            yield Block(at, min(at + 60, len(text)), closed=False)
            continue
        beside = (
            opens[0] == "$$"
            and BESIDE.search(text[max(0, opens.start() - 40) : opens.start()]) is not None
        )
        word = beside and not claims(text[at : closes.start()])
        yield Block(at, closes.start(), word, one=(opens["env"] or "").rstrip("*") in ONE)
        at = closes.end()


def _ends(opens: re.Match[str]) -> str:
    if opens["env"]:
        return rf"\\end\s*\{{{re.escape(opens['env'])}\}}"
    if opens["fence"]:
        return rf"\n[ \t]*{opens['fence']}"
    if opens["copy"]:  # out of a page of Wikipedia
        return r"\}[ \t]*(?:\n|\Z)"
    if opens["indent"] is not None:  # up to the next line that is no deeper
        return rf"\n(?!{opens['indent']}[ \t]|[ \t]*\n)|\Z"
    return r"\$\$" if opens[0] == "$$" else r"(?<!\\)\\\]"


def _inline(text: str, shown: list[Block]) -> Iterator[Block]:
    """What stands in prose between what is displayed."""
    at = 0
    for block in (*shown, Block(len(text), len(text))):
        for match in INLINE.finditer(text, at, max(at, block.start)):
            yield Block(*match.span(match.lastgroup or 0), inline=True)
        at = max(at, block.end) if block.closed else at


def claims(formula: str) -> bool:
    """Whether a formula in prose may be an equation."""
    return RELATED.search(formula) is not None


def is_value(formula: str) -> bool:
    """Whether it gives a value with its unit, one at the beginning, or a list of names."""
    formula = " ".join(formula.split())
    short = len(formula) <= LONGEST_VALUE
    return short and any(form.fullmatch(formula) for form in VALUES)
