"""Where in a C file something is: the coordinates of its parser as a line and a column.

code.c:3:14: y is not declared    ->    code.c, line 3, column 14: y is not declared
"""

import re


def placed(text: str, words: str, origin: str, coord: str = "") -> str:
    """One line that says where something is, and what.

    Parameters
    ----------
    text : str
        The file.
    words : str
        What is wrong, with coordinates in front where they are known: ``file:line:column: ``,
        ``file:line: ``, or ``file: ``.
    origin : str
        What the coordinates, and messages, call the file.
    coord : str
        Coordinates that hold where `words` have none: where the function begins.
    """
    words = " ".join(words.split())
    name = re.escape(origin)
    # What the parser says itself stands behind the name of the file, and has it once more.
    rest = words.removeprefix(f"{origin}: no C: ")
    kind = "no C: " if rest != words else ""
    head = re.match(rf"{name}:(\d+)(?::(\d+))?: ", rest)
    rest = rest[head.end() :] if head else rest.removeprefix(f"{origin}: ")
    if rest == "At end of input":
        place = text.count("\n") + 1, len(text) - text.rfind("\n")
    else:
        standard = re.match(rf"{name}:(\d+):(\d+)", coord)
        place = _within(text, head) or _within(text, standard) or (1, 1)
    return f"{origin}, line {place[0]}, column {place[1]}: {kind}{rest}"


def _within(text: str, found: re.Match[str] | None) -> tuple[int, int] | None:
    """Line and column of coordinates; None where there are none, or not of this text."""
    lines = text.split("\n")
    if found is None or not 0 < int(found[1]) <= len(lines):
        return None
    code = lines[int(found[1]) - 1]
    return int(found[1]), int(found[2] or len(code) - len(code.lstrip()) + 1)
