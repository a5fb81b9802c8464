"""The search for causes: every row of the tables is tried, alone, then two together.

A trial is a cause of the quantities that it changes, if all of these are what it predicts; so it
breaks nothing that agreed, and it explains what it touches or nothing.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import combinations, islice

import numpy as np

from mechanics.compare.amounts import SHARP, Amount, amounts, joined, stacked, together
from mechanics.compare.causes import CAUSES, Trial
from mechanics.compare.change import NOTHING, Array, Change
from mechanics.compare.ours import Ours
from mechanics.compare.quantities import (
    AS_MEANT,
    FORCES,
    FORWARD,
    INVERSE,
    POTENTIAL,
    Reading,
    predicted,
)
from mechanics.compare.states import States

ROUNDING = 2.0**-32
"""Differences up to this part of the largest number are taken for rounding."""
COARSE = 0.02
"""What is nothing beside the largest factor, where answers were printed with few digits."""
FIELDS = 8
"""Of the table of amounts the first rows go with each other and with any reading."""
FEW = 12
"""How many trials of a cause without an amount go together with an amount."""
OTHERS = 3
"""How many other causes that explain the same are told."""


@dataclass(frozen=True, eq=False)
class Seen:
    """What an engine answered.

    Attributes
    ----------
    observed : mapping of str to array
        By quantity, a row for each state.
    rounding : float
        Absolute: half a unit of the last digit that was printed.
    """

    ours: Ours
    states: States
    observed: Mapping[str, Array]
    rounding: float = 0.0

    def between(self, quantity: str, one: Array, two: Array) -> tuple[float, float]:
        """The largest difference, and what is allowed; infinite where shapes differ."""
        if one.shape != two.shape:
            return np.inf, 0.0
        left, right = self.comparable(quantity, one), self.comparable(quantity, two)
        size = max(float(np.abs(entries).max(initial=0.0)) for entries in (left, right))
        if quantity in (INVERSE, FORWARD):
            # Small forces may be differences of large ones.
            size = max(size, self._bias)
        apart = float(np.abs(left - right).max(initial=0.0))
        return apart, max(ROUNDING * size, self.rounding)

    def comparable(self, quantity: str, values: Array) -> Array:
        """Answers as they are compared.

        Accelerations are compared by the forces M a, so that their difference does not grow with
        the condition of M; potential energies are counted from that of the first state.
        """
        if quantity == POTENTIAL:
            return values - values[0]
        if quantity == FORWARD and values.shape == self.states.v.shape:
            return np.asarray(np.einsum("nij,nj->ni", self._mass, values))
        return values

    @cached_property
    def _mass(self) -> Array:
        return self.ours.mass_matrix(self.states.q)

    @cached_property
    def _bias(self) -> float:
        still = np.zeros_like(self.states.v)
        return float(np.abs(self.ours.forces(self.states.q, self.states.v, still)).max())

    def explained(self, reading: Reading, differing: Sequence[str]) -> tuple[str, ...]:
        """The quantities that a reading explains; none where it changes another."""
        try:
            return self._explained(reading, differing)
        except np.linalg.LinAlgError:
            return ()  # nothing resists a motion of the scene that was so changed

    @cached_property
    def meant(self) -> dict[str, Array]:
        """Our numbers for the scene as it is."""
        return {name: predicted(self.ours, name, self.states) for name in self.observed}

    def _explained(self, reading: Reading, differing: Sequence[str]) -> tuple[str, ...]:
        found = []
        for quantity in (*differing, *(name for name in self.observed if name not in differing)):
            if reading.only is not None and quantity not in reading.only:
                continue
            read = predicted(self.ours, quantity, self.states, reading)
            if quantity in differing:
                apart, allowed = self.between(quantity, read, self.observed[quantity])
                if apart <= allowed:
                    found.append(quantity)
                    continue
            apart, allowed = self.between(quantity, read, self.meant[quantity])
            if apart > allowed:
                return ()
        return tuple(found)


@dataclass(frozen=True, eq=False)
class Explanation:
    """A cause with what it explains.

    Attributes
    ----------
    causes : tuple of str
        Names in the tables.
    words : str
    quantities : tuple of str
    reading : Reading
    """

    causes: tuple[str, ...]
    words: str
    quantities: tuple[str, ...]
    reading: Reading


def explain(seen: Seen, differing: Sequence[str]) -> tuple[list[Explanation], list[Explanation]]:
    """Causes of the differences, and others that would explain the same.

    Returns
    -------
    (list, list) of Explanation
        Together the first explain as much as is found; where they leave some, no row does.
    """
    left, chosen, others = list(differing), [], []
    while left:
        found = [e for e in _single(seen, left) if e.quantities]
        if not any(set(e.quantities) == set(left) for e in found):
            found += [e for e in _pairs(seen, left) if e.quantities]
        if not found:
            break
        # The first of those that explain the most; the tables stand in that order.
        best = max(found, key=lambda e: len(e.quantities))
        chosen.append(best)
        others += [
            e for e in found if e is not best and set(e.quantities) == set(best.quantities)
            and e.causes != best.causes
        ]  # fmt: skip
        left = [quantity for quantity in left if quantity not in best.quantities]
    return chosen, others[:OTHERS]


def _single(seen: Seen, left: Sequence[str]) -> Iterator[Explanation]:
    for amount in amounts(seen.ours):
        yield from _fitted(seen, (amount,), left, AS_MEANT, (), "")
    for name, trial in _trials(seen):
        for only in (None, tuple(left)):
            reading = replace(trial.reading, only=only or trial.reading.only)
            if found := seen.explained(reading, left):
                words = trial.words + _alone(seen, only, found)
                yield Explanation((name,), words, found, reading)
                break


def _alone(seen: Seen, only: tuple[str, ...] | None, found: Sequence[str]) -> str:
    return f" ({', '.join(found)} alone)" if only and len(found) < len(seen.observed) else ""


def _trials(seen: Seen, most: int | None = None) -> Iterator[tuple[str, Trial]]:
    """Names of the causes and what is tried, of each the first so many."""
    shapes = {quantity: values.shape for quantity, values in seen.observed.items()}
    for cause in CAUSES:
        for trial in islice(cause.trials(seen.ours, shapes), most):
            yield cause.name, trial


def _pairs(seen: Seen, left: Sequence[str]) -> Iterator[Explanation]:
    table = list(amounts(seen.ours))[:FIELDS]
    for pair in combinations(table, 2):
        yield from _fitted(seen, pair, left, AS_MEANT, (), "")
    for name, trial in _trials(seen, FEW):
        for amount in table:
            yield from _fitted(seen, (amount,), left, trial.reading, (name,), trial.words)


def _fitted(
    seen: Seen,
    table: Sequence[Amount],
    left: Sequence[str],
    reading: Reading,
    names: tuple[str, ...],
    words: str,
) -> Iterator[Explanation]:
    """Amounts fitted together; what they change is either everything, or what differs alone."""
    parts = [amount.units(seen.ours) for amount in table]
    units = [unit for part in parts for unit in part]
    sharp = COARSE if seen.rounding else SHARP
    forces = [quantity for quantity in left if quantity in FORCES]
    for x in _factors(seen, table, units, forces, reading):
        told, at = [], 0
        for amount, part in zip(table, parts, strict=True):
            own, at = x[at : at + len(part)], at + len(part)
            told.append(amount.told(seen.ours, own, sharp))
        if not all(told):
            continue
        change = joined(reading.change, together(units, [*x]))
        for only in (None, tuple(left)):
            tried = replace(reading, change=change, only=only or reading.only)
            found = seen.explained(tried, left)
            if found:
                less = replace(tried, change=reading.change)
                if words and seen.explained(less, left) == found:
                    break  # the amount is rounding
                text = "; ".join(filter(None, (words, *told))) + _alone(seen, only, found)
                causes = (*names, *(amount.name for amount in table))
                yield Explanation(causes, text, found, tried)
                return


def _factors(
    seen: Seen,
    table: Sequence[Amount],
    units: Sequence[Change],
    quantities: Sequence[str],
    reading: Reading,
) -> Iterator[Array]:
    """Factors that are fitted; of a cause for whole bodies those of one body, or of all, too."""
    shown = np.array([bool(unit) for unit in units])
    fitted = _least_squares(seen, units, quantities, reading)
    if fitted is not None:
        x, shown, only = fitted
        whole = np.repeat([a.whole for a in table], [len(a.units(seen.ours)) for a in table])
        near = np.where(whole, np.round(x), x)
        if np.isin(near[whole], (0, 1)).all() and near.any():
            yield near
        if only:
            return
    if len(table) == 1 and table[0].whole:
        yield shown.astype(float)
        yield from np.eye(len(units))[shown]


def _least_squares(
    seen: Seen, units: Sequence[Change], quantities: Sequence[str], reading: Reading
) -> tuple[Array, Array, bool] | None:
    """The factors, which of them the numbers show, and whether there are no others; None without
    more numbers than factors.
    """
    ours, right = seen.ours, []
    columns: list[Array] = []
    if INVERSE in quantities:
        quantities = (INVERSE,)  # it shows every amount
    for quantity in quantities:
        states, target = seen.states, seen.observed[quantity]
        asked = quantity
        if quantity == FORWARD:
            # f that gives the accelerations that were observed: linear, where these are not.
            if target.shape != states.v.shape or reading.arguments or reading.values:
                continue
            states, target, asked = replace(states, a=target), states.f, INVERSE
            only = None if reading.only is None else (*reading.only, INVERSE)
            used = replace(reading, only=only)
        else:
            used = reading
        base = predicted(ours, asked, states, used)
        if base.shape != target.shape:
            continue
        right.append((target - base).ravel())
        # All units at once: what costs is the number of programs that are run, not their size.
        change, times = stacked(units, len(states)), len(units)
        if reading.change is not NOTHING:
            change = joined(change, reading.change)
        moved = predicted(ours, asked, states.repeated(times), replace(used, change=change))
        columns.append((moved.reshape(times, *base.shape) - base).reshape(times, -1).T)
    if not right or sum(map(len, right)) <= len(units):
        return None
    matrix = np.concatenate(columns)
    # Amounts that nothing shows are left at zero.
    sizes = np.linalg.norm(matrix, axis=0)
    used_columns = sizes > SHARP * ROUNDING * max(sizes.max(initial=0.0), 1e-300)
    x = np.zeros(len(units))
    if used_columns.any():
        scaled = matrix[:, used_columns] / sizes[used_columns]
        found, _, rank, _ = np.linalg.lstsq(scaled, np.concatenate(right), rcond=SHARP)
        x[used_columns] = found / sizes[used_columns]
        return x, used_columns, rank == used_columns.sum()
    return x, used_columns, False
