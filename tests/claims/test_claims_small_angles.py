"""Equations for small angles are REFUTED, and told to be right to first order; no others are."""

import pytest

from mechanics.claims.read import read_source
from mechanics.judge.check import check, derived
from mechanics.judge.small_angles import right_for_small_angles
from mechanics.kernel import Finding, Verdict
from systems import elastic_pendulum, four_bar

SCENE = elastic_pendulum.scene()
SECOND = "M*L^2/3*theta'' + M*L/2*x''{} + M*g*L/2*{} = 0"
REFUTED = Finding("", Verdict.REFUTED, "")


def told(text: str) -> tuple[str, ...]:
    statements = read_source(SCENE, text).statements
    return right_for_small_angles(derived(SCENE), statements, [REFUTED] * len(statements))


@pytest.mark.parametrize(
    "text",
    [
        SECOND.format("", "theta"),
        SECOND.format("*cos(theta)", "theta"),
        r"\frac{M L^2}{3} \ddot{\theta} + \frac{M L}{2} \ddot{x} + \frac{M g L}{2} \theta = 0",
        "(M + m)*x'' + M*L/2*theta'' + 2*k*x = 0\n" + SECOND.format("", "theta"),
    ],
)
def test_linearized_equations_are_right_to_first_order(text: str) -> None:
    assert told(text) == ("linearized about theta = 0 (to first order, for small angles)",)


@pytest.mark.parametrize(
    "text",
    [
        SECOND.format("", "2*theta"),
        SECOND.format("", "theta").replace("L^2/3", "L^2/12"),
        SECOND.format("", "theta").replace("+ M*g", "- M*g"),
        SECOND.format("", "theta + theta'^2"),
        SECOND.format("", "theta + theta^2"),
        SECOND.format("", "theta + x'*theta'*sin(theta)"),
        SECOND.format("", "(theta + 1)"),
        SECOND.format("", "tan(theta)"),
        "theta*theta = 0",
        "(M + m)*x'' + M*L*theta'' + 2*k*x = 0\n" + SECOND.format("", "theta"),
        "L = M*theta'^2/2",
    ],
)
def test_what_is_wrong_to_first_order_or_hides_more_is_not_told(text: str) -> None:
    assert told(text) == ()


def test_scenes_with_constraints_are_left_out() -> None:
    truth = derived(four_bar.scene())
    assert right_for_small_angles(truth, (), ()) == ()


def test_it_is_told_beside_a_refutation() -> None:
    (entry,) = check(SCENE, SECOND.format("", "theta"), blame=False).judged
    assert entry.finding.verdict is Verdict.REFUTED
    assert entry.right_if == told(SECOND.format("", "theta"))


@pytest.mark.parametrize(
    ("words", "right"),
    [
        (r"With $\theta$ small,", True),
        ("Linearized about the lower position,", True),
        ("For a small pitch", True),
        ("Without linearization", False),
        ("Before linearizing,", False),
        ("This is not linearized:", False),
        ("Small angles are not assumed:", False),
    ],
)
def test_what_the_text_says_of_small_angles(words: str, right: bool) -> None:
    formula = r"\frac{L}{3}\ddot\theta + \frac12\ddot x + \frac g2\theta = 0"
    found = check(derived(SCENE), f"{words} ${formula}$.", blame=False)
    assert found.ok if right else found.verdict is Verdict.REFUTED


def test_what_is_said_behind_an_equation_is_about_another() -> None:
    formula = r"\frac{L}{3}\ddot\theta + \frac12\ddot x + \frac g2\theta = 0"
    text = f"The equation is ${formula}$. We linearize it later."
    assert check(derived(SCENE), text, blame=False).verdict is Verdict.REFUTED
