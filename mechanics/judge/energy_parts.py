"""Energies that the words before them call those of a part, or twice the whole.

"The kinetic energy of the cart is ..."    "Twice the kinetic energy is ..."
"""

import re
from dataclasses import replace

from mechanics.claims.prose import ENDS
from mechanics.kernel import Verdict, undecided
from mechanics.report.answer.judged import Judged
from mechanics.scene import Scene
from mechanics.scene.quantities import KineticEnergy, PotentialEnergy, TotalEnergy

PART = re.compile(
    r"\b(?P<part>(?:(?:twice|half)\s+(?:of\s+)?(?:the\s+)?)?(?:(?:translation|rotation)al\s+)?"
    r"(?:kinetic|potential|total|mechanical)\s+energy"
    r"(?:\s+(?:of|in|due to)\s+(?:the\s+|its\s+)?(?P<of>(?:[\w-]+\s+){1,3}?))?)"
    r"\s*(?:is|reads|becomes|equals|:|=)?\s*(?:then|now|just|simply)?\s*(?:\$+|\\\(|\\\[)?\s*$",
    re.IGNORECASE,
)
ENERGIES = (KineticEnergy, PotentialEnergy, TotalEnergy)
WHOLE = re.compile(
    r"\b(?:system|whole|mechanism|machine|assembly|both|all|two|three|bodies|masses|motion)\b", re.I
)


def of_a_part(scene: Scene, entry: Judged) -> Judged:
    """The entry; an energy that the words before it call that of a part is not refuted.

    "The kinetic energy of the cart is ..." in a scene of a cart and a pole; what nothing else of
    the scene has is the whole.
    """
    written, row = entry.statement.written, entry.statement.row
    if entry.finding.verdict is not Verdict.REFUTED or written is None or row is None:
        return entry
    if not written.text or not isinstance(row.quantity, ENERGIES):
        return entry
    before = " ".join(written.text[max(0, written.start - 120) : written.start].split())
    sentence = ENDS.split(before)[-1]
    part = PART.search(sentence)
    if part is None or not (_is_part(scene, part) or _of_it(scene, sentence[: part.start()])):
        return entry
    words = f"the text speaks of the {part['part'].strip()}: parts of an energy are not judged"
    return replace(entry, finding=undecided(entry.finding.subject, words))


def _of_it(scene: Scene, before: str) -> bool:
    """Whether it is its energy, where the same sentence speaks of one of several bodies."""
    words = {*re.findall("[a-z]+", before.lower())}
    bodies = {word for body in scene.bodies for word in re.findall("[a-z]+", body.name.lower())}
    own = before.lower().rstrip().endswith((" its", " whose"))
    return own and len(scene.bodies) > 1 and bool(words & bodies)


def _is_part(scene: Scene, said: re.Match[str]) -> bool:
    plain, of = said["part"].lower(), (said["of"] or "").lower()
    if re.match(r"twice|half|(?:translation|rotation)al", plain) or re.match("rotation|trans", of):
        return True
    if not of or len(scene.bodies) < 2 or WHOLE.search(of):
        return False
    bodies = {word for body in scene.bodies for word in re.findall("[a-z]+", body.name.lower())}
    words = set(re.findall("[a-z]+", of))
    return bool(words & bodies) or not words & set(re.findall("[a-z]+", scene.name.lower()))
