"""Reactions along a motion: those of the free bodies, in columns of their own."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from mechanics import compile
from mechanics.compiled.model import Model
from mechanics.errors import InputError
from mechanics.routes.derivation import by_route
from mechanics.simulate import simulate, with_reactions
from systems import elastic_pendulum, four_bar, rocker, two_mass_chain

ModelOf = Callable[[str], Model]


def test_reactions_hold_the_bodies() -> None:
    """M y_C'' = N - M g and 0 = N1 - N - m g, with y_C = -L/2 cos(theta)."""
    model = compile(by_route("free_body", elastic_pendulum.scene()))
    motion = with_reactions(simulate(model, 1.0, samples=11), model)
    assert list(motion.columns)[-3:] == ["T", "N", "N1"] and motion.units["N1"] == "N"
    M, m, L, g = (motion.parameters[name] for name in ("M", "m", "L", "g"))
    q = np.column_stack(list(motion.coordinates.values()))
    u = np.column_stack(list(motion.speeds.values()))
    theta, rate = q[:, 1], u[:, 1]
    turning = model.forward_dynamics(q, u, list(motion.parameters.values()))[:, 1]
    rising = L / 2 * (turning * np.sin(theta) + rate**2 * np.cos(theta))
    assert np.allclose(motion.reactions["N"], M * (rising + g), rtol=1e-10)
    assert np.allclose(motion.reactions["N1"], motion.reactions["N"] + m * g, rtol=1e-12)


@pytest.mark.campaign
@pytest.mark.parametrize("system", [four_bar, rocker])
def test_every_reaction_has_a_column(system) -> None:
    """Those of the joint that is cut, which are multipliers, and those of a scene with inputs."""
    model = compile(by_route("free_body", system.scene()))
    motion = simulate(model, 0.1, samples=3)
    found = with_reactions(motion, model)
    assert found.reactions.keys() == {reaction.name for reaction in system.scene().reactions}
    assert all(np.isfinite(column).all() for column in found.reactions.values())
    assert list(found.columns)[: len(motion.columns)] == list(motion.columns)


def test_what_gives_no_reactions_is_named() -> None:
    model = compile(by_route("kane", elastic_pendulum.scene()))
    motion = simulate(model, 0.1, samples=2)
    with pytest.raises(InputError, match=r"the route kane does not solve for N: take free_body"):
        with_reactions(motion, model)
    other = compile(by_route("free_body", elastic_pendulum.scene()))
    named = {"x": motion.coordinates["x"], "T": motion.coordinates["theta"]}
    with pytest.raises(InputError, match="reaction T is named as another column: rename it"):
        with_reactions(replace(motion, coordinates=named), other)
    free = compile(by_route("kane", two_mass_chain.scene()))
    with pytest.raises(InputError, match="it declares no reactions: leave them out"):
        with_reactions(simulate(free, 0.1, samples=2), free)
