"""What a C text has at chosen states: exact values, everything that may be computed, statuses."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from flint import arb
from numpy.typing import NDArray
from sympy import Symbol

from mechanics.compiled.translation_validation.code import EVERY
from mechanics.compiled.translation_validation.numeric import Magnitudes, decided
from mechanics.compiled.translation_validation.rounding import RoundedBalls
from mechanics.compiled.translation_validation.states import FINITE, STRATA, TYPES, States, states
from mechanics.compiled.translation_validation.text import ASKED, VALUES, Text
from mechanics.kernel.balls import Balls, precision
from mechanics.program import Program, interpret
from mechanics.program.c.condition import atoms

BITS = 320
WORK = 16_000
"""Operations that are enclosed for one function; it says at how many states."""
FEWEST, MOST = 2, 12
"""States of each stratum."""
ROOM = 8
"""How many times the error of the program a text may have: other orders of terms are fine."""

Array = NDArray[np.floating]


@dataclass(frozen=True)
class Truth:
    """What a text has at some states, worked out once for all binaries.

    Attributes
    ----------
    exact : list of (int, bool, list of (str, arb, arb))
        By state: whether all numbers are normal; for every entry of the outputs its name, the exact
        value and everything that may be computed.
    sizes : array
        N x entries: sums of magnitudes.
    statuses : array of int or None
    doubt : str
        Why values of the text are no good measure of a binary; mostly empty.
    """

    text: Text
    given: States
    exact: list[tuple[int, bool, list[tuple[str, arb, arb]]]]
    sizes: Array
    statuses: NDArray[np.int64] | None
    doubt: str = ""


def truth(text: Text, symbols: Mapping[str, Sequence[Symbol]], written: Program) -> Truth:
    """Enclose the values of a text at states of every stratum.

    Parameters
    ----------
    symbols : mapping of str to sequence of Symbol
        Of the inputs.
    written : Program
        What the text was printed from, see `as_written`: its roundings are the measure of the
        text's. A text that is equal to it over the real numbers may still be of no use to a
        machine: (x + 2^200) - 2^200.
    """
    kind, program = text.kernel.kind, text.program
    each = int(np.clip(WORK // (FINITE * max(len(program), 1)), FEWEST, MOST))
    given = states(text.groups, dict(symbols), kind, each)
    for name in text.kernel.shared or ():
        if name in given.columns:
            given.columns[name][:] = given.columns[name][0]
    count = len(given.stratum)
    columns = {
        f"{name}[{k}]": given.columns[name][:, k] for name, n in text.groups for k in range(n)
    }
    domain = Magnitudes(TYPES[kind])
    with np.errstate(all="ignore"):
        known = interpret(program, domain, {n: domain.input(c) for n, c in columns.items()})
    firsts = np.cumsum((0, *text.counts))[:-1]
    magnitudes = np.stack([np.broadcast_to(known[VALUES][k].size, count) for k in firsts], axis=1)
    asked = [np.broadcast_to(one.value, count) for one in known[ASKED]]
    status = text.status
    statuses = None if status is None else decided(status, asked, text.places, count)
    exact, doubt = [], ""
    for i in np.flatnonzero(given.stratum < FINITE):
        state = {name: arb(float(column[i])) for name, column in columns.items()}
        mine = original(written, state, kind)
        if mine is None:
            continue
        found = _enclosed(text, state)
        doubt = doubt or _worse(found, mine, STRATA[given.stratum[i]])
        if found is not None:
            exact.append((int(i), *found))
    if not any(given.stratum[i] == 0 for i, *_ in exact):
        doubt = doubt or "refused: values are enclosed at no ordinary state"
    return Truth(text, given, exact, magnitudes, statuses, doubt)


def original(program: Program, state: Mapping[str, arb], kind: str) -> dict[str, arb] | None:
    """What may be computed of every entry by a program; None where a value may overflow."""
    with precision(BITS):
        wide = interpret(program, RoundedBalls(kind), state)
        if not _bounded(wide[EVERY], kind):
            return None
    return {
        f"{name}[{k}]": value
        for name, values in wide.items()
        for k, value in enumerate(values)
        if name != EVERY
    }


def _bounded(values: Sequence[arb], kind: str) -> bool:
    """Whether no value may overflow."""
    largest = arb(float(np.finfo(TYPES[kind]).max))
    return all(abs(value) <= largest for value in values)


def _worse(
    found: tuple[bool, list[tuple[str, arb, arb]]] | None, own: Mapping[str, arb], where: str
) -> str:
    """How the roundings of a text are worse than those of the program; empty where they are not."""
    if found is None:
        return f"refused: values of the text overflow where those of the graph do not ({where})"
    for name, _, around in found[1]:
        mine, room = around.rad(), own[name].rad()
        if not mine <= ROOM * room:
            many = float(mine / room) if room > 0 else float("inf")
            return (
                f"refused: {name} may be off by {many:.3g} times what the operations of the graph"
                f" can be off ({where})"
            )
    return ""


def _enclosed(
    text: Text, state: Mapping[str, arb]
) -> tuple[bool, list[tuple[str, arb, arb]]] | None:  # fmt: skip
    """Every entry at one state, and whether all is normal; None where a value overflows."""
    kind = text.kernel.kind
    tiny = arb(float(np.finfo(TYPES[kind]).tiny))
    with precision(BITS):
        wide = interpret(text.program, RoundedBalls(kind), state)
        if not _bounded(wide[EVERY], kind):
            return None
        fine = interpret(text.program, Balls(), state)
        found, first = [], 0
        for (name, _), count in zip(text.signature.entries(), text.counts, strict=True):
            value, around = fine[VALUES][first], wide[VALUES][first]
            for other in wide[VALUES][first + 1 : first + count]:
                around = around.union(other)
            found.append((name, value, around))
            first += count
        normal = all(abs(x) >= tiny or x.is_zero() for x in fine[EVERY])
    return normal, found


def doubtful(known: Truth, state: int) -> bool:
    """Whether roundings decide a condition of the status: a divisor may just be zero, or not."""
    text = known.text
    if known.given.stratum[state] >= FINITE or text.status is None:
        return False
    kind = text.kernel.kind
    largest = arb(float(np.finfo(TYPES[kind]).max))
    with precision(BITS):
        given = {
            f"{name}[{k}]": arb(float(known.given.columns[name][state, k]))
            for name, size in text.groups
            for k in range(size)
        }
        wide = interpret(text.program, RoundedBalls(kind), given)[ASKED]
        for atom in atoms(text.status):
            first, *others = (wide[text.places[operand]] for operand in atom.operands)
            if atom.relation == "==":
                difference = first - others[0]
                if difference.contains(0) and not difference.is_zero():
                    return True
            elif not abs(first) < largest and not abs(first) > largest:
                return True
    return False
