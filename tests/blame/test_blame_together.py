r"""An edit that would spoil what is shown is not the one that is told."""

import mechanics
from mechanics.blame.reference import Reference
from mechanics.judge.bounded_blame import shown_with
from mechanics.judge.check import derived
from systems import cartpole

CART = derived(cartpole.scene())
STATE = r"Let $x_1 = x$, $x_2 = \dot x$, $x_3 = \theta$, $x_4 = \dot\theta$. Then"
RATES = r"""\begin{align}
\dot x_1 &= x_2\\
\dot x_2 &= \frac{F + m_p l x_4^2 \sin x_3 - \frac34 m_p g\sin x_3\cos x_3}{m_c+m_p-\frac34 m_p\cos^2 x_3}\\
\dot x_3 &= x_4
\end{align}"""  # noqa: E501


def test_a_definition_that_others_are_shown_with_is_left_as_it_is() -> None:
    found = mechanics.check(CART, f"{STATE} {RATES.replace('x_4^2', 'x_4')}", notation="latex")
    verdicts = [entry.finding.verdict.name for entry in found.judged]
    assert verdicts == ["PROVED", "REFUTED", "PROVED"]
    assert {"x_2", "x_4"} <= shown_with(Reference(CART), found.judged, 1)
    blame = found.judged[1].blame
    assert blame is not None
    for repair in blame.repairs:
        assert repair.finding.shown
        assert all(edit.definition == "" for edit in repair.edits)


def test_a_definition_that_is_wrong_is_told() -> None:
    below = r"m_c+m_p-\frac34 m_p\cos^2 x_3"
    wrong = RATES.replace(below, r"\Delta") + rf" where $\Delta = {below.replace('34', '14')}$."
    blame = mechanics.check(CART, f"{STATE} {wrong}", notation="latex").judged[1].blame
    assert blame is not None
    assert [edit.definition for edit in blame.repairs[0].edits] == ["Delta"]


def test_the_line_of_a_row_that_is_right_is_left_as_it_is() -> None:
    text = (
        r"\[ M \begin{bmatrix} \ddot x\\ \ddot\theta \end{bmatrix} + \begin{bmatrix}"
        r" -m_p l\dot\theta^2 \sin\theta \\ -m_p g l \sin\theta \end{bmatrix} ="
        r" \begin{bmatrix} F \\ 0 \end{bmatrix} \]"
        r"\[ M = \begin{bmatrix} m_c+m_p & m_p l\cos\theta \\ m_p l\cos\theta & \frac13 m_p l^2"
        r"\end{bmatrix} \]"
    )
    first, second = mechanics.check(CART, text, notation="latex").judged
    assert first.finding.shown
    assert second.blame is not None
    assert second.blame.repairs[0].edits[0].definition == "M_22"
