"""Notes as they stand in files: columns that name a state, derivatives of packages, plain text."""

import pytest

from mechanics import check
from mechanics.claims.spelled_rates import bases
from systems import bead_on_hoop, double_pendulum, rod_pendulum

STATE = (
    r"\[ \mathbf x = \begin{pmatrix} x_1 \newline x_2 \end{pmatrix} ="
    r"\begin{pmatrix} \theta \newline \dot\theta \end{pmatrix} \] then"
    r"\[ \dot{\mathbf x} = \begin{pmatrix} \dot x_1 \\ \dot x_2 \end{pmatrix} ="
    r"\begin{pmatrix} x_2 \\ \frac{3g}{2l}\sin x_1 + \frac{FACTOR u}{ml^2} \end{pmatrix}. \]"
)
FORCES = r"$$L = T + U = \frac{ml^2}{FACTOR}\dot\theta^2 - \frac{mgl}{2}\cos\theta$$"
PACKAGE = r"\pdv{L}{\theta} = FACTOR m g l \sin\theta, L = m l^2\dot\theta^2/6 - m g l\cos\theta/2"
RATE = r"\dv[2]{\theta}{t} = \frac{3g}{2l}\sin\theta + \frac{FACTOR u}{ml^2} \dots f_2"
GLUED = "R θ'' + sin(θ) g SIGN sin(θ) cos(θ) ω ωR = 0"
BOBS = """Length of the first rod: l1
L = T1 + T2 - V1 - V2 where
T1 = 1/2 m1 l1^2 φ1_dot^2 (Kinetic energy of m1)
Here and in what follows, _dot denotes the time derivative
T2 = 1/2 m2 [l1^2 φ1_dot^2 + l2^2 φ2_dot^2 SIGN 2 l1 l2 φ1_dot φ2_dot cos(φ1 - φ2)]
V1 = - m1 g l1 cos(φ1) (potential energy of m1)
V2 = - m2 g [l1 cos(φ1) + l2 cos(φ2)]
"""


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("system", "text", "right", "wrong"),
    [
        (rod_pendulum, STATE, "3", "2"),
        (rod_pendulum, FORCES, "6", "24"),
        (rod_pendulum, PACKAGE, r"\frac12", "2"),
        (rod_pendulum, f"$${RATE}$$", "3", "2"),
        (bead_on_hoop, GLUED, "-", "+"),
        (double_pendulum, BOBS, "+", "-"),
    ],
)
def test_what_stands_in_notes_is_read(system, text: str, right: str, wrong: str) -> None:  # type: ignore[no-untyped-def]
    def verdict(mark: str) -> str:
        written = text.replace("SIGN", mark).replace("FACTOR", mark)
        return check(system.scene(), written, blame=False).verdict.name

    assert (verdict(right), verdict(wrong)) == ("PROVED", "REFUTED")


def test_a_rate_is_spelled_before_its_number() -> None:
    assert ("q1", 2) in [*bases("qdotdot1")]


RIGHT = "3*g/(2*l)*sin(theta) + 3*u/(m*l^2)"


@pytest.mark.sample(4)
@pytest.mark.parametrize("rate", ["d^2 theta/dt^2", "d²θ/dt²", "d^2(theta)/dt^2", "theta''"])
@pytest.mark.parametrize(
    "before", ["", "The equation of motion is ", "Equation of motion: ", "We thus obtain: "]
)
def test_words_before_an_equation_and_its_derivative_are_read(rate: str, before: str) -> None:
    def verdict(right: str) -> str:
        return check(rod_pendulum.scene(), f"{before}{rate} = {right}", blame=False).verdict.name

    assert verdict(RIGHT) == "PROVED"
    assert verdict(RIGHT.replace("2*l", "4*l")) == "REFUTED"


@pytest.mark.parametrize(
    ("text", "verdict", "unjudged"),
    [
        (f"The rod floats, and we get theta'' = {RIGHT}", "PROVED", 1),
        (f"wrong: theta'' = {RIGHT}", "UNDECIDED", 0),
        (f"It is wrong that theta'' = {RIGHT}", "UNDECIDED", 0),
        (f"theta'' = {RIGHT} (only for small theta)", "UNDECIDED", 0),
        (f"Equation of motion: theta'' = {RIGHT}", "PROVED", 0),
    ],
)
def test_words_in_the_line_of_an_equation_are_sentences(
    text: str, verdict: str, unjudged: int
) -> None:
    answer = check(rod_pendulum.scene(), text, blame=False)
    assert answer.verdict.name == verdict
    assert len(answer.unjudged) == unjudged
