"""A black box beside compiled equations: numbers only, so SUPPORTED at most.

|box(state) - engine(state)| <= 1e-9 (1 + |engine|)    at every random state    SUPPORTED
                              > 1e-6 (1 + |engine|)    at some state            REFUTED there

Where the box steps, both are mean rates over the step, (y(t + h) - y(t)) / h.
"""

import random
from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import partial
from typing import Any

import numpy as np
from flint import arb
from sympy import Symbol

from mechanics.checks.ledger_compare import definitions_in_full
from mechanics.claims.code.black_box import BlackBox, Box, entries, match_box
from mechanics.claims.names import Match
from mechanics.claims.statement import Statement
from mechanics.compiled import compile
from mechanics.equations import Equations
from mechanics.errors import InputError, SingularError
from mechanics.judge.mean_rates import State, mean_rates
from mechanics.kernel import Finding, refuted, supported, undecided
from mechanics.scene.published import published

STATES = 200
CLOSE, APART = 1e-9, 1e-6
"""Relative; a box may differentiate numerically, and rounds in its own way."""


def check_box(
    truth: Equations, box: BlackBox, names: Mapping[str, str] | None = None
) -> tuple[list[tuple[Statement, Finding]], tuple[Match, ...]]:
    """Statements of a black box with their findings, and what its arguments were taken for.

    Raises
    ------
    InputError
        When it fails at every state, or what it is given or gives is unexplained.
    """
    scene = truth.scene
    if not scene.unconstrained:
        what = "constraints" if scene.constraints else "quaternions of norm 1"
        raise InputError(
            f"black box {box.title}: {scene.name} has {what}, off which random states are:"
            " pass code that can be read"
        )
    model = compile(truth, compiler=None)
    source = random.Random(0)
    first = match_box(scene, box, names, len(scene.q) + len(scene.u) if box.step else len(scene.u))
    states = [_state(truth, box, source) for _ in range(STATES)]
    outcomes = [(state, out) for state in states if (out := _called(first, state)) is not None]
    if not outcomes:
        raise InputError(f"black box {box.title}: it fails at each of {STATES} states")
    ready = match_box(scene, box, names, len(outcomes[0][1]))

    def engine(state: State, place: int) -> float:
        return float(mean_rates(model, state, box.step, box.integrator)[place])

    names_of_rates = [*(f"{q}_dot" for q in scene.q), *map(str, scene.ud)]
    found = []
    for k, (tag, quantity, (rate, _)) in enumerate(ready.claims):
        label = f"{box.title}: {tag}"
        row = published(tag, quantity, rate, ready.outputs[k], label=label)
        finding = _judged(partial(engine, place=names_of_rates.index(tag)), label, k, outcomes)
        found.append((Statement(row, label, tag), finding))
    return found, ready.arguments.matches


def _state(truth: Equations, box: BlackBox, source: random.Random) -> State:
    """A random state, of numbers with few digits."""
    scene = truth.scene
    state = {
        symbol.name: source.randrange(-128, 128) / 64
        for symbol in (*scene.q, *scene.u, *scene.input_symbols)
    }
    definitions = definitions_in_full(scene)
    # A density stands in a definition only.
    below = set[Symbol]().union(*(value.free_symbols for value in definitions.values()))
    for symbol in (*scene.parameters, *sorted(below - {*scene.parameters}, key=str)):
        state[symbol.name] = source.randrange(32, 128) / 64
    state |= {name: float(value) for name, value in box.values.items()}
    for symbol, value in definitions.items():
        state[symbol.name] = float(value.xreplace({s: state[s.name] for s in value.free_symbols}))
    return {**state, "t": 0.0}


def _called(ready: Box, state: State) -> np.ndarray | None:
    """What the box returns at a state, as rates; None where it has no finite numbers.

    Raises
    ------
    InputError
        When it fails in a way that no state excuses.
    """
    arguments: dict[str, Any] = {}
    for name, value in ready.arguments.values.items():
        numbers = [state[str(symbol)] for symbol in entries(value)]
        arguments[name] = np.array(numbers) if isinstance(value, tuple) else numbers[0]
    try:
        result = np.asarray(ready.box.function(**arguments), dtype=float).reshape(-1)
    except (ArithmeticError, ValueError, AssertionError):
        return None  # it has no value there, and others are drawn
    except (Exception, SystemExit) as error:
        words = " ".join(str(error).split())
        raise InputError(f"black box {ready.box.title}: {type(error).__name__}: {words}") from None
    before = [state[str(symbol)] for symbol in ready.arguments.state]
    if ready.box.step and len(before) == len(result):
        result = (result - before) / ready.box.step
    return result if np.all(np.isfinite(result)) else None


def _judged(
    engine: Callable[[State], float], label: str, k: int,
    outcomes: list[tuple[State, np.ndarray]],
) -> Finding:  # fmt: skip
    rows: list[tuple[State, float, float]] = []
    for state, outputs in outcomes:
        try:
            rows.append((state, engine(state), float(outputs[k])))
        except SingularError:
            continue
    if not rows:
        return undecided(label, "the engine's own equations are singular there")
    state, value, given = max(rows, key=lambda row: _error(*row[1:]))
    worst = _error(value, given)
    words = f"largest difference {worst:.1e} of 1 + the value, at {len(outcomes)} states"
    if worst <= CLOSE:
        samples = [(_near(known, CLOSE), number) for _, known, number in rows]
        return supported(label, samples, f"{words}; the code itself was not read")
    if worst <= APART:
        return undecided(label, f"{words}: more than rounding, less than an error")
    shown = tuple(sorted((name, str(Fraction(v))) for name, v in state.items() if name != "t"))
    return refuted(label, words, _near(value, APART), given, shown)


def _error(value: float, given: float) -> float:
    return abs(given - value) / (1 + abs(value))


def _near(value: float, share: float) -> arb:
    """Numbers that differ from a value by no more than a share of 1 + its magnitude."""
    return arb(value, share * (1 + abs(value)))
