"""Conventions as people declare them, and what they leave open.

other vertical    half-length of L    from the right horizontal, counterclockwise    one choice
from the horizontal    half-length, of several lengths                               several

A name may end with one symbol of the scene: ``other sign of theta``.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, product

from sympy import Symbol

from mechanics.claims.angle_directions import SENSES, directed
from mechanics.claims.convention import POINT_MASS, Change, Convention, combined_table
from mechanics.claims.conventions import joints, lengths, other_sign, other_signs, other_vertical
from mechanics.claims.directions import DIRECTIONS, Counted, counted
from mechanics.claims.kinds import quantity
from mechanics.claims.names import Match
from mechanics.errors import InputError
from mechanics.nearest import instead
from mechanics.scene import Scene

SIGNS = ("other sign of angles", "other sign of displacements", "other sign of inputs")
JOINTS = ("relative angles", "absolute angles")
SIZES = ("half-length", "twice the length")
OPEN = ("from the horizontal", "above the horizontal", "below the horizontal")
DEFINITE = tuple(f"{way} {sense}" for way in DIRECTIONS for sense in SENSES.values())
EXACT = "single precision as exact"
HARMLESS = "what is not here changes nothing"
NAMES = ("other vertical", *SIGNS, *JOINTS, *SIZES, "point mass", *OPEN, *DEFINITE, EXACT,
         HARMLESS)  # fmt: skip
"""What may be declared; several are parted by a comma."""

Places = frozenset[tuple[int | None, int]]
"""Which of `directed` a name admits."""

MOST = 32
"""Choices that are looked at."""

UP = frozenset(((0, 1), (2, -1), (None, 1)))
DOWN = frozenset(((0, -1), (2, 1), (None, -1)))
WORDS = {
    "ccw": "counterclockwise", "cw": "clockwise", "anticlockwise": "counterclockwise",
    "halflength": "half-length", "upright": "upward vertical", "hanging": "downward vertical",
}  # fmt: skip
DROPPED = frozenset(("from", "the", "counted", "measured"))


@dataclass(frozen=True)
class Declared:
    """One convention that a person declares.

    Attributes
    ----------
    told : str
        As the person says it.
    name : str
        In its plain form, without articles.
    of : str
        The one symbol that it is about; empty for all.
    """

    told: str
    name: str
    of: str = ""


def read_declared(names: Sequence[str], known: Sequence[Match] = ()) -> tuple[Declared, ...]:
    """Conventions that a person declares, none twice.

    Parameters
    ----------
    names : sequence of str
    known : sequence of Match
        What names of the person were taken for.

    Raises
    ------
    InputError
        For a name that is none.
    """
    found: dict[tuple[str, str], Declared] = {}
    meanings = {match.name: match.meaning for match in known}
    for blank in (told for told in names if not told.replace(",", "").strip()):
        raise InputError(f"convention {blank[:80]!r}: {instead(blank, NAMES, 'conventions')}")
    for part in _parts(",".join(names)):
        every = _known()
        name, of = _plain(part), ""
        if name not in every:
            head, _, of = part.rpartition(" of ")
            name, of = _plain(head), of.strip()
            heads = {*every, "other sign"} - {_plain(sign) for sign in SIGNS}
            if name not in heads or not of.isidentifier():
                raise InputError(
                    f"convention {part[:80]!r}: {instead(part, NAMES, 'conventions')}"
                    " (of one name: half-length of L, other sign of theta)"
                )
            of = meanings.get(of, of)
        found.setdefault((name, of), Declared(part, name, of))
    return tuple(found.values())


def readings(scene: Scene, declared: Sequence[Declared], held: frozenset[Symbol]) -> list[Change]:
    """Everything that declared conventions can mean for statements that hold these symbols.

    Empty where a scene has nothing that one of them could be about.

    Raises
    ------
    InputError
        For conventions that contradict each other, too many choices, or a symbol that cannot have
        such a convention.
    """
    angles = counted(scene)
    choices = [_choices(scene, one, held, angles) for one in declared]
    count = 1
    for some in choices:
        count *= len(some)
    if count > MOST:
        raise InputError(
            f"conventions {', '.join(d.told for d in declared)}: they can mean {count} things: say"
            " which, for example 'half-length of L'"
        )
    found: dict[object, Change] = {}
    for chosen in product(*choices):
        change = _ordered([c for group in chosen for c in group], declared)
        seen = {s: e for s, e in combined_table(change).items() if s in held and s != e}
        found.setdefault((frozenset(seen.items()), POINT_MASS in change), change)
    return list(found.values())


def _parts(told: str) -> Iterator[str]:
    """Names between commas; a sense alone belongs to the direction before it."""
    before = ""
    for part in (p.strip() for p in told.split(",")):
        if before and _plain(part.partition(" of ")[0]) in SENSES.values():
            yield f"{before} {part}"
            before = ""
            continue
        if before:
            yield before
        before = part
    if before:
        yield before


def _plain(name: str) -> str:
    """A name without articles, in the words that are used here."""
    low = re.sub(r"(counter|anti)[- ]clock", r"\1clock", name.lower())
    words = [WORDS.get(w, w) for w in low.replace("half length", "half-length").split()]
    return " ".join(w for w in words if w not in DROPPED)


def _known() -> dict[str, Places | None]:
    """Names in their plain form, with the directions that they admit."""
    found: dict[str, Places | None] = {_plain(name): None for name in NAMES}
    for k, way in enumerate(DIRECTIONS):
        found[way] = frozenset((k, sense) for sense in SENSES)
        for sense, word in SENSES.items():
            found[f"{way} {word}"] = frozenset(((k, sense),))
    return found | {
        "horizontal": UP | DOWN, "above horizontal": UP, "below horizontal": DOWN,
        "above right horizontal": frozenset(((0, 1),)),
        "below right horizontal": frozenset(((0, -1),)),
        "above left horizontal": frozenset(((2, -1),)),
        "below left horizontal": frozenset(((2, 1),)),
    }  # fmt: skip


def _choices(
    scene: Scene, one: Declared, held: frozenset[Symbol], angles: Sequence[Counted]
) -> list[Change]:  # fmt: skip
    """What one declared convention can mean.

    Raises
    ------
    InputError
        For a symbol that cannot have it.
    """
    found = _meanings(scene, one, held, angles)
    if one.of and not found:
        every = (*scene.q, *scene.input_symbols, *scene.parameters)
        own = [replace(one, of=s.name) for s in every]
        able = [other.of for other in own if _meanings(scene, other, held, angles)]
        what = quantity(scene, one.of)
        what = f"{'an' if what[0] in 'ai' else 'a'} {what}" if what else "no name"
        raise InputError(
            f"convention {one.told!r}: {one.of} is {what} of {scene.name} and cannot have it:"
            f" {', '.join(able) or 'nothing'} can"
        )
    return found


def _meanings(
    scene: Scene, one: Declared, held: frozenset[Symbol], angles: Sequence[Counted]
) -> list[Change]:  # fmt: skip
    places = _known().get(one.name)
    found: list[Change]
    if places is not None:
        found = [(c,) for *place, c in directed(scene, angles, one.of) if tuple(place) in places]
    elif one.name in SIZES or one.name == _plain(SIZES[1]):
        found = _sizes(scene, one, held)
    elif one.name == "other sign":
        free = (*scene.q, *scene.input_symbols)
        found = [(other_sign(scene, [s], one.of),) for s in free if s.name == one.of]
    elif one.name == "other vertical":
        turned = other_vertical(scene, angles, one.of)
        found = [] if turned is None else [(turned,)]
    else:
        every = () if one.of else (*other_signs(scene), *joints(scene, angles), POINT_MASS)
        found = [(c,) for c in every if c.name == one.name]
    return found


def _sizes(scene: Scene, one: Declared, held: frozenset[Symbol]) -> list[Change]:
    """Each length that the statements hold, and all of them together."""
    start = "half-length of " if one.name == SIZES[0] else "twice the length of "
    every = [c for c in lengths(scene) if c.name.startswith(start)]
    if one.of:
        return [(c,) for c in every if c.name == start + one.of]
    used = [c for c in every if held & c.table.keys()] or every[:1]
    return [*((c,) for c in used), *([tuple(used)] if len(used) > 1 else [])]


def _ordered(change: list[Convention], declared: Sequence[Declared]) -> Change:
    """Joints first: a person's joint angle is between the person's own directions."""
    alone = any(d.of for d in declared)
    for one, other in combinations(change, 2):
        kinds = {one.kind, other.kind}
        # Beside joint angles, one angle alone that is counted otherwise could mean two things.
        together = kinds == {"turn", "sign"} or (
            "joints" in kinds and len(kinds) == 2 and not alone
        )
        if one.table.keys() & other.table.keys() and not together:
            raise InputError(
                f"conventions {', '.join(d.told for d in declared)}: {one.name} and {other.name}"
                " contradict each other: give one of them"
            )
    return tuple(sorted(change, key=lambda c: c.kind != "joints"))
