"""What a C text has at chosen states: exact values, everything that may be computed, statuses."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np
from flint import arb
from numpy.typing import NDArray
from sympy import Symbol

from mechanics.compiled.custody.code import exact as exact_code
from mechanics.compiled.custody.numeric import decided, sizes, values
from mechanics.compiled.custody.rounding import Rounded, RoundedArithmetic
from mechanics.compiled.custody.states import FINITE, STRATA, TYPES, States, states
from mechanics.compiled.custody.text import Text
from mechanics.compiled.programs.program import Program
from mechanics.exact.balls import Ball, BallArithmetic, State, precision
from mechanics.exact.c.condition import atoms
from mechanics.exact.graph import evaluated
from mechanics.program.casadi_reader import Instruction as Node

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
    text : Text
    given : States
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
    text : Text
    symbols : mapping of str to sequence of Symbol
        Of the inputs.
    written : Program
        What the text was printed from: its roundings are the measure of the text's. A text that is
        equal to it over the real numbers may still be of no use to a machine: (x + 2^200) - 2^200.
    """
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
    exact, doubt = [], ""
    for i in np.flatnonzero(given.stratum < FINITE):
        own = original(written, {n: c[i] for n, c in given.columns.items()}, kind)
        if own is None:
            continue
        found = _enclosed(text, [a[i] if a.size else a for a in arguments])
        doubt = doubt or _worse(found, own, STRATA[given.stratum[i]])
        if found is not None:
            exact.append((int(i), *found))
    if not any(given.stratum[i] == 0 for i, *_ in exact):
        doubt = doubt or "refused: values are enclosed at no ordinary state"
    return Truth(text, given, exact, magnitudes, statuses, doubt)


def original(
    written: Program, given: Mapping[str, Array], kind: str
) -> dict[str, arb] | None:  # fmt: skip
    """What may be computed of every entry by the program; None where a value may overflow."""
    code = exact_code(written)
    with precision(BITS):
        rough = RoundedArithmetic(kind)
        numbers = [
            [Rounded(arb(float(x)), rough) for x in given[name]] if size else []
            for name, size in code.inputs
        ]
        wide = evaluated(rough, code.nodes, [*numbers, []], True)
        if not _bounded(code.nodes, wide, kind):
            return None
        return {
            f"{name}[{k}]": number.arb
            for name, entries in code.results(wide).items()
            for k, number in enumerate(entries)
        }


def _bounded(nodes: Sequence[Node], wide: Sequence[Any], kind: str) -> bool:
    """Whether no value may overflow."""
    largest = arb(float(np.finfo(TYPES[kind]).max))
    computed = (x.arb for x, node in zip(wide, nodes, strict=True) if node.constant is None)
    return all(abs(x) < largest for x in computed)


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
    text: Text, arguments: Sequence[Array]
) -> tuple[bool, list[tuple[str, arb, arb]]] | None:  # fmt: skip
    """Every entry at one state, and whether all is normal; None where a value overflows."""
    kind, nodes = text.kernel.kind, text.program.nodes
    limits = np.finfo(TYPES[kind])
    tiny = arb(float(limits.tiny))
    with precision(BITS):
        rough, sharp = RoundedArithmetic(kind), BallArithmetic(State({}))
        numbers = [[arb(float(x)) for x in group] for group in arguments]
        wide = evaluated(rough, nodes, [[Rounded(x, rough) for x in g] for g in numbers], True)
        needed = _needed(text)
        if not _bounded([nodes[k] for k in needed], [wide[k] for k in needed], kind):
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


def _needed(text: Text) -> list[int]:
    """Nodes that an output depends on: reading c ? x : y leaves others behind."""
    nodes = text.program.nodes
    waiting = [written.node for _, at in text.entries() for written in text.program.outputs[at]]
    found: set[int] = set()
    while waiting:
        node = waiting.pop()
        if node not in found:
            found.add(node)
            if nodes[node].constant is None and nodes[node].op != ca.OP_INPUT:
                waiting += nodes[node].operands
    return sorted(found)


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
