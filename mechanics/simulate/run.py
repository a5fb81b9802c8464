"""Simulate a compiled model: from names and numbers to a `Trajectory`."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.model import Model
from mechanics.compiled.quantities import Quantities, Quantity
from mechanics.errors import InputError, SingularError
from mechanics.simulate.conservative import conservative
from mechanics.simulate.consistent import consistent_coordinates, consistent_speeds
from mechanics.simulate.constraints import periodic
from mechanics.simulate.flow import flow
from mechanics.simulate.march import METHODS, Tolerance
from mechanics.simulate.samples import Samples, sample
from mechanics.simulate.trajectory import Ending, Trajectory
from mechanics.simulate.values import read_initial, read_inputs, read_parameters

Array = NDArray[np.float64]
# The solvers of SciPy raise a smaller tolerance to this without being asked.
FINEST_RTOL = 100 * np.finfo(float).eps


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
) -> Trajectory:
    """Integrate the equations of motion from t = 0.

    Parameters
    ----------
    model : Model
        From `mechanics.compile`.
    duration : float
        In s.
    initial : mapping of str to float
        Initial values by plain name: ``{"theta": 2.5, "theta_dot": 0}``. What is not given is
        taken from the scene's example, and is zero where that has none. In a constrained scene
        the given values are kept and as many of the others as there are constraints are solved
        for, the last ones first.
    parameters : mapping of str to float
        What is not given has its typical value.
    inputs : mapping of str to float or callable
        Inputs as numbers or functions of t; what is not given is zero. Where rates of an input are
        needed they are given in the same way, ``{"f": sin, "f_dot": cos}``.
    samples : int
        Number of samples at equal distances, both ends included.
    rtol, atol : float
        Relative and absolute error that one step may make.
    method : str
        A solver of SciPy: DOP853, RK45, Radau, BDF, LSODA.

    Returns
    -------
    Trajectory
        Shorter than asked for where the motion cannot be continued; `ending` and `reason` say why.

    Raises
    ------
    InputError
        For a name that does not exist, a value that is no number or out of range, or initial
        values that no configuration satisfies.
    ValueMissingError
        For a parameter that has no value.
    SingularError
        When the initial configuration is singular, so that no motion starts from it.
    """
    initial, parameters, inputs = initial or {}, parameters or {}, inputs or {}
    times, by = _times(duration, samples), _tolerance(method, rtol, atol)
    scene, quantities = model.equations.scene, model.quantities
    p = read_parameters(quantities.p, quantities.definitions, parameters)
    signals = read_inputs(scene, [entry.symbol for entry in quantities.inputs], inputs)
    suggested_q, suggested_u = read_initial(scene, initial)
    moving = flow(model, p, signals, inputs)
    q, branch = consistent_coordinates(moving.manifold, 0.0, suggested_q, periodic(scene))
    u = consistent_speeds(moving.manifold, 0.0, q, suggested_u)
    found = sample(moving, np.concatenate([q, u]), times, by)
    if found.time == 0.0:
        raise SingularError(
            f"{scene.name}: no motion starts from the initial values: {found.ending.value}:"
            " start from others"
        )
    reached = times[: len(found.states)]
    given = np.array([signals(time) for time in reached])
    states = found.states[:, : len(q)], found.states[:, len(q) :]
    energy = model.energy(*states, inputs=given, p=p)
    drift = dict(zip(moving.manifold.names, found.drift.tolist(), strict=True))
    return Trajectory(
        title=scene.name,
        times=reached,
        coordinates=_by_name(quantities.q, states[0]),
        speeds=_by_name(quantities.u, states[1]),
        inputs=_by_name(quantities.inputs, given),
        units=_units(quantities),
        kinetic=np.asarray(energy["kinetic"], dtype=np.float64),
        potential=np.asarray(energy["potential"], dtype=np.float64),
        conservative=conservative(scene, inputs),
        parameters={e.name: float(v) for e, v in zip(quantities.p, p, strict=True)},
        drift=drift,
        branch=branch,
        ending=found.ending,
        reason=_reason(found, duration),
    )


def _by_name(entries: Sequence[Quantity], columns: Array) -> dict[str, Array]:
    return {entry.name: columns[:, i] for i, entry in enumerate(entries)}


def _units(quantities: Quantities) -> dict[str, str]:
    groups = (quantities.q, quantities.u, quantities.inputs)
    energies = ("kinetic_energy", "potential_energy", "total_energy")
    return {
        "t": "s",
        **{entry.name: entry.unit for group in groups for entry in group},
        **dict.fromkeys(energies, "J"),
    }


def _reason(found: Samples, duration: float) -> str:
    if found.ending is Ending.COMPLETE:
        return found.ending.value
    return f"ended at t = {found.time:.6g} s of {duration:g} s: {found.ending.value}"


def _times(duration: float, count: int) -> Array:
    if not (isinstance(duration, int | float) and math.isfinite(duration) and duration > 0):
        raise InputError(f"duration: {duration!r} found: a positive number of seconds is needed")
    if not isinstance(count, int) or count < 2:
        raise InputError(f"samples: {count!r} found: a whole number of at least 2 is needed")
    return np.linspace(0.0, float(duration), count)


def _tolerance(method: str, rtol: float, atol: float) -> Tolerance:
    if method not in METHODS:
        raise InputError(f"method {method!r}: the methods are {', '.join(METHODS)}")
    if not FINEST_RTOL <= rtol < 1:
        raise InputError(f"rtol: {rtol!r} found: it has to be in [{FINEST_RTOL:.2g}, 1)")
    if not (math.isfinite(atol) and atol > 0):
        raise InputError(f"atol: {atol!r} found: it has to be positive")
    return Tolerance(method, rtol, atol)
