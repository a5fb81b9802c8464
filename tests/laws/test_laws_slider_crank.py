"""A slider-crank: two descriptions of its last pin that are one only where the loop is closed.

r cos a + l cos b = x,    r sin a + l sin b = 0
"""

import pytest
from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics import crosscheck, derive, holonomic
from mechanics.crosscheck import CrossCheck
from mechanics.exact import Verdict
from mechanics.scene import Particle, RigidBody, Scene, force, gravity, parameters, reaction

a, b, x, F = dynamicsymbols("a b x F")
r, l, m1, m2, m3, g = parameters(
    "r l m1 m2 m3 g", units="m m kg kg kg m/s^2", typical="0.1 0.3 1 1 1 9.81"
)


def slider_crank(pin: str) -> Scene:
    """Crank, rod and slider; the forces of the last pin act at the rod's end or at the slider."""
    ground, origin = ReferenceFrame("N"), Point("O")
    crank = ground.orientnew("A", "Axis", (a, ground.z))
    rod = ground.orientnew("B", "Axis", (b, ground.z))
    joint = origin.locatenew("P", r * crank.x)
    points = {
        "end of the rod": joint.locatenew("Q", l * rod.x),
        "slider": origin.locatenew("S", x * ground.x),
    }
    held = [("O", origin, "crank", None), ("P", joint, "rod", "crank")]
    held.append(("Q", points[pin], "slider", "rod"))
    return Scene(
        "slider crank",
        ground,
        origin,
        coordinates=(a, b, x),
        bodies=(
            RigidBody("crank", origin.locatenew("G1", r / 2 * crank.x), crank, m1, m1 * r**2 / 12),
            RigidBody("rod", joint.locatenew("G2", l / 2 * rod.x), rod, m2, m2 * l**2 / 12),
            Particle("slider", points["slider"], m3),
        ),
        loads=(gravity(-g * ground.y), force("F", points["slider"], F * ground.x, on="slider")),
        inputs=(F,),
        reactions=(
            *(
                reaction(f"{name}{axis}", at=at, on=on, by=by, along=getattr(ground, axis))
                for name, at, on, by in held
                for axis in "xy"
            ),
            reaction("W", at=points["slider"], on="slider", by=None, along=ground.y),
        ),
        constraints=(
            holonomic("along x", r * cos(a) + l * cos(b) - x, "Qx"),
            holonomic("along y", r * sin(a) + l * sin(b), "Qy"),
        ),
        example={"a": 0.7},
    )


@pytest.mark.parametrize("pin", ["end of the rod", "slider"])
def test_all_routes_agree(pin: str) -> None:
    result = crosscheck(slider_crank(pin), CrossCheck(states=10))
    assert result.ok
    assert {finding.verdict for finding in result.pairs.values()} == {Verdict.PROVED}


@pytest.mark.parametrize("pin", ["end of the rod", "slider"])
def test_a_principle_that_reads_zero_on_the_closed_loop_is_dropped(pin: str) -> None:
    # About its own pin the slider has neither momentum nor moment, once the loop is closed.
    chosen = derive(slider_crank(pin), "moving_point").chosen
    assert not any(words.startswith("slider: moment") for words in chosen)
