"""Accelerations that are no numbers, at random states, and why.

    underflow    a product below the smallest normal number is divided by
    singular     a pivot is zero to the last digit of the precision
    overflow     a value on the way is beyond the largest number
    range        the acceleration itself is, so that no form can give it

The largest single precision number is 3.4e38, the smallest normal one 1.2e-38.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.model import Model
from mechanics.compiled.programs.trace import trace
from mechanics.compiled.residuals import NAMES, PRECISIONS, SEED
from mechanics.compiled.sampling import States, sample
from mechanics.kernel import Finding, undecided

UNDERFLOW = "underflow: a product is below {tiny:.1e}, the smallest normal number, and divided by"
SINGULAR = "singular in this precision: a pivot is zero to its last digit"
OVERFLOW = "overflow: a value on the way to it is beyond {largest:.1e}, the largest number"


@dataclass(frozen=True)
class Lost:
    """Accelerations of one model in one precision that are no numbers, where they should be.

    Attributes
    ----------
    subject : str
        ``"kane: accelerations, single"``.
    lost, states : int
        How many of how many states, those not counted whose acceleration is out of range.
    cause : str
        At the first of them.
    state : tuple of (str, float)
        q, u, inputs and parameters there.
    """

    subject: str
    lost: int
    states: int
    cause: str
    state: tuple[tuple[str, float], ...]

    @property
    def finding(self) -> Finding:
        """For the report: the equations are not wrong, the numbers cannot be had in this form."""
        where = ", ".join(f"{name} = {value:.9g}" for name, value in self.state)
        evidence = (
            f"not finite at {self.lost} of {self.states} states, for example {where}: {self.cause};"
            " compile another form=, or in double precision"
        )
        return undecided(self.subject, evidence)


def not_finite(models: Sequence[Model], *, states: int) -> tuple[Lost, ...]:
    """Models and precisions that lose accelerations at the states of `residuals`."""
    return tuple(
        lost
        for model in models
        for kind in PRECISIONS
        for lost in _lost(model, sample(model.quantities, states, SEED).rounded(kind), kind)
    )


def _lost(model: Model, states: States, kind: type[np.floating]) -> Iterator[Lost]:
    limits = np.finfo(kind)
    broken = ~np.isfinite(_accelerations(model, states, kind)).all(axis=1)
    if not broken.any():
        return
    truth = np.abs(_accelerations(model, states, np.float64))
    # Without a wider precision at hand an overflow of a double counts as lost.
    in_range = (truth <= float(limits.max)).all(axis=1) | ~np.isfinite(truth).all(axis=1)
    places = np.flatnonzero(broken & in_range)
    if not len(places):
        return
    points = np.hstack(states.groups)
    known = model.quantities
    names = [entry.name for group in (known.q, known.u, known.inputs, known.p) for entry in group]
    first = points[places[0]]
    subject = f"{model.equations.route}: accelerations, {NAMES[kind]}"
    state = tuple(zip(names, map(float, first), strict=True))
    yield Lost(subject, len(places), len(points), _cause(model, first, kind), state)


def _accelerations(model: Model, states: States, kind: type[np.floating]) -> NDArray[np.float64]:
    q, u, inputs, p = states.groups
    with np.errstate(all="ignore"):
        solved = model.evaluate("forward_dynamics", kind, q=q, u=u, inputs=inputs, p=p)
        return np.asarray(solved["ud"], dtype=np.float64)


def _cause(model: Model, point: NDArray[np.float64], kind: type[np.floating]) -> str:
    limits = np.finfo(kind)
    events = trace(model.program("forward_dynamics"), point[None, :], kind)
    if not events.by_zero[0]:
        return OVERFLOW.format(largest=float(limits.max))
    if events.underflow[0] >= 0:
        return UNDERFLOW.format(tiny=float(limits.tiny))
    return SINGULAR
