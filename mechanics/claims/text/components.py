"""Modelica models that are parts of another: what such a part declares has its name before it.

    model Spring Real x, f; ... end Spring;  Spring s;    f of the model is s.f    ->    s_f

What a model of which there are several parts, or one with other values, says is not read.
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from mechanics.claims.lines import NOT_USED, Entry, Line, Unread, is_constant
from mechanics.claims.names import Naming
from mechanics.claims.tree import Name, Node, ended, names, parts, with_parts

HEAD = re.compile(r"^[ \t]*(?:partial[ \t]+)?(?:model|block|class)[ \t]+(\w+)", re.MULTILINE)
VARIABLES = re.compile(r"^[ \t]*(?:(?:input|output|flow)[ \t]+)*Real[ \t]+([^;]*);", re.MULTILINE)
VALUE = re.compile(
    r"^[ \t]*parameter[ \t]+Real[ \t]+(\w+)[ \t]*(?:\([^;()]*\))?"
    r"[ \t]*=[ \t]*([-+\d.eE]+)(?![\w.*/^+-])",
    re.MULTILINE,
)
"""A number that a parameter has."""
STRING = re.compile(r'"[^"\n]*"|\([^()]*\)')
NOT_READ = "parts of a model that are not read: write its equations as one model"


@dataclass(frozen=True)
class Part:
    """A model that is a part of another: where its text is, its name there, what it declares."""

    start: int
    end: int
    name: str
    variables: frozenset[str]


def in_components(lines: Sequence[Entry], text: str) -> list[Entry]:
    """The lines with names of their own for the variables of each part.

    Parameters
    ----------
    lines : sequence of Entry
        As they were read, with their places in the text.
    text : str
    """
    heads = list(HEAD.finditer(text))
    if not heads:
        return list(lines)
    ends = [*(head.start() for head in heads[1:]), len(text)]
    found: list[Part] = []
    for head, end in zip(heads, ends, strict=True):
        declared = re.findall(rf"^[ \t]*{head[1]}[ \t]+(?!=)([^;\n]*);", text, re.MULTILINE)
        if not declared:
            continue
        name = STRING.sub("", declared[0]).strip() if declared[0].count("(") == 0 else ""
        if len(declared) > 1 or not name.isidentifier():
            return [_unread(line) for line in lines]
        body = STRING.sub("", text[head.start() : end])
        told = [
            word.split("=")[0].split() for v in VARIABLES.findall(body) for word in v.split(",")
        ]
        variables = frozenset(words[0] for words in told if words)
        found.append(Part(head.start(), end, name, variables))
    return [_named(line, text, found) for line in lines] if found else list(lines)


def with_values(lines: Sequence[Entry], text: str, naming: Naming) -> list[Entry]:
    """The lines of a model, each with what parameters of the scene the model gives values."""
    pairs = [pair for pair in VALUE.findall(text) if is_constant(pair[0], naming)]
    notes = tuple(f"{name} = {number}: {NOT_USED}" for name, number in dict(pairs).items())
    return [
        replace(one, notes=(*one.notes, *notes)) if isinstance(one, Line) else one for one in lines
    ]


def _unread(line: Entry) -> Entry:
    if not isinstance(line, Line):
        return line
    return Unread(line.source, line.at, line.at, NOT_READ, line.tag)


def _named(line: Entry, text: str, found: Sequence[Part]) -> Entry:
    if not isinstance(line, Line):
        return line
    within = next((part for part in found if part.start <= line.at < part.end), None)
    of = {part.name: part for part in found}

    def renamed(node: Node) -> Node:
        if isinstance(node, Name):
            name = _name(node, text, within, of)
            return node if name == node.name else ended(replace(node, name=name), node.end)
        inside = parts(node)
        new = tuple(map(renamed, inside))
        return node if new == inside else ended(with_parts(node, new), node.end)

    sides = tuple(map(renamed, line.sides))
    before = re.split(r"[;\n]", text[: line.at])[-1].strip()
    source = f"{before}{line.source}"
    dotted = sum(len(re.findall(rf"(?<![\w.]){part.name}\.\w", source)) for part in found)
    old = [name for side in line.sides for name in names(side)]
    new = [name for side in sides for name in names(side)]
    turned = sum(_field(name, text, of) is not None for name in old)
    if len(old) != len(new) or turned != dotted:
        return _unread(line)
    return replace(line, sides=sides, source=source)


def _field(name: Name, text: str, of: Mapping[str, Part]) -> Part | None:
    """The part that a name is of: f in s.f or der(s.f)."""
    inner = re.compile(r"(?:der[ \t]*\([ \t]*)?(\w+)\.\w").match(text, name.at)
    outer = re.search(r"(\w+)\.$", text[max(0, name.at - 60) : name.at])
    found = inner or outer
    return of.get(found[1]) if found else None


def _name(name: Name, text: str, within: Part | None, of: Mapping[str, Part]) -> str:
    part = _field(name, text, of) or within
    own = part is not None and name.name in part.variables
    return f"{part.name}_{name.name}" if part is not None and own else name.name
