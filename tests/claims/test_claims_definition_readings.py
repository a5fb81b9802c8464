"""A definition with a slash means one thing where it is judged and where it is used."""

import pytest

from mechanics import check
from mechanics.kernel import Verdict
from systems import rod_pendulum

LAGRANGIAN = "L = 1/6m*(l*theta')^2 - m*g*l/2*cos(theta)\n"


def verdicts(text: str) -> list[str]:
    answer = check(rod_pendulum.scene(), text, blame=False)
    return [entry.verdict.name for entry in answer.judged]


@pytest.mark.parametrize(
    "equation",
    [
        "d/dt(\u2202L/\u2202theta') - \u2202L/\u2202theta = u",
        "\u2202L/\u2202theta' = m*l^2/3*theta'",
        "diff(L, theta) = m*g*l/2*sin(theta)",
    ],
)
def test_what_uses_an_energy_uses_it_as_it_is_judged(equation: str) -> None:
    assert verdicts(LAGRANGIAN + equation) == ["PROVED", "PROVED"]


def test_a_wrong_partial_derivative_is_refuted() -> None:
    text = LAGRANGIAN + "\u2202L/\u2202theta' = m*l^2/2*theta'"
    assert verdicts(text) == ["PROVED", "REFUTED"]
    assert check(rod_pendulum.scene(), text).judged[1].verdict is Verdict.REFUTED


def test_a_mixed_reading_that_no_other_mends_stays() -> None:
    text = "L = 1/6m*(l*theta')^2 - g*l/2*cos(theta)\n\u2202L/\u2202theta' = m*l^2/3*theta'"
    assert "PROVED" not in verdicts(text)[:1]
