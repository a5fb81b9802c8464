"""What a text declares of a name, and the scene's cannot be, leaves statements open."""

from pathlib import Path

import pytest

from mechanics import check
from mechanics.equations import Equations
from mechanics.judge.check import derived
from systems import rod_pendulum

C = "#include <math.h>\n{head}\ndouble f(double theta, double theta_dot, double u{rest}) {{\n"
C += "return 3*{g}/(2*l)*sin(theta) + 3*u/(m*l*l);\n}}\n"
MODELICA = """model P
  Real theta; Real w; input Real u;
  parameter Real m=1; parameter Real l={l}; parameter Real g(unit="m/s2")={g};
equation
  der(theta)=w; der(w)=3*g/(2*l)*sin(theta)+3*u/(m*l^2);
end P;
"""
OPEN, RIGHT = "UNDECIDED", "PROVED"


@pytest.fixture(scope="module")
def truth() -> Equations:
    return derived(rod_pendulum.scene())


@pytest.mark.parametrize(
    ("suffix", "text", "verdict"),
    [
        (".c", C.format(head="#define G -9.81", g="G", rest=", double m, double l"), OPEN),
        (".c", C.format(head="#define G 9.81", g="G", rest=", double m, double l"), RIGHT),
        (".c", C.format(head="", g="g", rest=", double m, double l, double g"), RIGHT),
        (".mo", MODELICA.format(l="1", g="10"), RIGHT),
        (".mo", MODELICA.format(l="0", g="10"), OPEN),
        (".mo", MODELICA.format(l="1", g="-10"), OPEN),
    ],
)
def test_a_value_that_the_scene_cannot_have_is_no_example(
    truth: Equations, tmp_path: Path, suffix: str, text: str, verdict: str
) -> None:
    path = tmp_path / f"p{suffix}"
    path.write_text(text)
    found = check(truth, path, blame=False)
    assert found.verdict.name == verdict
    assert ("is positive" in " ".join(str(found).split())) is (verdict == OPEN)
