r"""LaTeX as tokens, fractions, brackets and groups, and about how wide it is set.

\frac{a}{b} \left(c + d\right)    ->    fraction (a, b), bracket (c + d)
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass

SIGNS = re.compile(r"[-+=]")
TOKEN = re.compile(r"\\[A-Za-z]+|\\.|\s+|.", re.DOTALL)
OPENS = re.compile(r"\{|\(|\[|\\(left|begin)\b")
CLOSES = re.compile(r"\}|\)|\]|\\(right|end)\b")
PAIRS = {"(": ")", "[": "]"}
WORDS = re.compile(r"\\(sin|cos|tan|cot|sec|csc|sinh|cosh|tanh|exp|log|sqrt)")
TABLE = re.compile(r"\\begin\b|\\\\")
MARKED = re.compile(r"\\class\{wrong\}\{[-+]\}")
"""A sign that is wrong; the right one stands behind it."""
NO_WIDTH = re.compile(
    r"\s+|[\^_.{}]|\\(?:,|left|right|d+ot|class|operatorname|mathrm|[td]?frac|[bB]ig[lr])"
)
HELD = re.compile(r"(?:[\^_]|\\[A-Za-z]+(?:\^\{[^{}]*\})?)\s*$")
"""What takes the bracket behind it as its own: an exponent, a function."""


@dataclass(frozen=True)
class Item:
    """A token, or a fraction, bracket, group or marked part with what is inside."""

    text: str
    kind: str = ""
    parts: tuple[str, ...] = ()
    open: str = ""
    close: str = ""


def items(latex: str) -> Iterator[Item]:
    """The items of LaTeX, in order; their texts together are the LaTeX."""
    tokens = TOKEN.findall(latex)
    at = 0
    while at < len(tokens):
        item, at = _item(tokens, at)
        yield item


def _item(tokens: list[str], at: int) -> tuple[Item, int]:
    token = tokens[at]
    if token in (r"\frac", r"\tfrac", r"\dfrac", r"\class"):
        first, middle = _group(tokens, at + 1)
        second, end = _group(tokens, middle)
        if first is not None and second is not None:
            whole = "".join(tokens[at:end])
            if token != r"\class":
                return Item(whole, "fraction", (first, second)), end
            return Item(whole, first, (second,)), end
    elif token == "{":
        inner, end = _group(tokens, at)
        before = "".join(tokens[max(at - 2, 0) : at]).rstrip()
        if inner is not None:
            kind = "held" if HELD.search(before) else "group"
            return Item("".join(tokens[at:end]), kind, (inner,)), end
    elif OPENS.fullmatch(token) and token != r"\begin":
        closed = _closed(tokens, at)
        skip = 2 if token == r"\left" else 1
        if closed is not None and closed - at >= 2 * skip and _match(token, tokens[closed - 1]):
            inner = "".join(tokens[at + skip : closed - skip])
            ends = tokens[at + skip - 1], tokens[closed - 1]
            return Item("".join(tokens[at:closed]), "bracket", (inner,), *ends), closed
    return Item(token), at + 1


def _match(opening: str, closing: str) -> bool:
    """Whether a bracket is closed by its own kind; a piece of a sum may hold half of a pair."""
    return opening not in PAIRS or PAIRS[opening] == closing


def _group(tokens: list[str], at: int) -> tuple[str | None, int]:
    """What stands in braces from a place on, and where they end."""
    while at < len(tokens) and tokens[at].isspace():
        at += 1
    end = _closed(tokens, at) if at < len(tokens) and tokens[at] == "{" else None
    return (None, at) if end is None else ("".join(tokens[at + 1 : end - 1]), end)


def _closed(tokens: list[str], at: int) -> int | None:
    """Behind what closes the bracket that opens at a place."""
    depth = 0
    for k in range(at, len(tokens)):
        if tokens[k] in (r"\left", r"\right"):
            depth += 1 if tokens[k] == r"\left" else -1
            if depth == 0:
                return min(k + 2, len(tokens))
        elif k and tokens[k - 1] in (r"\left", r"\right"):
            continue
        else:
            depth += bool(OPENS.fullmatch(tokens[k])) - bool(CLOSES.fullmatch(tokens[k]))
            if depth == 0:
                return k + 1
    return None


def width(latex: str) -> int:
    """About how many characters wide LaTeX is set."""
    wide = 0
    for item in items(latex):
        if item.kind == "fraction":
            wide += max(map(width, item.parts))
        elif item.parts:
            wide += sum(map(width, item.parts)) + (2 if item.kind == "bracket" else 0)
        elif WORDS.fullmatch(item.text):
            wide += len(item.text)
        elif not NO_WIDTH.fullmatch(item.text):
            wide += 2 if SIGNS.fullmatch(item.text) else 1
    return wide


def terms(latex: str) -> list[str]:
    """LaTeX cut before the signs between its terms; an equality sign begins a part, too."""
    parts, current, depth, before = [], "", 0, ""
    for found in TOKEN.finditer(latex):
        token = found[0]
        depth += bool(OPENS.fullmatch(token)) - bool(CLOSES.fullmatch(token))
        sign = depth == 0 and (SIGNS.fullmatch(token) or MARKED.match(latex, found.start()))
        if sign and current.strip() and not before.endswith(("=", "+", "-", "^", "_", "\\cdot")):
            parts.append(current.strip())
            current = ""
        current += token
        before = token if token.strip() else before
    parts.append(current.strip())
    return [_spaced(part, first=n == 0) for n, part in enumerate(parts) if part]


def _spaced(part: str, *, first: bool) -> str:
    """A part that goes on from another one, its sign set off as between two terms."""
    sign, rest = part[0], part[1:].lstrip()
    if first or not SIGNS.fullmatch(sign):
        return part
    if sign == "=" and rest.startswith("-"):
        return f"= {{{rest}}}"
    return f"{sign} {rest}"
