"""Equations on a terminal: lines that are too long go on below, from an operator on.

`mechanics check` reads them again as one equation.
"""

import re

INDENT = 4


def fitted(text: str, width: int) -> str:
    """The text in lines of at most so many characters, where operators are near enough.

    Examples
    --------
    >>> print(fitted("m*x_ddot = -k*x - d*x_dot", 20))
    m*x_ddot = -k*x
        - d*x_dot
    """
    return "\n".join("\n".join(_parts(line, width)) for line in text.splitlines())


def _parts(line: str, width: int) -> list[str]:
    """A line, broken where the fewest brackets are open, as far to the right as that goes."""
    indent = " " * (len(line) - len(line.lstrip()) + INDENT)
    parts = []
    while len(line) > width:
        places = [
            (line.count(")", 0, k) - line.count("(", 0, k), k)
            for k in (match.start() for match in re.finditer(r" [+=-] ", line))
            if len(line) - len(line.lstrip()) < k <= width
        ]
        if not places:
            break
        _, place = max(places)
        parts.append(line[:place])
        line = indent + line[place + 1 :]
    return [*parts, line]
