r"""Definitions of s_i and c_i for every i: as people have them, or otherwise, which counts."""

import pytest

from mechanics.claims.sines import defined_otherwise
from mechanics.judge.check import derived
from systems import double_pendulum
from tests.verdict_of import verdict_of

USUAL = [
    r"$c_i=\cos\theta_i$ and $s_{ij}=\sin(\theta_i+\theta_j)$", r"$s_\alpha=\sin\alpha$",
    "c_i = cos(theta_i), s_i = sin(theta_i)", r"$c_i := \cos(q_i)$",
    r"$c_{i} = \cos\left(\theta_{i}\right)$", r"$c_{12}=\sin\theta$",
    r"$s_i$ and $c_i$ denote $\sin\theta_i$ and $\cos\theta_i$",
    r"$c_{ijk} = \cos(\theta_i+\theta_j+\theta_k)$", "m_c*x'' = s_y", r"$\dot x = c_x$, $c_y = 3$",
]  # fmt: skip
OTHERWISE = [
    r"$c_i=\sin\theta_i$, $s_i=\cos\theta_i$", r"$c_{ij}=\cos(\theta_i-\theta_j)$",
    r"$c_k=\cos(\theta_k/2)$", r"$(c_i,s_i)=(\sin\theta_i,\cos\theta_i)$",
    r"$c_i,s_i=\sin\theta_i,\cos\theta_i$", r"$c_\bullet=\sin\theta_\bullet$",
    r"$c_i\equiv\cos2\theta_i$", r"$s_\alpha=\cos\alpha$", "c_i = sin(theta_i)",
    r"$c_{ij}=\cos\theta_i\cos\theta_j$",
]  # fmt: skip


@pytest.mark.parametrize("text", USUAL)
def test_the_usual_ones_say_nothing_else(text: str) -> None:
    assert not defined_otherwise(text)


@pytest.mark.parametrize("text", OTHERWISE)
def test_others_are_no_sines_and_cosines(text: str) -> None:
    assert defined_otherwise(text)


@pytest.mark.parametrize(
    ("words", "shown"),
    [("", True), (r"With $c_i=\cos\phi_i$ and $s_i=\sin\phi_i$:", True),
     (r"With $c_i=\sin\phi_i$ and $s_i=\cos\phi_i$:", False),
     (r"With $c_\bullet=\sin\phi_\bullet$:", False)],
)  # fmt: skip
def test_what_a_text_defines_for_every_index_counts(words: str, shown: bool) -> None:
    energy = (
        r"\[ T=\tfrac12(m_1+m_2)l_1^2\dot\phi_1^2+\tfrac12m_2l_2^2\dot\phi_2^2"
        r"+m_2l_1l_2(c_1c_2+s_1s_2)\dot\phi_1\dot\phi_2 \]"
    )
    verdict = verdict_of(derived(double_pendulum.scene()), f"{words}\n{energy}")
    assert (verdict == "PROVED") is shown
