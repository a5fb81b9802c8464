"""Pages as people publish them: what of their formulas is a claim, and where one goes on."""

import pytest

import mechanics
from benchmarks.corpus.load import HERE, scene_of
from mechanics.judge.check import derived

ROD = derived(scene_of(HERE / "scenes" / "bobs_and_bowls.py", "simple_ell"))
LONG = derived(scene_of(HERE / "scenes" / "rigid_pendulums.py", "simple_capital"))
SWING = r"l \ddot\theta = -g \sin\theta"


def verdicts(text: str, of: object = ROD) -> list[str]:
    found = mechanics.check(of, text, notation="latex", blame=False)
    return [entry.finding.verdict.name for entry in found.judged]


@pytest.mark.parametrize(
    "beside",
    [
        "The mass is $$m$$ and the angle $$\\theta$$.\n",  # as Jekyll marks it
        "The angle is \\\\( \\theta \\\\), its rate \\\\( \\dot{\\theta} \\\\).\n",
        r"For small angles $\sin\theta \approx \theta$, $\cos\theta\approx 1$." + "\n",
        "$$\\dot{x} = f(x, u)$$\n",
        r"The masses are $m_1 = m$ and $m_2 = 2m$." + "\n",
    ],
)
def test_what_is_no_claim_leaves_the_claim_alone(beside: str) -> None:
    assert verdicts(f"{beside}\n$${SWING}$$") == ["PROVED"]
    assert verdicts(f"{beside}\n$${SWING.replace('-g', 'g')}$$") == ["REFUTED"]


def test_a_function_that_the_text_gives_is_a_claim() -> None:
    given = r"$$f(\theta, l) = \frac{g}{l} \sin\theta$$ $$\ddot\theta = f(\theta, l)$$"
    assert verdicts(f"{given} $${SWING}$$") == ["UNDECIDED", "UNDECIDED", "PROVED"]


@pytest.mark.parametrize("second", [r"m l^2 \dot\theta^2 / 2", r"m l^2 \dot\theta^2"])
def test_a_display_that_begins_with_equals_goes_on(second: str) -> None:
    text = rf"$$T = \frac12 m (l \dot\theta)^2$$ which is $$= {second}$$"
    assert verdicts(text) == ["PROVED" if second.endswith("2") and "/" in second else "REFUTED"]


def test_an_energy_without_a_letter_is_what_words_call_it() -> None:
    heading = "The kinetic energy is\n"
    assert verdicts(heading + r"$$\frac12 m l^2 \dot\theta^2$$") == ["PROVED"]
    assert verdicts(heading + r"$$m l^2 \dot\theta^2$$") == ["REFUTED"]


def test_dots_above_a_letter_are_rates() -> None:
    limits = SWING.replace(r"\ddot\theta", r"\mathop{\theta}\limits^{..}")
    assert verdicts(f"$${limits}$$") == ["PROVED"]
    assert verdicts(f"$${limits.replace('..', '.')}$$") != ["PROVED"]


def test_the_lagrangian_in_script_is_no_length() -> None:
    energy = r"$$\mathcal{L} = \frac12 m L^2 \dot\theta^2 + m g L \cos\theta$$"
    law = r"$$\frac{d}{dt} \frac{\partial \mathcal{L}}{\partial\dot\theta} = "
    law += r"\frac{\partial \mathcal{L}}{\partial\theta}$$"
    assert verdicts(energy + law, LONG) == ["PROVED", "PROVED"]
    assert verdicts(energy.replace("+", "-") + law, LONG) == ["REFUTED", "REFUTED"]


def test_a_rate_that_the_text_alone_gives_is_put_in() -> None:
    text = r"$$T = \frac12 m l^2 \dot\psi^2$$ $$\dot\psi = 1 \dot\theta$$"
    assert verdicts(text) == ["PROVED"]
    assert verdicts(text.replace("1 ", "2 ")) == ["REFUTED"]


@pytest.mark.parametrize("number", ["2.0", r"\SI{2.0}{s}", r"2.0\,\mathrm{s}."])
def test_the_number_that_a_formula_comes_to_is_no_claim(number: str) -> None:
    text = rf"The period is $$T = 2\pi\sqrt{{\frac{{l}}{{g}}}} \approx {number}$$"
    assert verdicts(text) == ["PROVED"]
    assert verdicts(text.replace("{g}", "{2g}")) == ["REFUTED"]


def test_an_energy_holds_up_to_a_constant() -> None:
    text = r"$$V = -m g l \cos\theta + C$$"
    assert verdicts(text) == ["PROVED"]
    assert verdicts(text.replace("C", r"C \theta")) == ["UNDECIDED"]
    assert verdicts(text.replace(r"\cos", r"\sin")) == ["REFUTED"]


def test_words_and_dots_of_plain_text() -> None:
    text = "potential energy = -m*g*l*cos(θ)\nkinetic energy = m*(l*θ.)^2/2\n"
    text += "得: m*l^2*θ..+m*g*l*sinθ=0"
    found = mechanics.check(ROD, text, notation="text", blame=False)
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED"] * 3
