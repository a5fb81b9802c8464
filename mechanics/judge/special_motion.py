"""Words by which a sentence gives a statement for some motions only: "at constant theta".

A statement that is wrong in general may be right for these. Nobody derives such a motion here, so
that it is not refuted where its sentence speaks of one.
"""

import re
from dataclasses import replace

from mechanics.claims.claim import Written
from mechanics.claims.prose import FROM_REST, sentence_around
from mechanics.kernel import Verdict, undecided
from mechanics.report.answer.judged import Judged
from mechanics.scene.quantities import (
    Hamiltonian,
    KineticEnergy,
    Lagrangian,
    PotentialEnergy,
    TotalEnergy,
)

ENERGIES = (KineticEnergy, PotentialEnergy, TotalEnergy, Lagrangian, Hamiltonian)
MOTIONS = re.compile(
    r"\bsteady\b|\bcircular orbits?\b|\bat constant\b|\brelative equilibri\w+|\bhover\w*"
    rf"|{FROM_REST.pattern}|\binitially\b"
    r"|\baverag(?:ed?|ing)\b|\bmode shapes?\b|\bin (?:the|this|its) (?:\w+ )?(?:normal )?mode\b"
    r"|\b(?:when|if|while|with) (?:(?!(?:end|pivot|support|hinge|base|axle|axis|cent(?:re|er))\b)"
    r"\w+ ){1,4}?(?:held|clamped|locked|blocked)\b"
    r"|\b(?:in|out of) phase\b|\\gg\b|\\ll\b"
    r"|\bmuch (?:heavier|lighter|larger|smaller|greater|less)\b|\bin the frame of\b"
    r"|\bin (?:the|a) (?:co-?)?(?:rotating|moving|turning) (?:frame|system)\b"
    r"|\bfor\s*\$\s*\\omega"
    r"|\b(?:dimensionless|non-?dimensional|rescaled) (?:time|variables?|form|equations?)\b",
    re.IGNORECASE,
)
SERIES = re.compile(
    r"\bsmall[ -](?:oscillations?|angles?|amplitudes?|displacements?|vibrations?)\b|\bnear\b"
    r"|\bto (?:first|second|third|fourth|lowest|leading) order\b|\b(?:quadratic|harmonic|taylor)\b",
    re.IGNORECASE,
)
"""Of an energy these leave its first terms."""


def of_special_motion(entry: Judged) -> Judged:
    """The entry; not refuted where its own sentence gives it for some motions only.

    Parameters
    ----------
    entry : Judged
    """
    row, written = entry.statement.row, entry.statement.written
    if entry.verdict is not Verdict.REFUTED or row is None or written is None:
        return entry
    own = _own_words(written)
    found = MOTIONS.search(own)
    if found is None and isinstance(row.quantity, ENERGIES):
        found = SERIES.search(own)
    if found is None:
        return entry
    words = " ".join(found[0].split())
    doubt = f"the text gives it for '{words}', which is not judged apart: leave that out"
    return replace(entry, finding=undecided(entry.finding.subject, doubt), right_if=())


def _own_words(written: Written) -> str:
    """The sentence of a statement; behind a formula on another line of a text stands its case."""
    sentence = sentence_around(written.text, written.start)
    if written.notation != "text":
        return sentence
    line = written.text[: written.start].rpartition("\n")[2]
    line += written.text[written.start :].partition("\n")[0]
    return "\n".join(
        other if other == line else other.partition("=")[0] for other in sentence.split("\n")
    )
