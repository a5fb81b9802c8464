"""What a text says of an equilibrium, and of a momentum along an axis."""

from functools import cache

import pytest

import mechanics
from mechanics.equations import Equations
from mechanics.judge.check import derived
from systems import bead_on_hoop
from tests.notation_scenes import verdicts


@cache
def hoop() -> Equations:
    return derived(bead_on_hoop.scene())


def on_hoop(text: str) -> list[str]:
    found = mechanics.check(hoop(), text, blame=False)
    return [entry.finding.verdict.name for entry in found.judged]


@pytest.mark.parametrize(
    ("formula", "verdict"),
    [
        (r"\cos\theta_0 = g/(\omega^2 R)", "PROVED"),
        (r"\omega^2 R\cos\theta_e = g", "PROVED"),
        (r"\cos\theta_0 = 2g/(\omega^2 R)", "REFUTED"),
        (r"\sin\theta_0 = g/(\omega^2 R)", "REFUTED"),
        (r"\cos\theta_0 = \omega^2 R/g", "REFUTED"),
        (r"g\theta_0 = 0", "PROVED"),
        (r"g(\theta_0 - 1) = 0", "REFUTED"),
    ],
)
def test_equilibria(formula: str, verdict: str) -> None:
    assert on_hoop(f"There is an equilibrium at ${formula}$.") == [verdict]


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        (r"Equilibria: $\theta=0$ and $\cos\theta = g/(\omega^2 R)$.", "PROVED"),
        (r"In equilibrium $mg\sin\theta = m\omega^2R\sin\theta\cos\theta$.", "PROVED"),
        (r"At rest $\cos\theta = g/(\omega^2 R)$.", "PROVED"),
        (r"At rest $\cos\theta = 2g/(\omega^2 R)$.", "REFUTED"),
        (r"The bead rests where $\cos\theta = g/(\omega^2 R)$.", "PROVED"),
        (r"The bead rests where $\sin\theta = g/(\omega^2 R)$.", "REFUTED"),
        (r"Equilibria: $\cos\theta = \omega^2 R/g$.", "REFUTED"),
        (r"In equilibrium $mg\sin\theta = m\omega^2R\sin\theta$.", "REFUTED"),
        (r"In equilibrium $\theta = \arccos\frac{g}{R\omega^2}$.", "PROVED"),
        (r"In equilibrium $\theta = -\arccos\frac{g}{R\omega^2}$.", "PROVED"),
        (r"In equilibrium $\theta = \arcsin\frac{g}{R\omega^2}$.", "REFUTED"),
        (r"Equilibria satisfy $\sin\theta = 0$.", "PROVED"),
        (r"Equilibria satisfy $\sin\theta\,(\omega^2\cos\theta - g/R) = 0$.", "PROVED"),
        (
            r"Equilibria: $\sin\theta\,(\omega^2\cos\theta - g/R)(\cos\theta - 2/3) = 0$.",
            "REFUTED",
        ),
        (r"No equilibrium has $\cos\theta = \frac{g}{R\omega^2}$.", "UNDECIDED"),
        (r"There is no equilibrium with $\cos\theta = \frac{g}{R\omega^2}$.", "UNDECIDED"),
        (r"Away from equilibrium $\cos\theta = \frac{g}{R\omega^2}$.", "UNDECIDED"),
        (r"We look for equilibria. A constraint is $\cos\theta = g/(\omega^2 R)$.", "REFUTED"),
    ],
)
def test_a_sentence_on_equilibria_is_about_the_angle_at_rest(text: str, verdict: str) -> None:
    assert on_hoop(text) == [verdict]


JACOBI = r"\frac12 mR^2\dot\theta^2 %s \frac12 mR^2\omega^2\sin^2\theta - mgR\cos\theta"


@pytest.mark.parametrize("rate", [r"\dot E = 0", r"\frac{dE}{dt} = 0"])
def test_what_prose_says_of_the_rate_of_an_energy_is_judged(rate: str) -> None:
    text = f"The energy $E = {JACOBI % '+'}$ is conserved, ${rate}$."
    # It is T + V, which is not conserved: the sentence says so twice, in a word and in a formula.
    assert on_hoop(text) == ["PROVED", "REFUTED", "REFUTED"]
    assert on_hoop(
        r"At rest $\dot\theta = 0$; $\ddot\theta = (\omega^2\cos\theta-g/R)\sin\theta$."
    ) == ["PROVED"]


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        (rf"${JACOBI % '-'} = \text{{const}}$", ["PROVED"]),
        (rf"${JACOBI % '+'} = \text{{const}}$", ["REFUTED"]),
        (r"$p_\theta = mR^2\dot\theta = \mathrm{const}$", ["PROVED", "REFUTED"]),
    ],
)
def test_what_is_said_to_be_constant_has_the_rate_zero(text: str, verdict: list[str]) -> None:
    assert on_hoop(text) == verdict


@pytest.mark.parametrize(("sign", "verdict"), [("-", "PROVED"), ("+", "REFUTED")])
def test_p_is_the_only_momentum(sign: str, verdict: str) -> None:
    rest = r"\frac12 mR^2\omega^2\sin^2\theta - mgR\cos\theta"
    assert on_hoop(rf"$H = \frac{{p^2}}{{2mR^2}} {sign} {rest}$") == [verdict]
    assert (
        on_hoop(rf"$p = mR^2\dot\theta$, $H = \frac{{p^2}}{{2mR^2}} {sign} {rest}$")[-1] == verdict
    )


def test_the_rate_of_a_bracket_in_plain_text() -> None:
    right = "m*R^2*omega^2*sin(theta)*cos(theta) - m*g*R*sin(theta)"
    assert on_hoop(f"d/dt(m*R^2*theta') = {right}") == ["PROVED"]
    assert on_hoop(f"d/dt(m*R*theta') = {right}") == ["REFUTED"]


def test_what_it_is_read_as() -> None:
    (entry,) = mechanics.check(hoop(), r"\cos\theta_0 = g/(\omega^2 R)", blame=False).judged
    assert "theta_0 is read as theta at an equilibrium" in entry.statement.notes


def test_a_momentum_is_along_the_axis_of_its_name() -> None:
    assert verdicts("pendulum", r"P_x = ml\dot\theta\cos\theta") == ["PROVED"]
    assert verdicts("pendulum", r"P_y = ml\dot\theta\cos\theta") == ["REFUTED"]
    assert verdicts("pendulum", r"P_x = -ml\dot\theta\cos\theta") == ["REFUTED"]
