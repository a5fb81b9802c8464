"""How large the error of a choice can be on states that were not tried.

    bound = max(SAFETY * largest error seen, tail)

The largest of 299 errors is one that 99 % of all states stay below, with a confidence of 95 %
(Wilks, Annals of Mathematical Statistics 12, 1941), whatever their distribution. On it stands a
factor of safety.

Beside a separatrix errors have a heavy tail, P(error > x) ~ x^(-1/xi). With many states xi is
estimated from the m largest errors (Hill, Annals of Statistics 3, 1975) and the tail extrapolated:

    tail = x_m (m / (count p))^xi,   p = 1 - coverage
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtri

from mechanics.errors import MechanicsError
from mechanics.trade.case import Case
from mechanics.trade.choice import Choice
from mechanics.trade.family import Family
from mechanics.trade.measure import prepared
from mechanics.trade.truth import Truth

Array = NDArray[np.float64]

SAFETY = 2.0
"""By how much the largest error that was seen has to stay below a target."""
COVERAGE, CONFIDENCE = 0.999, 0.95
# Share of the errors that is the tail, and the fewest that tell its index.
TAIL, FEWEST = 0.05, 10
# Below half an ulp of the scale an error is luck.
SMALLEST = 2.0**-53


@dataclass(frozen=True, eq=False)
class Trained:
    """Errors of a choice over the training states.

    Attributes
    ----------
    errors : array, shape (count,)
        Largest along the way, in the stated norm; infinite where a run failed.
    """

    choice: Choice
    errors: Array = field(repr=False)

    @property
    def largest(self) -> float:
        """Largest error that was seen."""
        return float(np.max(self.errors))

    @property
    def bound(self) -> float:
        """What errors on other states of the family are expected to stay below."""
        if not np.all(np.isfinite(self.errors)):
            return np.inf
        return max(SAFETY * max(self.largest, SMALLEST), tail_limit(self.errors))


def tail_limit(errors: Array) -> float:
    """What the stated share stays below by the index of the tail; 0 where there is no tail."""
    count = int(TAIL * len(errors))
    if count < FEWEST:
        return 0.0
    top = np.sort(np.maximum(errors, SMALLEST))[-count - 1 :]
    index = float(np.mean(np.log(top[1:] / top[0])))
    # The estimate of the index scatters by its count's square root.
    upper = index * (1 + ndtri(CONFIDENCE) / np.sqrt(count))
    return float(top[0] * (count / (len(errors) * (1 - COVERAGE))) ** upper)


def train(case: Case, choices: Sequence[Choice], around: Family, count: int) -> tuple[Trained, ...]:
    """Errors of choices on the first `count` states of a family."""
    if around.elsewhere is not None:
        found = around.elsewhere(choices, count)
    else:
        states = around.starts[:count], around.truths[:count]
        found = [errors_of(case, choice, *states) for choice in choices]
    return tuple(map(Trained, choices, found))


def error_of(case: Case, choice: Choice, start: Array, truth: Truth) -> float:
    """Largest error of a choice along the motion from a state; infinite where it fails.

    An error is not taken for smaller than the doubt about what it is measured against.
    """
    try:
        outcome = prepared(case, choice, start)()
    except MechanicsError:
        return np.inf
    if outcome.failure or len(outcome.states) < len(case.times):
        return np.inf
    return max(float(np.max(truth.errors(outcome.states))), truth.doubt)


def errors_of(case: Case, choice: Choice, starts: Array, truths: Sequence[Truth]) -> Array:
    """Errors of a choice from states; after one where it fails it is not tried on the others."""
    found = np.full(len(starts), np.inf)
    for i, (start, truth) in enumerate(zip(starts, truths, strict=True)):
        found[i] = error_of(case, choice, start, truth)
        if not np.isfinite(found[i]):
            break
    return found
