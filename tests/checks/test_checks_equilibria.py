"""A declared equilibrium that is none is refused before any route runs."""

from dataclasses import replace
from typing import Any

import pytest
from linkages import slider_crank
from sympy import Rational, asin, pi, sqrt

from mechanics.checks.admissible import check_scene
from mechanics.errors import SceneError
from mechanics.scene import Scene
from systems import elastic_pendulum, rod_pendulum

ROD, SPRING, CRANK = rod_pendulum.scene(), elastic_pendulum.scene(), slider_crank("slider")
CLOSED = {"b": asin(Rational(1, 3)), "x": sqrt(2) / 5}
"""r = 1/10, l = 3/10 and a = -pi/2: the crank hangs."""

SHOWN = {
    "upside down": (ROD, {"theta": pi}),
    "at a number of its own": (ROD, {"theta": 3 * pi, "u": 0}),
    "held by the motor": (ROD, {"theta": pi / 6, "u": -2.5}),
    "on springs": (SPRING, {"x": 0, "theta": pi}),
    "a hanging crank": (CRANK, {"a": -pi / 2, **CLOSED}),
}
NONE = {
    "a quarter turn": (ROD, {"theta": pi / 2}),
    "pi to five digits": (ROD, {"theta": 3.14159}),
    "too weak a motor": (ROD, {"theta": pi / 6, "u": -2.4}),
    "the wrong sense": (ROD, {"theta": pi / 6, "u": 2.5}),
    "a moving rod": (ROD, {"theta": 0, "theta_dot": 1}),
    "a stretched spring": (SPRING, {"x": 0.1, "theta": pi}),
    "an open loop": (CRANK, {"a": -pi / 2, **CLOSED, "x": 0.4}),
    "a crank on its side": (CRANK, {"a": 0, "b": 0, "x": 0.4}),
}


def declared(scene: Scene, *equilibria: dict[str, Any]) -> Scene:
    return replace(scene, equilibria=equilibria)


@pytest.mark.parametrize("name", SHOWN)
def test_what_is_an_equilibrium_is_taken(name: str) -> None:
    scene, equilibrium = SHOWN[name]
    assert check_scene(declared(scene, equilibrium)).name == scene.name


@pytest.mark.parametrize("name", NONE)
def test_what_is_none_is_refused(name: str) -> None:
    scene, equilibrium = NONE[name]
    with pytest.raises(SceneError, match="is not shown to be an equilibrium") as refused:
        check_scene(declared(scene, equilibrium))
    assert "\n" not in str(refused.value)
    assert all(f"{key} = " in str(refused.value) for key in equilibrium)


def test_the_first_that_is_none_is_named() -> None:
    with pytest.raises(SceneError, match="theta = 1 is not"):
        check_scene(declared(ROD, {"theta": pi}, {"theta": 1}, {"theta": 2}))
