"""Third step of the chain: C text = binary, at chosen states.

    computed value in the ball of everything that correct roundings of the text may give

No tolerance is chosen: the ball follows from the text. What is reported besides is how far the
values are from the exact ones, in units of the last place of the result, and of the sum of the
magnitudes of its terms.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import arb

from mechanics.compiled.custody.build import Built
from mechanics.compiled.custody.calls import lanes, one_by_one
from mechanics.compiled.custody.states import STRATA, TYPES
from mechanics.compiled.custody.status import OK
from mechanics.compiled.custody.truth import BITS, Truth, doubtful
from mechanics.kernel import Finding, Witness, refuted, supported, undecided
from mechanics.kernel.balls import precision


@dataclass(frozen=True)
class Measured:
    """How a binary compares with its text.

    Attributes
    ----------
    symbol, compiler : str
    states : int
        At which values were enclosed.
    ulp : float
        Largest error at ordinary states, in units of the last place of the result.
    ulp_terms : float
        Largest error wherever all numbers are normal, in units of the last place of the sum of the
        magnitudes of the terms, which cancellation does not touch.
    statuses : int
        States at which the status was compared.
    """

    symbol: str
    compiler: str
    states: int
    ulp: float
    ulp_terms: float
    statuses: int


def compare(known: Truth, built: Built) -> tuple[Finding, Measured | None]:
    """Decide whether a binary is its text, and measure it.

    Parameters
    ----------
    known : Truth
    built : Built
    """
    text = known.text
    symbol, kind = text.kernel.symbol, text.kernel.kind
    subject = f"{symbol}, {built.words} = {text.kernel.file}"
    if built.library is None:
        return undecided(subject, f"refused: {built.refusal}"), None
    call = lanes if text.kernel.lanes else one_by_one
    results, statuses, odd = call(known, getattr(built.library, symbol))
    if odd:
        return refuted(subject, odd), None
    ulp = ulp_terms = 0.0
    for i, normal, entries in known.exact:
        for k, (name, exact, around) in enumerate(entries):
            found = float(results[i, k])
            with precision(BITS):
                if not (np.isfinite(found) and around.contains(arb(found))):
                    return _refuted(subject, known, i, name, around, found), None
                error = float(abs(arb(found) - exact).upper())
                if known.given.stratum[i] == 0:
                    ulp = max(ulp, error / _last(float(exact.mid()), kind))
                size = float(known.sizes[i, k])
                if normal:
                    ulp_terms = max(ulp_terms, error / _last(size, kind))
    wrong = _wrong_status(subject, known, statuses)
    if wrong is None:
        wrong = _no_number(subject, known, results, statuses)
    if wrong is not None:
        return wrong, None
    if known.doubt:
        return undecided(subject, known.doubt), None
    count = len(known.given.stratum) if statuses is not None else 0
    measured = Measured(symbol, built.words, len(known.exact), ulp, ulp_terms, count)
    words = (
        f"{len(known.exact)} states inside of what correct roundings can give; largest error"
        f" {ulp_terms:.3g} ulp of the sum of the terms, {ulp:.3g} of the result at ordinary states;"
        f" status at {count} states"
    )
    return supported(subject, words), measured


def _last(value: float, kind: str) -> float:
    """Unit of the last place; infinite beyond the largest number."""
    with np.errstate(over="ignore", invalid="ignore"):
        unit = float(np.spacing(TYPES[kind](abs(value))))
    return unit if np.isfinite(unit) else np.inf


def _refuted(subject: str, known: Truth, i: int, name: str, around: arb, found: float) -> Finding:
    witness = Witness(_state(known, i), around.str(20), repr(found))
    words = f"{name} is not what correct roundings of the text can give"
    return refuted(subject, words, witness)


def _state(known: Truth, i: int) -> tuple[tuple[str, str], ...]:
    return tuple(
        (f"{name}[{entry}]", float(value).hex())
        for name, column in known.given.columns.items()
        for entry, value in enumerate(column[i])
    )


def _wrong_status(subject: str, known: Truth, statuses: Any) -> Finding | None:
    if statuses is None or known.statuses is None:
        return None
    differ = np.flatnonzero(np.atleast_1d(statuses != known.statuses)).tolist()
    i = next((i for i in differ if not doubtful(known, i)), None)
    if i is None:
        return None
    found, wanted = int(statuses[i]), int(known.statuses[i])
    witness = Witness(_state(known, i), str(wanted), str(found))
    words = f"the status is {found}, the text says {wanted} ({STRATA[known.given.stratum[i]]})"
    return refuted(subject, words, witness)


def _no_number(subject: str, known: Truth, results: Any, statuses: Any) -> Finding | None:
    """A state at which the status says that all is well, and a value is no number."""
    if statuses is None or not results.size:
        return None
    wild = (statuses == OK) & ~np.isfinite(results).all(axis=1)
    if not wild.any():
        return None
    i = int(np.flatnonzero(wild)[0])
    witness = Witness(_state(known, i), f"status {OK}", str(results[i].tolist()))
    words = f"the status is {OK}, and a value is no number ({STRATA[known.given.stratum[i]]})"
    return refuted(subject, words, witness)
