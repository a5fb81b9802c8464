"""Whose speed, force or momentum a letter is, by the words of its own sentence.

The speed of the lower bob is V = l_1 phi_1'      V is read as the speed of the upper one: open
The angular momentum about the pivot is L = ...   L is read as that about the mass centre: open
"""

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import islice

from mechanics.claims.counting_words import ONE_OF_SEVERAL, without_counts
from mechanics.claims.prose import sentence_around
from mechanics.claims.statement import Letter
from mechanics.equations import Equations
from mechanics.judge.meanings import candidates
from mechanics.kernel import undecided
from mechanics.report.answer.judged import Judged
from mechanics.scene import Scene

READ_AS = re.compile(r"(?:on the left|returns) is read as (?:the )?(?P<what>.+)")
OWNED = re.compile(
    r"\b(?P<noun>speed|velocity|tension|force|reaction|momentum|torque|moment)s?\b"
    r"(?: (?!of\b|in\b|at\b|about\b|on\b)\w+){0,2} (?:of|in|at|about|on)"
    r"(?P<owner>(?: (?!is\b|are\b|and\b|as\b|with\b|given\b)[\w-]+){1,6})",
    re.IGNORECASE,
)
SMALL_WORDS = frozenset(("the", "a", "an", "its", "of", "each", "this", "that", "our", "along"))
POINTS = frozenset(("tip", "end", "edge", "rim", "top", "bottom", "contact", "far", "free"))
"""Places of a body that are none of its centre."""
FIXED = frozenset(("pivot", "hinge", "support", "origin", "suspension", "fixed", "ceiling"))
CENTRES = frozenset(("centre", "center", "centroid"))


def of_its_owner(truth: Equations, entry: Judged) -> Judged:
    """The entry; open where it is right for another body or point than its sentence names.

    Or where nothing says that it is that of several which the name of its function says.

    Parameters
    ----------
    truth : Equations
    entry : Judged
    """
    scene, letter, written = truth.scene, entry.statement.letter, entry.statement.written
    notes = [m["what"] for note in entry.statement.notes if (m := READ_AS.search(note))]
    if letter is not None and letter.returned:
        return _of_its_function(truth, entry, letter, notes)
    if written is None or not notes or not entry.finding.shown:
        return entry
    return _as_said(scene, entry, notes[0], sentence_around(written.text, written.start))


def _as_said(scene: Scene, entry: Judged, what: str, words: str) -> Judged:
    """The entry; open where words say that it is of something else than it is read as."""
    said = OWNED.search(" ".join(words.split()))
    owner = {*without_counts(said["owner"].lower()).split()} - SMALL_WORDS if said else set()
    if said is None or not owner or _fits(scene, what, owner):
        return entry
    doubt = f"it is the {what}, and the text says '{said[0].strip()}'"
    return replace(entry, finding=undecided(entry.finding.subject, doubt))


def _of_its_function(
    truth: Equations, entry: Judged, letter: Letter, notes: Sequence[str]
) -> Judged:
    """The entry of what a function returns; open where its name says which, and nothing else."""
    if not (notes and entry.finding.shown):
        return entry
    commented = entry
    for paragraph in entry.statement.comments.split("\n\n"):
        commented = _as_said(truth.scene, commented, notes[0], paragraph)
    several = len(list(islice(candidates(truth, letter.said), 2))) > 1
    if not (several and letter.owner and commented.finding.shown):
        return commented
    if letter.owner <= _tokens(truth.scene, notes[0]):
        return entry
    doubt = (
        f"it is the {notes[0]}, and nothing says that {letter.name} is that one: say which:"
        f" about (--about) can be {letter.said}, or a reaction"
    )
    return replace(entry, finding=undecided(entry.finding.subject, doubt))


def _tokens(scene: Scene, what: str) -> set[str]:
    """Words of a thing of the scene, with those of the bodies that it acts on."""
    tokens = {*re.findall(r"[a-z]+|\d+", what.lower())}
    reactions = {one.name: {*one.on.lower().split(), *(one.by or "").lower().split()}
                 for one in scene.reactions}  # fmt: skip
    for name in {*re.findall(r"\w+", what)} & reactions.keys():
        tokens |= reactions[name]
    return tokens


def _fits(scene: Scene, what: str, owner: set[str]) -> bool:
    tokens = _tokens(scene, what)
    if "momentum" in tokens and owner & (FIXED | CENTRES):
        return ("about" in tokens) is bool(owner & FIXED)
    if owner & tokens or "momentum" in tokens:
        return True
    if "speed" in tokens or "velocity" in tokens:
        return not owner & POINTS and (len(scene.bodies) == 1 or not _names_a_body(scene, owner))
    return len(scene.reactions) < 2 or not _names_a_body(scene, owner)


def _names_a_body(scene: Scene, owner: set[str]) -> bool:
    """Whether words tell bodies apart."""
    bodies = {word for body in scene.bodies for word in re.findall(r"[a-z]+", body.name.lower())}
    return bool(owner & (bodies | ONE_OF_SEVERAL))
