"""Statements about loops whose lengths are numbers are judged on the component of the example."""

import pytest

from mechanics.crosscheck import derive
from mechanics.equations import Equations
from mechanics.judge.check import check
from mechanics.kernel import Verdict
from systems import four_bar_chain


@pytest.fixture(scope="module")
def parallelograms() -> Equations:
    return derive(four_bar_chain.scene(2), "kane")


RIGHT = (
    r"\ddot q_1 = 0",
    r"\dot q_0 = \dot q_4",
    "T = m*q0'^2 + m*q4'^2/3 + m*q2'^2/6",
    "(5/3)*m*q0'' + (5/3)*m*q2'' - m*q4''*5/3 - m*q0''*5/3 = 0",
)
"""Cranks and rockers of parallelograms turn equally, and couplers do not turn."""


@pytest.mark.sample(2)
@pytest.mark.parametrize("text", RIGHT)
def test_what_holds_on_the_component_is_shown(parallelograms: Equations, text: str) -> None:
    (judged,) = check(parallelograms, text, blame=False).judged
    assert judged.finding.shown, judged.finding


@pytest.mark.campaign
@pytest.mark.parametrize("text", [r"\ddot q_2 = 0", r"\dot q_0 = -\dot q_4", "T = m*q0'^2"])
def test_what_is_wrong_there_is_refuted(parallelograms: Equations, text: str) -> None:
    (judged,) = check(parallelograms, text, blame=False).judged
    assert judged.finding.verdict is Verdict.REFUTED
