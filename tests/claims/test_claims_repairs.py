"""A repair that is printed can be read again, and is right."""

import pytest

import mechanics
from mechanics.judge.check import derived
from systems import cartpole

CART = derived(cartpole.scene())
RAIL = r"\ddot x + A l\ddot\theta\cos\theta = F/M + A l\dot\theta^2\sin\theta"
TYPED = "x'' + A*l*theta''*cos(theta) = F/M + A*l*theta'^2*sin(theta)"


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("text", "beside"),
    [
        (RAIL + r", \quad A = \frac{m_c}{m_c+m_p}, M = m_c+m_p", r"\\ M = m_c+m_p"),
        (RAIL.replace("A", r"\mu") + r", \quad \mu = \frac{m_c}{m_c+m_p}, M = m_c+m_p",
         r"\\ M = m_c+m_p"),
        (f"{TYPED}\nA = mc/(mc+mp)\nM = mc+mp", "\nM = mc+mp"),
        (r"\frac1 l \ddot x\cos\theta + \frac13\ddot\theta = \frac g l\sin\theta", ""),
        (r"\frac1 l \ddot x\cos\theta + \frac43\ddot\theta = -\frac g l\sin\theta", ""),
        (r"\frac43 l\ddot\theta + \ddot x\cos\theta = \underbrace{g\cos\theta}_{\text{gravity}}",
         ""),
        (r"\underbrace{(m_c - m_p)}_{M}\ddot x + m_p l\ddot\theta\cos\theta = \overbrace{F}^{u}"
         r"+ m_p l\dot\theta^2\sin\theta", ""),
        (r"a = \ddot x = \frac{F - m_p l(\ddot\theta\cos\theta - \dot\theta^2\sin\theta)}"
         "{m_c - m_p}", ""),
        (r"\begin{multline} (m_c+m_p)\ddot x + m_p l \Bigl[ \ddot\theta\cos\theta \\ +"
         r"\dot\theta^2\sin\theta \Bigr] = F \end{multline}", ""),
    ],
)  # fmt: skip
def test_a_repair_is_read_again_and_right(text: str, beside: str) -> None:
    (entry,) = mechanics.check(CART, text).judged
    assert entry.finding.verdict.name == "REFUTED"
    assert entry.blame is not None
    assert entry.blame.repairs
    for repair in entry.blame.repairs:
        again = mechanics.check(CART, repair.repaired + beside, blame=False)
        assert [found.finding.verdict.name for found in again.judged] == ["PROVED"]
