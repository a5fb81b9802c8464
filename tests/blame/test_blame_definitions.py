"""Mistakes in definitions: exchanged, in functions, in matrices, and of an operator."""

from math import radians

import numpy as np
import pytest
from particles import on_line
from sympy.physics.mechanics import dynamicsymbols

import mechanics
from mechanics.scene import Scene, parameters, spring
from systems import cartpole, double_pendulum

CART = mechanics.derive(cartpole.scene(), "free_body")
DOUBLE = mechanics.derive(double_pendulum.scene(), "free_body")

MATRICES = """
M = [{corner}, mp*l*cos(y(2)); mp*l*cos(y(2)), 4/3*mp*l^2];
h = [F + mp*l*y(4)^2*sin(y(2)); {moment}];
acc = inv(M)*h;
ydot = [y(3); y(4); acc(1); acc(2)];
"""


def _edits(reference, statement, about=None) -> list[list[tuple[str, str, str]]]:
    """Of the first repair of each statement that is wrong."""
    found = mechanics.check(reference, statement, about=about)
    wrong = [entry for entry in found.judged if entry.finding.verdict.name == "REFUTED"]
    assert wrong
    repairs = [entry.blame.repairs for entry in wrong]
    return [[(e.written, e.right, e.definition) for e in own[0].edits] for own in repairs]


def test_two_definitions_that_are_exchanged() -> None:
    def rates(theta, theta_dot, x_dot, F, g, l, mc, mp):
        s, c = np.cos(theta), np.sin(theta)
        temp = (F + mp * l * theta_dot**2 * s) / (mc + mp)
        return (g * s - c * temp) / (l * (4 / 3 - mp * c**2 / (mc + mp)))

    (edits,) = _edits(CART, rates, "theta_ddot")
    assert edits == [("cos(theta)", "sin(theta)", "s"), ("sin(theta)", "cos(theta)", "c")]


def test_degrees_where_radians_are_meant() -> None:
    def rates(theta, theta_dot, F, g, l, mc, mp):
        c = np.cos(radians(theta))
        temp = (F + mp * l * theta_dot**2 * np.sin(theta)) / (mc + mp)
        return (g * np.sin(theta) - c * temp) / (l * (4 / 3 - mp * c**2 / (mc + mp)))

    (edits,) = _edits(CART, rates, "theta_ddot")
    assert edits == [("theta*pi/180", "theta", "c")]


def test_rates_in_a_definition_of_which_functions_are_taken() -> None:
    def acceleration(phi1, phi2, phi1_dot, phi2_dot, g, l1, l2, m1, m2):
        d = phi1_dot - phi2_dot
        below = l1 * (2 * m1 + m2 - m2 * np.cos(2 * d))
        pull = phi2_dot**2 * l2 + phi1_dot**2 * l1 * np.cos(d)
        weight = g * (2 * m1 + m2) * np.sin(phi1) + m2 * g * np.sin(phi1 - 2 * phi2)
        return -(weight + 2 * np.sin(d) * m2 * pull) / below

    (edits,) = _edits(DOUBLE, acceleration, "phi1_ddot")
    assert edits == [("phi1_dot - phi2_dot", "phi1 - phi2", "d")]


@pytest.mark.parametrize(
    ("corner", "moment", "edit"),
    [
        ("mc", "mp*g*l*sin(y(2))", ("", "+ mp", "M_11")),
        ("mc + mp", "mp*g*l^2*sin(y(2))", ("l^2", "l", "h_2")),
    ],
)
def test_an_entry_of_a_matrix_that_is_inverted(corner, moment, edit) -> None:
    assert _edits(CART, MATRICES.format(corner=corner, moment=moment)) == [[edit], [edit]]


def test_the_sign_of_an_entry_of_a_matrix_in_the_line_itself() -> None:
    line = (
        r"\begin{bmatrix} m_c + m_p & m_p l\cos\theta \\ -m_p l\cos\theta & \frac43 m_p l^2"
        r"\end{bmatrix}\begin{bmatrix}\ddot x\\ \ddot\theta\end{bmatrix} ="
        r"\begin{bmatrix} F + m_p l\dot\theta^2\sin\theta \\ m_p g l\sin\theta\end{bmatrix}"
    )
    assert _edits(CART, line) == [[("-", "+", "")]]


def test_another_operator_between_two_names() -> None:
    def rates(theta, theta_dot, F, g, l, mc, mp):
        polemass = mp + l
        temp = (F + polemass * theta_dot**2 * np.sin(theta)) / (mc + mp)
        below = l * (4 / 3 - mp * np.cos(theta) ** 2 / (mc + mp))
        return (g * np.sin(theta) - np.cos(theta) * temp) / below

    (edits,) = _edits(CART, rates, "theta_ddot")
    assert edits == [("mp + l", "mp*l", "polemass")]


def test_a_fraction_that_is_upside_down() -> None:
    line = "x'' = (F/mp - l*theta''*cos(theta) + l*theta'^2*sin(theta))/(1 + mp/mc)"
    assert _edits(CART, line) == [[("mp/mc", "mc/mp", "")]]


def _oscillator() -> Scene:
    x, (m, k) = dynamicsymbols("x"), parameters("m k", units="kg N/m", typical="1 10")
    return on_line(
        "oscillator", x, m, lambda N, O, P: [spring("k", O, P, k, along=N.x, second_on="block")],
        body="block",
    )  # fmt: skip


def test_a_period_and_a_frequency() -> None:
    scene = _oscillator()
    assert _edits(scene, r"T = 2\pi\sqrt{\frac{2m}{k}}") == [[("2", "", "")]]
    assert _edits(scene, r"\omega = \sqrt{\frac{k}{3m}}") == [[("3", "", "")]]
