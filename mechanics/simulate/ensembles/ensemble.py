"""Many motions at once: ``ensemble(model, duration, initial={...arrays...}) -> Ensemble``.

names and numbers --> Motions --> a method over lanes, in C --> Ensemble
                              --> one motion after the other, where there is no compiler
"""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from mechanics.compiled.model import Model
from mechanics.compiled.tableaus import TABLEAUX
from mechanics.errors import InputError, wanted
from mechanics.simulate.ensembles.choice import best
from mechanics.simulate.ensembles.motions import Motions, read_motions
from mechanics.simulate.ensembles.one_by_one import one_by_one
from mechanics.simulate.ensembles.outcome import Ensemble
from mechanics.simulate.ensembles.run import ADAPTIVE, FIXED, Run, adaptive, fixed
from mechanics.simulate.integrators.loop import plan

Array = NDArray[np.float64]
AUTO = "auto"
TOLERANCE = 1e-9
FINEST = 1e-15
SHARE = 1e-3
"""Of the tolerance, for the error of one step."""
FINEST_STEP = 100 * float(np.finfo(float).eps)
"""What sums of slopes can be told apart by; SciPy's limit, too."""
BUDGET = 1_000_000
"""Steps that a motion may try."""


def ensemble(
    model: Model,
    duration: float,
    *,
    initial: Mapping[str, Any] | None = None,
    parameters: Mapping[str, Any] | None = None,
    inputs: Mapping[str, Any] | None = None,
    times: ArrayLike | None = None,
    tolerance: float | None = None,
    step: float | None = None,
    method: str = AUTO,
    threads: int = 1,
    budget: int = BUDGET,
    beyond_domain: bool = False,
) -> Ensemble:
    """Integrate many motions from t = 0, several of them in every operation of the processor.

    Parameters
    ----------
    model : Model
        From `mechanics.compile`.
    duration : float
        In s.
    initial, parameters, inputs : mapping of str to float or array, shape (batch,)
        By plain name, as `mechanics.simulate` takes them. Arrays have one length, the number of
        motions; numbers are shared. What is not given is taken from the scene's example and the
        typical values; a parameter that is defined by others follows them.
    times : array, shape (N,), optional
        When states are wanted, in s: increasing from 0 to the duration. By default 0 and the end.
    tolerance : float
        For adaptive methods; 1e-9 unless a step is given. The error of one step, relative to each
        entry of the state, is kept below a thousandth of it, so that a thousand steps stay within
        it where the motion itself does not magnify errors. With ``method="dop853"`` it is the
        relative and absolute error of a step, as in SciPy.
    step : float
        For fixed steps: their length in s, shortened so that steps end at the times.
    method : str
        Adaptive: ``"taylor"`` (series of an order that suits the tolerance; for equations without
        comparisons, magnitudes and roundings) or ``"dop853"``. With fixed steps: ``"rk4"``,
        ``"rk5"``, ``"rk8"``. ``"auto"`` takes Taylor series where they exist and are the cheaper
        ones by counted operations, else DOP853; rk4 for a step.
    threads : int
        On how many processors; the result is the same to the last bit.
    budget : int
        Steps that may be tried for one motion.
    beyond_domain : bool
        In a scene with conditions of validity: that they are not watched has to be accepted.

    Returns
    -------
    Ensemble
        A motion that cannot be continued ends early, says why, and disturbs no other.

    Raises
    ------
    WrongKindError
        For what is no model.
    InputError
        For a name that does not exist, a value that is no number or out of range, arrays of
        different length, or initial values that no configuration satisfies.
    ValueMissingError
        For a parameter that has no value.
    ExpressionError
        If ``"taylor"`` is asked for and an operation has no series; it is named.
    """
    wanted(model, Model, "ensemble", "pass compile(equations)")
    grid = _times(duration, times)
    name, by = _method(method, tolerance, step)
    _whole("threads", threads)
    _whole("budget", budget)
    scene = model.equations.scene
    if scene.conditions and not beyond_domain:
        raise InputError(
            f"{scene.name}: it has conditions of validity, which an ensemble does not watch:"
            " simulate the motions one by one, or pass beyond_domain=True"
        )
    needed = sum(count for count, _ in plan(grid, by)) if name in FIXED else 0
    if needed > budget:
        raise InputError(
            f"step {by:g} s: {needed:.2g} steps are needed, and the budget is {budget}: take"
            " longer ones or fewer times, or give a larger budget"
        )
    motions = read_motions(model, grid, initial or {}, parameters or {}, inputs or {})
    run = _run(motions, name, by, budget, min(threads, max(1, len(motions))))
    names = tuple(entry.name for entry in (*model.quantities.q, *model.quantities.u))
    return Ensemble(
        scene.name, grid, run.states, names, run.status, run.reached, run.steps, run.evaluations,
        run.method,
    )  # fmt: skip


def _run(motions: Motions, name: str, by: float, budget: int, threads: int) -> Run:
    model = motions.model
    if model.compiler is None:
        return one_by_one(motions, name, by, budget)
    if name in FIXED:
        return fixed(motions, TABLEAUX[FIXED.index(name)], by, threads)
    share = by if name == "dop853" else by * SHARE
    held = model.right_hand_side.held
    chosen = best(held.program, held.state, share) if name == AUTO else name
    if chosen == "dop853":
        share = max(share, FINEST_STEP)
    return adaptive(motions, chosen, share, budget, threads)


def _times(duration: float, times: ArrayLike | None) -> Array:
    if not (isinstance(duration, int | float) and math.isfinite(duration) and duration > 0):
        raise InputError(f"duration: {duration!r} found: a positive number of seconds is needed")
    if times is None:
        return np.array([0.0, float(duration)])
    try:
        found = np.array(times, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(f"times: {times!r} found: numbers are needed") from None
    ends = found.ndim == 1 and len(found) > 1 and found[0] == 0 and found[-1] == duration
    if not (ends and np.all(np.diff(found) > 0)):
        raise InputError(
            f"times: {found} found: numbers that increase from 0 to the duration, {duration:g} s,"
            " are needed"
        )
    return found


def _method(name: str, tolerance: float | None, step: float | None) -> tuple[str, float]:
    """The method, or auto, and its tolerance or step."""
    if name not in (AUTO, *ADAPTIVE, *FIXED):
        names = ", ".join((AUTO, *ADAPTIVE, *FIXED))
        raise InputError(f"method {name!r}: the methods are {names}")
    if tolerance is not None and step is not None:
        raise InputError("tolerance and step: both are given: give one of them")
    if step is not None:
        if name in ADAPTIVE:
            raise InputError(f"method {name!r}: it chooses its steps: give a tolerance")
        if not (isinstance(step, int | float) and math.isfinite(step) and step > 0):
            raise InputError(f"step: {step!r} found: a positive number of seconds is needed")
        return (FIXED[0] if name == AUTO else name), float(step)
    if name in FIXED:
        raise InputError(f"method {name!r}: it has fixed steps: give step, in s")
    if tolerance is None:
        return name, TOLERANCE
    if not (isinstance(tolerance, int | float) and FINEST <= tolerance < 1):
        raise InputError(f"tolerance: {tolerance!r} found: it has to be in [{FINEST:g}, 1)")
    return name, float(tolerance)


def _whole(name: str, value: int) -> None:
    if not isinstance(value, int) or value < 1:
        raise InputError(f"{name}: {value!r} found: a whole number of at least 1 is needed")
