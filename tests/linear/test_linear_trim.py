"""Inputs that hold a pose: what they are, and what is refused."""

import pytest
from sympy import cos, pi
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

import mechanics
from mechanics import Particle, Scene, gravity, parameters, reaction
from mechanics.errors import InputError

m, L, g = parameters("m L g", units="kg m m/s^2", typical="1 2 9.81")
q, tau = dynamicsymbols("q tau")


def arm(driven=True):
    ground, origin = ReferenceFrame("N"), Point("O")
    rod = ground.orientnew("A", "Axis", (q, ground.z))
    tip = origin.locatenew("P", L * rod.x)
    push = (mechanics.force("motor", tip, tau / L * rod.y),) if driven else ()
    return Scene("arm", ground, origin, (q,), (Particle("bob", tip, m),),
                 loads=(gravity(-g * ground.y), *push), inputs=(tau,) if driven else (),
                 reactions=(reaction("S", at=tip, on="bob", by=None, along=rod.x),))  # fmt: skip


@pytest.mark.parametrize("route", ["kane", "free_body"])
@pytest.mark.parametrize("angle", [0, pi / 6, pi / 2])
def test_a_motor_holds_the_weight(angle, route):
    equations = mechanics.derive(arm(), route)
    (held,) = mechanics.trim(equations, {"q": angle}).values()
    assert held == m * g * L * cos(angle)
    assert mechanics.linearize(equations, {"q": angle}, inputs={"tau": held}) is not None


def test_what_no_input_holds_is_refused():
    equations = mechanics.derive(arm(driven=False))
    assert mechanics.trim(equations, {"q": pi / 2}) == {}
    with pytest.raises(InputError, match="no inputs hold it at rest at q = 0"):
        mechanics.trim(equations, {"q": 0})


def test_every_coordinate_has_a_value():
    with pytest.raises(InputError, match="no value for coordinate q"):
        mechanics.trim(mechanics.derive(arm()), {})
