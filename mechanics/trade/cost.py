"""What a choice costs, told apart.

    seconds of a run = call + steps * step          two runs of one line tell both

`call` is what a call from Python takes whatever it integrates, `step` what the method itself takes:
of a method in C one step, of another one evaluation. For a target without Python neither counts:
there it is the operations of a step, counted in its graph, and the memory that it works in.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from mechanics.program.routine import Routine
from mechanics.simulate.integrators import explicit
from mechanics.trade.case import Case
from mechanics.trade.choice import Choice
from mechanics.trade.measure import Measurement

IN_C = {member.name: member.name.removeprefix("C ") for member in explicit.MEMBERS}
"""Methods whose step is one function in C, and the names of their tableaus."""


@dataclass(frozen=True)
class Cost:
    """Of a choice.

    Attributes
    ----------
    call, step : float or None
        In s: of a call from Python, and of each step, or evaluation where `steps` counts these.
        None where one run only was measured.
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
    line = [m for m in measurements
            if m.choice.with_amount(1.0) == choice.with_amount(1.0) and not m.failure]  # fmt: skip
    counts = {m.choice: _count(case, m) for m in line}
    low, high = (end(line, key=lambda m: counts[m.choice]) for end in (min, max))
    call = step = None
    if counts[high.choice] > 2 * counts[low.choice]:
        first, last = (case.horizon * m.time for m in (low, high))
        step = max(0.0, (last - first) / (counts[high.choice] - counts[low.choice]))
        call = max(0.0, first - step * counts[low.choice])
    if not embeddable(choice):
        word = "step" if choice.setting.tolerance is None else "evaluation"
        return Cost(call, step, counts[choice], word)
    code = _step(case, choice)
    slots = case.model(choice.variant).right_hand_side.steps
    work = slots[IN_C[choice.setting.integrator]].compiled.function.sz_w()
    size = sum(count for _, count in code.inputs) + work
    width = 4 if choice.setting.arithmetic == "single" else 8
    return Cost(call, step, counts[choice], "step", operations(case, choice), width * size)


def _count(case: Case, found: Measurement) -> int:
    if found.choice.setting.tolerance is not None:
        return max(1, found.evaluations)
    return math.ceil(case.horizon / found.choice.amount * (1 - 1e-12))


def _step(case: Case, choice: Choice) -> Routine:
    steps = case.model(choice.variant).right_hand_side.steps
    return steps[IN_C[choice.setting.integrator]].compiled.routine
