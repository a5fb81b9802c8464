"""Published cart-poles, right and wrong, as the Python code that they are."""

from collections.abc import Callable

import numpy as np
import pytest
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

import mechanics
from mechanics import Particle, RigidBody, Scene, force, gravity, parameters, reaction

STATE = {"state": "x x_dot theta theta_dot"}
MIRRORED = (
    "theta is counted from the other vertical and theta is counted the other way round",
    "theta is counted from the other vertical and x is counted the other way and F is counted the"
    " other way",
)


def scene() -> Scene:
    """A uniform rod of half-length l, theta from upright, on a cart that F pushes."""
    x, theta, F = dynamicsymbols("x theta F")
    mc, mp, l, g = parameters("mc mp l g", units="kg kg m m/s^2", typical="1 0.1 0.5 9.8")
    ground, origin = ReferenceFrame("N"), Point("O")
    rod = ground.orientnew("A", "Axis", (-theta, ground.z))
    pivot = origin.locatenew("P", x * ground.x)
    centre = pivot.locatenew("C", l * rod.y)
    return Scene(
        "cart-pole", ground, origin, coordinates=(x, theta),
        bodies=(Particle("cart", pivot, mc), RigidBody("pole", centre, rod, mp, mp * l**2 / 3)),
        loads=(gravity(-g * ground.y), force("F", pivot, F * ground.x, on="cart")),
        reactions=(
            reaction("N", at=pivot, on="cart", by=None, along=ground.y),
            reaction("Tx", at=pivot, on="pole", by="cart", along=ground.x),
            reaction("Ty", at=pivot, on="pole", by="cart", along=ground.y),
        ),
        inputs=(F,),
    )  # fmt: skip


TRUTH = mechanics.derive(scene())


def cart_pole(factor: float, squared: Callable, sign: int) -> Callable:
    """Gymnasium's formulas, with what others wrote in three places."""

    def accelerations(state, force, masscart, masspole, length, gravity):
        _, _, theta, theta_dot = state
        costheta, sintheta = np.cos(theta), np.sin(theta)
        total_mass, polemass_length = masspole + masscart, masspole * length
        temp = (force + polemass_length * squared(theta, theta_dot) * sintheta) / total_mass
        thetaacc = (sign * gravity * sintheta - costheta * temp) / (
            length * (factor - masspole * np.square(costheta) / total_mass)
        )
        xacc = temp - polemass_length * thetaacc * costheta / total_mass
        return np.array([xacc, thetaacc])

    return accelerations


def of_rate(theta, theta_dot):
    return np.square(theta_dot)


def of_angle(theta, theta_dot):
    return theta**2


@pytest.mark.parametrize(
    ("function", "verdict", "right_if"),
    [
        (cart_pole(4.0 / 3.0, of_rate, 1), "PROVED", ()),  # Gymnasium
        (cart_pole(7.0 / 3.0, of_rate, 1), "REFUTED", ()),  # parallel axis counted twice
        (cart_pole(4.0 / 3.0, of_angle, 1), "REFUTED", ()),  # th^2 for th'^2
        (cart_pole(4.0 / 3.0, of_rate, -1), "REFUTED", MIRRORED),  # g = -9.8 with +g sin th
    ],
)
def test_published_cart_poles(function: Callable, verdict: str, right_if: tuple) -> None:
    found = mechanics.check(TRUTH, function, names=STATE)
    assert [entry.finding.verdict.name for entry in found.judged] == [verdict, verdict]
    assert all(entry.right_if == right_if for entry in found.judged)
    assert {match.name: match.meaning for match in found.names} == {
        "state": "x x_dot theta theta_dot", "force": "F", "masscart": "mc", "masspole": "mp",
        "length": "l", "gravity": "g",
    }  # fmt: skip


def test_folded_constants_are_listed() -> None:
    found = mechanics.check(TRUTH, cart_pole(4.0 / 3.0, of_rate, 1), names=STATE)
    assert found.judged[0].statement.notes == ("1.3333333333333333 is read as 4/3",)
