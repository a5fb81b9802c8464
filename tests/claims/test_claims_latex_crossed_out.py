r"""What is crossed out is read where it is a factor of every term of an equation."""

import pytest

from mechanics import check
from mechanics.kernel import Verdict
from systems import rod_pendulum

HALF = r"\cancel{m}\frac{l^2}{3}\ddot\theta"


def test_a_factor_of_all_terms_may_be_crossed_out() -> None:
    scene = rod_pendulum.scene()
    text = rf"{HALF} - \cancel{{m}}\frac{{g l}}{{2}}\sin\theta = \cancel{{m}}\frac{{u}}{{m}}"
    assert check(scene, rf"\[ {text} \]").verdict is Verdict.PROVED
    assert check(scene, rf"\[ {text.replace('3', '2')} \]", blame=False).verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    "text",
    [
        r"\frac{m l^2}{3}\ddot\theta = \frac{m g l}{2}\sin\theta + u + \cancel{m l^2}",
        rf"{HALF} = \frac{{m g l}}{{2}}\sin\theta + u",
        HALF + r" = \frac{1}{\cancel{m}}(\frac{m g l}{2}\sin\theta + u)",
        HALF + r" = (\frac{m g l}{2}\sin\theta + u)/\cancel{m}",
        r"\cancel{m}^2\frac{l^2}{3}\ddot\theta = \cancel{m}^2(\frac{g l}{2}\sin\theta + u)",
    ],
)
def test_anything_else_that_is_crossed_out_is_not_read(text: str) -> None:
    answer = check(rod_pendulum.scene(), rf"\[ {text} \] \[ \theta = \theta \]", blame=False)
    assert answer.verdict is Verdict.UNDECIDED


def test_the_lagrangian_of_a_page_whose_macros_stand_elsewhere() -> None:
    text = r"\[ \Lagr = \frac{1}{6} m l^2 \dot\theta^2 - \frac{1}{2} m g l \cos\theta \]"
    (entry,) = check(rod_pendulum.scene(), text, blame=False).judged
    assert type(entry.statement.row.quantity).__name__ == "Lagrangian"


def test_an_angle_of_time_may_be_small() -> None:
    text = rf"For $$\sin(\theta (t)) \approx \theta (t)$$ we use $${HALF} = 0$$"
    judged = check(rod_pendulum.scene(), text, blame=False).judged
    assert all("approximation" not in entry.statement.doubt for entry in judged)
