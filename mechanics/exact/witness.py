"""A witness: a real state where the enclosures of the two sides are disjoint.

[left] and [right] disjoint  =>  left != right there, whatever the rounding.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from typing import Any

import sympy
from flint import arb

from mechanics.exact.arithmetic import Arithmetic
from mechanics.exact.balls import BallArithmetic, State, precision
from mechanics.exact.finding import Witness
from mechanics.exact.signals import Inadmissible

STATES = 120
DIGITS = 17
ROUNDS = (((64, 128, 256, 512, 1024, 2048), 4), ((64, 256), 60))
"""Precisions, and at how many states where both sides are defined they are tried: many digits for
differences that are tiny everywhere, many states for those that are zero where some sign is right.
"""


def find_witness(
    experiment: Callable[[Arithmetic], Sequence[tuple[Any, Any]]], seed: int | None
) -> Witness | None:
    """Return a state that refutes the experiment, or None if none was found."""
    source = random.Random(seed) if seed is not None else random.SystemRandom()
    for precisions, wanted in ROUNDS:
        defined = 0
        for _ in range(STATES):
            witness, here = _at_state(experiment, State({}, source), precisions)
            if witness is not None:
                return witness
            defined += here
            if defined == wanted:
                break
    return None


def _at_state(
    experiment: Callable[[Arithmetic], Sequence[tuple[Any, Any]]],
    state: State,
    precisions: Sequence[int],
) -> tuple[Witness | None, bool]:
    """Return a witness if there is one, and whether the experiment was defined at the state."""
    defined = False
    for bits in precisions:
        with precision(bits):
            a = BallArithmetic(state)
            try:
                pairs = [(_ball(a, x), _ball(a, y)) for x, y in experiment(a)]
            except Inadmissible:
                if bits >= 256:
                    return None, defined
                continue  # more digits may tell a pivot or a sign
        finite = [(x, y) for x, y in pairs if x.is_finite() and y.is_finite()]
        defined = defined or bool(finite)
        if not finite and bits >= 256:
            return None, defined
        apart = [(x, y) for x, y in finite if not x.overlaps(y)]
        if apart:
            x, y = max(apart, key=lambda pair: float(abs(pair[0] - pair[1]).mid()))
            return Witness(state.items(), *_words(x, y), _solved(a, state)), True
    return None, defined


def _solved(a: BallArithmetic, state: State) -> tuple[tuple[str, str], ...]:
    """What the experiment computed for symbols that the state does not hold."""
    given = {name for name, _ in state.items()}
    found = {
        str(symbol): _ball(a, number).str(DIGITS, radius=False)
        for symbol, number in a.memo.items()
        if isinstance(symbol, sympy.Symbol) and not isinstance(symbol, sympy.Dummy)
    }
    return tuple(sorted((name, text) for name, text in found.items() if name not in given))


def _ball(a: Arithmetic, number: Any) -> arb:
    result: arb = (a.rational(0) + number).arb
    return result


def _words(x: arb, y: arb) -> tuple[str, str]:
    """Return decimal enclosures with so many digits that they too are disjoint."""
    for digits in (20, 40, 80, 160, 320, 640):
        left, right = x.str(digits), y.str(digits)
        with precision(5 * digits):
            if not arb(left).overlaps(arb(right)):
                break
    return left, right
