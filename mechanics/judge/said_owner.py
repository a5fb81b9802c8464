"""Whose speed, force or momentum a letter is, by the words of its own sentence.

The speed of the lower bob is V = l_1 phi_1'      V is read as the speed of the upper one: open
The angular momentum about the pivot is L = ...   L is read as that about the mass centre: open
"""

import re
from dataclasses import replace

from mechanics.claims.prose import sentence_around
from mechanics.kernel import undecided
from mechanics.report.answer.judged import Judged
from mechanics.scene import Scene

READ_AS = re.compile(r"(?:on the left|returns) is read as (?:the )?(?P<what>.+)")
OWNED = re.compile(
    r"\b(?P<noun>speed|velocity|tension|force|reaction|momentum|torque|moment)s?\b"
    r"(?: (?!of\b|in\b|at\b|about\b|on\b)\w+){0,2} (?:of|in|at|about|on)"
    r"(?P<owner>(?: (?!is\b|are\b|and\b|as\b|with\b|given\b)[\w-]+){1,4})",
    re.IGNORECASE,
)
SMALL_WORDS = frozenset(("the", "a", "an", "its", "of", "each", "this", "that", "our", "along"))
POINTS = frozenset(("tip", "end", "edge", "rim", "top", "bottom", "contact", "far", "free"))
"""Places of a body that are none of its centre."""
FIXED = frozenset(("pivot", "hinge", "support", "origin", "suspension", "fixed", "ceiling"))
CENTRES = frozenset(("centre", "center", "centroid"))


def of_its_owner(scene: Scene, entry: Judged) -> Judged:
    """The entry; open where it is right for another body or point than its sentence names.

    Parameters
    ----------
    scene : Scene
    entry : Judged
    """
    written = entry.statement.written
    notes = [m["what"] for note in entry.statement.notes if (m := READ_AS.search(note))]
    if written is None or not notes or not entry.finding.shown:
        return entry
    said = OWNED.search(" ".join(sentence_around(written.text, written.start).split()))
    owner = {*said["owner"].lower().split()} - SMALL_WORDS if said else set()
    if said is None or not owner or _fits(scene, notes[0], owner):
        return entry
    doubt = f"it is the {notes[0]}, and the text says '{said[0].strip()}'"
    return replace(entry, finding=undecided(entry.finding.subject, doubt))


def _fits(scene: Scene, what: str, owner: set[str]) -> bool:
    tokens = {*re.findall(r"[a-z]+|\d+", what.lower())}
    reactions = {one.name: {*one.on.lower().split(), *(one.by or "").lower().split()}
                 for one in scene.reactions}  # fmt: skip
    for name in {*re.findall(r"\w+", what)} & reactions.keys():
        tokens |= reactions[name]
    if owner & tokens:
        return True
    if "momentum" in tokens:
        about = "about" in tokens
        return about if owner & FIXED else not about if owner & CENTRES else True
    if "speed" in tokens or "velocity" in tokens:
        return not owner & POINTS and (len(scene.bodies) == 1 or not _names_a_body(scene, owner))
    return len(scene.reactions) < 2 or not _names_a_body(scene, owner)


def _names_a_body(scene: Scene, owner: set[str]) -> bool:
    """Whether words tell bodies apart."""
    bodies = {word for body in scene.bodies for word in re.findall(r"[a-z]+", body.name.lower())}
    sides = {
        "upper",
        "lower",
        "left",
        "right",
        "first",
        "second",
        "inner",
        "outer",
        "front",
        "rear",
    }
    return bool(owner & (bodies | sides))
