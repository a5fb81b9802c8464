"""Slips that authors make, named where they stand: exchanged names, |v| v, a cotangent, a half."""

import pytest

from benchmarks.corpus.load import HERE, scene_of
from mechanics import check
from mechanics.blame.result import Edit, Mistake

TYPED = HERE / "scenes" / "typed.py"


def edits(scene: str, text: str) -> tuple[Edit, ...]:
    """Of the first repair."""
    (entry,) = (e for e in check(scene_of(TYPED, scene), text).judged if not e.finding.shown)
    assert entry.blame is not None and entry.blame.repairs
    return entry.blame.repairs[0].edits


MOMENTUM = r"p_\phi = (I_3\sin^2\theta + I_1\cos^2\theta)\dot\phi + I_3\dot\psi\cos\theta"


@pytest.mark.parametrize(
    ("scene", "text", "mistake", "right"),
    [
        ("cone", r"U = mgr\tan\alpha", Mistake.FUNCTION, r"\cot \alpha"),
        ("cone", r"U = mgr\sin\alpha/\sin\alpha", Mistake.FUNCTION, r"\cos \alpha"),
        ("quadratic", r"m\ddot x + b\dot x^2 + kx = 0", Mistake.POWER,
         r"\left|\dot x\right| \dot x"),
        ("orbit", r"r\ddot\theta + \dot r\dot\theta = 0", Mistake.FACTOR, r"2 \dot r \dot\theta"),
        ("top", r"V = Mgl\sin\theta", Mistake.FUNCTION, r"\cos \theta"),
        ("parabola", r"\ddot x + \frac{2agx}{1+4a^2x^2} = 0", Mistake.MISSING,
         r"+ \frac{4 a^{2} x \dot{x}^{2}}{1+4a^2x^2}"),
    ],
)  # fmt: skip
def test_one_edit(scene: str, text: str, mistake: Mistake, right: str) -> None:
    (edit,) = edits(scene, rf"\[ {text} \]")
    assert (edit.mistake, edit.right) == (mistake, right)


def test_two_names_are_exchanged_in_one_bracket() -> None:
    found = edits("top", rf"\[ {MOMENTUM} \]")
    assert [(e.written, e.right) for e in found] == [("I_3", "I_{1}"), ("I_1", "I_{3}")]


def test_a_factor_in_a_sum_below_a_sine() -> None:
    text = (
        "theta_1'' = -(g*(2*m_1 + m_2)*sin(theta_1) + m_2*(g*sin(theta_1 - theta_2)"
        " + 2*(L_2*theta_2'^2 + L_1*theta_1'^2*cos(theta_1 - theta_2))*sin(theta_1 - theta_2)))"
        "/(2*L_1*(m_1 + m_2 - m_2*cos(theta_1 - theta_2)^2))"
    )
    (edit,) = edits("two_rods", text)
    assert (edit.written, edit.right) == ("theta_2", "2*theta_2")


def test_a_length_that_turns_a_wheel_is_no_angle() -> None:
    text = r"E = \frac12 (m_1 + m_2 + I/R^2)\dot x^2 + (m_2 + m_1) g x"
    (edit,) = edits("atwood", rf"\[ {text} \]")
    assert edit.mistake is Mistake.SIGN
