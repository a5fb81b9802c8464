"""What a function of MATLAB, Julia or C++ computes, and what never reaches its caller."""

from pathlib import Path

import pytest

from mechanics import check
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from systems.rod_pendulum import scene

SCENE = scene()
LAW = "3*g/(2*l)*sin(y(1)) + 3*u/(m*l^2)"
HEAD = "function dy = rod(t, y, u, m, l, g)\n"
JULIA = "function rod!(dy, y, p, t)\n m, l, g, u = p\n %s\nend\n"
ROW = "[y[2], 3*g/(2*l)*sin(y[1]) + 3*u/(m*l^2)]"
C = """#include <cmath>
%svoid rod(const double *y, double *dy, double u, double m, double l, double g) {
  dy[0] = y[1];
  dy[1] = %s*g/(2*l)*sin(y[0]) + 3*u/(m*l*l);
}
"""
SMALL = """double theta_ddot(double theta, double u, double m, double l, double g) {
  return %s*g/(2*l)*sin(theta) + 3*u/(m*l*l);
}
"""
MEMBERS = """#include <cmath>
class Rod {
  double m, l, g;
 public:
  Rod(double m_, double l_, double g_) : m(%s), l(%s), g(g_) {%s}
  void rod(const double *y, double *dy, double u) {
    dy[0] = y[1]; dy[1] = 3*g/(2*l)*sin(y[0]) + 3*u/(m*l*l);
  }
};
"""


def verdict(folder: Path, text: str, suffix: str) -> Verdict | None:
    """The verdict; None for what is not read."""
    path = folder / f"code{suffix}"
    path.write_text(text, encoding="utf-8")
    try:
        return check(SCENE, path, blame=False).verdict
    except InputError as error:
        assert "\n" not in str(error)
        return None


@pytest.mark.parametrize(
    "lines",
    [
        "if t > 5\n k = 3;\nend\ndy = [y(2); k*g/(2*l)*sin(y(1)) + 3*u/(m*l^2)];",
        f"error('not yet');\ndy = [y(2); {LAW}];",
    ],
)
def test_numbers_under_a_condition_and_an_error_are_followed(tmp_path: Path, lines: str) -> None:
    assert verdict(tmp_path, f"{HEAD}{lines}\nend\n", ".m") is None


def test_a_parameter_is_not_what_a_name_spells(tmp_path: Path) -> None:
    text = (
        "function dy = rod(t, y, u, p)\nm = p.{}; l = p.{}; g = p.g;\ndy = [y(2); "
        + LAW
        + "];\nend\n"
    )
    assert verdict(tmp_path, text.format("m", "l"), ".m") is Verdict.PROVED
    assert verdict(tmp_path, text.format("l", "m"), ".m") is None
    script = f"m = p.l;\nl = p.m;\nthetadd = {LAW.replace('y(1)', 'theta')};\n"
    assert verdict(tmp_path, script, ".m") is Verdict.REFUTED


def test_an_array_of_julia_is_filled_and_not_named_anew(tmp_path: Path) -> None:
    assert verdict(tmp_path, JULIA % f"dy .= {ROW}", ".txt") is Verdict.PROVED
    assert verdict(tmp_path, JULIA % f"dy = {ROW}", ".txt") is Verdict.UNDECIDED
    early = f"dy[1] = y[2]\n return nothing\n dy[2] = {ROW[7:-1]}"
    assert verdict(tmp_path, JULIA % early, ".txt") is Verdict.UNDECIDED
    assert (
        verdict(tmp_path, JULIA % early.replace(" return nothing\n", ""), ".txt") is Verdict.PROVED
    )


def test_constructors_templates_and_defaults(tmp_path: Path) -> None:
    assert verdict(tmp_path, MEMBERS % ("m_", "l_", ""), ".cpp") is Verdict.PROVED
    for parts in (("l_", "m_", ""), ("m_", "l_/2", ""), ("m_", "l_", " l = 2*l_; ")):
        assert verdict(tmp_path, MEMBERS % parts, ".cpp") is None
    half = "template <typename T> T half(T x) { return x / 2; }\n"
    assert verdict(tmp_path, C % (half, "2*half(3.0)"), ".cpp") is Verdict.PROVED
    assert verdict(tmp_path, C % (half, "2*half(3)"), ".cpp") is None
    three = "double three(double x, double k = {}) {{ return k*x; }}\n"
    assert verdict(tmp_path, C % (three.format(3), "three(1.0)"), ".cpp") is Verdict.PROVED
    assert verdict(tmp_path, C % (three.format(2), "three(1.0)"), ".cpp") is Verdict.REFUTED


def test_integers_that_do_not_fit_are_refused(tmp_path: Path) -> None:
    ten = "100000*100000/10000000000.0*3"
    assert verdict(tmp_path, C % ("", ten), ".cpp") is None
    assert verdict(tmp_path, SMALL % "(300*300/30000.0)", ".ino") is None
    assert verdict(tmp_path, SMALL % "(300*100/10000.0)", ".ino") is Verdict.PROVED
