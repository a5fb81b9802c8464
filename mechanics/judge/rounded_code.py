"""Code that rounds to single precision among doubles, read in exact numbers.

REFUTED by far more than roundings make            REFUTED
REFUTED by a difference that may be a rounding     UNDECIDED
shown                                              UNDECIDED: "right if single precision counts
                                                   as exact", and shown where that is declared
"""

import re
from collections.abc import Sequence
from dataclasses import replace

from mechanics.claims.declared_conventions import EXACT
from mechanics.judge.other_reading import is_wrong
from mechanics.kernel import Witness, undecided
from mechanics.report.answer.judged import Judged

FAR = 1e-3
"""Of the larger side: single precision has 24 bits, 6e-8, and few roundings are made of it."""
NUMBER = re.compile(r"[-+]?\d[\d_]*\.?\d*(?:e[-+]?\d+)?")
SAID = "convention: single precision counts as exact"


def exact_said(convention: Sequence[str]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """What is to be told where single precision is declared as exact, and the other conventions.

    Parameters
    ----------
    convention : sequence of str
    """
    parts = [part.strip() for told in convention for part in told.split(",")]
    if EXACT not in map(str.lower, parts):
        return (), tuple(convention)
    others = ", ".join(part for part in parts if part.lower() != EXACT)
    return (SAID,), (others,) if others else ()


def as_rounded(judged: Sequence[Judged], declared: bool) -> tuple[Judged, ...]:
    """The entries; open where they rest on numbers of single precision that count as exact.

    Parameters
    ----------
    judged : sequence of Judged
    declared : bool
        Whether somebody says that they do.
    """
    return tuple(_granted(entry if declared else _open(entry)) for entry in judged)


def _granted(entry: Judged) -> Judged:
    """An entry; open where it is right only if something is so that nothing here says."""
    words, finding = entry.statement.granted, entry.finding
    if not words or not finding.shown:
        return entry
    return replace(entry, finding=undecided(finding.subject, f"right if {words}: put it in"))


def _open(entry: Judged) -> Judged:
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
