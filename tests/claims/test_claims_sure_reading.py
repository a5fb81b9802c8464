"""What code returns is read by what shows it; what only is taken so is not refuted."""

from mechanics.judge.check import check
from systems import bead_on_hoop, double_pendulum


def test_code_that_takes_a_momentum_returns_its_rate():
    from numpy import cos, sin

    def rhs(theta, p_theta, R, m, g, omega):
        force = m * R**2 * omega**2 * sin(theta) * cos(theta) - m * g * R * sin(theta)
        return p_theta / (m * R**2), force

    assert check(bead_on_hoop.scene(), rhs, blame=False).verdict.name == "PROVED"


def test_what_takes_no_speeds_is_not_refuted_as_accelerations():
    from numpy import sin

    def weight(phi1, phi2, m1, m2, l1, l2, g):
        return (m1 + m2) * g * l1 * sin(phi1), m2 * g * l2 * sin(phi2)

    answer = check(double_pendulum.scene(), weight, blame=False)
    assert all(entry.open and entry.right_if for entry in answer.judged)
