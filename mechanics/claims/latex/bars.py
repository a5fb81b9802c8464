r"""Bars around a formula: which opens and which closes.

    x |\dot x|    \frac{|a + |b||}{c}    ->    each bar becomes an opening or a closing mark

A bar opens behind an operator, a function or an opening bracket, and where none is open; it closes
otherwise. Bars pair within one pair of braces and one side of an equation; others stay.
"""

import re

OPENING, CLOSING = "\ue000", "\ue001"
"""Marks that no text has: private use."""

TOKEN = re.compile(
    r"(?P<skip>\\(?:left|right|middle)\s*(?:\\[A-Za-z]+|\\?.)|\\[,;:!> ])"
    r"|\\[bB]igg?(?P<side>[lr]?)\s*(?P<sized>\|)"
    r"|(?P<end>\\\\|&|=)"
    r"|(?P<operator>\\(?:cdot|times|ast|over|a?sinh?|a?cosh?|a?tanh?|arcsin|arccos|arctan|exp|log"
    r"|ln|sqrt)(?![A-Za-z])|[-+*/,<>^_])"
    r"|(?P<operand>\\[A-Za-z]+|\\.)"
    r"|(?P<open>[{(\[])|(?P<close>[})\]])|(?P<bar>\|)|(?P<other>\S)"
)


def barred(text: str) -> str:
    """The text with marks for its bars; no character moves."""
    if "|" not in text:
        return text
    out, frames, waits = list(text), [list[int]()], True
    for match in TOKEN.finditer(text):
        kind = match.lastgroup
        opened = frames[-1]
        if kind == "open":
            frames.append([])
        elif kind == "close" and len(frames) > 1:
            frames.pop()
        elif kind == "end":
            opened.clear()
        elif kind in ("bar", "sized"):
            at, side = match.end() - 1, match["side"] or ""
            if side == "l" or (side != "r" and (waits or not opened)):
                opened.append(at)
                kind = "operator"
            elif opened:
                out[opened.pop()], out[at] = OPENING, CLOSING
        if kind != "skip":
            waits = kind in ("open", "operator", "end")
    return "".join(out)
