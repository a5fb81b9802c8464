"""An equation for small angles is mended to first order, which is told; an exact one is not."""

import mechanics
from mechanics.judge.check import derived
from systems import rod_pendulum

ROD = derived(rod_pendulum.scene())
RIGHT = "theta'' = 3*g*theta/(2*l) + 3*u/(m*l^2)"


def test_a_sign_of_a_linearized_equation() -> None:
    (entry,) = mechanics.check(ROD, RIGHT.replace("+ 3", "- 3")).judged
    assert entry.verdict.name == "REFUTED"
    assert entry.blame is not None
    assert [(e.written, e.right) for e in entry.blame.repairs[0].edits] == [("-", "+")]
    assert "first order" in entry.blame.searched


def test_an_exact_equation_is_mended_exactly() -> None:
    (entry,) = mechanics.check(ROD, RIGHT.replace("theta/", "sin(theta)/").replace("+", "-")).judged
    assert entry.blame is not None
    assert "first order" not in entry.blame.searched
