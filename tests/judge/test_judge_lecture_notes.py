"""Lecture notes: laws, names of rates, steps and limits beside what is claimed."""

import pytest

from tests.notation_scenes import judged, verdicts

MOTION = r"$$l\ddot\theta = -SIGN g\sin\theta$$"
RIGHT, WRONG = MOTION.replace("SIGN", ""), MOTION.replace("SIGN", "2")


def verdict(text: str, name: str = "pendulum") -> str:
    return judged(name, text).verdict.name


@pytest.mark.sample(4)
@pytest.mark.parametrize(
    "words",
    [
        "A bob of mass $m$ hangs on a string of fixed length $l$ and negligible mass.",
        "Only the bob has any potential energy.",
        "We ignore terms of higher order.",
        r"The angular speed is $\omega = \dot\theta$.",
        r"$\frac d{dt}\frac{\partial L}{\partial\dot\theta}=\frac{\partial L}{\partial\theta}$ so",
        r"With the period $T$ we have $2\pi = \omega T$, and $T = 2\pi\sqrt{l/g}$.",
        r"The bob hangs at the distance $l = 2 A/3$ from the pivot.",
        r"$$T = T_a + T_b = \frac12 m l^2\dot\theta^2$$",
        r"If $\theta$ is the angle between the string and the vertical, it can be any.",
        r"The angular speed is $\omega = \dot\theta \ne l$.",
        "Without an external torque the equation is as follows.",
        "Gravity is $g$ (\u2248 9.81).",
        "\u30aa\u30a4\u30e9\u30fc\uff1d\u30e9\u30b0\u30e9\u30f3\u30b8\u30e5",
    ],
)
def test_what_the_scene_says_too_does_not_stop_a_page(words: str) -> None:
    assert verdict(f"{words}\n{RIGHT}") == "PROVED"
    assert verdict(f"{words}\n{WRONG}") == "REFUTED"


@pytest.mark.parametrize(
    "words",
    [
        "Only the cart moves, and the bob is at rest.",
        "We ignore gravity.",
        "We neglect terms that are not small.",
        r"The force is $R = 3 m g$.",
        r"The bob hangs at the distance $l = 2 A/3$ from the pivot, where $A = 7 m$.",
        r"$$T = T_a + V_b = \frac12 m l^2\dot\theta^2$$",
        r"If $\theta$ is the angle of rest, we have",
        "It holds for angles (\u2248 0).",
        "\u3042\uff1d\u3042",
        r"With the period $T$ we have $2\pi = \omega T$, and $T = 2\pi\sqrt{g/l}$.",
    ],
)
def test_what_it_does_not_say_does(words: str) -> None:
    assert verdict(f"{words}\n{RIGHT}") != "PROVED"


def test_each_side_of_a_chain_says_what_one_name_of_its_own_is() -> None:
    chain = r"$$T = \frac12 I w^2 + \frac12 m v^2 = \frac12 m (l w)^2 = \frac12 m l^2\dot\theta^2$$"
    assert verdict(chain) == "PROVED"
    assert verdict(chain.replace(r"\frac12 m l^2\dot", r"m l^2\dot")) == "REFUTED"
    assert verdict(r"$$T = \frac12 w^2 = \frac13 w^2 = \frac12 m l^2\dot\theta^2$$") == "UNDECIDED"


def test_the_hamiltonian_of_any_motion_is_named_by_p_q_and_l() -> None:
    law = r"$$H = p\dot q - L = \frac12 m l^2\dot\theta^2 - m g l\cos\theta$$"
    assert verdict(law) == "PROVED"
    assert verdict(law.replace(r"\frac12", "")) == "REFUTED"
    assert verdict(law.replace("- L", "+ L")) == "UNDECIDED"


STEP = r"""
$$\frac{d}{dt}\frac{\partial L}{\partial\dot\theta} = \frac{d}{dt}(FACTOR m l^2\dot\theta)
  = FACTOR m l^2\ddot\theta$$
$$p_\theta = FACTOR m l^2\dot\theta$$
"""


def test_a_momentum_is_judged_beside_the_step_that_has_its_rate() -> None:
    assert verdicts("pendulum", STEP.replace("FACTOR", "")) == ["PROVED", "PROVED"]
    assert verdicts("pendulum", STEP.replace("FACTOR", "2")) == ["REFUTED", "REFUTED"]


@pytest.mark.parametrize(
    ("energy", "expected"),
    [("m g y", "PROVED"), ("-m g y", "UNDECIDED"), (r"-m g l\cos\theta", "PROVED")],
)
def test_the_height_of_the_only_body_may_show_and_refutes_nothing(
    energy: str, expected: str
) -> None:
    assert verdict(f"$$V = {energy}$$") == expected


def test_a_number_behind_a_letter_belongs_to_its_name() -> None:
    height = r"$$V = -m1 g l1\cos\varphi1 - m_2 g (l1\cos\varphi_1 + l2\cos\varphi2)$$"
    assert verdict(height, "double") == "PROVED"
    assert verdict(height.replace("m1 g", "m2 g"), "double") == "REFUTED"


def test_a_slip_of_the_pen_may_show_and_refutes_nothing() -> None:
    slip = "l*theta'' = -FACTOR*g*sin(Theta)"
    assert verdict(slip.replace("FACTOR", "1")) == "PROVED"
    assert verdict(slip.replace("FACTOR", "2")) == "UNDECIDED"


DRAWN = """
          -FACTOR g sin(theta)
theta'' = -----------------
                  l
"""


def test_a_fraction_that_is_drawn_is_one() -> None:
    assert verdict(DRAWN.replace("FACTOR", "1")) == "PROVED"
    assert verdict(DRAWN.replace("FACTOR", "2")) == "REFUTED"


CONSERVED = r"""
$$E' = T' + V_g + V_s = \frac12 m l^2\dot\theta^2 - FACTOR m g l\cos\theta = \text{constant}$$
"""


def test_an_energy_by_any_name_is_what_is_said_to_be_constant() -> None:
    assert verdict(CONSERVED.replace("FACTOR", "")).startswith("PROVED")
    assert verdict(CONSERVED.replace("FACTOR", "2")) == "REFUTED"


@pytest.mark.parametrize(
    ("said", "expected"),
    [
        (r"The speed of the bob is $v_b = l\dot\theta$.", "PROVED"),
        (r"The speed of the bob is $v_b = 2l\dot\theta$.", "REFUTED"),
        (r"$$v_b = l\dot\theta$$", "UNDECIDED"),
    ],
)
def test_a_speed_that_prose_names_is_the_scenes(said: str, expected: str) -> None:
    assert verdict(f"{said}\n{RIGHT}") == expected


@pytest.mark.parametrize(
    "said", ["where $y$ is the depth of the bob", "The y axis points downwards.", "y is the depth."]
)
def test_a_height_of_which_the_text_speaks_is_no_guess(said: str) -> None:
    assert verdict(f"$$V = m g y$$ {said}") == "UNDECIDED"


@pytest.mark.parametrize(
    "words", ["Une masse $m$ est suspendue par une tige sans masse.", "una varilla sin masa"]
)
def test_what_has_no_mass_is_read_in_other_languages(words: str) -> None:
    assert verdict(f"{words}\n\n{RIGHT}") == "PROVED"


@pytest.mark.parametrize(
    "page",
    [
        ".. math::\n    %s\n    :label: swing\n\nThat is all.",
        "**Swing** (of the bob):\n%s",
        "**Swing to and fro** (with gravity):\n\n%s",
    ],
)
def test_headings_and_labels_of_a_formula_are_none(page: str) -> None:
    latex = "math" in page
    right = r"l\ddot\theta = -g\sin\theta" if latex else "l*theta'' = -g*sin(theta)"
    assert verdict(page.replace("%s", right)) == "PROVED"
    assert verdict(page.replace("%s", right.replace("g", "l"))) == "REFUTED"
