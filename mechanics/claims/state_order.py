"""The order of a state in an array, where a comment or a sentence says it.

% z = [x; theta; xdot; thetadot]        // st: x, x', theta_1, theta_1'        state: x, y, ...
% y(1) -> x   % y(2) -> x_dot
"""

import re

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
COMMENT = re.compile(r"(?://|/\*|[%#*])[^\n]*|\"\"\".*?\"\"\"|'''.*?'''", re.DOTALL)


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
    found: list[str] = []
    for entry in ENTRY.findall(words[: end.start()] if end else words):
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
