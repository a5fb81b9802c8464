"""About which place a text linearizes, and whether it does."""

from functools import cache
from pathlib import Path

import pytest

from benchmarks.corpus.load import HERE, scene_of
from mechanics import check
from mechanics.equations import Equations
from mechanics.grading.submission import things_in
from mechanics.judge.check import derived
from mechanics.kernel import Verdict
from systems import bead_on_hoop, cylinder_in_cylinder, elastic_pendulum, rod_pendulum

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


CODE = {
    "python": "# {}\ndef rate(x, u, m, l, g):\n    th, w = x\n    return [w, {}]\n",
    "c": "/* {} */\ndouble theta_ddot(double th, double u, double m, double l, double g)"
    " {{ return {}; }}\n",
    "matlab": "function thdd = f(th, u, m, l, g)\n% {}\nthdd = {};\nend\n",
}
SUFFIX = {"python": ".py", "c": ".c", "matlab": ".m"}


@pytest.mark.sample(3)
@pytest.mark.parametrize("language", CODE)
@pytest.mark.parametrize(
    ("comment", "value", "verdict"),
    [
        ("linearized about the upright position", "1.5*g/l*th + 3*u/(m*l*l)", "PROVED"),
        ("Linearized about th = pi", "1.5*g/l*th + 3*u/(m*l*l)", "REFUTED"),
        ("linearized about th = 0", "1.5*g/l*th - 3*u/(m*l*l)", "REFUTED"),
        ("not linearized", "1.5*g/l*th + 3*u/(m*l*l)", "REFUTED"),
        ("the rod as it swings", "1.5*g/l*th + 3*u/(m*l*l)", "REFUTED"),
    ],
)
def test_comments_of_code_say_that_it_is_linearized(
    language: str, comment: str, value: str, verdict: str, tmp_path: Path
) -> None:
    path = tmp_path / f"rod{SUFFIX[language]}"
    path.write_text(CODE[language].format(comment, value))
    things = things_in(path, run_python=True)
    found = check(rod_pendulum.scene(), things, only="formulas", blame=False)
    right = found.verdict.name in ("PROVED", "CERTIFIED")
    assert (found.verdict.name == verdict) or (right and verdict == "PROVED"), str(found)


@pytest.mark.parametrize("words", ["For small angles", r"As $\sin\theta\approx\theta$ here,"])
@pytest.mark.parametrize("factor", ["2", "3"])
def test_where_constraints_hold_what_is_linearized_is_left_open(words: str, factor: str) -> None:
    text = rf"{words} $\ddot\theta + \frac{{{factor}g}}{{3(R-a)}}\theta = 0$."
    found = check(cylinder_in_cylinder.scene(), text, blame=False)
    assert found.verdict.name == "UNDECIDED"
    full = text.replace(r"\theta = 0", r"\sin\theta = 0")
    right = check(cylinder_in_cylinder.scene(), full, blame=False).verdict.name
    assert (right == "REFUTED") is (factor == "3")


def test_small_coordinates_may_be_listed() -> None:
    words = r"For small $x$ and $\theta$: $\tfrac12 ML\ddot x + \tfrac13 ML^2\ddot\theta"
    text = words + r" + {}MgL\theta = 0$"
    for factor, right in ((r"\tfrac12", True), (r"\tfrac13", False)):
        found = check(elastic_pendulum.scene(), text.replace("{}", factor), blame=False)
        assert found.ok is right
