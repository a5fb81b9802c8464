"""General laws in the prose are no claims about the scene."""

import pytest

from tests.notation_scenes import judged, verdicts

CLAIM = r"\[ ml\ddot\theta = -mg\sin\theta \]"
LAWS = [
    r"$F = ma$", r"$\sum F = ma$", r"$\sum \vec F = m\vec a$", r"$\tau = I\alpha$", r"\[ F = ma \]",
    r"$\sum M = I\alpha$", r"$p = mv$", r"$L = T - V$",
    r"$$\frac{d}{dt}\frac{\partial L}{\partial\dot q_i} - \frac{\partial L}{\partial q_i} = 0$$",
]  # fmt: skip


@pytest.mark.parametrize("law", LAWS)
def test_a_law_is_told_and_not_judged(law: str) -> None:
    found = judged("pendulum", f"By Newton {law} we get {CLAIM}")
    assert [e.finding.verdict.name for e in found.judged] == ["PROVED"]
    assert any("a general law, not judged" in remark for remark in found.remarks)
    assert verdicts("pendulum", f"By {law}: {CLAIM.replace('= -', '= ')}") == ["REFUTED"]


@pytest.mark.parametrize(
    "claim",
    [
        "ma = -mg",
        r"K = mg\cos\theta",
        r"K = mg",
        r"\sum F = -mg\sin\theta",
        r"\sum F_y = 0",
        "R = S",
        r"J\ddot\theta = 0",
    ],
)
def test_what_may_be_a_claim_stays_one(claim: str) -> None:
    assert "UNDECIDED" in verdicts("pendulum", rf"\[ {claim} \] {CLAIM}")


def test_a_law_alone_has_no_verdict_either() -> None:
    assert verdicts("pendulum", r"\[ F = ma \]") == ["UNDECIDED"]
