"""A mass of zero is named: it is not the configuration that is singular."""

import pytest
from particles import pendulum
from sympy.physics.mechanics import dynamicsymbols

from mechanics import compile, derive, simulate
from mechanics.errors import SceneError, SingularError

theta = dynamicsymbols("theta")


def test_a_mass_that_is_set_to_zero_is_named() -> None:
    model = compile(derive(pendulum(typical="1 1 9.81")), form="elimination")
    with pytest.raises(SingularError, match=r"m = 0, so that nothing resists"):
        simulate(model, 1.0, parameters={"m": 0})


def test_a_length_that_is_zero_is_no_mass() -> None:
    model = compile(derive(pendulum(typical="1 1 9.81")))
    with pytest.raises(SingularError, match=r"at theta = 0 the .*: start from others"):
        simulate(model, 1.0, parameters={"L": 0})


def test_a_typical_mass_of_zero_is_refused() -> None:
    with pytest.raises(SceneError, match=r"body bob: m of its mass or inertia is positive, but 0"):
        pendulum(typical="0 1 9.81")
    assert pendulum(typical="- 1 9.81").parameters
