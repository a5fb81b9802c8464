"""What a person writes about a body that a quaternion turns: judged where its norm is 1."""

from fractions import Fraction

import pytest
from quaternions import ball_top

from mechanics import check, derive, extremes
from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.kernel import Verdict


@pytest.fixture(scope="module")
def truth() -> Equations:
    return derive(ball_top(), "kane")


EULER = """
(A + m*l^2)*wx_dot = (A + m*l^2 - C)*wy*wz + 2*m*g*l*(e2*e3 + e0*e1)
(A + m*l^2)*wy_dot = (C - A - m*l^2)*wx*wz - 2*m*g*l*(e1*e3 - e0*e2)
C*wz_dot = 0
"""


def verdicts(truth: Equations, text: str) -> list[Verdict]:
    return [judged.finding.verdict for judged in check(truth, text).judged]


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "text",
    [
        EULER,
        "V = m*g*l*(e0^2 - e1^2 - e2^2 + e3^2)",
        "V = m*g*l*(1 - 2*e1^2 - 2*e2^2)",
        "E = (A + m*l^2)*(wx^2 + wy^2)/2 + C*wz^2/2 - 2*m*g*l*(e1^2 + e2^2)",
        "e1' = (e0*wx + e2*wz - e3*wy)/2",
    ],
)
def test_what_holds_on_the_unit_sphere_is_proved(truth: Equations, text: str) -> None:
    assert set(verdicts(truth, text)) == {Verdict.PROVED}


def test_a_wrong_factor_is_refuted_at_a_unit_quaternion(truth: Equations) -> None:
    found = check(truth, EULER.replace("2*m*g*l*(e2", "m*g*l*(e2"), blame=False)
    finding = found.judged[0].finding
    assert finding.verdict is Verdict.REFUTED
    state = {**dict(finding.witness.state), **dict(finding.witness.solved)}
    # What only chooses the point on the sphere is no quantity of the scene: nobody reads of it.
    scene = truth.scene
    symbols = {*scene.q, *scene.u, *scene.ud, *scene.parameters}
    assert {name for name, _ in finding.witness.state} <= {symbol.name for symbol in symbols}
    assert sum(float(Fraction(state[f"e{i}"])) ** 2 for i in range(4)) == pytest.approx(1)
    assert verdicts(truth, "V = m*g*l*(1 - e1^2 - e2^2)") == [Verdict.REFUTED]


def test_extremes_say_that_they_take_no_quaternion(truth: Equations) -> None:
    with pytest.raises(InputError, match="declare angles") as caught:
        extremes(truth)
    assert "\n" not in str(caught.value)
