"""Code that rounds to single precision among doubles, or rests on code that is not here.

REFUTED by far more than roundings make            REFUTED
REFUTED by a difference that may be a rounding     UNDECIDED
shown                                              UNDECIDED: "right if single precision counts
                                                   as exact", and shown where that is declared
shown, if check() changes nothing                  UNDECIDED: "right if check() changes nothing"
anything, if own.h gives no name a meaning         UNDECIDED; and as it is where that is declared
"""

import re
from collections.abc import Sequence
from dataclasses import replace

from mechanics.claims.declared_conventions import EXACT, HARMLESS
from mechanics.judge.other_reading import is_wrong
from mechanics.kernel import Witness, undecided
from mechanics.report.answer.judged import Judged

FAR = 1e-3
"""Of the larger side: single precision has 24 bits, 6e-8, and few roundings are made of it."""
NUMBER = re.compile(r"[-+]?\d[\d_]*\.?\d*(?:e[-+]?\d+)?")
NOTES = {
    EXACT: "convention: single precision counts as exact",
    HARMLESS: "convention: what is not here changes nothing",
}


def code_conventions(convention: Sequence[str] | str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Which of `NOTES` are declared, and the other conventions.

    Parameters
    ----------
    convention : str or sequence of str
    """
    convention = [convention] if isinstance(convention, str) else convention
    parts = [part.strip() for words in convention for part in words.split(",")]
    declared = tuple(name for name in NOTES if name in map(str.lower, parts))
    if not declared:
        return (), tuple(convention)
    others = ", ".join(part for part in parts if part.lower() not in NOTES)
    return declared, (others,) if others else ()


def as_rounded(judged: Sequence[Judged], declared: Sequence[str]) -> tuple[Judged, ...]:
    """The entries; open where they rest on what nothing here says.

    Parameters
    ----------
    judged : sequence of Judged
    declared : sequence of str
        Which of `NOTES` somebody says.
    """
    entries = judged if EXACT in declared else [*map(_if_rounded, judged)]
    return tuple(entries if HARMLESS in declared else map(_if_assumed, entries))


def _if_assumed(entry: Judged) -> Judged:
    """An entry; open where it is right only if something is so that nothing here says."""
    statement, finding = entry.statement, entry.finding
    if statement.missing_code and (finding.shown or is_wrong(entry)):
        words = f"{statement.missing_code}: put what it declares into the file"
        why = undecided(finding.subject, f"{words}, or --convention '{HARMLESS}'")
        return replace(entry, finding=why, right_if=(), open=False)
    if not statement.assumption or not finding.shown:
        return entry
    words = f"right if {statement.assumption}: put it in, or --convention '{HARMLESS}' says so"
    return replace(entry, finding=undecided(finding.subject, words))


def _if_rounded(entry: Judged) -> Judged:
    rounded, finding = entry.statement.rounded, entry.finding
    if not rounded or not (finding.shown or is_wrong(entry)) or entry.of_dimension:
        return entry
    why = f"{rounded!r} is rounded to single precision among doubles"
    if finding.shown:
        words = f"right if single precision counts as exact ({why}): --convention '{EXACT}' says so"
        return replace(entry, finding=undecided(finding.subject, words))
    if finding.witness is not None and _far(finding.witness):
        return entry
    words = f"the sides differ, if not by more than roundings may make: {why}"
    return replace(entry, finding=undecided(finding.subject, words), right_if=(), open=False)


def _far(witness: Witness) -> bool:
    """Whether two sides differ at a state by more than roundings make."""
    sides = [
        NUMBER.match(side.replace(" ", "").lstrip("[")) for side in (witness.left, witness.right)
    ]
    if None in sides:
        return False
    left, right = (float(side[0].replace("_", "")) for side in sides if side is not None)
    return abs(left - right) > FAR * max(abs(left), abs(right))
