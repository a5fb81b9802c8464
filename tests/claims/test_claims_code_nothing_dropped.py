"""Code of other languages that computes something else is never shown to be right.

What each of these texts computes is what gcc, Octave and the definitions of Julia and Modelica say.
"""

from pathlib import Path

import pytest

import mechanics
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from systems import rod_pendulum

ROD = rod_pendulum.scene()
RIGHT = "3*g/(2*l)*sin(theta) + 3*u/(m*l*l)"
C = """#include <math.h>
{0}
double acc(double theta, double w, double u, double m, double l, double g) {{
  {1}
  return {2};
}}
"""
MATLAB = "function a = acc(theta, w, u, m, l, g)\n{1}\na = {2};\nend\n{0}"
JULIA = "{0}\nfunction acc(theta, w, u, m, l, g)\n  {1}\n  a = {2}\n  return a\nend\n"
MODEL = """{0}model Rod
  parameter Real m = 1, l = 1, g = 9.81; {1}
  Real theta; {3} input Real u;
equation
  der(theta) = w;
  der(w) = {2};
end Rod;
"""


def verdict(folder: Path, suffix: str, text: str) -> Verdict:
    path = folder / f"page{suffix}"
    path.write_text(text)
    try:
        return mechanics.check(ROD, path, blame=False).verdict
    except InputError:
        return Verdict.UNDECIDED


@pytest.mark.parametrize(
    ("suffix", "text"),
    [(".c", C), (".cpp", C), (".m", MATLAB), (".jl", JULIA), (".mo", MODEL)],
)
def test_what_is_right_is_shown(tmp_path: Path, suffix: str, text: str) -> None:
    page = text.format("", "", RIGHT, "Real w;")
    assert verdict(tmp_path, suffix, page) in (Verdict.PROVED, Verdict.CERTIFIED)


@pytest.mark.sample(8)
@pytest.mark.parametrize("suffix", [".c", ".cpp"])
@pytest.mark.parametrize(
    ("above", "inside", "formula"),
    [
        ("#/**/define sin cos", "", RIGHT), ("%:define sin cos", "", RIGHT),
        ("", "(void)(m = 2);", RIGHT), ("", "m = m > 0 && m;", RIGHT),
        ("", "int i; i = 3; for (i = 0; i < 1; i++) {} m = i*m/3;", RIGHT),
        ("", "int n = 4; double s = 1; for (int i = 0; i < n; ++i) { n = 2; s *= 2; } m *= s/16;",
         RIGHT),
        ("", "float n; n = 0.1; m *= 10*n;", RIGHT),
        ("", "float n[1]; n[0] = m; m = n[0];", RIGHT),
        ("static float tenth(void) { return 0.1; }", "m *= 10*tenth();", RIGHT),
        ("static double same(float k) { return k; }", "m = same(m);", RIGHT),
        ("", "", RIGHT.replace("sin(", "sinf(")),
        ("", "double A[2][2] = {{1, 2}, {3, 4}}; m *= A[1][0]/2;", RIGHT),
        ("", "double v[3]; v[2] = 1; m += v[0];", RIGHT),
    ],
)  # fmt: skip
def test_c(tmp_path: Path, suffix: str, above: str, inside: str, formula: str) -> None:
    found = verdict(tmp_path, suffix, C.format(above, inside, formula))
    assert found not in (Verdict.PROVED, Verdict.CERTIFIED)


@pytest.mark.parametrize(
    ("above", "inside", "formula"),
    [
        ("double k(int a = 2.5) { return a; }", "m *= k()/2.5;", RIGHT),
        ("auto k(double a) { return 2; }", "m *= 3/k(m)/1.5;", RIGHT),
        ("", "auto [a, b] = std::make_pair(2, 3); m *= b/a/1.5;", RIGHT),
        ("", "std::vector<double> v(3, 1); v[2] = 3; m += v[0];", RIGHT),
        ("", "std::vector<double> q{1, 2}, v(q); v[1] = 3; m += v[0];", RIGHT),
        ("", "double *v = new double[2]{5, 6}; v[1] = m; m += v[0];", RIGHT),
        ("using mine::sin;", "", RIGHT),
    ],
)  # fmt: skip
def test_c_plus_plus(tmp_path: Path, above: str, inside: str, formula: str) -> None:
    found = verdict(tmp_path, ".cpp", C.format(above, inside, formula))
    assert found not in (Verdict.PROVED, Verdict.CERTIFIED)


def test_a_header_that_is_not_here_may_give_names_another_meaning(tmp_path: Path) -> None:
    declared = "class Rod { double m, l, g; double acc(double theta, double u); };\n"
    text = f"{declared}double Rod::acc(double theta, double u) {{ return {RIGHT}; }}\n"
    assert verdict(tmp_path, ".cpp", f'#include "rod.h"\n{text}') is Verdict.UNDECIDED
    assert verdict(tmp_path, ".cpp", f"#define FAST <cmath>\n#include FAST\n{text}") is (
        Verdict.UNDECIDED
    )
    assert verdict(tmp_path, ".cpp", f'#include <cmath>\n#include "Eigen/Dense"\n{text}') is (
        Verdict.PROVED
    )


@pytest.mark.parametrize(
    ("below", "inside", "formula"),
    [
        ("", "k = l && 3; l = l*k/3;", RIGHT), ("", "k = (l > 0) && 3; l = l*k/3;", RIGHT),
        ("", "l = single(l);", RIGHT), ("", "l = 0x10*l/16;", RIGHT), ("", "l = --l;", RIGHT),
        ("", "disp(l = 2);", RIGHT), ("", 'fprintf("%d", l = 2);', RIGHT),
        ("function k = h()\nglobal q\nq = 5; k = 2;\nend\n",
         "global q; q = 1; k = h(); l = l*q;", RIGHT),
    ],
)  # fmt: skip
def test_matlab(tmp_path: Path, below: str, inside: str, formula: str) -> None:
    found = verdict(tmp_path, ".m", MATLAB.format(below, inside, formula))
    assert found not in (Verdict.PROVED, Verdict.CERTIFIED)


@pytest.mark.parametrize(
    ("above", "inside", "formula"),
    [
        ("k = 3\nfunction other()\n  global k = 4\nend\nother()", "", f"({RIGHT})*k/3"),
        ("const k = [3.0]\nk[1] = 4", "", f"({RIGHT})*k[1]/3"),
        ("", "k = Float32(0.1)", f"({RIGHT})*10*k"), ("", "", f"({RIGHT})*10*0.1f0"),
        ("", "k::Float32 = 0.1", f"({RIGHT})*10*k"),
        ("h(k)::Float32 = k", "", f"h({RIGHT})"),
        ('eval(Meta.parse("sin(x) = sind(x)"))', "", RIGHT), ("@eval sin(x) = sind(x)", "", RIGHT),
        ('include_string(Main, "sin(x) = sind(x)")', "", RIGHT), ("@other", "", RIGHT),
        ("Core.eval(Main, :(sin(x) = sind(x)))", "", RIGHT), ("@other @inline", "", RIGHT),
    ],
)  # fmt: skip
def test_julia(tmp_path: Path, above: str, inside: str, formula: str) -> None:
    found = verdict(tmp_path, ".jl", JULIA.format(above, inside, formula))
    assert found not in (Verdict.PROVED, Verdict.CERTIFIED)


SIN = "function sin\n  input Real x;\n  output Real y;\nalgorithm\n  y := x;\nend sin;\n"
QUARTER = RIGHT.replace("sin(theta)", "cos(theta - pi/2)")


@pytest.mark.parametrize(
    ("above", "inside", "formula", "rate"),
    [
        (SIN, "", RIGHT, "Real w;"), (f"pure {SIN}", "", RIGHT, "Real w;"),
        ("function sin = Modelica.Math.cos;\n", "", RIGHT, "Real w;"),
        ("model sin\nequation\nend sin;\n", "", RIGHT, "Real w;"),
        ("", "import sin = Modelica.Math.cos;", RIGHT, "Real w;"),
        ("", "import pi = Modelica.Constants.e;", QUARTER, "Real w;"),
        ("", "constant Real pi = 3;", QUARTER, "Real w;"),
        ("", "", RIGHT, 'Real w(unit="m/s");'), ("", "", RIGHT, "Modelica.Units.SI.Velocity w;"),
        ("", "parameter Real k = 2*u;", f"({RIGHT})*k/k", "Real w;"),
        ("", "constant Real k = theta;", f"({RIGHT})*k/k", "Real w;"),
        ("", "", RIGHT, "Real w = 2;"), ("type Real = Integer;\n", "", RIGHT, "Real w;"),
    ],
)  # fmt: skip
def test_modelica(tmp_path: Path, above: str, inside: str, formula: str, rate: str) -> None:
    found = verdict(tmp_path, ".mo", MODEL.format(above, inside, formula, rate))
    assert found not in (Verdict.PROVED, Verdict.CERTIFIED)


def test_a_unit_of_a_rate_may_be_right(tmp_path: Path) -> None:
    for rate in ('Real w(unit="rad/s");', "Modelica.Units.SI.AngularVelocity w;"):
        assert verdict(tmp_path, ".mo", MODEL.format("", "", RIGHT, rate)) is Verdict.PROVED


def test_a_parameter_may_be_made_of_others(tmp_path: Path) -> None:
    inside = "parameter Real k = 3*g/(2*l);"
    made = MODEL.format("", inside, "k*sin(theta) + 3*u/(m*l*l)", "Real w;")
    assert verdict(tmp_path, ".mo", made) is Verdict.PROVED
    moved = made.replace("m = 1", "m = 2*u")
    assert verdict(tmp_path, ".mo", moved) is Verdict.UNDECIDED
