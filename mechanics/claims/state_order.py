"""The order of a state in an array, where a comment or a sentence says it.

% z = [x; theta; xdot; thetadot]        // st: x, x', theta_1, theta_1'        state: x, y, ...
% y(1) -> x   % y(2) -> x_dot
# z: x, v, theta, omega                 # z = [x1 x2 v1 v2]
"""

import re
from collections.abc import Sequence

from mechanics.claims.names import Naming
from mechanics.claims.text.letters import plain
from mechanics.errors import InputError
from mechanics.scene.symbols import DOTS

STATES = ("state", "states", "x", "y", "z", "s", "q", "st", "X", "Y")
"""What a comment on the state is about."""
OPENS = re.compile(r"[ \t]*(?::|=|->|\bis\b)[ \t]*(?P<list>[^\n]*)")
STATE = r"(?i:\bstate(?:[ \t]+(?:vector|variables?))?)"
CLOSES = re.compile(r"[\])}]|\*/|\"\"\"")
ENTRY = re.compile(r"[^\s,;:\[\](){}]+")
SPEED = re.compile(r"(?:v|w|om|omega|\u03c9)_?(\w*)")
COMMENT = re.compile(r"(?://|/\*|[%#*])[^\n]*|\"\"\".*?\"\"\"|'''.*?'''", re.DOTALL)

MARKS = "/*%#\"' \t"
"""Around comments."""


def comments_of(text: str) -> str:
    """Comments and documentation of code, one a paragraph."""
    return "\n\n".join(found[0].strip(MARKS) for found in COMMENT.finditer(text))


def state_order(text: str, array: str, naming: Naming) -> tuple[str, ...]:
    """Names of the scene, with ``_dot``, for the entries of an array; empty where nothing says.

    Parameters
    ----------
    text : str
        With its comments.
    array : str
    naming : Naming

    Raises
    ------
    InputError
        Where it says that entries are momenta.
    """
    of = [rf"(?<![\w.]){re.escape(array)}", *([STATE] if array in STATES else [])]
    for comment in COMMENT.finditer(text):
        for name in of:
            for match in re.finditer(name, comment[0]):
                opened = OPENS.match(comment[0], match.end())
                if opened is not None and (entries := _entries(opened["list"], naming)):
                    return entries
    return _one_by_one(text, array, naming)


def _one_by_one(text: str, array: str, naming: Naming) -> tuple[str, ...]:
    """What comments call each entry: y(1) from 1, y[0] from 0."""
    one = re.compile(
        rf"(?<![\w.]){re.escape(array)}([(\[])(\d)[)\]][ \t]*(?:=|->|:|is\b)[ \t]*([^\s,;]+)"
    )
    said = {
        int(place) - (bracket == "("): word
        for comment in COMMENT.finditer(text)
        for bracket, place, word in one.findall(comment[0])
    }
    for place, word in said.items():
        if naming.lookup(plain(word)[0]) is None and naming.momentum(plain(word)[0]):
            raise InputError(
                f"entry {place + 1} of {array} is the momentum {word}: momenta in a state are not"
                " read, write it with speeds"
            )
    whole = set(said) == {*range(len(said))}
    return _entries(" ".join(said[place] for place in sorted(said)), naming) if whole else ()


def _entries(words: str, naming: Naming) -> tuple[str, ...]:
    """The names that a list is made of, if these are those of a state or parameters, each once."""
    opening = words[:1] in tuple("[({")
    end = CLOSES.search(words, 1 if opening else 0)
    entries = ENTRY.findall(words[: end.start()] if end else words)
    if with_speeds := _with_letters_of_speeds(entries, naming):
        return with_speeds
    found: list[str] = []
    for entry in entries:
        name, dots = plain(entry.rstrip("'."))
        target = naming.lookup(name)
        order = 0 if target is None else target[1] + dots + entry.count("'")
        constant = target is not None and target[0] in naming.vocabulary.constants
        if target is None or not (constant or naming.is_function(name)) or order >= len(DOTS):
            break
        found.append(target[0] + DOTS[order])
    scene = naming.vocabulary.scene
    whole = {str(symbol) for symbol in (*scene.q, *scene.u)}
    all_constants = len(found) > 1 and {*found} <= naming.vocabulary.constants.keys()
    named = set(found) >= whole or all_constants
    return tuple(found) if len(set(found)) == len(found) and named else ()


def _with_letters_of_speeds(entries: Sequence[str], naming: Naming) -> tuple[str, ...]:
    """Coordinates, and letters of speeds behind each of them, or behind all; else empty."""
    scene = naming.vocabulary.scene
    number = len(scene.q)
    some = entries[: 2 * number]
    names = [naming.lookup(plain(entry)[0]) for entry in some]
    places = [n[0] if n and not n[1] and naming.is_function(e) else ""
              for e, n in zip(some, names, strict=True)]  # fmt: skip
    held = [name for name in places if name]
    if len(some) < 2 * number or scene.speeds or {*held} != {str(q) for q in scene.q}:
        return ()
    if any(n and not name for n, name in zip(names, places, strict=True)) or len(held) != number:
        return ()
    behind_all = [*held, *held]
    behind_each = [name for name in held for _ in range(2)]
    for order in (behind_all, behind_each):
        pairs = list(zip(some, places, order, strict=True))
        if all(name == own or (not name and _of_speed(entry, own)) for entry, name, own in pairs):
            return tuple(own + ("" if name else DOTS[1]) for _, name, own in pairs)
    return ()


def _of_speed(letter: str, coordinate: str) -> bool:
    """Whether a name is a letter of speeds, with the number of a coordinate, or itself, behind."""
    said, number = SPEED.fullmatch(letter), re.search(r"\d*$", coordinate)
    return said is not None and said[1] in ("", coordinate, number[0] if number else "")
