r"""Sines and cosines by one letter, as in robotics: s_1, c_{12}, c_\psi, s\theta_1.

s_1 = sin(theta_1)      c_12 = cos(theta_1 + theta_2)      c_{1-2} = cos(theta_1 - theta_2)

Only where both letters are used so, or in a matrix, as that of masses holds cosines only, or where
dimensions ask for a number; the scene has no such name, the text defines none, and the scene has no
damper or spring left that the letter could name.
"""

import re
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

from mechanics.claims.definitions import definitions
from mechanics.claims.dimension import dimension
from mechanics.claims.kinds import ANGLES, angular
from mechanics.claims.lines import Aside, Entry, Line
from mechanics.claims.names import Naming
from mechanics.claims.spelled_rates import key
from mechanics.claims.tree import (
    COMPOSED,
    Call,
    Name,
    Node,
    Product,
    Sum,
    Table,
    ended,
    names,
    negative,
    parts,
    total,
    with_parts,
)

LETTERS = {"s": "sin", "S": "sin", "c": "cos", "C": "cos"}
SHORT = re.compile(r"(?P<letter>[sScC])_?(?P<of>\d+(?:minus\d)?|[A-Za-z]+\d*)")
LINKS = frozenset(("N*s/m", "N/m", "N*m*s/rad", "N*m*s", "N*m/rad", "N*m", "kg/s"))
"""Units of dampers and springs, which people name c, too."""


INDEX = r"_?\s*\{?\s*\\?(?P<of>[A-Za-z]+)\s*\}?"
DEFINES = r"\s*(?:&?\s*=(?!=)|:=|\\equiv\b|\\coloneqq\b|\\triangleq\b|\u2261|\u2254)"
GENERAL = re.compile(
    rf"(?<![A-Za-z\\])(?P<letter>[sScC])(?=_){INDEX}(?P<more>[^=$\n;:]{{0,40}}?){DEFINES}"
    r"(?P<right>[^,;.$\n=]{0,60})"
)
"""A short name with a letter for a number, and what it is short for."""
ANY = re.compile(r"[ijklmn]{1,3}$|bullet$|cdot$|ast$|star$")
"""What stands for a number."""
ANGLE = r"\(?(?:q|(?:var)?(?:theta|phi|alpha|beta|gamma|psi))_?"


def defined_otherwise(text: str) -> bool:
    r"""Whether a text says of s_i, c_{ij} or c_\alpha that they are something else.

    Parameters
    ----------
    text : str
        The whole text, prose and formulas.
    """
    found = (
        said for said in GENERAL.finditer(text) if said["of"] in ANGLES or ANY.match(said["of"])
    )
    return not all(map(_as_usual, found))


def _as_usual(said: re.Match[str]) -> bool:
    r"""Whether it is c_i = \cos\theta_i, c_{ij} = \cos(\theta_i + \theta_j), ...: as people do."""
    function, of = LETTERS[said["letter"]], said["of"]
    right = re.sub(r"\\left|\\right|\\[,;:! ]|[\s{}\\\])]", "", said["right"])
    if said["more"].strip(" }\\,"):
        return False
    if of in ANGLES:
        return right in (f"{function}{of}", f"{function}({of}")
    angles = r"\+".join(rf"{ANGLE}{one}" for one in of)
    return re.fullmatch(rf"{function}\(?{angles}", right) is not None


def with_sines(lines: Sequence[Entry], naming: Naming, text: str) -> list[Entry]:
    r"""The lines with sines and cosines in place of short names, and of ``s\theta``."""
    if defined_otherwise(text):
        return list(lines)
    own = definitions(lines, naming)
    sides = [side for line in lines if isinstance(line, Line) for side in line.sides]
    every = [name for side in sides for name in names(side)]
    if _left(naming, {name.name for name in every}):
        return list(lines)
    dotted = {name.name for name in every if name.order}
    free = [n for n in dict.fromkeys(name.name for name in every)
            if n not in own and n not in dotted and not naming.knows(n)]  # fmt: skip
    short = {name: found for name in free if (found := _short(name, naming)) is not None}
    pairs = [pair for side in sides for pair in _beside(side, naming, {*free})]
    letters = {name[0].lower() for name in (*short, *(one.name for one, _ in pairs))}
    several = any(len(key(name)) > 2 and key(name)[1:].isdigit() for name in short)
    both = letters >= {"s", "c"}
    tables = (names(side) for side in sides if isinstance(side, Table) and len(side.rows) > 1)
    numbered = {name.name for held in tables for name in held} & {*short}
    if not (both or several or numbered or _as_numbers(lines, naming, short)):
        return list(lines)
    told = [Aside(_words(name, found), 0) for name, found in short.items()]
    return [*told, *(_replaced(line, naming, {*free}, short) for line in lines)]


def _as_numbers(lines: Sequence[Entry], naming: Naming, short: Mapping[str, Call]) -> bool:
    """Whether short names are sines of angles of their number, and all that is added or equal where
    they stand has one dimension so: with a length s it has not. A c may be a coefficient.
    """
    if not all(n[0] in "sS" and names(call)[0].name.endswith(n[-1]) for n, call in short.items()):
        return False
    sides = [line.sides for line in lines if isinstance(line, Line)]
    using = [some for some in sides if any(n.name in short for side in some for n in names(side))]
    with_numbers = replace(naming, own={**naming.own, **short})
    terms = [
        [t for side in some for t in (side.terms if isinstance(side, Sum) else (side,))]
        for some in using
    ]
    found = [{dimension(with_numbers, term) for term in some} for some in terms]
    return bool(using) and all(len(one) == 1 and None not in one for one in found)


def _left(naming: Naming, used: Iterable[str]) -> bool:
    """Whether the scene has a damper or spring that the text does not use by its name."""
    parameters = naming.vocabulary.scene.parameters
    held = {found[0] for name in used if (found := naming.lookup(name)) is not None}
    return any(getattr(p, "unit", "") in LINKS and p.name not in held for p in parameters)


def _angles(naming: Naming) -> dict[int, str]:
    """Angles of the scene by their number: that of their name, or their place."""
    angles = [q.name for q in naming.vocabulary.scene.q if q in angular(naming.vocabulary.scene)]
    numbers = [re.search(r"(\d+)$", name) for name in angles]
    if angles and all(numbers):
        return {int(n[1]): name for n, name in zip(numbers, angles, strict=True) if n}
    return dict(enumerate(angles, 1))


def _short(name: str, naming: Naming) -> Call | None:
    """What a name stands for that is a letter and the number, or letter, of an angle."""
    part = SHORT.fullmatch(name)
    if part is None:
        return None
    function, of = LETTERS[part["letter"]], part["of"]
    if not of[0].isdigit():
        angle = of.rstrip("0123456789") in ANGLES and f"{part['letter']}_" == name[:2]
        return Call(COMPOSED, function, (Name(COMPOSED, of),)) if angle else None
    angles = _angles(naming)
    if "minus" in of:
        one, other = (angles.get(int(n)) for n in of.split("minus"))
        if one is None or other is None:
            return None
        return Call(
            COMPOSED,
            function,
            (total(COMPOSED, [Name(COMPOSED, one), negative(Name(COMPOSED, other))]),),
        )
    if int(of) in angles:
        return Call(COMPOSED, function, (Name(COMPOSED, angles[int(of)]),))
    digits = [int(digit) for digit in of]
    ascending = digits == list(range(digits[0], digits[0] + len(digits)))
    if len(digits) < 2 or not ascending or not all(digit in angles for digit in digits):
        return None
    return Call(
        COMPOSED, function, (total(COMPOSED, [Name(COMPOSED, angles[digit]) for digit in digits]),)
    )


def _words(name: str, call: Call) -> str:
    inside = (" - " if "minus" in name else " + ").join(n.name for n in names(call))
    return f"{name.replace('minus', '-')} is read as {call.function}({inside})"


def _beside(node: Node, naming: Naming, free: Container[str]) -> Iterator[tuple[Name, Name]]:
    """Letters directly before an angle: s theta."""
    inside = parts(node)
    if isinstance(node, Product):
        for one, other in pairwise(inside):
            if _is_pair(one, other, naming, free):
                assert isinstance(one, Name) and isinstance(other, Name)
                yield one, other
    for part in inside:
        yield from _beside(part, naming, free)


def _is_pair(one: Node, other: Node, naming: Naming, free: Container[str]) -> bool:
    if not isinstance(one, Name) or not isinstance(other, Name) or other.order or one.order:
        return False
    if one.name not in LETTERS or one.name not in free or one.end != other.at:
        return False
    found = naming.lookup(other.name)
    known = {q.name for q in angular(naming.vocabulary.scene)}
    return found[0] in known if found else other.name.split("_")[0] in ANGLES


def _replaced(
    line: Entry, naming: Naming, free: Container[str], short: Mapping[str, Call]
) -> Entry:
    if not isinstance(line, Line):
        return line

    def change(node: Node) -> Node:
        inside = parts(node)
        if isinstance(node, Name) and node.name in short:
            return ended(replace(short[node.name], at=node.at), node.end)
        if not inside:
            return node
        if isinstance(node, Product):
            kept: list[Node] = []
            for part in inside:
                if kept and _is_pair(kept[-1], part, naming, free):
                    letter = kept.pop()
                    assert isinstance(letter, Name)
                    called = Call(letter.at, LETTERS[letter.name], (part,))
                    kept.append(ended(called, part.end))
                else:
                    kept.append(part)
            inside = tuple(kept)
        new = tuple(map(change, inside))
        return node if new == parts(node) else ended(with_parts(node, new), node.end)

    return replace(line, sides=tuple(map(change, line.sides)))
