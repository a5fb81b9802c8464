"""What a text says of a special case is right in that case, and no more."""

import math

import pytest

from mechanics import check
from mechanics.kernel import Verdict
from systems import bead_on_hoop, double_pendulum, rod_pendulum
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


U = 0.0


class Rod:
    def __init__(self) -> None:
        self.u = 0.0

    def rate(self, theta, m, l, g):
        return 3 * g / (2 * l) * math.sin(theta) + 3 * self.u / (m * l**2)

    def wrong(self, theta, m, l, g):
        return 3 * g / l * math.sin(theta) + 3 * self.u / (m * l**2)


def inside(theta, m, l, g):
    u = 0.0
    return 3 * g / (2 * l) * math.sin(theta) + 3 * u / (m * l**2)


def of_the_file(theta, m, l, g):
    return 3 * g / (2 * l) * math.sin(theta) + 3 * U / (m * l**2)


def wrong(theta, m, l, g):
    u = 0.0
    return 3 * g / l * math.sin(theta) + 3 * u / (m * l**2)


def pushed(theta, m, l, g):
    u = 2.0
    return 3 * g / (2 * l) * math.sin(theta) + 2 * u / (m * l**2)


@pytest.mark.parametrize("function", [inside, of_the_file, Rod().rate])
def test_an_input_that_is_a_number_inside_of_code_is_a_case(function) -> None:
    names = {"U": "u"} if function is of_the_file else None
    (entry,) = check(rod_pendulum.scene(), function, names=names, blame=False).judged
    (told,) = entry.right_if
    assert (entry.verdict, told.split(";")[0]) == (Verdict.UNDECIDED, "u = 0, as the code says")


@pytest.mark.parametrize("function", [wrong, pushed, Rod().wrong])
def test_code_that_is_wrong_in_its_own_case_is_refuted(function) -> None:
    (entry,) = check(rod_pendulum.scene(), function, blame=False).judged
    assert (entry.verdict, entry.right_if) == (Verdict.REFUTED, ())


def test_a_line_that_only_gives_an_input_a_value_is_no_wrong_equation() -> None:
    found = check(rod_pendulum.scene(), "u = 0\ntheta'' = 3*g/(2*l)*sin(theta)", blame=False)
    assert [entry.verdict for entry in found.judged] == [Verdict.UNDECIDED] * 2


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        ("U = m*g*l/2*(1 - sin theta)\ntheta'' = 3*g/(2*l)*theta for small angles\n", "REFUTED"),
        ("U = m*g*l/2*(1 - theta^2/2), for small angles\n", "UNDECIDED"),
        ("For small angles:\nU = m*g*l/2*(1 - theta^2/2)\n", "UNDECIDED"),
    ],
)
def test_what_stands_behind_a_formula_of_a_text_is_of_that_line(text: str, verdict: str) -> None:
    answer = check(rod_pendulum.scene(), text, blame=False, notation="text")
    assert answer.judged[0].verdict.name == verdict


@pytest.mark.parametrize("frame", ["In the rotating frame", "In the frame of the hoop"])
def test_an_energy_of_another_frame_is_not_refuted(frame: str) -> None:
    text = rf"{frame} the kinetic energy is $T=\frac12mR^2\dot\theta^2$."
    assert check(bead_on_hoop.scene(), text, blame=False).verdict is Verdict.UNDECIDED
    plain = text.replace(f"{frame} the", "The")
    assert check(bead_on_hoop.scene(), plain, blame=False).verdict is Verdict.REFUTED


@pytest.mark.parametrize("wrong", ["Y = m*g", "Y = 2*m*g", "p_theta = m*theta_dot"])
def test_a_value_beside_a_wrong_reaction_makes_it_no_better(wrong: str) -> None:
    answer = check(rod_pendulum.scene(), f"l = 1\n{wrong}", blame=False)
    assert answer.verdict is Verdict.REFUTED
    assert not answer.judged[-1].right_if
