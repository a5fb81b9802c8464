"""What a text says of a special case is right in that case, and no more."""

import pytest

from mechanics import check
from mechanics.kernel import Verdict
from systems import double_pendulum, rod_pendulum
from tests.notation_scenes import verdicts

FREE = r"\ddot\theta=\frac{3g}{2l}\sin\theta"
EQUAL = (
    r"2l\ddot\varphi_1+l\ddot\varphi_2\cos(\varphi_1-\varphi_2)"
    r"+l\dot\varphi_2^2\sin(\varphi_1-\varphi_2)+2g\sin\varphi_1=0"
)


@pytest.mark.parametrize(
    ("text", "case"),
    [
        (rf"For $u=0$ we have ${FREE}$.", "u = 0, as the text says"),
        (rf"Without torque, ${FREE}$.", "u = 0, as the text says"),
        (
            r"For $l=1\,\mathrm{m}$ and $u=0$: $\ddot\theta=\frac{3}{2}g\sin\theta$.",
            "l = 1, u = 0, as the text says",
        ),
    ],
)
def test_what_is_right_in_the_case_of_the_text_is_not_refuted(text: str, case: str) -> None:
    (entry,) = check(rod_pendulum.scene(), text, blame=False).judged
    assert (entry.verdict, entry.right_if) == (Verdict.UNDECIDED, (case,))


def test_equal_parameters_of_a_text_are_a_case_too() -> None:
    text = rf"For $m_1=m_2=m$ and $l_1=l_2=l$: ${EQUAL}$"
    answer = check(double_pendulum.scene(), text, blame=False)
    assert answer.verdict is Verdict.UNDECIDED
    assert answer.judged[-1].right_if == ("l2 = l1, m2 = m1, as the text says",)


@pytest.mark.parametrize(
    "text",
    [
        r"For $u=0$ we have $\ddot\theta=\frac{g}{l}\sin\theta$.",
        r"For $u=1$ we have $\ddot\theta=\frac{3g}{2l}\sin\theta$.",
        rf"${FREE}$. For $u=0$ that is plain.",
    ],
)
def test_what_is_wrong_in_that_case_or_before_it_stays_refuted(text: str) -> None:
    assert check(rod_pendulum.scene(), text, blame=False).verdict is Verdict.REFUTED


CASE = r"$$T = m g + FACTOR m l\dot\theta^2 \quad\text{for}\quad \theta = 0$$"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (CASE.replace("FACTOR", ""), ["UNDECIDED"]),
        (r"$$l\ddot\theta = -g\sin\theta \quad\text{for}\quad \theta = 0$$", ["PROVED"]),
        (r"$$l\ddot\theta = -2g\sin\theta, \quad \theta = 0$$", ["REFUTED", "REFUTED"]),
        (r"$$l\ddot\theta = -2g\sin\theta \quad\text{where}\quad g = 10$$", ["REFUTED"]),
    ],
)
def test_a_case_behind_an_equation_is_no_claim(text: str, expected: list[str]) -> None:
    assert verdicts("pendulum", text) == expected
