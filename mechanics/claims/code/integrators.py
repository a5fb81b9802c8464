"""Code that returns the next state: the rates that it steps with, and which integrator it is.

    f = (next - y) / h  at h = 0              next = integrator(f, y, h),    compared for all h

explicit Euler             y + h f(y)
semi-implicit Euler        u1 = u + h a(q, u),  q1 = q + h v(q, u1); or the coordinates first
constant acceleration      u1 = u + h a(q, u),  q1 = q + h v(q, u) + h^2 a(q, u) / 2
velocity Verlet            q1 likewise,  u1 = u + h (a(q, u) + a(q1, u)) / 2
midpoint, Heun, RK4        as everywhere
"""

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from random import Random
from typing import Protocol

from sympy import Expr, Float, Piecewise, S, Symbol, nan, oo, zoo

from mechanics.scene import Scene

STEP = Symbol("dt", positive=True)
"""By how much time a call advances the state."""

NAMES = (
    "dt", "DT", "dT", "Ts", "TS", "T_s", "delta_t", "del_t", "deltat", "timestep", "time_step",
    "step_size", "h",
)  # fmt: skip
"""What code calls it."""

ELSE_NAMES = ("tau", "T", "delta")
"""What it is called where no input of the scene is left that may be meant."""

DIGITS, CLOSE = 30, 1e-9
"""Relative; of numbers that propose an integrator, which is then compared exactly."""

State = dict[Expr, Expr]
Rates = Mapping[Expr, Expr]


class Halves(Protocol):
    """What has coordinates and speeds, as a scene."""

    @property
    def q(self) -> Sequence[Expr]:
        """Coordinates."""

    @property
    def u(self) -> Sequence[Expr]:
        """Speeds."""


@dataclass(frozen=True)
class Step:
    """A step of some integrator.

    Attributes
    ----------
    rates : dict of Expr to Expr
        Rate of each entry of the state.
    integrator : str
        Its name; empty where it is none of `INTEGRATORS`.
    composed : tuple of Expr
        What that integrator makes of the rates, entry by entry.
    """

    rates: dict[Expr, Expr]
    integrator: str
    composed: tuple[Expr, ...]


def step_of(
    scene: Scene, state: Sequence[Expr], values: Sequence[Expr], passed: Collection[Expr]
) -> Step | None:
    """The step that code returns.

    Parameters
    ----------
    scene : Scene
    state : sequence of Symbol
    values : sequence of Expr
        What the entries of the state become.
    passed : collection of Symbol
        All that they may hold.

    Returns
    -------
    Step or None
        None where a value less the entry is not a multiple of the step.
    """
    rates = {s: _per_step(value, s) for s, value in zip(state, values, strict=True)}
    if any(rate.has(zoo, nan, oo) for rate in rates.values()):
        return None
    symbols = sorted({*passed, *scene.parameters, *scene.definitions}, key=str)
    name, composed = integrator_of(scene, rates, state, values, symbols)
    return Step(rates, name, composed)


def _per_step(value: Expr, symbol: Expr) -> Expr:
    """What an entry gains in a step by that step, as it goes to zero; case by case."""
    if isinstance(value, Piecewise):
        cases = [
            (_per_step(inner, symbol), put(where, {STEP: S.Zero})) for inner, where in value.args
        ]
        return Piecewise(*cases)
    at_once = put((value - symbol) / STEP, {STEP: S.Zero})
    if at_once.has(zoo, nan, oo):
        at_once = put(((value - symbol) / STEP).expand(), {STEP: S.Zero})
    return at_once


def integrator_of(
    halves: Halves, rates: Rates, state: Sequence[Expr], values: Sequence[Expr],
    symbols: Sequence[Expr],
) -> tuple[str, tuple[Expr, ...]]:  # fmt: skip
    """Which integrator advances a state by its rates to values, and what it makes of them."""
    for name, advance in INTEGRATORS.items():
        after = advance(halves, rates, {symbol: symbol for symbol in state})
        composed = tuple(after[symbol] for symbol in state)
        if alike(composed, values, symbols):
            return name, composed
    return "", ()


def put(expression: Expr, table: Mapping[Expr, Expr]) -> Expr:
    """An expression with others in it, what is used twice looked at once: a step of RK4 holds the
    rates four times over, one in the other.
    """
    done: dict[int, Expr] = {}

    def changed_in(e: Expr) -> Expr:
        if id(e) not in done:
            new = table.get(e) if e.is_Symbol or not e.args else None
            changed = [changed_in(arg) for arg in e.args]
            same = all(a is b for a, b in zip(changed, e.args, strict=True))
            done[id(e)] = new if new is not None else e if same else e.func(*changed)
        return done[id(e)]

    return changed_in(expression)


def alike(ones: Sequence[Expr], others: Sequence[Expr], symbols: Sequence[Expr]) -> bool:
    """Whether expressions have the same value at a random state."""
    source = Random(0)
    numbers = {s: Float(source.uniform(0.5, 1), DIGITS) for s in symbols}
    for one, other in zip(ones, others, strict=True):
        a, b = put(one, numbers), put(other, numbers)
        if not (a.is_number and b.is_number and abs(a - b) <= CLOSE * (1 + abs(b))):
            return False
    return True


def _moved(state: State, rates: Rates, at: State, share: Expr, only: Sequence[Expr]) -> State:
    """The state after a share of the step with the rates that it has somewhere."""
    return {s: v + share * put(rates[s], at) if s in only else v for s, v in state.items()}


def _explicit(halves: Halves, rates: Rates, state: State) -> State:
    return _moved(state, rates, state, STEP, list(state))


def _semi_implicit(halves: Halves, rates: Rates, state: State) -> State:
    after = _moved(state, rates, state, STEP, halves.u)
    return _moved(after, rates, after, STEP, halves.q)


def _coordinates_first(halves: Halves, rates: Rates, state: State) -> State:
    after = _moved(state, rates, state, STEP, halves.q)
    return _moved(after, rates, after, STEP, halves.u)


def _constant(halves: Halves, rates: Rates, state: State) -> State:
    after = _explicit(halves, rates, state)
    for q in halves.q:
        slope = sum((rates[q].diff(u) * rates[u] for u in halves.u), S.Zero)
        after[q] += STEP**2 / 2 * put(slope, state)
    return after


def _verlet(halves: Halves, rates: Rates, state: State) -> State:
    end = _constant(halves, rates, state)
    after = {**end, **{u: state[u] for u in halves.u}}
    speeds = {
        u: state[u] + STEP / 2 * (put(rates[u], state) + put(rates[u], after)) for u in halves.u
    }
    return {**end, **speeds}


def _midpoint(halves: Halves, rates: Rates, state: State) -> State:
    half = _moved(state, rates, state, STEP / 2, list(state))
    return _moved(state, rates, half, STEP, list(state))


def _heun(halves: Halves, rates: Rates, state: State) -> State:
    end = _explicit(halves, rates, state)
    return {s: v + STEP / 2 * (put(rates[s], state) + put(rates[s], end)) for s, v in state.items()}


def _rk4(halves: Halves, rates: Rates, state: State) -> State:
    every = list(state)
    second = _moved(state, rates, state, STEP / 2, every)
    third = _moved(state, rates, second, STEP / 2, every)
    last = _moved(state, rates, third, STEP, every)
    weights = ((state, 1), (second, 2), (third, 2), (last, 1))
    return {
        s: v + STEP / 6 * sum(weight * put(rates[s], at) for at, weight in weights)
        for s, v in state.items()
    }


INTEGRATORS: dict[str, Callable[[Halves, Rates, State], State]] = {
    "explicit Euler": _explicit,
    "semi-implicit Euler": _semi_implicit,
    "semi-implicit Euler, coordinates first": _coordinates_first,
    "constant acceleration": _constant,
    "velocity Verlet": _verlet,
    "the midpoint method": _midpoint,
    "Heun's method": _heun,
    "RK4": _rk4,
}
"""By name."""
