"""A motion that is wanted, and the models that can be used for it.

y' = f(t, y),   y(0) = start,   0 <= t <= horizon
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled import Model, compile
from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.simulate.consistent import Suggestion, consistent_coordinates, consistent_speeds
from mechanics.simulate.constraints import manifold, periodic
from mechanics.simulate.integrators import Problem
from mechanics.simulate.manifold import Manifold
from mechanics.simulate.values import (
    for_equations,
    read_initial,
    read_inputs,
    read_parameters,
)
from mechanics.trade.choice import LINEARIZED, Variant
from mechanics.trade.linearized import linearized

Array = NDArray[np.float64]

# Times at which errors are looked at, the start included.
TIMES = 21
# Evaluations that one run may spend: a tenth of a second to seconds, depending on who calls.
BUDGET = 400_000
ELSEWHERE = 4


@dataclass(frozen=True, eq=False)
class Case:
    """A motion of a system with numbers bound, and models of it that are compiled on first use.

    Attributes
    ----------
    horizon : float
        In s.
    initial, parameters : mapping of str to float
        What differs from the example and the typical values.
    inputs : mapping of str to float
    compiler : str or None
        As for `mechanics.compile`.
    grid : tuple of float, optional
        Times at which the motion is looked at, from 0 to the horizon; by default some of them at
        equal distances.
    through : bool
        Whether fixed steps go on through these times; see `Problem`.
    linear : callable
        Makes the linearized equations; refuses where there are none.
    """

    equations: Equations
    horizon: float
    initial: Mapping[str, float] = field(default_factory=dict)
    parameters: Mapping[str, float] = field(default_factory=dict)
    inputs: Mapping[str, Any] = field(default_factory=dict)
    compiler: str | None = "auto"
    grid: tuple[float, ...] | None = None
    through: bool = False
    linear: Callable[["Case"], Equations] = lambda case: linearized(
        case.equations, case.parameters, case.suggested
    )
    _models: dict[Variant, Model] = field(default_factory=dict, repr=False)

    def __post_init__(self) -> None:
        if not (np.isfinite(self.horizon) and self.horizon > 0):
            raise InputError(
                f"horizon: {self.horizon!r} found: a positive number of seconds is needed"
            )

    def model(self, variant: Variant = Variant()) -> Model:  # noqa: B008 - frozen
        """The model of a variant, compiled once; its graphs do not depend on the compiler."""
        if variant not in self._models:
            default = replace(variant, flags=Variant().flags)
            if variant != default:
                made = replace(self.model(default), flags=variant.flags)
            else:
                equations = self.linear(self) if variant.model == LINEARIZED else self.equations
                made = compile(equations, compiler=self.compiler, form=variant.form)
            self._models[variant] = made
        return self._models[variant]

    def p(self, model: Model) -> Array:
        """Parameters in the order of a model."""
        own = for_equations(self.equations.scene, self.parameters)
        return read_parameters(model.quantities.p, model.quantities.definitions, own)

    @cached_property
    def suggested(self) -> tuple[Suggestion, Suggestion]:
        """Coordinates and speeds to start from, before they are made consistent."""
        return read_initial(self.equations.scene, self.initial)

    @cached_property
    def manifold(self) -> Manifold:
        """The constraints."""
        model = self.model()
        return manifold(self.equations.scene, model.numbers(self.p(model)), self.inputs)

    @cached_property
    def start(self) -> Array:
        """(q, u) at t = 0, on the constraints."""
        return self.consistent(*self.suggested)

    def consistent(self, q: Suggestion, u: Suggestion) -> Array:
        """A state on the constraints from suggested values."""
        placed, _ = consistent_coordinates(self.manifold, 0.0, q, periodic(self.equations.scene))
        speeds = consistent_speeds(self.manifold, 0.0, placed, u)
        return np.concatenate([placed, speeds])

    @property
    def times(self) -> Array:
        """Times at which the motion is looked at, shape (N,), in s."""
        return np.linspace(0.0, self.horizon, TIMES) if self.grid is None else np.array(self.grid)

    def problem(self, variant: Variant = Variant(), start: Array | None = None) -> Problem:  # noqa: B008
        """What an integrator is given."""
        model = self.model(variant)
        begin = self.start if start is None else start
        # From another start a motion may be faster: what the case can pay for shall not fail there.
        budget = BUDGET if start is None else ELSEWHERE * BUDGET
        p = self.p(model)
        return Problem(model, p, self.inputs, begin, self.times, budget, self.through)

    def with_model(self, model: Model) -> "Case":
        """The same with a model that was compiled already."""
        return replace(self, _models={Variant(): model})

    def until(self, horizon: float) -> "Case":
        """The same for another length of time, with the models that were compiled already."""
        return replace(self, horizon=horizon, grid=None)

    def starting(self, start: Array) -> "Case":
        """The same from another state on the constraints."""
        return replace(self, initial=dict(zip(self.names, start.tolist(), strict=True)))

    @property
    def names(self) -> tuple[str, ...]:
        """Plain names of the entries of y."""
        return tuple(s.name for s in (*self.equations.scene.q, *self.equations.scene.u))

    @cached_property
    def units(self) -> tuple[str, ...]:
        """Units of the entries of y."""
        quantities = self.model().quantities
        return tuple(entry.unit for entry in (*quantities.q, *quantities.u))

    def energy(self, states: Array) -> dict[str, Array]:
        """Kinetic and potential energy of states, shape (k,), in J."""
        model, size = self.model(), len(self.equations.scene.q)
        symbols = [entry.symbol for entry in model.quantities.inputs]
        signals = read_inputs(self.equations.scene, symbols, self.inputs)
        times = self.times[: len(states)]
        given = np.array([signals(*at) for at in zip(times, states, strict=True)])
        q, u = states[:, :size], states[:, size:]
        found = model.energy(q, u, inputs=given, p=self.p(model))
        return {name: np.asarray(value, dtype=float) for name, value in found.items()}
