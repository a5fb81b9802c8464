"""Simulate a compiled model: from names and numbers to a `Trajectory`."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from textwrap import shorten
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechanics.checks.example import contradicted
from mechanics.compiled.model import Model
from mechanics.compiled.quantities import Quantities, Quantity
from mechanics.errors import InputError, SingularError
from mechanics.kinematics.euler_angles import singular_angles
from mechanics.nearest import instead
from mechanics.scene.physical import massive
from mechanics.simulate.conservative import conservative
from mechanics.simulate.consistent import consistent_coordinates, consistent_speeds
from mechanics.simulate.constraints import periodic
from mechanics.simulate.domain import Domain, domain
from mechanics.simulate.error_estimate import error_estimate
from mechanics.simulate.exits import at_the_start
from mechanics.simulate.flow import flow
from mechanics.simulate.march import METHODS, Flow, Tolerance
from mechanics.simulate.samples import Samples, Watching, sample
from mechanics.simulate.trajectory import Ending, Trajectory
from mechanics.simulate.values import (
    Signals,
    for_equations,
    read_initial,
    read_inputs,
    read_parameters,
)

Array = NDArray[np.float64]
Progress = Callable[[float], None]
# The solvers of SciPy raise a smaller tolerance to this without being asked.
FINEST_RTOL = 100 * np.finfo(float).eps

SECOND = 0.8
"""Share of the work after which the second run begins."""

NEEDED = ("coordinate_rates", "forward_dynamics", "energy")
"""Functions of a model that a simulation calls."""


@dataclass(frozen=True, eq=False)
class Begin:
    """A model with numbers bound, and where its motion starts.

    Attributes
    ----------
    p : array
        Parameters in the model's order.
    inputs : mapping
        As they were given.
    signals : Signals
        Of the model's inputs.
    state : array, shape (n + m,)
        On the constraints.
    branch : str
        Which of the configurations that satisfy the constraints it is.
    domain : Domain
        Where the model is valid.
    """

    model: Model
    p: Array
    inputs: Mapping[str, Any]
    signals: Signals
    moving: Flow
    state: Array
    branch: str
    domain: Domain


def begin(
    model: Model,
    initial: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    inputs: Mapping[str, Any] | None = None,
) -> Begin:
    """Names and numbers read; initial values made consistent. See `simulate_one`."""
    missing = [name for name in NEEDED if name not in tuple(model.casadi)]
    if missing:
        raise InputError(
            f"simulate: {model.equations.scene.name} was compiled without {', '.join(missing)}:"
            " name them among its outputs, or leave outputs out"
        )
    scene, quantities, given = model.equations.scene, model.quantities, inputs or {}
    values = parameters or {}
    p = read_parameters(quantities.p, quantities.definitions, for_equations(scene, values))
    signals = read_inputs(scene, [entry.symbol for entry in quantities.inputs], given)
    suggested_q, suggested_u = read_initial(scene, initial or {})
    moving = flow(model, p, signals, given)
    q, branch = consistent_coordinates(moving.manifold, 0.0, suggested_q, periodic(scene))
    if branch and not parameters and not {*(initial or {})} & {*suggested_q.names}:
        off = contradicted(scene.example, dict(zip(suggested_q.names, q, strict=True)))
        listed = ", ".join(f"{name} = {value:g}" for name, value in off.items())
        branch += f"; the example's {listed} does not satisfy the constraints" if off else ""
    u = consistent_speeds(moving.manifold, 0.0, q, suggested_u)
    state = np.concatenate([q, u])
    valid = domain(model, p, given, values, state)
    return Begin(model, p, given, signals, moving, state, branch, valid)


def simulate_one(
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
    estimate: bool = True,
) -> Trajectory:
    """Integrate the motion from one initial state; see `mechanics.simulate.batch.simulate`."""
    times, by = equal_times(duration, samples), _tolerance(method, rtol, atol)
    start = begin(model, initial, parameters, inputs)
    name = model.equations.scene.name
    outside = at_the_start(name, start.domain, start.state, beyond_domain)
    watch = Watching(start.domain, beyond_domain)
    found = sample(start.moving, start.state, times, by, _until(SECOND, progress), watch)
    if found.time == 0.0:
        raise SingularError(
            f"{name}: no motion starts from the initial values: {_why_none(start, found.ending)}"
        )
    crossed = (*outside, *found.crossings)
    motion = trajectory(start, times, replace(found, crossings=crossed))
    error = error_estimate(start.moving, start.state, times, by, found) if estimate else None
    if progress is not None:
        progress(1.0)
    if error is None:
        return motion
    return replace(motion, error_estimate=error.error, tenfold=error.tenfold, horizon=error.horizon)


def _until(share: float, progress: Progress | None) -> Progress | None:
    """What the first part of the work tells of the whole."""
    return None if progress is None else lambda done: progress(share * done)


def _why_none(start: Begin, ending: Ending) -> str:
    """What to do: a mass that is zero makes every configuration singular."""
    masses = {s.name for body in start.model.equations.scene.bodies for s in massive(body)}
    named = zip(start.model.quantities.p, start.p, strict=True)
    zeros = [entry.name for entry, value in named if value == 0 and entry.name in masses]
    if zeros:
        return f"{', '.join(zeros)} = 0, so that nothing resists: give it another value"
    values = dict(zip((q.name for q in start.model.quantities.q), start.state, strict=False))
    angles = singular_angles(start.model.equations.scene, values)
    place = ", ".join(f"{name} = {value:.6g}" for name, value in values.items())
    return angles or (
        f"at {shorten(place, 120, placeholder=' ...')} {ending.value}: start from others"
        " (--set NAME=VALUE, initial= or the scene's example=)"
    )


def trajectory(start: Begin, times: Array, found: Samples) -> Trajectory:
    """Samples of a motion with names, units and energies.

    Parameters
    ----------
    times : array, shape (N,)
        That were asked for.
    found : Samples
        At the first K of them.
    """
    model, quantities = start.model, start.model.quantities
    reached = times[: len(found.states)]
    given = np.array([start.signals(*at) for at in zip(reached, found.states, strict=True)])
    n = len(quantities.q)
    states = found.states[:, :n], found.states[:, n:]
    energy = model.energy(*states, inputs=given, p=start.p)
    names = start.moving.manifold.names
    return Trajectory(
        title=model.equations.scene.name,
        times=reached,
        coordinates=_by_name(quantities.q, states[0]),
        speeds=_by_name(quantities.u, states[1]),
        inputs=_by_name(quantities.inputs, given),
        units=_units(quantities)
        | {
            f"{name}{end}": unit
            for name, output in model.equations.scene.outputs.items()
            for end, unit in output.entries
        },
        kinetic=np.asarray(energy["kinetic"], dtype=np.float64),
        potential=np.asarray(energy["potential"], dtype=np.float64),
        conservative=conservative(model.equations.scene, start.inputs),
        parameters={e.name: float(v) for e, v in zip(quantities.p, start.p, strict=True)},
        drift=dict(zip(names, found.drift.tolist(), strict=True)),
        branch=start.branch,
        ending=found.ending,
        reason=_reason(found, float(times[-1]), _singular_at_end(start, reached, found)),
        crossings=found.crossings,
        outputs=_outputs(model, {"q": states[0], "u": states[1], "inputs": given, "p": start.p}),
        scene=model.equations.scene,
    )


def _outputs(model: Model, at: Mapping[str, Any]) -> dict[str, Array]:
    """What the scene wants computed, where the model has it, entry by entry."""
    found: dict[str, Array] = {}
    for name, output in model.equations.scene.outputs.items():
        if name in tuple(model.casadi):
            (values,) = model.evaluate(name, **at).values()
            columns = values.reshape(len(values), -1).T
            labels = [f"{name}{end}" for end, _ in output.entries]
            found.update(zip(labels, columns, strict=True))
    return found


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


def _singular_at_end(start: Begin, times: Array, found: Samples) -> str:
    """Euler angles that are singular where a motion ends."""
    if found.ending is not Ending.SINGULAR:
        return ""
    names = [q.name for q in start.model.quantities.q]
    at = {name: float(np.interp(found.time, times, found.states[:, i]))
          for i, name in enumerate(names)}  # fmt: skip
    return singular_angles(start.model.equations.scene, at)


def _reason(found: Samples, duration: float, angles: str) -> str:
    if found.ending is Ending.COMPLETE:
        return found.ending.value
    said = [one.sentence for one in found.crossings if found.ending is Ending.LEFT_DOMAIN]
    words = angles or ": ".join([found.ending.value, *said])
    return f"ended at t = {found.time:.6g} s of {duration:g} s: {words}"


def equal_times(duration: float, count: int) -> Array:
    """Times of the samples, in s."""
    if not (isinstance(duration, int | float) and math.isfinite(duration) and duration > 0):
        raise InputError(f"duration: {duration!r} found: a positive number of seconds is needed")
    if not isinstance(count, int) or count < 2:
        raise InputError(f"samples: {count!r} found: a whole number of at least 2 is needed")
    return np.linspace(0.0, float(duration), count)


def _tolerance(method: str, rtol: float, atol: float) -> Tolerance:
    if method not in METHODS:
        raise InputError(f"method {method!r}: {instead(method, METHODS, 'methods')}")
    if not FINEST_RTOL <= rtol < 1:
        raise InputError(f"rtol: {rtol!r} found: it has to be in [{FINEST_RTOL:.2g}, 1)")
    if not (math.isfinite(atol) and atol > 0):
        raise InputError(f"atol: {atol!r} found: it has to be positive")
    return Tolerance(method, rtol, atol)
