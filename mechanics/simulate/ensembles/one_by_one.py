"""The same motions without a C compiler: SciPy and CasADi's virtual machine, one by one.

Slower by a factor of thousands; the method that is reported says so.
"""

from collections.abc import Iterator

import numpy as np

from mechanics.compiled.tableaus import TABLEAUX
from mechanics.simulate.ensembles.motions import Motions
from mechanics.simulate.ensembles.outcome import Status
from mechanics.simulate.ensembles.run import FIXED, STAGES, Method, Run
from mechanics.simulate.integrators import explicit, scipy
from mechanics.simulate.integrators.problem import Cause, Problem, Setting

WHY = "one by one, because there is no C compiler"
STATUS = {
    None: Status.FINISHED,
    Cause.BUDGET: Status.TOO_LONG,
    Cause.NOT_FINITE: Status.NOT_FINITE,
    Cause.NO_STEP: Status.STALLED,
}


def one_by_one(motions: Motions, method: Method) -> Run:
    """Every motion by a scalar integrator.

    Parameters
    ----------
    method : Method
        All adaptive ones are DOP853, whose steps are counted with those that were refused; its
        `by` is the tolerance.
    """
    name, by, budget = method
    if name in FIXED:
        place = FIXED.index(name)
        member, stages = explicit.MEMBERS[place], len(TABLEAUX[place].a)
        setting, words = Setting(member.name, step=by), f"steps of at most {by:g} s"
    else:
        member, stages = _DOP853, STAGES["dop853"]
        tolerance = max(by, scipy.FINEST)
        setting = Setting(member.name, tolerance=tolerance)
        words = f"tolerance {tolerance:.3g}"
    found = [member.prepare(problem, setting)() for problem in _problems(motions, budget * stages)]
    states = np.full((len(motions), len(motions.times), motions.start.shape[1]), np.nan)
    for row, outcome in zip(states, found, strict=True):
        row[: len(outcome.states)] = outcome.states
    evaluations = np.array([outcome.evaluations for outcome in found], dtype=np.int64)
    return Run(
        states, tuple(STATUS[outcome.cause] for outcome in found),
        np.array([len(outcome.states) for outcome in found], dtype=np.int64),
        evaluations // stages, evaluations, f"{member.name}, {words}, {WHY}",
    )  # fmt: skip


_DOP853 = next(member for member in scipy.MEMBERS if member.name.endswith("DOP853"))


def _problems(motions: Motions, budget: int) -> Iterator[Problem]:
    names = motions.model.entries["inputs"]
    rows = zip(motions.start, motions.inputs, motions.p, strict=True)
    for start, inputs, p in rows:
        held = {name: x for name, x in zip(names, inputs.tolist(), strict=True) if name != "t"}
        yield Problem(motions.model, p, held, start, motions.times, budget)
