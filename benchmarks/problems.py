"""From names and numbers to a `Problem`: what `simulate` reads, for any integrator."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from mechanics.compiled.model import Model
from mechanics.errors import InputError
from mechanics.simulate.consistent import consistent_coordinates, consistent_speeds
from mechanics.simulate.constraints import manifold, periodic
from mechanics.simulate.integrators.problem import BUDGET, Problem
from mechanics.simulate.values import read_initial, read_parameters


def pose(
    model: Model,
    times: ArrayLike | Sequence[float],
    *,
    initial: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    inputs: Mapping[str, Any] | None = None,
    budget: int = BUDGET,
) -> Problem:
    """A problem with consistent initial values.

    Parameters
    ----------
    times : array, shape (N,)
        When the state is wanted, in s: increasing from 0.
    initial, parameters, inputs : mapping, optional
        As for `mechanics.simulate`.
    budget : int
        Evaluations of the right-hand side after which an integrator gives up.

    Raises
    ------
    InputError, ValueMissingError, SingularError
        As `mechanics.simulate`, and for times that do not increase from 0.
    """
    wanted = np.asarray(times, dtype=float)
    if wanted.ndim != 1 or len(wanted) < 2 or wanted[0] != 0 or not np.all(np.diff(wanted) > 0):
        raise InputError("times: give at least 2 numbers that increase from 0")
    initial, parameters, inputs = initial or {}, parameters or {}, inputs or {}
    scene, quantities = model.equations.scene, model.quantities
    p = read_parameters(quantities.p, quantities.definitions, parameters)
    numbers = model.numbers(p)
    constraints = manifold(scene, numbers, inputs)
    suggested_q, suggested_u = read_initial(scene, initial)
    q, _ = consistent_coordinates(constraints, 0.0, suggested_q, periodic(scene))
    u = consistent_speeds(constraints, 0.0, q, suggested_u)
    problem = Problem(model, p, dict(inputs), np.concatenate([q, u]), wanted, budget)
    problem.signals(0.0)
    return problem
