"""What an integrator is given and gives back.

    y' = f(t, y),   y(0) = start,   y = (q, u)           wanted: y at the times, with a setting

An `Integrator` is data: it tells whether it is installed and whether it suits a problem, and
prepares a call. Preparing may compile; only the call is timed.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import Enum
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.model import Model
from mechanics.errors import MechanicsError
from mechanics.simulate.values import Signals, read_inputs

Array = NDArray[np.float64]

BUDGET = 10_000_000
"""Evaluations of the right-hand side that an integrator may spend, unless a problem says else."""


class OverBudget(MechanicsError, RuntimeError):
    """An integrator has used up its evaluations; caught by its adapter, which reports it."""


@dataclass(frozen=True, eq=False)
class Problem:
    """A motion that is wanted, with numbers bound.

    Attributes
    ----------
    model : Model
    p : array
        Parameters in the model's order.
    inputs : mapping of str to float or callable
        Inputs, and rates of them where they are needed, as `mechanics.simulate` takes them; what is
        not given is zero.
    start : array, shape (n + m,)
        (q, u) at t = 0; on the constraints.
    times : array, shape (N,)
        When the state is wanted, in s: increasing from 0.
    budget : int
        Evaluations of the right-hand side after which an integrator gives up.
    through : bool
        Whether fixed steps, but CasADi's, go on through the times: the state at a time is then a
        shorter step of the same method from the last end before it. Else steps end at the times.
    """

    model: Model
    p: Array
    inputs: Mapping[str, Any]
    start: Array
    times: Array
    budget: int = BUDGET
    through: bool = False

    @cached_property
    def signals(self) -> Signals:
        """The model's inputs as functions of time."""
        symbols = [entry.symbol for entry in self.model.quantities.inputs]
        return read_inputs(self.model.equations.scene, symbols, self.inputs)

    @cached_property
    def varying(self) -> tuple[str, ...]:
        """Names of the model's inputs that change with time, time itself included."""
        names = self.model.entries["inputs"]
        return tuple(n for n in names if n == "t" or callable(self.inputs.get(n, 0.0)))


@dataclass(frozen=True)
class Setting:
    """How to integrate.

    Attributes
    ----------
    integrator : str
        Name of one of `INTEGRATORS`.
    tolerance : float or None
        Relative and absolute error of a step, for adaptive methods.
    step : float or None
        Length of a step in s, for the others; shortened so that steps end at the times.
    arithmetic : str
        ``"double"``, or ``"single"``: the right-hand side, or the whole method where it is compiled
        with it, in 24 binary digits.
    """

    integrator: str
    tolerance: float | None = None
    step: float | None = None
    arithmetic: str = "double"

    @property
    def kind(self) -> type[np.floating]:
        """The type of the numbers."""
        return np.float32 if self.arithmetic == "single" else np.float64


class Cause(Enum):
    """What kind of failure ended a motion early."""

    BUDGET = "all evaluations are used up"
    NOT_FINITE = "the state is not finite"
    NO_STEP = "no step meets the tolerance"


@dataclass(frozen=True, eq=False)
class Outcome:
    """What came out.

    Attributes
    ----------
    states : array, shape (k, n + m)
        At the first k of the times: all of them unless it failed.
    evaluations : int
        Of the right-hand side.
    failure : str
        Why it ended early, in one sentence; empty when it did not.
    jacobians : int
        Evaluations of the Jacobian, by implicit methods.
    cause : Cause or None
        The kind of failure, told by integrators that are called from Python.
    """

    states: Array = field(repr=False)
    evaluations: int
    failure: str = ""
    jacobians: int = 0
    cause: Cause | None = None


@dataclass(frozen=True)
class Integrator:
    """One method.

    Attributes
    ----------
    name : str
    family : str
        Where it comes from: ``"SciPy"``, ``"SUNDIALS"``, ``"CasADi"``, ``"heyoka"``, ``"C"``.
    adaptive : bool
        Whether it takes a tolerance; otherwise a step.
    available : callable
        Without arguments: empty, or why it cannot be used on this machine.
    suits : callable
        Of (problem, setting): empty, or why it cannot solve that.
    prepare : callable
        Of (problem, setting), to a call without arguments that integrates.
    """

    name: str
    family: str
    adaptive: bool
    available: Callable[[], str]
    suits: Callable[[Problem, Setting], str]
    prepare: Callable[[Problem, Setting], Callable[[], Outcome]]
