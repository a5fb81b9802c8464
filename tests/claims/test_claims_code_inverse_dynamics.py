"""tau = f(q, q', q''): what code returns drives the speeds; with tau an argument, a residual."""

import casadi
import numpy as np
import pytest
from notation_scenes import truth

import mechanics
from mechanics.blame.result import Mistake
from mechanics.errors import InputError
from systems import cartpole, rod_pendulum

ROD = mechanics.derive(rod_pendulum.scene(), "free_body")
CART = mechanics.derive(cartpole.scene(), "free_body")


def _verdict(truth: object, code: object, **options: object) -> str:
    return mechanics.check(truth, code, blame=False, **options).verdict.name


def rod(q, qd, qdd, m, l, g):
    return m * l**2 / 3 * qdd - m * g * l / 2 * np.sin(q)


def test_python_that_returns_what_drives() -> None:
    assert _verdict(ROD, rod) == "PROVED"
    for sign, share in ((1, 2), (-1, 3), (-1, 2)):

        def wrong(q, qd, qdd, m, l, g, sign=sign, share=share):
            return m * l**2 / 3 * qdd + sign * m * g * l / share * np.sin(q)

        right = (sign, share) == (-1, 2)
        assert _verdict(ROD, wrong) == ("PROVED" if right else "REFUTED")


def test_twice_a_drive_is_no_drive_although_twice_a_residual_is_one() -> None:
    assert _verdict(ROD, lambda q, qd, qdd, m, l, g: 2 * rod(q, qd, qdd, m, l, g)) == "REFUTED"

    def residual(q, qd, qdd, u, m, l, g):
        return 2 * (rod(q, qd, qdd, m, l, g) - u)

    assert _verdict(ROD, residual) == "PROVED"

    def wrong(q, qd, qdd, u, m, l, g):
        return rod(q, qd, qdd, m, l, g) - 2 * u

    assert _verdict(ROD, wrong) == "REFUTED"


C = """
#include <math.h>
double torque(double theta, double theta_dot, double theta_ddot, double m, double l, double g)
{
    return m*l*l/3*theta_ddot - m*g*l/2*sin(theta);
}
"""


def test_c_and_casadi_that_return_what_drives() -> None:
    assert _verdict(ROD, C, notation="c") == "PROVED"
    assert _verdict(ROD, C.replace("l/2", "l"), notation="c") == "REFUTED"
    names = ("q", "qd", "qdd", "m", "l", "g")
    q, qd, qdd, m, l, g = (casadi.SX.sym(name) for name in names)
    for factor in (2, 3):
        tau = m * l**2 / 3 * qdd - m * g * l / factor * casadi.sin(q)
        function = casadi.Function("tau", [q, qd, qdd, m, l, g], [tau], list(names), ["tau"])
        assert _verdict(ROD, function) == ("PROVED" if factor == 2 else "REFUTED")


def cart(q, qd, qdd, mc, mp, l, g):
    (_, theta), (_, w), (a, alpha) = q, qd, qdd
    c, s = np.cos(theta), np.sin(theta)
    force = (mc + mp) * a + mp * l * (alpha * c - w**2 * s)
    moment = mp * l * (4 / 3 * l * alpha + a * c - g * s)
    return np.array([force, moment])


@pytest.mark.campaign
def test_all_freedoms_and_only_those_that_are_driven() -> None:
    assert _verdict(CART, cart) == "PROVED"
    for one, other in ((2, 1), (1, 2), (1, -1)):

        def scaled(q, qd, qdd, mc, mp, l, g, one=one, other=other):
            force, moment = cart(q, qd, qdd, mc, mp, l, g)
            return np.array([one * force, other * moment])

        assert _verdict(CART, scaled) == "REFUTED"
    assert _verdict(CART, lambda q, qd, qdd, mc, mp, l, g: cart(q, qd, qdd, mc, mp, l, g)[0]) == (
        "PROVED"
    )
    assert _verdict(CART, lambda q, qd, qdd, mc, mp, l, g: -cart(q, qd, qdd, mc, mp, l, g)[0]) == (
        "REFUTED"
    )


VALUES = {"m": 2, "l": "0.5", "g": "9.81"}


def test_numbers_of_a_robot_stand_for_parameters() -> None:
    def drive(q, qd, qdd):
        return 2 * 0.25 / 3 * qdd - 2 * 9.81 * 0.5 / 2 * np.sin(q)

    def wrong(q, qd, qdd, m, l, g):
        return m * l**2 / 3 * qdd - 3 * m * g * l / 2 * np.sin(q)

    assert _verdict(ROD, drive, values=VALUES) == "PROVED"
    assert _verdict(ROD, drive, values={**VALUES, "m": 3}) == "REFUTED"
    (entry,) = mechanics.check(ROD, wrong, values=VALUES).judged
    assert entry.finding.verdict.name == "REFUTED"
    assert entry.blame is not None and entry.blame.repairs
    (edit,) = entry.blame.repairs[0].edits
    assert edit.mistake is Mistake.FACTOR


@pytest.mark.parametrize("share", [3, 4])
def test_an_action_named_like_accelerations_is_asked_for(share: int) -> None:
    def rates(s, a, m, l, g):
        theta, omega = s
        return omega, 3 * g / (2 * l) * np.sin(theta) + share * a / (m * l**2)

    with pytest.raises(InputError, match="returns rates of a state"):
        _verdict(ROD, rates)
    expected = "PROVED" if share == 3 else "REFUTED"
    assert _verdict(ROD, rates, names={"a": "u"}) == expected


TORQUES = """
#include <math.h>
double {}(double theta1, double theta2, double theta1_dot, double theta2_dot, double theta1_ddot,
          double theta2_ddot, double m1, double m2, double l1, double l2, double g)
{{
    double c2 = cos(theta2), s2 = sin(theta2);
    double both = m2*l2*l2*(theta1_ddot + theta2_ddot) + m2*l1*l2*(c2*theta1_ddot
                  + s2*theta1_dot*theta1_dot) + m2*l2*g*cos(theta1 + theta2);
    double inner = (m1 + m2)*l1*l1*theta1_ddot + m2*l1*l2*(c2*(theta1_ddot + theta2_ddot)
                   - s2*(theta1_dot + theta2_dot)*(theta1_dot + theta2_dot))
                   + (m1 + m2)*l1*g*cos(theta1);
    return {};
}}
"""


@pytest.mark.parametrize(
    ("name", "value", "about"),
    [
        ("tau2", "both", None), ("compute_tau1", "both + inner", None),
        ("second", "both", "tau2"), ("f", "both + inner", "tau1"),
    ],
)  # fmt: skip
def test_one_torque_of_several_by_its_name(name: str, value: str, about: str | None) -> None:
    arm = truth("arm")
    assert _verdict(arm, TORQUES.format(name, value), notation="c", about=about) == "PROVED"
    for wrong in ("inner", "both - inner", "2*both"):
        code = TORQUES.format(name, wrong)
        assert _verdict(arm, code, notation="c", about=about) == "REFUTED"
