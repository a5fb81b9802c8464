"""Simulate from one initial state or from many.

{"theta": 0.5}                         one
({"theta": 0.5}, {"theta": 0.6})       two
{"theta": [0.5, 0.6], "x": 0.1}        two, with the same x
"""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.model import Model
from mechanics.errors import InputError
from mechanics.simulate.run import Progress, simulate_one
from mechanics.simulate.trajectory import Trajectory

Initial = Mapping[str, Any] | Sequence[Mapping[str, Any]] | None


@overload
def simulate(
    model: Model,
    duration: float,
    *,
    initial: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    inputs: Mapping[str, Any] | None = None,
    samples: int = 501,
    rtol: float = 1e-10,
    atol: float = 1e-12,
    method: str = "DOP853",
    progress: Progress | None = None,
    beyond_domain: bool = False,
) -> Trajectory: ...


@overload
def simulate(
    model: Model,
    duration: float,
    *,
    initial: Sequence[Mapping[str, float]] | Mapping[str, NDArray[np.float64]],
    parameters: Mapping[str, float] | None = None,
    inputs: Mapping[str, Any] | None = None,
    samples: int = 501,
    rtol: float = 1e-10,
    atol: float = 1e-12,
    method: str = "DOP853",
    progress: Progress | None = None,
    beyond_domain: bool = False,
) -> tuple[Trajectory, ...]: ...


def simulate(
    model: Model,
    duration: float,
    *,
    initial: Initial = None,
    parameters: Mapping[str, float] | None = None,
    inputs: Mapping[str, Any] | None = None,
    samples: int = 501,
    rtol: float = 1e-10,
    atol: float = 1e-12,
    method: str = "DOP853",
    progress: Progress | None = None,
    beyond_domain: bool = False,
    estimate: bool = True,
) -> Trajectory | tuple[Trajectory, ...]:
    """Integrate the equations of motion from t = 0.

    Parameters
    ----------
    model : Model
        From `mechanics.compile`.
    duration : float
        In s.
    initial : mapping of str to float, or many of them
        Initial values by plain name: ``{"theta": 2.5, "theta_dot": 0}``. What is not given is
        taken from the scene's example, and is zero where that has none. In a constrained scene
        the given values are kept and as many of the others as there are constraints are solved
        for, the last ones first. A sequence of mappings, or a mapping with arrays of shape (k,)
        (numbers are shared), is a batch of k initial states.
    parameters : mapping of str to float
        What is not given has its typical value.
    inputs : mapping of str to float or callable
        Inputs as numbers or functions of t; what is not given is zero. Where rates of an input are
        needed they are given in the same way, ``{"f": sin, "f_dot": cos}``. A control law is a
        `mechanics.Feedback`: ``{"f": Feedback(lambda t, q, u: -30 * q[0])}``.
    samples : int
        Number of samples at equal distances, both ends included.
    rtol, atol : float
        Relative and absolute error that one step may make.
    method : str
        A solver of SciPy: DOP853, RK45, Radau, BDF, LSODA.
    progress : callable, optional
        Told the share that is done, from 0 to 1, as it goes on.
    beyond_domain : bool
        Whether to go on where a condition of validity does not hold; `Trajectory.crossings` tell
        where. Otherwise the motion ends there.
    estimate : bool
        Whether a second run, by a coarser tolerance, estimates the error: about a quarter of the
        time more with DOP853.

    Returns
    -------
    Trajectory, or tuple of Trajectory for a batch
        Shorter than asked for where the motion cannot be continued; `ending` and `reason` say why.

    Raises
    ------
    InputError
        For a name that does not exist, a value that is no number or out of range, or initial
        values that no configuration satisfies or that lie outside of the model's domain.
    ValueMissingError
        For a parameter that has no value.
    SingularError
        When the initial configuration is singular, so that no motion starts from it.
    """
    options: dict[str, Any] = {
        "parameters": parameters,
        "inputs": inputs,
        "samples": samples,
        "rtol": rtol,
        "atol": atol,
        "method": method,
        "beyond_domain": beyond_domain,
        "estimate": estimate,
    }
    starts = initial_states(initial)
    if starts is None:
        one = initial if isinstance(initial, Mapping) else None
        return simulate_one(model, duration, initial=one, progress=progress, **options)
    return tuple(
        simulate_one(
            model, duration, initial=start, progress=part(progress, i, len(starts)), **options
        )
        for i, start in enumerate(starts)
    )


def initial_states(initial: Initial) -> tuple[dict[str, Any], ...] | None:
    """The initial states of a batch, one mapping each; None where it is no batch.

    Raises
    ------
    InputError
        If it is neither a mapping nor a sequence of mappings, a batch is empty, or arrays differ
        in length.
    """
    if initial is None:
        return None
    if isinstance(initial, Mapping):
        arrays = {name: np.asarray(v) for name, v in initial.items() if np.ndim(v) > 0}
        if not arrays:
            return None
        if any(a.ndim > 1 for a in arrays.values()) or len({len(a) for a in arrays.values()}) > 1:
            shapes = ", ".join(f"{name} {a.shape}" for name, a in arrays.items())
            raise InputError(f"initial values: arrays of one length are needed: {shapes} found")
        count = len(next(iter(arrays.values())))
        rows: Iterable[dict[str, Any]] = (
            {**initial, **{name: array[i] for name, array in arrays.items()}} for i in range(count)
        )
        return _not_empty(rows)
    if isinstance(initial, str | bytes) or not isinstance(initial, Iterable):
        raise InputError(f"initial values: {initial!r} found: give a mapping, or many of them")
    given = list(initial)
    for i, row in enumerate(given):
        if not isinstance(row, Mapping):
            raise InputError(f"initial values: entry {i} of the batch is {row!r}: give a mapping")
    return _not_empty(dict(row) for row in given)


def part(progress: Progress | None, index: int, count: int) -> Progress | None:
    """What one of many tells when it goes on."""
    if progress is None:
        return None
    tell = progress
    return lambda share: tell((index + share) / count)


def _not_empty(rows: Iterable[dict[str, Any]]) -> tuple[dict[str, Any], ...]:
    found = tuple(rows)
    if not found:
        raise InputError("initial values: the batch is empty: give one state or more")
    return found
