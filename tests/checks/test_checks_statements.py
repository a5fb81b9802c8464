"""Energies are known up to what is constant; reactions are told by any equation between them."""

import pytest

import mechanics
from mechanics.kernel import Verdict
from systems import elastic_pendulum, four_bar, rod_pendulum

ENERGY = "m*l^2*theta'^2/6 + m*g*l/2*cos(theta)"
POTENTIAL = (
    "g*l1*m1*sin(q1)/2 + g*m2*(l1*sin(q1) + l2*sin(q2)/2)"
    " + g*m3*(l1*sin(q1) + l2*sin(q2) + l3*sin(q3)/2)"
)


def verdict(scene: mechanics.Scene, text: str) -> Verdict:
    (entry,) = mechanics.check(scene, text, notation="text", blame=False).judged
    return entry.finding.verdict


@pytest.mark.parametrize("more", ["", " + m*g*l", " - 3*m*g*l"])
def test_an_energy_is_known_up_to_a_constant(more: str) -> None:
    assert verdict(rod_pendulum.scene(), f"E = {ENERGY}{more}") is Verdict.PROVED


@pytest.mark.parametrize("more", ["m*l^2*theta''", "X*l", "m*g*l*theta", "m*l^2*theta'"])
def test_what_moves_is_no_constant(more: str) -> None:
    assert verdict(rod_pendulum.scene(), f"E = {ENERGY} + {more}") is Verdict.REFUTED


def test_on_a_constraint_too() -> None:
    scene = four_bar.scene()
    assert verdict(scene, f"V = {POTENTIAL} + m1*l1*g") is Verdict.PROVED
    assert verdict(scene, f"V = {POTENTIAL} + m1*l1^2*q1''") is Verdict.REFUTED


@pytest.mark.parametrize("factor", ["M", "2*M*cos(theta)"])
@pytest.mark.parametrize(("weight", "expected"), [("m", "PROVED"), ("M", "REFUTED")])
def test_a_relation_between_reactions_may_be_scaled(
    factor: str, weight: str, expected: str
) -> None:
    text = f"{factor}*N1 = {factor}*(N + {weight}*g)"
    assert verdict(elastic_pendulum.scene(), text).name == expected
