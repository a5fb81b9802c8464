"""Third step of the chain: C text = binary, at chosen states.

    computed value in the ball of everything that correct roundings of the text may give

No tolerance is chosen: the ball follows from the text. What is reported besides is how far the
values are from the exact ones, in units of the last place of the result, and of the sum of the
magnitudes of its terms.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import arb

from mechanics.compiled.translation_validation.build import Built
from mechanics.compiled.translation_validation.calls import lanes, one_by_one
from mechanics.compiled.translation_validation.states import STRATA, TYPES
from mechanics.compiled.translation_validation.status import OK
from mechanics.compiled.translation_validation.truth import BITS, Truth, doubtful
from mechanics.kernel import Finding, refuted, supported, undecided
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
        Largest error at ordinary states, in units of the last place of a result that is not 0.
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
    if odd is not None:
        return refuted(subject, odd.words, odd.wanted, odd.found), None
    ulp = ulp_terms = 0.0
    samples: list[tuple[Any, Any]] = []
    for i, normal, entries in known.exact:
        for k, (name, exact, around) in enumerate(entries):
            found = float(results[i, k])
            with precision(BITS):
                if not (np.isfinite(found) and around.contains(arb(found))):
                    return _refuted(subject, known, i, name, around, found), None
                samples.append((around, found))
                error = float(abs(arb(found) - exact).upper())
                if known.given.stratum[i] == 0 and not exact.contains(0):
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
    if statuses is not None and known.statuses is not None:
        open_ones = {i for i in _other_statuses(known, statuses) if doubtful(known, i)}
        sure = [i for i in range(count) if i not in open_ones]
        samples.append((known.statuses[sure].tolist(), statuses[sure].tolist()))
    return supported(subject, samples, words), measured


def _last(value: float, kind: str) -> float:
    """Unit of the last place; infinite beyond the largest number."""
    with np.errstate(over="ignore", invalid="ignore"):
        unit = float(np.spacing(TYPES[kind](abs(value))))
    return unit if np.isfinite(unit) else np.inf


def _refuted(subject: str, known: Truth, i: int, name: str, around: arb, found: float) -> Finding:
    words = f"{name} is not what correct roundings of the text can give"
    return refuted(subject, words, around, found, _state(known, i))


def _state(known: Truth, i: int) -> tuple[tuple[str, str], ...]:
    return tuple(
        (f"{name}[{entry}]", float(value).hex())
        for name, column in known.given.columns.items()
        for entry, value in enumerate(column[i])
    )


def _wrong_status(subject: str, known: Truth, statuses: Any) -> Finding | None:
    if statuses is None or known.statuses is None:
        return None
    i = next((i for i in _other_statuses(known, statuses) if not doubtful(known, i)), None)
    if i is None:
        return None
    found, wanted = int(statuses[i]), int(known.statuses[i])
    words = f"the status is {found}, the text says {wanted} ({STRATA[known.given.stratum[i]]})"
    return refuted(subject, words, wanted, found, _state(known, i))


def _other_statuses(known: Truth, statuses: Any) -> list[int]:
    """States at which the status is another one than the text says."""
    return np.flatnonzero(np.atleast_1d(statuses != known.statuses)).tolist()


def _no_number(subject: str, known: Truth, results: Any, statuses: Any) -> Finding | None:
    """A state at which the status says that all is well, and a value is no number."""
    if statuses is None or not results.size:
        return None
    wild = (statuses == OK) & ~np.isfinite(results).all(axis=1)
    if not wild.any():
        return None
    i = int(np.flatnonzero(wild)[0])
    words = f"the status is {OK}, and a value is no number ({STRATA[known.given.stratum[i]]})"
    wild_one = next(float(value) for value in results[i] if not np.isfinite(value))
    return refuted(subject, words, 0, wild_one, _state(known, i))
