"""A mass of zero is named: it is not the configuration that is singular."""

import pytest
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics import compile, derive, simulate
from mechanics.errors import SceneError, SingularError
from mechanics.scene import Particle, Scene, gravity, parameters, reaction

theta = dynamicsymbols("theta")


def pendulum(typical: str) -> Scene:
    m, length, g = parameters("m L g", units="kg m m/s^2", typical=f"{typical} 1 9.81")
    ground, origin = ReferenceFrame("N"), Point("O")
    rod = ground.orientnew("A", "Axis", (theta, ground.z))
    tip = origin.locatenew("P", -length * rod.y)
    return Scene(
        "pendulum",
        ground,
        origin,
        coordinates=(theta,),
        bodies=(Particle("bob", tip, m),),
        loads=(gravity(-g * ground.y),),
        reactions=(reaction("S", at=tip, on="bob", by=None, along=rod.y),),
    )


def test_a_mass_that_is_set_to_zero_is_named() -> None:
    model = compile(derive(pendulum("1")), form="elimination")
    with pytest.raises(SingularError, match=r"m = 0, so that nothing resists"):
        simulate(model, 1.0, parameters={"m": 0})


def test_a_length_that_is_zero_is_no_mass() -> None:
    model = compile(derive(pendulum("1")))
    with pytest.raises(SingularError, match="start from others"):
        simulate(model, 1.0, parameters={"L": 0})


def test_a_typical_mass_of_zero_is_refused() -> None:
    with pytest.raises(SceneError, match=r"body bob: m of its mass or inertia is positive, but 0"):
        pendulum("0")
    assert pendulum("-").parameters
