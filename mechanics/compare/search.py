"""The search for causes: every row of the tables is tried, alone, then two together.

A trial is a cause of the quantities that it changes, if all of these are what it predicts; so it
breaks nothing that agreed, and it explains what it touches or nothing.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import combinations

import numpy as np

from mechanics.compare.amounts import SHARP, Amount, amounts, joined, together
from mechanics.compare.causes import CAUSES, Trial
from mechanics.compare.ours import Array, Change, Ours
from mechanics.compare.quantities import (
    AS_MEANT,
    FORCES,
    FORWARD,
    INVERSE,
    Reading,
    comparable,
    predicted,
)
from mechanics.compare.states import States

ROUNDING = 2.0**-32
"""Differences up to this part of the largest number are taken for rounding."""
COARSE = 0.02
"""What is nothing beside the largest factor, where answers were printed with few digits."""
FIELDS = 4
"""Of the table of amounts the first rows go with any reading."""
OTHERS = 3
"""How many other causes that explain the same are told."""


@dataclass(frozen=True, eq=False)
class Seen:
    """What an engine answered.

    Attributes
    ----------
    ours : Ours
    states : States
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
        (left, right), size = comparable(self.ours, quantity, (one, two), self.states)
        apart = float(np.abs(left - right).max(initial=0.0))
        return apart, max(ROUNDING * size, self.rounding)

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
        yield Explanation((name,), trial.words, seen.explained(trial.reading, left), trial.reading)


def _trials(seen: Seen) -> Iterator[tuple[str, Trial]]:
    shapes = {quantity: values.shape for quantity, values in seen.observed.items()}
    for cause in CAUSES:
        for trial in cause.trials(seen.ours, shapes):
            yield cause.name, trial


def _pairs(seen: Seen, left: Sequence[str]) -> Iterator[Explanation]:
    table = list(amounts(seen.ours))
    for pair in combinations([amount for amount in table if not amount.whole], 2):
        yield from _fitted(seen, pair, left, AS_MEANT, (), "")
    for name, trial in _trials(seen):
        for amount in table[:FIELDS]:
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
                alone = only and len(found) < len(seen.observed)
                more = f" ({', '.join(found)} alone)" if alone else ""
                text = "; ".join(filter(None, (words, *told))) + more
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
    fitted = _least_squares(seen, units, quantities, reading)
    if not all(amount.whole for amount in table):
        if fitted is not None:
            yield fitted[0]
        return
    if fitted is not None:
        x, only = fitted
        near = np.round(x)
        if np.isin(near, (0, 1)).all() and near.any():
            yield near
        if only:
            return
    yield np.ones(len(units))
    yield from np.eye(len(units))


def _least_squares(
    seen: Seen, units: Sequence[Change], quantities: Sequence[str], reading: Reading
) -> tuple[Array, bool] | None:
    """The factors, and whether there are no others; None without more numbers than factors."""
    ours, right = seen.ours, []
    columns: list[list[Array]] = [[] for _ in units]
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
        for column, unit in zip(columns, units, strict=True):
            change = joined(reading.change, unit)
            moved = predicted(ours, asked, states, replace(used, change=change))
            column.append((moved - base).ravel())
    if not right or sum(map(len, right)) <= len(units):
        return None
    matrix = np.stack([np.concatenate(column) for column in columns], axis=1)
    # Amounts that nothing shows are left at zero.
    sizes = np.linalg.norm(matrix, axis=0)
    used_columns = sizes > SHARP * ROUNDING * max(sizes.max(initial=0.0), 1e-300)
    x = np.zeros(len(units))
    if used_columns.any():
        scaled = matrix[:, used_columns] / sizes[used_columns]
        found, _, rank, _ = np.linalg.lstsq(scaled, np.concatenate(right), rcond=SHARP)
        x[used_columns] = found / sizes[used_columns]
        return x, rank == len(units)
    return x, False
