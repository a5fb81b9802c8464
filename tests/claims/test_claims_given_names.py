"""Names that a person gives stand before operators and spellings, but behind the scene's own."""

import pytest

import mechanics
from mechanics.kernel import Verdict
from systems import double_pendulum, elastic_pendulum


def verdict(scene: mechanics.Scene, text: str, names: dict[str, str]) -> Verdict:
    (entry,) = mechanics.check(scene, text, names=names, notation="text", blame=False).judged
    return entry.finding.verdict


def test_a_coordinate_may_be_called_like_the_operator() -> None:
    text = "(M + m)*D(t).diff(t, 2) + 2*k*D(t) = -M*L/2*(theta''*cos(theta) - theta'**2*sin(theta))"
    assert verdict(elastic_pendulum.scene(), text, {"D": "x"}) is Verdict.PROVED


@pytest.mark.parametrize("rate", ["phi2_dot", "phi2dot", "phi2'"])
def test_the_rate_of_the_second_is_no_second_rate_of_what_is_called_without_a_number(
    rate: str,
) -> None:
    text = (
        f"(m1 + m2)*l1*phi_ddot + m2*l2*phi2_ddot*cos(phi - phi2)"
        f" + m2*l2*{rate}**2*sin(phi - phi2) + (m1 + m2)*g*sin(phi) = 0"
    )
    assert verdict(double_pendulum.scene(), text, {"phi": "phi1"}) is Verdict.PROVED
