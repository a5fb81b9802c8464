"""What a person sets of a method: times, tolerance or step; read, or refused in one line."""

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from mechanics.compiled.model import Model
from mechanics.errors import InputError
from mechanics.nearest import instead
from mechanics.simulate.ensembles.choice import best
from mechanics.simulate.ensembles.run import ADAPTIVE, FIXED, Method
from mechanics.simulate.ensembles.task import Task
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


def task_of(model: Model, method: Method, times: Array) -> Task:
    """What is integrated, with the method chosen and the error that one step may make.

    Parameters
    ----------
    method : Method
        Its name may be ``"auto"``; its `by` is the tolerance, or the step.
    times : array, shape (N,)
    """
    held, name, by = model.right_hand_side.held, method.name, method.by
    moving = held.sizes[0] - model.right_hand_side.timed
    if name not in FIXED:
        share = by if name == "dop853" else by * SHARE
        name = best(held.program, held.state, share) if name == AUTO else name
        by = max(share, FINEST_STEP) if name == "dop853" else share
    return Task(held, moving, Method(name, by, method.budget), times)


def refuse_conditions(model: Model, beyond_domain: bool) -> None:
    """Refuse a scene whose conditions nobody would watch."""
    scene = model.equations.scene
    if scene.conditions and not beyond_domain:
        raise InputError(
            f"{scene.name}: it has conditions of validity, which an ensemble does not watch:"
            " simulate the motions one by one, or pass beyond_domain=True"
        )


def read_times(duration: float, times: ArrayLike | None) -> Array:
    """When states are wanted: 0 and the duration, or what increases between them."""
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


def read_method(
    name: str, tolerance: float | None, step: float | None, budget: int, times: Array
) -> Method:
    """The method, or auto, and its tolerance or step."""
    whole("budget", budget)
    by = Method(*_name_and_size(name, tolerance, step), budget)
    needed = sum(count for count, _ in plan(times, by.by)) if by.name in FIXED else 0
    if needed > budget:
        raise InputError(
            f"step {by.by:g} s: {needed:.2g} steps are needed, and the budget is {budget}: take"
            " longer ones or fewer times, or give a larger budget"
        )
    return by


def _name_and_size(name: str, tolerance: float | None, step: float | None) -> tuple[str, float]:
    if name not in (AUTO, *ADAPTIVE, *FIXED):
        methods = instead(name, (AUTO, *ADAPTIVE, *FIXED), "methods")
        raise InputError(f"method {name!r}: {methods}")
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


def whole(name: str, value: int) -> None:
    """Refuse what is no whole number of at least 1."""
    if not isinstance(value, int) or value < 1:
        raise InputError(f"{name}: {value!r} found: a whole number of at least 1 is needed")
