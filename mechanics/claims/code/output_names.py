"""What the names of several outputs say of their order.

xdd, thdd     ax, alpha     acc_cart, acc_pole     a1, a2     dw2, dw1     lower, upper
   x theta       x theta          x theta           1  2       2    1        2      1

Each name says of which coordinates it may be, by its stem, by the body that moves with it, by a
number or by a word that counts; a name that says nothing may be of any.
"""

import re
from collections.abc import Iterator, Sequence
from itertools import permutations

from sympy import Symbol

from mechanics.claims.counting_words import COUNTED
from mechanics.claims.kinds import angular
from mechanics.claims.names import Naming
from mechanics.claims.spelled_rates import bases, key
from mechanics.scene import RigidBody, Scene
from mechanics.scene.symbols import DOTS

TWICE = "double_?dot|dotdot|ddot|dd|pp|accelerations?|accel|acc"
BEFORE = "ang_?acc|qdd|ddq|d2|dd|accelerations?|accel|acc|d|a"
AFTER = f"{TWICE}|dot|d|p"
MARKS = re.compile(
    rf"{BEFORE}|{AFTER}|out|output|res|result|ret|val|value|row|eqn|equation|residual"
)
"""Parts of names that are of any output."""
ANGULAR = ("angular", "rotational", "rotation", "rot", "ang", "angle", "omega", "alpha", "om", "w")
LINEAR = ("linear", "translation", "trans", "lin", "vel", "v", "x", "y", "z", "s", "r")
LETTERS = frozenset(stem for stem in (*ANGULAR, *LINEAR) if len(stem) == 1)
SEPARATED = re.compile(r"\s*(?:[,;]|\band\b)\s*")
LISTED = re.compile(rf"[^\W\d]\w*'*(?:{SEPARATED.pattern}[^\W\d]\w*'*)+")
INDEXED = re.compile(r"\b\w+ ?[(\[]\d+[)\]] ?(?:=|:|is\b) ?")
"""The place of an output before its name: a(1): theta_ddot."""
WITHIN = re.compile(r"\b(?:for|from|between|by|with|in|into) (?:both )?(?:the )?$")
"""Before two names of a sentence on something else: solve for thetadd and xdd."""
MOST = 3
"""Coordinates whose orders are tried."""

Coordinates = frozenset[Symbol]


def orders_by_names(
    scene: Scene, names: Sequence[str], known: Sequence[Symbol | None]
) -> Iterator[tuple[Symbol, ...]]:
    """The orders of the coordinates that the names of as many outputs leave, the scene's first.

    Parameters
    ----------
    scene : Scene
    names : sequence of str
        As many as coordinates; any other number leaves all orders.
    known : sequence of Symbol or None
        The coordinate that a name is of, where it is one of the scene's.
    """
    hints = [
        hint if q is None else frozenset((q,))
        for hint, q in zip(coordinates_of(scene, names), known, strict=True)
    ]
    size = len(scene.q)
    for order in permutations(scene.q) if size <= MOST else [tuple(scene.q)]:
        if len(hints) != size or all(q in hint for q, hint in zip(order, hints, strict=True)):
            yield order


def listed_otherwise(
    naming: Naming, names: Sequence[str], outputs: Sequence[object], comments: str
) -> str:
    """The list of a comment that has the outputs of a function in another order; empty for none.

    Parameters
    ----------
    naming : Naming
    names : sequence of str
        Of the outputs, where they have some.
    outputs : sequence of Symbol or other
        What they are taken for.
    comments : str
        Of the function.
    """
    meanings = [str(output) for output in outputs]
    scene = naming.vocabulary.scene
    comments = INDEXED.sub("", comments)
    for found in LISTED.finditer(comments):
        if "," not in found[0] and WITHIN.search(
            comments, max(0, found.start() - 24), found.start()
        ):
            continue
        words = SEPARATED.sub(" ", found[0]).split()
        known = [(naming.lookup(word.rstrip("'")), word.count("'")) for word in words]
        meant = [one[0] + "".join(DOTS[one[1] + k :][:1]) for one, k in known if one is not None]
        if _in_another_order(words, names) or _in_another_order(meant, meanings):
            return found[0]
        if meanings == [*map(str, scene.ud)] and _accelerations_otherwise(scene, words):
            return found[0]
    return ""


def _accelerations_otherwise(scene: Scene, words: Sequence[str]) -> bool:
    """Whether words are accelerations in another order of the coordinates: thdd, xdd."""
    if len(words) != len(scene.q) or not all(2 in {order for _, order in bases(w)} for w in words):
        return False
    hints = coordinates_of(scene, words)
    return not all(q in hint for q, hint in zip(scene.q, hints, strict=True)) and any(
        all(q in hint for q, hint in zip(order, hints, strict=True))
        for order in permutations(scene.q)
    )


def _in_another_order(some: Sequence[str], others: Sequence[str]) -> bool:
    return list(some) != list(others) and sorted(some) == sorted(others)


def unknown_words(scene: Scene, names: Sequence[str]) -> bool:
    """Whether names tell outputs apart by words that say nothing of the scene: cart_acc, pole_acc.

    Parameters
    ----------
    scene : Scene
    names : sequence of str
    """
    if len(names) != len(scene.q) or len(names) < 2:
        return False
    words = [
        {w for w in _plain(n).split("_") if len(w) > 2 and not MARKS.fullmatch(w)} for n in names
    ]
    free = all(hint == frozenset(scene.q) for hint in coordinates_of(scene, names))
    return free and all(words) and len({*map(frozenset, words)}) == len(names)


def coordinates_of(scene: Scene, names: Sequence[str]) -> tuple[Coordinates, ...]:
    """The coordinates that each of some names may be of."""
    plain = [_plain(name) for name in names]
    stems = _stems(scene)
    found = [_by_stem(scene, one, stems) for one in plain]
    turning = angular(scene)
    if any(hint and hint <= turning for hint in found):
        linear = frozenset(scene.q) - turning  # a beside alpha
        found = [
            linear if one == "a" and linear else h for one, h in zip(plain, found, strict=True)
        ]
    if len({*plain}) == 1 and len(found[0]) < min(len(names), len(scene.q)):
        found = [frozenset[Symbol]()] * len(names)  # x1 to x4 of a state
    if len(names) == len(scene.q):
        found = _by_count(scene, plain, _by_number(scene, names, plain, found))
    return tuple(hint or frozenset(scene.q) for hint in found)


def _plain(name: str) -> str:
    """A name in small letters, without numbers and with underscores between its words."""
    parted = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower()
    return re.sub(r"_+", "_", re.sub(r"\d+", "", re.sub(r"^d2", "dd", parted))).strip("_")


def _stems(scene: Scene) -> dict[str, Coordinates]:
    """Stems of names, and the coordinates that they are of."""
    turning = angular(scene)
    stems: dict[str, Coordinates] = {}
    for stem in ANGULAR:
        stems[stem] = frozenset(turning)
    for stem in LINEAR:
        stems[stem] = frozenset(scene.q) - turning
    for word, moved in _bodies(scene).items():
        stems[word] = moved
    bases = {q: re.sub(r"\d", "", key(q.name)).lower() for q in scene.q}
    for base in {*bases.values()}:
        of = frozenset(q for q in scene.q if bases[q] == base)
        for end in range(2, len(base)):
            others = [b for b in {*bases.values()} if b != base and b.startswith(base[:end])]
            if not others:
                stems[base[:end]] = of
        stems[base] = of
    return stems


def _bodies(scene: Scene) -> dict[str, Coordinates]:
    """Words of the names of bodies, and the coordinates that move them and no inner body."""
    moved: dict[str, Coordinates] = {}
    for body in scene.bodies:
        held = set(scene.position(body.centre).free_symbols)
        if isinstance(body, RigidBody):
            held |= scene.rotation(body.frame).free_symbols
        moved[body.name] = frozenset(held) & frozenset(scene.q)
    found: dict[str, Coordinates] = {}
    for name, own in moved.items():
        rest = own.difference(*(other for other in moved.values() if other < own))
        for word in re.findall("[a-z]{3,}", name.lower()):
            found[word] = found.get(word, frozenset()) | rest
    return found


def _by_stem(scene: Scene, name: str, stems: dict[str, Coordinates]) -> Coordinates:
    """The coordinates of the longest stem that a name has between marks of rates."""
    bare = name.replace("_", "")
    words = [bare, *(word for word in name.split("_") if len(word) > 2)]  # xdot_update
    for stem in sorted(stems, key=len, reverse=True):
        if bare == stem and stem in LETTERS and stems[stem] != _named(scene, stem):
            return frozenset()  # u and v are any two
        marked = re.compile(rf"(?:{BEFORE})?{re.escape(stem)}(?:{AFTER})?")
        if any(map(marked.fullmatch, words)):
            return stems[stem]
    return frozenset()


def _named(scene: Scene, letter: str) -> Coordinates:
    """Coordinates that are called by a letter."""
    return frozenset(q for q in scene.q if q.name.lower().rstrip("0123456789_") == letter)


def _by_number(
    scene: Scene, names: Sequence[str], plain: Sequence[str], found: Sequence[Coordinates]
) -> list[Coordinates]:
    """Hints with the numbers of names that differ by these alone."""
    numbers = [re.findall(r"\d+", re.sub(r"^d2", "dd", name)) for name in names]
    alike = len({*plain}) == 1 and all(len(number) == 1 for number in numbers)
    values = [int(number[0]) for number in numbers] if alike else []
    if len({*values}) < 2 or len(values) != len({*values}):
        return list(found)
    numbered = all(re.search(r"\d", q.name) for q in scene.q)
    if values == sorted(values) and not found[0] and not numbered:
        return list(found)  # o0 and o1 are any two outputs
    return [_numbered(scene, hint, k, 0 in values) for hint, k in zip(found, values, strict=True)]


def _numbered(scene: Scene, hint: Coordinates, number: int, from_zero: bool) -> Coordinates:
    """The coordinate of that number, by its own or by its place."""
    some = [q for q in scene.q if not hint or q in hint]
    own = [q for q in some if re.findall(r"\d+", q.name)[-1:] == [str(number + from_zero)]]
    place = number if from_zero else number - 1
    if len(own) == 1:
        return frozenset(own)
    return frozenset(some[place : place + 1]) if 0 <= place < len(some) else hint


def _by_count(
    scene: Scene, plain: Sequence[str], found: Sequence[Coordinates]
) -> list[Coordinates]:
    """Hints with words that count, where all names that say nothing else have one."""
    places = [
        next((k for k, words in enumerate(COUNTED) if {*words} & {*name.split("_")}), None)
        for name in plain
    ]
    if None in places or len({*places}) != len(places) or len(places) < 2:
        return list(found)
    return [
        hint if len(hint) == 1 else frozenset(scene.q[k : k + 1]) if k is not None else hint
        for hint, k in zip(found, places, strict=True)
    ]
