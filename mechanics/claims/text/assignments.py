"""Names that a program assigns more than once: each line uses what the name is worth there.

    a = f(y); a = a + g(y); dy(2) = a;    a holds the second value        l = l/2;    of here on
    y = flipud(y); dy(1) = y(2);          what uses a name that was not read is not read, either

A text is a program by its head, ``function ...``, or where lines end in semicolons; the equations
of a text, and those of a model, hold all at once.
"""

import re
from collections import Counter
from collections.abc import Container, Sequence
from dataclasses import replace

from mechanics.claims.lines import Aside, Entry, Line, Unread
from mechanics.claims.names import Naming
from mechanics.claims.tree import Name, Node, ended, names, parts, with_parts

HEAD = re.compile(r"^[ \t]*function\b", re.MULTILINE)
MODEL = re.compile(r"^[ \t]*(?:model|equation)\b|~", re.MULTILINE)
ENDED = re.compile(r"[^\n;]*;")
OF_ARRAY = re.compile(r"(?P<array>\w+)[(\[]")
BRANCH = re.compile(r"(?:^|[;\n])[ \t]*(?:if|else|elseif|for|while|switch|case)\b", re.MULTILINE)
HERE = "{} as assigned ({})"
VERSION = re.compile(r" as assigned \(\d+\)$")
ASSIGNS = re.compile(r"(\w+)\s*=(?!=)")


def in_sequence(lines: Sequence[Entry], text: str, naming: Naming) -> list[Entry]:
    """The lines with a name of its own for each value that a name has on the way.

    What a name is worth at the end keeps the name; of an argument, or the name of an entry, what
    it is worth at the beginning.

    Parameters
    ----------
    lines : sequence of Entry
    text : str
    naming : Naming
    """
    if MODEL.search(text):
        return list(lines)
    program = HEAD.search(text) is not None
    assigned = [_assigned(line, text, program) for line in lines]
    counts = Counter(name for name in assigned if name)
    again = {
        name for line, name in zip(lines, assigned, strict=True)
        if name and (counts[name] > 1 or _holds(line, name))
    }  # fmt: skip
    unread = [_unread(line) if program or _ends(line, text) else "" for line in lines]
    if not again and not any(unread):
        return list(lines)
    seen: Counter[str] = Counter()
    now: dict[str, str] = {}
    # Which branch assigned a name last is not read.
    anew = set(again) if BRANCH.search(text) else set[str]()
    used = set[str]()
    given = set[str]()
    arrays = {one for line in lines if isinstance(line, Line) for one in _of_arrays(line)}
    found: list[Entry] = []
    for line, name, lost in zip(lines, assigned, unread, strict=True):
        if not isinstance(line, Line):
            found.append(line)
            anew |= {lost} - {""}
            continue
        if late := _used(line) & anew:
            words = f"it uses {', '.join(sorted(late))}, whose value here is not read"
            anew |= {name} - {""}
            found.append(Unread(line.source, line.at, line.at, words, line.tag))
            continue
        left, *others = line.sides
        sides = [_renamed(side, now) for side in others]
        used |= {held.name for side in sides for held in names(side)}
        if name in again and isinstance(left, Name):
            seen[name] += 1
            if name in arrays:
                anew.add(name)
            if seen[name] == 1 and naming.knows(name) and not OF_ARRAY.match(name):
                given |= {name} if _holds(line, name) or isinstance(others[0], Name) else set()
            first = seen[name] == 1 and not _holds(line, name)
            keeps = first if name in given else seen[name] == counts[name]
            own = name if keeps else HERE.format(name, seen[name])
            now[name] = own
            left = ended(replace(left, name=own), left.end)
        else:
            left = _renamed(left, now)
        found.append(replace(line, sides=(left, *sides)))
    return [_overwritten(line, used) for line in found]


def _overwritten(line: Entry, used: Container[str]) -> Entry:
    """A line; a value that nothing uses before there is another says nothing."""
    left = line.sides[0] if isinstance(line, Line) else None
    if not isinstance(line, Line) or not isinstance(left, Name) or left.name in used:
        return line
    if not VERSION.search(left.name):
        return line
    return Aside(f"{line.source[:60]}: assigned anew before it is used", line.at)


def _assigned(line: Entry, text: str, program: bool) -> str:
    """The name that a line assigns a value to; empty where it may be an equation."""
    if not isinstance(line, Line) or len(line.sides) != 2:
        return ""
    left = line.sides[0]
    if not isinstance(left, Name) or left.order:
        return ""
    return left.name if program or _ends(line, text) else ""


def _ends(line: Entry, text: str) -> bool:
    return ENDED.match(text, line.at) is not None


def _unread(line: Entry) -> str:
    """The name that a line assigns that cannot be read; empty for others."""
    found = ASSIGNS.match(line.source) if isinstance(line, Unread) else None
    return found[1] if found else ""


def _used(line: Line) -> set[str]:
    """Names that a line uses, and arrays of which it uses entries."""
    return {n.name for side in line.sides[1:] for n in names(side)} | _of_arrays(line)


def _holds(line: Entry, name: str) -> bool:
    """Whether the right side of a line uses a name, or an entry of it."""
    sides = line.sides[1:] if isinstance(line, Line) else ()
    held = {n.name for side in sides for n in names(side)}
    return name in held


def _of_arrays(line: Line) -> set[str]:
    """Arrays of which a line uses entries."""
    held = [n.name for side in line.sides[1:] for n in names(side)]
    return {part["array"] for one in held if (part := OF_ARRAY.match(one))}


def _renamed(node: Node, now: dict[str, str]) -> Node:
    if isinstance(node, Name) and now.get(node.name, node.name) != node.name and not node.order:
        return ended(replace(node, name=now[node.name]), node.end)
    inside = parts(node)
    new = tuple(_renamed(part, now) for part in inside)
    return node if new == inside else ended(with_parts(node, new), node.end)
