"""The bound of what edits do, proved over a box.

    |d_i(part)| <= bound_i      for all i, on every part of the box

In each round every part on which it does not hold yet is halved along the input whose width enters
the deviations most. The budget counts parts.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from mechanics.kernel import Finding, enclosed, undecided
from mechanics.program import Program
from mechanics.reduce.deviation import Plan, deviations, plan
from mechanics.reduce.edits import Edits
from mechanics.reduce.intervals import Interval, ball_of, between

Array = NDArray[np.float64]
Box = Mapping[str, tuple[Fraction, Fraction]]

BOXES = 4096
"""Parts of a box that are looked at, unless the caller asks for more."""
CHUNK = 4096
"""Parts at once."""


@dataclass(frozen=True)
class Enclosure:
    """What is known of the deviations over a box.

    Attributes
    ----------
    boxes : int
        Parts that were looked at.
    deviations : tuple of Interval
        Hulls over the parts.
    """

    finding: Finding
    boxes: int
    deviations: tuple[Interval, ...]


def bound(
    subject: str,
    program: Program,
    box: Box,
    edits: Edits,
    bounds: Sequence[Fraction],
    boxes: int = BOXES,
) -> Enclosure:
    """Prove that no output deviates by more than its bound anywhere in a box.

    Parameters
    ----------
    box : mapping of str to (Fraction, Fraction)
        A range for every input.
    edits : mapping of int to Kind
    bounds : sequence of Fraction
        For every output.
    boxes : int
        Budget.
    """
    numbers = {name: low for name, (low, high) in box.items() if low == high}
    of = plan(program, edits, numbers)
    limits = np.array([_down(b) for b in bounds])
    ends = {n: between(*box[n]) for n in program.inputs if n not in numbers}
    whole = np.array([[[e.low for e in ends.values()], [e.high for e in ends.values()]]])
    parts, count = whole, 0
    low, high = np.full(len(bounds), np.inf), np.full(len(bounds), -np.inf)
    weights: Array | None = None
    while True:
        found = _at(of, list(ends), parts)
        count += len(parts)
        shown = (np.maximum(-found[:, 0], found[:, 1]) <= limits).all(axis=1)
        low = np.minimum(low, found[shown, 0].min(axis=0, initial=np.inf))
        high = np.maximum(high, found[shown, 1].max(axis=0, initial=-np.inf))
        if shown.all():
            break
        if weights is None:
            weights = _weights(of, list(ends), whole, limits)
        left = parts[~shown]
        if count + 2 * len(left) > boxes or not weights.any():
            return Enclosure(undecided(subject, _doubt(found[~shown], limits, count)), count, ())
        parts = _halved(left, whole, weights)
    hulls = tuple(Interval(float(a), float(b)) for a, b in zip(low, high, strict=True))
    rows = [(-b, ball_of(hull), b) for b, hull in zip(bounds, hulls, strict=True)]
    words = f"the deviation is enclosed on {count} part{'s' * (count > 1)} of the box"
    return Enclosure(enclosed(subject, rows, words), count, hulls)


def estimate(program: Program, box: Box, edits: Edits, unit: Array, parts: int) -> Array:
    """What no deviation is larger than, from so many parts of a box, the worst halved first.

    Parameters
    ----------
    box : mapping of str to (Fraction, Fraction)
    edits : mapping of int to Kind
    unit : (outputs,) array
        By which deviations are compared.
    """
    numbers = {name: low for name, (low, high) in box.items() if low == high}
    of = plan(program, edits, numbers)
    ends = {n: between(*box[n]) for n in program.inputs if n not in numbers}
    whole = np.array([[[e.low for e in ends.values()], [e.high for e in ends.values()]]])
    weights = _weights(of, list(ends), whole, unit)
    every, sizes = whole, np.abs(_at(of, list(ends), whole)).max(axis=1)
    while weights.any() and 2 * len(every) <= parts:
        with np.errstate(all="ignore"):
            worst = np.where(sizes > 0, sizes / unit, 0).max(axis=1)
        # Half of them: those that say most.
        split = np.argsort(-worst, kind="stable")[: (len(every) + 1) // 2]
        kept = np.setdiff1d(np.arange(len(every)), split)
        fresh = _halved(every[split], whole, weights)
        found = np.abs(_at(of, list(ends), fresh)).max(axis=1)
        every, sizes = np.concatenate([every[kept], fresh]), np.concatenate([sizes[kept], found])
    return sizes.max(axis=0)


def _at(of: Plan, names: Sequence[str], parts: Array) -> Array:
    """Lower and upper ends of the deviations, (parts, 2, outputs)."""
    found = np.empty((len(parts), 2, len([*of.program.roots])))
    for start in range(0, len(parts), CHUNK):
        some = parts[start : start + CHUNK]
        box = {name: Interval(some[:, 0, k], some[:, 1, k]) for k, name in enumerate(names)}
        with np.errstate(all="ignore"):
            for i, deviation in enumerate(deviations(of, box)):
                for end in (0, 1):
                    found[start : start + CHUNK, end, i] = deviation[end]
    return found


def _weights(of: Plan, names: Sequence[str], whole: Array, limits: Array) -> Array:
    """How much less the worst deviations are when an input keeps a quarter of its range."""
    several = np.repeat(whole, len(names) + 1, axis=0)
    for k in range(len(names)):
        a, b = whole[0, :, k]
        several[k, :, k] = a + 0.375 * (b - a), a + 0.625 * (b - a)
    found = _at(of, names, several)
    with np.errstate(all="ignore"):
        worst = np.where(limits > 0, np.abs(found).max(axis=1) / limits, 0).sum(axis=1)
        gains = worst[-1] - worst[:-1]
    wide = whole[0, 1] > whole[0, 0]
    if not np.isfinite(gains).all():
        return wide.astype(np.float64)
    return np.where(wide, np.maximum(gains, 1e-6 * np.max(gains, initial=0.0)), 0.0)


def _halved(parts: Array, whole: Array, weights: Array) -> Array:
    """Both halves of each part."""
    widths = whole[0, 1] - whole[0, 0]
    with np.errstate(all="ignore"):
        share = np.where(widths > 0, (parts[:, 1] - parts[:, 0]) / widths, 0)
    along = np.argmax(share * weights, axis=1)
    rows = np.arange(len(parts))
    middle = parts[rows, 0, along] / 2 + parts[rows, 1, along] / 2
    below, above = parts.copy(), parts.copy()
    below[rows, 1, along] = above[rows, 0, along] = middle
    return np.concatenate([below, above])


def _down(bound: Fraction) -> float:
    """A double that is not above it."""
    nearest = float(bound)
    return nearest if Fraction(nearest) <= bound else float(np.nextafter(nearest, -np.inf))


def _doubt(found: Array, limits: Array, count: int) -> str:
    sizes = np.abs(found).max(axis=1)
    if not np.isfinite(sizes).all():
        return (
            f"no bound within {count} parts of the box: a divisor may be 0 in it, or a root"
            " negative"
        )
    with np.errstate(all="ignore"):
        ratio = np.nanmax(np.where(sizes > 0, sizes / limits, 0))
    return f"no bound within {count} parts of the box: {ratio:.3g} times what may be is left"
