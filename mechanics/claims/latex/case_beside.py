r"""The case that a display gives an equation for: ``T = m g \quad\text{for}\quad \theta = 0``."""

import re

from mechanics.claims.lines import Line
from mechanics.claims.names import Naming
from mechanics.claims.prose import SYMBOL
from mechanics.claims.tree import Name, names

SPACED = r"(?:\\q?quad|\\[,;: ]|~|&|\s)*"
WORD = r"(?:for|at|when|if|f\u00fcr|bei|wenn|para|si|pour|per|se)"
FOR = rf"\\(?:text\w*|mbox|mathrm)\s*\{{\s*{WORD}\s*\}}"
BEFORE = re.compile(rf"{FOR}{SPACED}$")
BEHIND = re.compile(
    r"[^=]*=(?:(?!\\\\|\$\$|\\\]|\\end\b).)*?"
    rf"{FOR}{SPACED}{SYMBOL}\s*=\s*"
    r"(?P<value>[-+]?(?:\\[dt]?frac\s*)?(?:[\d.{}/]|\\pi)+)",
    re.DOTALL,
)
FAR, LONG = 60, 400


def is_case(line: Line, text: str, naming: Naming) -> bool:
    """Whether a line says only in which case the equation before it is meant."""
    left, *others = line.sides
    if not isinstance(left, Name) or len(others) != 1 or names(others[0]):
        return False
    moves = naming.is_function(left.name) is True
    return moves and BEFORE.search(text[max(0, line.at - FAR) : line.at]) is not None


def case_of(text: str, start: int, naming: Naming) -> str:
    """The case that stands behind an equation that begins at a place; empty where there is none."""
    found = BEHIND.match(text[start : start + LONG])
    name = re.sub("[{}]", "", found["name"]) if found else ""
    if found is None or naming.is_function(name) is not True:
        return ""
    return f"{name} = {found['value']}"
