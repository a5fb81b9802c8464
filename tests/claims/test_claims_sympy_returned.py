"""SymPy's objects that a function returns, or a list holds, are judged as the objects are."""

import pytest
from sympy import Eq, Function, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import mechanics
from mechanics.errors import InputError
from mechanics.judge.check import derived
from systems import rod_pendulum

ROD = derived(rod_pendulum.scene())
t, g, l, m = symbols("t g l m")
theta, u = dynamicsymbols("theta"), Function("u")(t)


def right():
    return Eq(theta.diff(t, 2), 3 * g / (2 * l) * sin(theta) + 3 * u / (m * l**2))


def wrong(k=2):
    return [Eq(theta.diff(t, k), 3 * g / l * sin(theta) + 3 * u / (m * l**2))]


def changing(count=[2]):  # noqa: B006
    count[0] += 1
    return count[0] * theta.diff(t, 2) - sin(theta)


@pytest.mark.parametrize(
    ("thing", "verdict"),
    [
        (right, "PROVED"), (wrong, "REFUTED"), ([[right()]], "PROVED"), ([wrong()], "REFUTED"),
        ([[right(), "theta'' = g"]], "REFUTED"),
    ],
)  # fmt: skip
def test_verdict(thing, verdict: str) -> None:
    assert mechanics.check(ROD, thing, blame=False).verdict.name == verdict


def test_one_that_changes_is_refused() -> None:
    with pytest.raises(InputError, match="returns Add"):
        mechanics.check(ROD, changing, blame=False)
