"""Methods of C++ that change numbers of their object: the next state."""

from functools import partial
from pathlib import Path

import pytest

from systems import rod_pendulum
from tests.verdict_of import verdict_in

SCENE = rod_pendulum.scene()
ROD = """#include <cmath>
void Rod::update(double u, double dt) {
  double acc = 3*g/(2*l)*std::sin(theta) + 3*u/(m*l*l);
  theta += theta_dot*dt;
  theta_dot += acc*dt;
}
"""


_verdict = partial(verdict_in, SCENE, "rod.cpp")


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("", ""),
        ("theta += theta_dot*dt", "theta = theta + theta_dot*dt"),
        ("void", "bool"),
        ("  theta +=", "  double old = theta;\n  theta +="),
    ],
)
def test_what_is_right_is_proved(old: str, new: str, tmp_path: Path) -> None:
    text = ROD.replace(old, new) if old else ROD
    text = text.replace("acc*dt;\n", "acc*dt;\n  return true;\n") if "bool" in text else text
    assert _verdict(text, tmp_path) == "PROVED"


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("3*g/(2*l)", "3*g/l"),
        ("+ 3*u", "- u"),
        ("theta += theta_dot*dt", "theta += acc*dt"),
        ("theta += theta_dot*dt", "theta -= theta_dot*dt"),
        ("theta_dot += acc*dt", "theta_dot = acc*dt"),
        ("  double acc", "  theta_dot = 2*theta_dot;\n  double acc"),
        ("  double acc", "  l = 2*l;\n  double acc"),
        ("  double acc", "  double theta = 0;\n  double acc"),
        ("  double acc", "  normalize();\n  double acc"),
        ("acc*dt;\n", "acc*dt;\n  normalize();\n"),
        ("double u, double dt", "double u, double dt, double theta"),
        ("double u, double dt", "double u, double dt, double& theta"),
        ("#include <cmath>", "#include <cmath>\ndouble theta = 0;"),
        ("#include <cmath>", "#include <cmath>\nclass Rod { int theta; };"),
        ("#include <cmath>", "#include <cmath>\n#define theta_dot theta"),
        ("  theta +=", "  double& other = theta;\n  other = 0;\n  theta +="),
        ("  theta +=", "  { double theta_dot = 0; }\n  theta +="),
        ("  theta +=", "  if (u > 0) theta = 0;\n  theta +="),
        ("std::sin(theta)", "std::sin(theta++)"),
        ("std::sin(theta)", "std::sin(theta = 2*theta)"),
        ("std::sin(theta)", "std::sin(other())"),
    ],
)
def test_what_is_wrong_is_not_proved(old: str, new: str, tmp_path: Path) -> None:
    assert old in ROD
    assert _verdict(ROD.replace(old, new, 1), tmp_path) in ("REFUTED", "UNDECIDED", "not read")


def test_what_is_called_last_may_change_it(tmp_path: Path) -> None:
    text = ROD.replace("void", "bool").replace("acc*dt;\n", "acc*dt;\n  return check();\n")
    assert _verdict(text, tmp_path) == "UNDECIDED"
    assert _verdict(text.replace("3*g/(2*l)", "3*g/l"), tmp_path) == "REFUTED"
    own = text.replace("#include <cmath>", "#include <cmath>\nbool Rod::check() { theta = 0; }")
    assert _verdict(own, tmp_path) == "not read"
