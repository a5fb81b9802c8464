"""When a part of a model may be left out, and what that saves.

    error of leaving out = largest |y(share = 0) - y(share)| / scale along the motion

If that is above 1 % for the part as it is, the size below which it would not be is found by
bisection over its share.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from sympy import sympify

from mechanics.compiled import Model, compile
from mechanics.equations import Equations
from mechanics.errors import MechanicsError
from mechanics.linear.values import with_numbers
from mechanics.scene import Scene
from mechanics.simulate.integrators import Outcome, Problem
from mechanics.simulate.values import for_equations, read_parameters
from mechanics.trade.case import BUDGET, Case
from mechanics.trade.choice import Choice
from mechanics.trade.load_scaling import SHARE, Part, parts
from mechanics.trade.measure import integrator
from mechanics.trade.truth import from_states

Derive = Callable[[Scene], Equations]

ENOUGH = 0.01
"""Error that a model without a part may have, of the scale of the motion."""
# Halvings of the share on a logarithmic scale from 1 down to 1e-9: two digits of it.
SMALLEST, BISECTIONS = 1e-9, 11


@dataclass(frozen=True, eq=False)
class Dropped:
    """A model without one part.

    Attributes
    ----------
    name : str
        Of the part.
    error : float
        Of leaving it out, along the motion from the example; infinite where it cannot be.
    operations : int
        Of the right-hand side without it.
    run : callable or None
        To be timed.
    share : float
        Below this share of its size it could be left out; NaN where that was not found.
    words : str
        In a sentence.
    """

    name: str
    error: float
    operations: int
    run: Callable[[], Outcome] | None
    share: float
    words: str


def dropped(case: Case, derive: Derive, choice: Choice) -> tuple[Dropped, ...]:
    """Every part of the scene left out in turn.

    Parameters
    ----------
    derive : callable
        Equations of a scene, by one route.
    choice : Choice
        How to integrate, with an error well below `ENOUGH`.
    """
    return tuple(_without(case, part, derive, choice) for part in parts(case.equations.scene))


def operations(model: Model) -> int:
    """Arithmetic operations of the right-hand side."""
    return model.right_hand_side.rate.routine.operations


def _without(case: Case, part: Part, derive: Derive, choice: Choice) -> Dropped:
    try:
        equations = derive(part.scene)
        whole = compile(equations, compiler=case.compiler)
        less = compile(equations, compiler=case.compiler, fixed={SHARE: 0})
        run = _run(case, less, choice, {})
        states = run().states
        size = operations(less)
    except MechanicsError as error:
        words = f"{part.name}: cannot be left out: {error}"
        return Dropped(part.name, np.inf, 0, None, np.nan, words)

    def lost(share: float) -> float:
        found = _run(case, whole, choice, {SHARE: share})()
        if min(len(found.states), len(states)) < len(case.times):
            return np.inf
        return float(np.max(from_states(found.states).errors(states)))

    now = lost(1.0)
    share = 1.0 if now <= ENOUGH else _largest_share(lost)
    return Dropped(part.name, now, size, run, share, _words(case, part, now, share))


def _run(case: Case, model: Model, choice: Choice, more: dict[str, float]) -> Callable[[], Outcome]:
    values = {**for_equations(case.equations.scene, case.parameters), **more}
    p = read_parameters(model.quantities.p, model.quantities.definitions, values)
    problem = Problem(model, p, case.inputs, case.start, case.times, BUDGET)
    return integrator(choice.setting.integrator).prepare(problem, choice.setting)


def _largest_share(error: Callable[[float], float]) -> float:
    """The share below which the error is small enough, by bisection of its logarithm."""
    low, high = np.log(SMALLEST), 0.0
    if not error(SMALLEST) <= ENOUGH:
        return np.nan
    for _ in range(BISECTIONS):
        middle = (low + high) / 2
        low, high = (middle, high) if error(np.exp(middle)) <= ENOUGH else (low, middle)
    return float(np.exp(low))


def _words(case: Case, part: Part, error: float, share: float) -> str:
    if not np.isfinite(error):
        return f"{part.name}: without it the motion has no end: it cannot be left out"
    lost = f"{part.name}: without it the motion is off by {_percent(error)} in {case.horizon:g} s"
    if error <= ENOUGH:
        return f"{lost}: it may be left out"
    if np.isnan(share):
        return f"{lost}: it cannot be left out, however small"
    size = _size(case, part, share)
    return f"{lost}: it may be left out below {share:.2g} of its size{size}"


def _size(case: Case, part: Part, share: float) -> str:
    if part.value is None:
        return ""
    scene = case.equations.scene
    value = sympify(part.value)
    names = {s.name for s in value.free_symbols}
    given = {name: number for name, number in case.parameters.items() if name in names}
    number = float(with_numbers(scene, value, given).evalf())
    return f" ({share * number:.2g} {part.unit} in place of {number:.3g})"


def _percent(error: float) -> str:
    digits = f"{100 * error:.2g}" if error < 1 else f"{10 * round(10 * error):d}"
    return f"{digits} %" if error < 10 else f"{error:.1g} times its size"
