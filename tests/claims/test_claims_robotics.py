"""What books on robotics write: s_1, c_12, columns by one letter, matrices by their entries."""

import pytest
from sympy.physics.mechanics import dynamicsymbols

import mechanics
from benchmarks.corpus.builders import P, pendulum
from tests.notation_scenes import judged, verdicts

CRAIG = r"""
\[ \tau = M(\Theta)\ddot\Theta + V(\Theta,\dot\Theta) + G(\Theta) \]
\[ M(\Theta) = \begin{bmatrix}
  l_2^2 m_2 + 2 l_1 l_2 m_2 c_2 + l_1^2 (m_1+m_2) & l_2^2 m_2 + l_1 l_2 m_2 c_2 \\
  l_2^2 m_2 + l_1 l_2 m_2 c_2 & l_2^2 m_2 \end{bmatrix} \]
\[ V(\Theta,\dot\Theta) = \begin{bmatrix}
  -m_2 l_1 l_2 s_2 \dot\theta_2^2 - 2 m_2 l_1 l_2 s_2 \dot\theta_1\dot\theta_2 \\
  m_2 l_1 l_2 s_2 \dot\theta_1^2 \end{bmatrix} \]
\[ G(\Theta) = \begin{bmatrix}
  m_2 l_2 g c_{12} + (m_1+m_2) l_1 g c_1 \\ m_2 l_2 g c_{12} \end{bmatrix} \]"""
BY_ENTRIES = r"""
\[ M(q)\ddot q + C(q,\dot q)\dot q + g(q) = \tau \]
\[ M_{11} = l_2^2 m_2 + 2 l_1 l_2 m_2 \cos q_2 + l_1^2 (m_1+m_2), \]
\[ M_{12} = M_{21} = l_2^2 m_2 + l_1 l_2 m_2 \cos q_2, \quad M_{22} = l_2^2 m_2 \]
\[ C_{11} = -m_2 l_1 l_2 \sin q_2 \dot q_2, C_{12} = -m_2 l_1 l_2 \sin q_2 (\dot q_1+\dot q_2) \]
\[ C_{21} = m_2 l_1 l_2 \sin q_2\dot q_1, \quad C_{22} = 0 \]
\[ g_1 = m_2 l_2 g \cos(q_1+q_2) + (m_1+m_2) l_1 g \cos q_1, g_2 = m_2 l_2 g \cos(q_1+q_2) \]"""
ELBOW = (
    r"\tau_2 = m_2 l_2 g c_{12} + m_2 l_1 l_2 s_2\dot\theta_1^2"
    r" + m_2 l_2^2 (\ddot\theta_1+\ddot\theta_2) + m_2 l_1 l_2 c_2\ddot\theta_1"
)
GLUED = (
    ELBOW.replace("c_{12}", "c_{1+2}").replace("s_2", r"s\theta_2 ").replace("c_2", r"c\theta_2 ")
)


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("text", "old", "new"),
    [
        (ELBOW, "c_{12}", "s_{12}"),
        (ELBOW, "c_{12}", "c_{1-2}"),
        (ELBOW, "s_2", "c_2"),
        (ELBOW.replace("c_", "C_").replace("s_", "S_"), "S_2", "C_2"),
        (GLUED, r"s\theta_2", r"c\theta_2"),
        (ELBOW.replace("c_2", r"c_{\theta_2}").replace("s_2", r"s_{\theta_2}"), "s_", "c_"),
        (CRAIG, "c_{12} + (", "c_{12} - ("),
        (CRAIG, r"l_2 s_2 \dot\theta_2^2", r"l_2 c_2 \dot\theta_2^2"),
        (CRAIG, "-m_2 l_1", "m_2 l_1"),
        (BY_ENTRIES, r"\sin q_2\dot q_1", r"\cos q_2\dot q_1"),
        (BY_ENTRIES, "2 l_1", "l_1"),
        (BY_ENTRIES.replace("M_{21} = ", ""), "C_{22} = 0", r"C_{22} = m_2 l_2^2\dot q_2"),
    ],
)
def test_the_right_one_and_one_mistake(text: str, old: str, new: str) -> None:
    assert old in text
    assert set(verdicts("arm", text)) <= {"PROVED", "CERTIFIED"}
    assert "REFUTED" in verdicts("arm", text.replace(old, new, 1))


def test_what_the_author_defines_is_no_short_sine() -> None:
    own = ELBOW.replace("c_2", "c_1") + r", \quad c_1 = \cos\theta_2"
    assert verdicts("arm", own) == ["PROVED"]
    assert verdicts("arm", own.replace(r"\cos\theta_2", r"\cos\theta_1")) == ["REFUTED"]


def test_a_damper_that_the_scene_has_is_no_cosine() -> None:
    found = judged("oscillator", r"m\ddot x + c_1\dot x + s_1 x = F_0\cos(\omega t)")
    assert not any("cos(" in remark for remark in found.remarks)


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        (
            r"p_1 = (m_1+m_2)l_1^2\dot\phi_1 + m_2 l_1 l_2\dot\phi_2\cos(\phi_1-\phi_2)",
            r"p_2 = (m_1+m_2)l_1^2\dot\phi_1 + m_2 l_1 l_2\dot\phi_2\cos(\phi_1-\phi_2)",
        ),
        (
            r"p_{\theta_2} = m_2l_2^2\dot\theta_2 + m_2 l_1 l_2\dot\theta_1\cos(\theta_1-\theta_2)",
            r"p_{\theta_2} = m_2l_2^2\dot\theta_2 - m_2 l_1 l_2\dot\theta_1\cos(\theta_1-\theta_2)",
        ),
    ],
)
def test_momenta_under_the_authors_names_of_angles(right: str, wrong: str) -> None:
    assert verdicts("double", right) == ["PROVED"]
    assert verdicts("double", wrong) == ["REFUTED"]


@pytest.mark.campaign
def test_the_mistake_is_mended_where_it_was_written() -> None:
    """Not in what s_2 stands for, which nobody wrote."""
    wrong = ELBOW.replace("+ m_2 l_1 l_2 s_2", "- m_2 l_1 l_2 s_2")
    (entry,) = judged("arm", wrong, blame=True).judged
    assert entry.blame is not None
    assert entry.blame.repairs[0].repaired == ELBOW


@pytest.mark.parametrize(
    ("right", "verdict"),
    [
        (r"-\frac{g}{l} s_1", "PROVED"),
        (r"-\frac{2 g}{l} s_1", "REFUTED"),
        (r"-\frac{g}{l^2} s_1", "UNDECIDED"),  # an arc, it may be
        (r"-\frac{g}{l} c_1", "UNDECIDED"),  # a coefficient
        (r"-\frac{g}{l} s_2", "UNDECIDED"),
    ],
)
def test_a_sine_alone_is_told_by_its_dimension_and_number(right: str, verdict: str) -> None:
    m, l, g = P("m:kg l:m g:m/s^2")
    scene = pendulum(dynamicsymbols("theta1"), m, 0, l, g)
    found = mechanics.check(scene, rf"\ddot\theta_1 = {right}", blame=False)
    assert found.verdict.name == verdict
