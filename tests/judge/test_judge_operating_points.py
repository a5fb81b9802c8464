"""About which place a text linearizes, and whether it does."""

from functools import cache

import pytest

from benchmarks.corpus.load import HERE, scene_of
from mechanics import check
from mechanics.equations import Equations
from mechanics.judge.check import derived
from mechanics.kernel import Verdict
from systems import bead_on_hoop

BOTTOM = r"$$\ddot\theta = (\omega^2 - g/R)\theta$$"
TOP = r"$$\ddot\theta = (\omega^2 + g/R)(\theta - \pi)$$"
APART = r"$$\ddot\theta = (\omega^2 + g/R)\theta$$"


@cache
def hoop() -> Equations:
    return derived(bead_on_hoop.scene())


def verdict(text: str) -> str:
    (entry,) = check(hoop(), text, blame=False).judged
    return entry.verdict.name


@pytest.mark.parametrize(
    "words",
    [
        r"Linearized about $\theta=\pi$:",
        r"For small angles near $\theta = \pi$",
        "Linearized about the upper equilibrium",
    ],
)
def test_the_place_is_read(words: str) -> None:
    assert verdict(f"{words} {TOP}") == "CERTIFIED"
    assert verdict(f"{words} {BOTTOM}") == "REFUTED"
    assert verdict(f"{words} {APART}") == "UNDECIDED"


@pytest.mark.parametrize(
    "words", ["For small angles", "Linearized about the lower equilibrium", "To first order"]
)
def test_without_a_place_or_below_it_is_the_bottom(words: str) -> None:
    assert verdict(f"{words} {BOTTOM}") == "CERTIFIED"
    assert verdict(f"{words} {TOP}") == "REFUTED"


@pytest.mark.parametrize("words", ["about a tilted position", "about the unstable equilibrium"])
def test_a_place_that_is_not_read_leaves_it_open(words: str) -> None:
    assert verdict(f"Linearized {words}: {BOTTOM}") == "UNDECIDED"


@pytest.mark.parametrize(
    "words",
    [
        "In contrast to the case of small angles, in general",
        "The small-angle approximation fails here; exactly,",
        "For large angles, where the linearized equation is useless,",
        "This also holds beyond small angles:",
        "Unlike the linearized equation, the exact equation is",
        "The full nonlinear equation, of which the linearized one is a special case, is",
        "Small angles are excluded.",
    ],
)
def test_a_sentence_that_speaks_of_another_equation_shows_nothing(words: str) -> None:
    assert verdict(f"{words} {BOTTOM}") == "UNDECIDED"


def test_a_decimal_is_a_place() -> None:
    assert verdict(rf"Linearized about $\theta=0.3$: {BOTTOM}") == "REFUTED"


def test_a_sentence_behind_the_equation_is_about_another() -> None:
    assert verdict(f"{BOTTOM} for small angles.") == "CERTIFIED"
    assert verdict(f"The exact equation: {BOTTOM} It was linearized nowhere.") == "REFUTED"


LINEAR = r"$$\ddot\theta = (\omega^2 - g/R)\theta$$"
FULL = r"$$\ddot\theta = (\omega^2\cos\theta - g/R)\sin\theta$$"


@pytest.mark.parametrize(
    ("text", "verdicts"),
    [
        (f"The linearized equation is {LINEAR}", {"CERTIFIED", "PROVED"}),
        (f"The nonlinear equation is {LINEAR}", {"REFUTED"}),
        (f"It can be linearized. The full nonlinear equation of motion is {LINEAR}", {"REFUTED"}),
        (f"The linearized equation is {FULL}", {"UNDECIDED"}),
        (f"The nonlinear equation is {FULL}", {"CERTIFIED", "PROVED"}),
    ],
)
def test_what_an_equation_is_called(text: str, verdicts: set[str]) -> None:
    assert verdict(text) in verdicts


@cache
def ball_on_beam() -> Equations:
    return derived(scene_of(HERE / "scenes" / "ball_beam.py", "make_scene"))


IN_LATEX = r"\[ \tfrac13 m_2l^2\ddot\theta + m_1gz = Fl - \tfrac12 m_2gl \]"
IN_TEXT = "m2*l^2/3*theta'' + m1*g*z = F*l - m2*g*l/2"
PLACES = {
    r"Linearized about $z = 0$, $\theta = 0$:": IN_LATEX,
    r"Linearized about $\theta = 0$ and $z = 0$,": IN_LATEX,
    "Linearized about z = 0, theta = 0:\n": IN_TEXT,
    "Linearised around theta = 0 and z = 0\n": IN_TEXT,
}


@pytest.mark.parametrize("words", PLACES)
def test_a_place_may_hold_several_coordinates(words: str) -> None:
    right = words + PLACES[words]
    for text, shown in ((right, True), (right.replace("+ m", "- m"), False)):
        answer = check(ball_on_beam(), text, blame=False)
        assert answer.verdict is (Verdict.PROVED if shown else Verdict.REFUTED)


def test_a_length_that_is_not_said_to_be_small_is_not() -> None:
    only = r"Linearized about $\theta = 0$:"
    assert check(ball_on_beam(), only + IN_LATEX, blame=False).verdict is Verdict.REFUTED
