"""What a choice costs, told apart.

    seconds of a run = call + steps * step          two runs of one method tell both

`call` is what a call from Python takes whatever it integrates, `step` what the method itself takes:
of a method in C one step, of another one evaluation. For a target without Python neither counts:
there it is the operations of a step, counted in its graph, and the memory that it works in.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from mechanics.clock import side_by_side
from mechanics.program.routine import Routine
from mechanics.simulate.integrators import explicit
from mechanics.simulate.integrators.loop import spans
from mechanics.trade.case import Case
from mechanics.trade.choice import Choice
from mechanics.trade.measure import Measurement, prepared

IN_C = {member.name: member.name.removeprefix("C ") for member in explicit.MEMBERS}
"""Methods whose step is one function in C, and the names of their tableaus."""
MANY = 1000
"""Steps of a run, at least, beside which a call is little."""
COMPARING, ROUNDS = 0.3, (7, 31)
"""Seconds and rounds for the two runs."""


@dataclass(frozen=True)
class Cost:
    """Of a choice.

    Attributes
    ----------
    call, step : float or None
        In s: of a call from Python, and of each step, or evaluation where `steps` counts these.
        None where the runs of an adaptive method do not tell them.
    steps : int
        In the whole motion.
    counted : str
        ``"step"`` or ``"evaluation"``.
    operations : float or None
        For a second of motion on a target without Python; None for what is not one function in C.
    memory : int or None
        Bytes that a step works in: its values, the state, inputs and parameters.
    """

    call: float | None
    step: float | None
    steps: int
    counted: str
    operations: float | None = None
    memory: int | None = None


def embeddable(choice: Choice) -> bool:
    """Whether a step is one function in C, by which ranking for embedding goes."""
    return choice.setting.integrator in IN_C and choice.variant.careful


def operations(case: Case, choice: Choice) -> float:
    """Of an embeddable choice, for a second of motion."""
    return _step(case, choice).operations / choice.amount


def costs(
    case: Case, choices: Iterable[Choice], measurements: Sequence[Measurement]
) -> Mapping[Choice, Cost]:
    """Costs of choices that were measured."""
    return {choice: _cost(case, choice, measurements) for choice in choices}


def _cost(case: Case, choice: Choice, measurements: Sequence[Measurement]) -> Cost:
    if choice.setting.tolerance is not None:
        alike = choice.with_amount(1.0)
        line = [m for m in measurements if m.choice.with_amount(1.0) == alike and not m.failure]
        count = next(max(1, m.evaluations) for m in line if m.choice == choice)
        return Cost(*_adaptive(case, line), count, "evaluation")
    count = math.ceil(case.horizon / choice.amount * (1 - 1e-12))
    call, step = _fixed(case, choice)
    if not embeddable(choice):
        return Cost(call, step, count, "step")
    code = _step(case, choice)
    slots = case.model(choice.variant).right_hand_side.steps
    work = slots[IN_C[choice.setting.integrator]].compiled.function.sz_w()
    size = sum(count for _, count in code.inputs) + work
    width = 4 if choice.setting.arithmetic == "single" else 8
    return Cost(call, step, count, "step", operations(case, choice), width * size)


def _fixed(case: Case, choice: Choice) -> tuple[float, float]:
    """Call and step of a method with fixed steps, by a run that is nearly nothing but the call."""
    many = choice.with_amount(min(choice.amount, case.horizon / MANY))
    runs = (case.until(choice.amount), choice), (case, many)
    (few, short), (most, long) = (
        (_steps(one, wanted), prepared(one, wanted)) for one, wanted in runs
    )
    # What disturbs a machine only adds.
    first, last = map(min, side_by_side([short, long], COMPARING, ROUNDS))
    step = max(0.0, last - first) / (most - few)
    return max(0.0, first - few * step), step


def _steps(case: Case, choice: Choice) -> int:
    """Steps of a run, those beside the others included."""
    parts = spans(case.problem(choice.variant), choice.amount)
    return sum(part.count + (part.rest > 0) for part in parts)


def _adaptive(case: Case, line: Sequence[Measurement]) -> tuple[float | None, float | None]:
    """Call and evaluation by two runs with different tolerances, where these tell them."""
    low, high = (end(line, key=lambda m: m.evaluations) for end in (min, max))
    if high.evaluations <= 2 * low.evaluations:
        return None, None
    first, last = (case.horizon * m.time for m in (low, high))
    step = max(0.0, (last - first) / (high.evaluations - low.evaluations))
    call = first - step * low.evaluations
    return (call if call > 0 else None), step


def _step(case: Case, choice: Choice) -> Routine:
    steps = case.model(choice.variant).right_hand_side.steps
    return steps[IN_C[choice.setting.integrator]].compiled.routine
