"""What a C text has at chosen states: exact values, everything that may be computed, statuses."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from flint import arb
from numpy.typing import NDArray
from sympy import Symbol

from mechanics.compiled.custody.numeric import decided, sizes, values
from mechanics.compiled.custody.rounding import Rounded, RoundedArithmetic
from mechanics.compiled.custody.states import FINITE, TYPES, States, states
from mechanics.compiled.custody.text import Text
from mechanics.exact.balls import Ball, BallArithmetic, State, precision
from mechanics.exact.c_condition import atoms
from mechanics.exact.graph import evaluated

BITS = 320
WORK = 16_000
"""Operations that are enclosed for one function; it says at how many states."""
FEWEST, MOST = 2, 12
"""States of each stratum."""

Array = NDArray[np.floating]


@dataclass(frozen=True)
class Truth:
    """What a text has at some states, worked out once for all binaries.

    Attributes
    ----------
    text : Text
    given : States
    exact : list of (int, bool, list of (str, arb, arb))
        By state: whether all numbers are normal; for every entry of the outputs its name, the exact
        value and everything that may be computed.
    sizes : array
        N x entries: sums of magnitudes.
    statuses : array of int or None
    """

    text: Text
    given: States
    exact: list[tuple[int, bool, list[tuple[str, arb, arb]]]]
    sizes: Array
    statuses: NDArray[np.int64] | None


def truth(text: Text, symbols: Mapping[str, Sequence[Symbol]]) -> Truth:
    """Enclose the values of a text at states of every stratum."""
    kind, nodes = text.kernel.kind, text.program.nodes
    each = int(np.clip(WORK // (FINITE * max(len(nodes), 1)), FEWEST, MOST))
    given = states(text.groups, dict(symbols), kind, each)
    for name in text.kernel.shared or ():
        if name in given.columns:
            given.columns[name][:] = given.columns[name][0]
    arguments: list[Array] = [np.zeros((0, 0))] * text.first
    arguments += [given.columns[name] for name, _ in text.groups]
    count = len(given.stratum)
    known = values(nodes, arguments, TYPES[kind])
    known = [np.broadcast_to(value, count) for value in known]
    at = [text.program.outputs[place][0].node for _, place in text.entries()]
    scale = sizes(nodes, known)
    magnitudes = np.stack([np.broadcast_to(scale[k], count) for k in at], axis=1)
    status = text.program.status
    statuses = None if status is None else decided(status, known, count)
    exact = []
    for i in np.flatnonzero(given.stratum < FINITE):
        found = _enclosed(text, [a[i] if a.size else a for a in arguments])
        if found is not None:
            exact.append((int(i), *found))
    return Truth(text, given, exact, magnitudes, statuses)


def _enclosed(
    text: Text, arguments: Sequence[Array]
) -> tuple[bool, list[tuple[str, arb, arb]]] | None:  # fmt: skip
    """Every entry at one state, and whether all is normal; None where a value overflows."""
    kind, nodes = text.kernel.kind, text.program.nodes
    limits = np.finfo(TYPES[kind])
    largest, tiny = arb(float(limits.max)), arb(float(limits.tiny))
    with precision(BITS):
        rough, sharp = RoundedArithmetic(kind), BallArithmetic(State({}))
        numbers = [[arb(float(x)) for x in group] for group in arguments]
        wide = evaluated(rough, nodes, [[Rounded(x, rough) for x in g] for g in numbers], True)
        computed = (x.arb for x, node in zip(wide, nodes, strict=True) if node.constant is None)
        if not all(abs(x) < largest for x in computed):
            return None
        fine = evaluated(sharp, nodes, [[Ball(x) for x in g] for g in numbers], True)
        found = []
        for name, place in text.entries():
            node = text.program.outputs[place][0].node
            value, around = fine[node].arb, wide[node].arb
            for other in text.program.outputs[place][1:]:
                around = around.union(wide[other.node].arb)
            found.append((name, value, around))
        normal = all(abs(x.arb) >= tiny or x.arb.is_zero() for x in fine)
    return normal, found


def doubtful(known: Truth, state: int) -> bool:
    """Whether roundings decide a condition of the status: a divisor may just be zero, or not."""
    text = known.text
    if known.given.stratum[state] >= FINITE or text.program.status is None:
        return False
    kind, nodes = text.kernel.kind, text.program.nodes
    largest = arb(float(np.finfo(TYPES[kind]).max))
    with precision(BITS):
        rough = RoundedArithmetic(kind)
        given: list[list[Rounded]] = [[]] * text.first
        for name, _ in text.groups:
            column = known.given.columns[name][state]
            given.append([Rounded(arb(float(x)), rough) for x in column])
        wide = evaluated(rough, nodes, given, True)
        for atom in atoms(text.program.status):
            first = wide[atom.operands[0]].arb
            if atom.relation == "==":
                difference = first - wide[atom.operands[1]].arb
                if difference.contains(0) and not difference.is_zero():
                    return True
            elif not abs(first) < largest and not abs(first) > largest:
                return True
    return False
