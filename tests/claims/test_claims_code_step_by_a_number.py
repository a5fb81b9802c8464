"""Next states whose step is a number of the code, accelerations by the name of a function."""

import pytest
from sympy.physics.mechanics import dynamicsymbols

import mechanics
from benchmarks.corpus.builders import P, pendulum, two_masses
from mechanics.errors import InputError
from mechanics.scene import force


def masses():
    x1, x2 = dynamicsymbols("x1 x2")
    m1, m2, k = P("m1:kg m2:kg k:N/m")
    return two_masses(
        (x1, x2), (m1, m2),
        lambda N, A, B: [force("a", A, k * (x2 - x1) * N.x, on="one"),
                         force("b", B, k * (x1 - x2) * N.x, on="two")],
    )  # fmt: skip


@pytest.mark.parametrize("sign, verdict", [("-", "PROVED"), ("+", "UNDECIDED")])
def test_a_step_by_a_number_of_the_code(sign: str, verdict: str) -> None:
    """The other sign is right from the other vertical, which nobody declares."""
    space: dict = {}
    exec(
        "from math import sin\ndef step(theta, theta_dot, g, l):\n    STEP = 0.02\n"
        f"    a = 2 * g / (2 * l) * sin(theta)\n"
        f"    return theta + STEP * theta_dot, theta_dot {sign} STEP * a",
        space,
    )
    m, l, g = P("m:kg l:m g:m/s^2")
    found = mechanics.check(
        pendulum(dynamicsymbols("theta"), m, 0, l, g), space["step"], blame=False
    )
    assert found.verdict.name == verdict


def test_the_name_of_a_function_says_which_acceleration_it_returns() -> None:
    def compute_x2dd(x1, x2, k, m2):
        return k * (x1 - x2) / m2

    def compute_x1dd(x1, x2, k, m2):
        return k * (x1 - x2) / m2

    assert mechanics.check(masses(), compute_x2dd).verdict.name == "PROVED"
    assert mechanics.check(masses(), compute_x1dd, blame=False).verdict.name == "REFUTED"


def test_rates_that_are_added_to_the_state_are_no_step_of_time_one() -> None:
    space: dict = {}
    exec(
        "from math import sin\ndef rates(theta, theta_dot, g, l):\n"
        "    return theta + theta_dot, theta_dot - g/l*sin(theta)",
        space,
    )
    m, l, g = P("m:kg l:m g:m/s^2")
    scene = pendulum(dynamicsymbols("theta"), m, 0, l, g)
    with pytest.raises(InputError, match="dt = 1"):
        mechanics.check(scene, space["rates"], blame=False)
