"""Chains of equalities: each link is an equation, and a name amid them is the person's own."""

import pytest

import mechanics
from mechanics.judge.check import derived
from systems import elastic_pendulum

PIVOT = derived(elastic_pendulum.scene())
TURN = r"-\frac{3}{2L}(\ddot x\cos\theta + g\sin\theta)"
PUSH = r"-\frac{2kx + \frac{ML}{2}(\ddot\theta\cos\theta - \dot\theta^2\sin\theta)}{M+m}"
TORQUE = r"-\frac{ML}{2}(\ddot x\cos\theta + g\sin\theta)"
RATE = r"(M+m)\ddot x + \frac{ML}{2}(\ddot\theta\cos\theta - \dot\theta^2\sin\theta)"


def verdicts(text: str) -> list[str]:
    found = mechanics.check(PIVOT, text, blame=False)
    return [entry.finding.verdict.name for entry in found.judged]


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "text",
    [
        rf"a = \ddot x = {PUSH}",
        rf"a := \ddot x = {PUSH}",
        rf"\ddot x = a = {PUSH}",
        rf"\ddot x = {PUSH} = a",
        rf"\alpha = \ddot\theta = {TURN}",
        rf"\alpha = \dot\omega = \ddot\theta = {TURN}",
        rf"\dot\omega = \ddot\theta = {TURN}",
        rf"\omega = \dot\theta, \quad \dot\omega = \ddot\theta = {TURN}",
        rf"\tau = \frac{{ML^2}}{{3}}\ddot\theta = {TORQUE}",
        rf"\frac{{ML^2}}{{3}}\ddot\theta = \tau = {TORQUE}",
        rf"\sum F_x = {RATE} = -2kx",
        rf"{RATE} = \sum F_x = -2kx",
        rf"\ddot\varphi = {TURN} = \frac{{3}}{{2L}}(-\ddot x\cos\theta - g\sin\theta)".replace(
            r"\theta", r"\varphi"
        ),
        "a = x'' = -(2*k*x + M*L/2*(theta''*cos(theta) - theta'^2*sin(theta)))/(M + m)",
    ],
)
def test_each_link_is_judged(text: str) -> None:
    assert verdicts(text) == ["PROVED"]
    for old, new in ((r"g\sin", r"2 g\sin"), ("2kx", "kx"), ("2*k*x", "k*x")):
        if old in text:
            assert verdicts(text.replace(old, new)) == ["REFUTED"]


def test_a_chain_of_matrices_is_judged_too() -> None:
    matrix = r"\begin{pmatrix} M+m & 0 \\ 0 & L \end{pmatrix}"
    text = rf"A = {matrix} = {matrix.replace('+m', '')}, \quad A x = \ddot x"
    assert verdicts(text)[0] == "REFUTED"


def test_what_a_chain_holds_is_used() -> None:
    text = (
        r"-2kx = F_x = \frac{dp_x}{dt}, \qquad p_x = (M+m)\dot x + \frac{ML}{2}\dot\theta\cos\theta"
    )
    assert verdicts(text) == ["PROVED", "PROVED"]
    assert verdicts(text.replace("+m", "-m"))[0] == "REFUTED"


def test_what_only_names_forces_is_in_doubt() -> None:
    assert verdicts(rf"\sum F_x = 0, \quad {RATE} = -2kx") == ["UNDECIDED", "PROVED"]
    assert verdicts(rf"R = M + M = 2 M, \quad {RATE} = -2kx") == [
        "PROVED", "UNDECIDED", "PROVED",
    ]  # fmt: skip
