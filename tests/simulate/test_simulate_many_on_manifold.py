"""Random states on the constraints, many at once: the same manifold as a simulation keeps."""

import functools

import numpy as np
import pytest

from mechanics import compile
from mechanics.compiled.model import Model
from mechanics.routes.derivation import by_route
from mechanics.simulate.constraints import manifold
from mechanics.simulate.many_on_manifold import states_on_manifold
from systems import four_bar, rolling_disc

COUNT = 200


@functools.cache
def model_of(system) -> Model:
    return compile(by_route("free_body", system.scene()), compiler=None)


@pytest.mark.parametrize("system", [four_bar, rolling_disc])
def test_every_state_satisfies_the_constraints(system) -> None:
    model = model_of(system)
    states = states_on_manifold(model, COUNT, 1)
    assert len(states) == COUNT
    symbols = [entry.symbol for entry in model.quantities.p]
    for q, u, p in zip(states.q[:20], states.u[:20], states.p[:20], strict=True):
        one = manifold(model.equations.scene, dict(zip(symbols, p, strict=True)), {})
        size = max(1.0, *np.abs(q), *np.abs(u), *p) ** 3
        assert np.max(one.residual(0.0, np.concatenate([q, u]))) < 1e-13 * size


def test_states_differ_and_are_the_same_for_the_same_seed() -> None:
    model = model_of(four_bar)
    one, same, other = (states_on_manifold(model, COUNT, seed) for seed in (1, 1, 2))
    assert np.array_equal(one.q, same.q) and not np.array_equal(one.q, other.q)
    assert np.unique(one.q, axis=0).shape == one.q.shape
    assert np.unique(one.p, axis=0).shape == one.p.shape
    assert len(states_on_manifold(model, 0, 1)) == 0
