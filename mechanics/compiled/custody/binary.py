"""Third step of the chain: C text = binary, at chosen states.

    computed value in the ball of everything that correct roundings of the text may give

No tolerance is chosen: the ball follows from the text. What is reported besides is how far the
values are from the exact ones, in units of the last place of the result, and of the sum of the
magnitudes of its terms.
"""

from __future__ import annotations

import ctypes
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import arb
from numpy.typing import NDArray
from sympy import Symbol

from mechanics.compiled.custody.build import Built
from mechanics.compiled.custody.numeric import decided, sizes, values
from mechanics.compiled.custody.rounding import Rounded, RoundedArithmetic
from mechanics.compiled.custody.states import FINITE, STRATA, TYPES, States, states
from mechanics.compiled.custody.text import Text
from mechanics.exact import Finding, Verdict, Witness
from mechanics.exact.balls import Ball, BallArithmetic, State, precision
from mechanics.exact.graph import evaluated

BITS = 320
WORK = 16_000
"""Operations that are enclosed for one function; it says at how many states."""
FEWEST, MOST = 2, 12
"""States of each stratum."""
LANES = 300
"""Of a call of many states: more than a block, and no multiple of a vector."""
PAD = 3

Array = NDArray[np.floating]


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
        return Finding(subject, Verdict.UNDECIDED, f"refused: {built.refusal}"), None
    call = _lanes if text.kernel.lanes else _one_by_one
    results, statuses, odd = call(known, getattr(built.library, symbol))
    if odd:
        return Finding(subject, Verdict.REFUTED, odd), None
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
    if wrong is not None:
        return wrong, None
    count = len(known.given.stratum) if statuses is not None else 0
    measured = Measured(symbol, built.words, len(known.exact), ulp, ulp_terms, count)
    words = (
        f"{len(known.exact)} states inside of what correct roundings can give; largest error"
        f" {ulp_terms:.3g} ulp of the sum of the terms, {ulp:.3g} of the result at ordinary states;"
        f" status at {count} states"
    )
    return Finding(subject, Verdict.SUPPORTED, words), measured


def _last(value: float, kind: str) -> float:
    """Unit of the last place; infinite beyond the largest number."""
    with np.errstate(over="ignore", invalid="ignore"):
        unit = float(np.spacing(TYPES[kind](abs(value))))
    return unit if np.isfinite(unit) else np.inf


def _refuted(subject: str, known: Truth, i: int, name: str, around: arb, found: float) -> Finding:
    witness = Witness(_state(known, i), around.str(20), repr(found))
    words = f"{name} is not what correct roundings of the text can give"
    return Finding(subject, Verdict.REFUTED, words, witness=witness)


def _state(known: Truth, i: int) -> tuple[tuple[str, str], ...]:
    return tuple(
        (f"{name}[{entry}]", float(value).hex())
        for name, column in known.given.columns.items()
        for entry, value in enumerate(column[i])
    )


def _wrong_status(subject: str, known: Truth, statuses: Any) -> Finding | None:
    if statuses is None or known.statuses is None:
        return None
    wrong = np.flatnonzero(np.atleast_1d(statuses != known.statuses))
    if not len(wrong):
        return None
    i = int(wrong[0])
    found, wanted = int(statuses[i]), int(known.statuses[i])
    witness = Witness(_state(known, i), str(wanted), str(found))
    words = f"the status is {found}, the text says {wanted} ({STRATA[known.given.stratum[i]]})"
    return Finding(subject, Verdict.REFUTED, words, witness=witness)


def _pointer(array: Array, offset: int = 0) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data + offset * array.itemsize)


def _one_by_one(known: Truth, function: Any) -> tuple[Array, Any, str]:
    """Values and statuses, a call a state."""
    text, count = known.text, len(known.given.stratum)
    kind = TYPES[text.kernel.kind]
    outs = [np.zeros((count, size), kind) for _, size in text.outputs]
    ins = [np.ascontiguousarray(known.given.columns[name]) for name, _ in text.groups]
    function.restype = ctypes.c_int if text.program.status is not None else None
    statuses = np.zeros(count, dtype=np.int64)
    for i in range(count):
        given = [_pointer(array, i * array.shape[1]) for array in (*ins, *outs)]
        result = function(*given)
        statuses[i] = result if result is not None else 0
    values = np.concatenate(outs, axis=1) if outs else np.zeros((count, 0))
    return values, statuses if text.program.status is not None else None, ""


def _lanes(known: Truth, function: Any) -> tuple[Array, Any, str]:
    """Values by one call: unaligned, in several blocks; equal lanes have to be equal."""
    text, count = known.text, len(known.given.stratum)
    kind, stride = TYPES[text.kernel.kind], LANES + PAD
    order = np.arange(LANES) % count
    arguments: list[Any] = [ctypes.c_size_t(LANES), ctypes.c_size_t(stride)]
    kept = []
    for name, size in text.groups:
        column = known.given.columns[name]
        if name in (text.kernel.shared or ()):
            array = np.ascontiguousarray(column[0])
            arguments.append(_pointer(array))
        else:
            array = np.zeros(1 + size * stride, kind)
            array[1:].reshape(size, stride)[:, :LANES] = column[order].T
            arguments.append(_pointer(array, 1))
        kept.append(array)
    outs = [np.full(1 + size * stride, 12345, kind) for _, size in text.outputs]
    arguments += [_pointer(array, 1) for array in outs]
    function.restype = ctypes.c_int
    flags = function(*arguments)
    tables = [array[1:].reshape(-1, stride) for array in outs]
    if any((t[:, LANES:] != 12345).any() for t in tables) or any(a[0] != 12345 for a in outs):
        return np.zeros((0, 0)), None, "it writes beyond its lanes"
    lanes = np.concatenate([t[:, :LANES] for t in tables]).T
    first = lanes[:count]
    if not np.array_equal(lanes, first[order], equal_nan=True):
        return lanes, None, "a lane has another value where it stands elsewhere in the batch"
    if known.statuses is not None and text.program.status is not None:
        wanted = int(np.bitwise_or.reduce(known.statuses))
        if flags != wanted:
            return lanes, None, f"it returns {flags}, the text says {wanted}"
    return first, None, ""
