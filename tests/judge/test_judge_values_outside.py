"""What a text declares of a name, and the scene's cannot be, leaves statements open."""

from pathlib import Path

import pytest

from mechanics import check
from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.judge.check import derived
from systems import double_pendulum, rod_pendulum

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
        (".c", C.format(head="const double l = 0;", g="g", rest=", double m, double g"), OPEN),
        (".c", C.format(head="const double l = 2;", g="g", rest=", double m, double g"), RIGHT),
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


PENDULUM = "(double theta, double theta_dot, double u, double m, double l, double g) {\n"
PENDULUM += "return 3*g/(2*l)*sin(theta) + 3*u/(m*l*l);\n}\n"


@pytest.mark.parametrize(("pre", "real"), [("", "double"), ("typedef double real;", "real")])
def test_a_real_quantity_is_real(truth: Equations, tmp_path: Path, pre: str, real: str) -> None:
    path = tmp_path / "p.cpp"
    path.write_text(f"#include <cmath>\n{pre}\ndouble f{PENDULUM.replace('double', real, 1)}")
    assert check(truth, path, blame=False).verdict.name == RIGHT


@pytest.mark.parametrize(
    ("pre", "real"),
    [
        ("", "int"),
        ("", "unsigned char"),
        ("typedef int real;", "real"),
        ("using real = int;", "real"),
    ],
)
def test_a_real_quantity_is_no_integer(
    truth: Equations, tmp_path: Path, pre: str, real: str
) -> None:
    path = tmp_path / "p.cpp"
    path.write_text(f"#include <cmath>\n{pre}\ndouble f{PENDULUM.replace('double', real, 1)}")
    with pytest.raises(InputError, match="theta is"):
        check(truth, path, blame=False)


@pytest.mark.parametrize("suffix", [".c", ".cpp", ".ino"])
@pytest.mark.parametrize("macro", ["double int", "return return 2*", "float int"])
def test_a_macro_leaves_the_words_of_the_language(
    truth: Equations, tmp_path: Path, suffix: str, macro: str
) -> None:
    path = tmp_path / f"p{suffix}"
    path.write_text(f"#include <math.h>\n#define {macro}\ndouble f{PENDULUM}")
    with pytest.raises(InputError, match="is a word of C"):
        check(truth, path, blame=False)


RIGHT_TEXT = "\ntheta'' = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2)"


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        (f"m = l{RIGHT_TEXT}", OPEN),
        (f"g = l{RIGHT_TEXT}", OPEN),
        (f"m = 2{RIGHT_TEXT}", RIGHT),
        (f"m = p.m{RIGHT_TEXT}", RIGHT),
    ],
)
def test_a_quantity_is_none_of_another_unit(truth: Equations, text: str, verdict: str) -> None:
    assert check(truth, text, blame=False).verdict.name == verdict


@pytest.mark.parametrize(
    ("old", "new", "verdict"),
    [
        ("", "", RIGHT),
        ("Real theta;", "constant Real theta = 0;", OPEN),
        ("Real theta;", "discrete Real theta;", OPEN),
        ("Real l=1", "Real l=m", OPEN),
        ("Real l=1", 'Real l=1 "half of the length"', OPEN),
        ("Real theta;", 'Real theta "angle from hanging";', OPEN),
        ("Real l=1", 'Real l=1 "length of the rod"', RIGHT),
        ("Real theta;", 'Real theta "angle from the upward vertical";', RIGHT),
    ],
)
def test_what_a_model_of_modelica_declares_is_compared(
    truth: Equations, tmp_path: Path, old: str, new: str, verdict: str
) -> None:
    path = tmp_path / "P.mo"
    path.write_text(MODELICA.format(l="1", g="10").replace(old, new, 1))
    assert check(truth, path, blame=False).verdict.name == verdict


@pytest.mark.parametrize(("sign", "verdict"), [("", "UNDECIDED"), ("-", "REFUTED")])
def test_a_parameter_that_code_makes_of_another_is_told(
    tmp_path: Path, sign: str, verdict: str
) -> None:
    path = tmp_path / "chain.m"
    path.write_text(f"""function dy = chain(t, y)
    % y: [phi1; phi2; phi1_dot; phi2_dot]
    m1 = 0.4; m2 = 0.3; g = 9.81; l1 = 1.2; l2 = 0.5*l1;
    d = y(1) - y(2);
    A = [(m1 + m2)*l1, m2*l2*cos(d); l1*cos(d), l2];
    b = [-m2*l2*y(4)^2*sin(d) - (m1 + m2)*g*sin(y(1)); {sign}l1*y(3)^2*sin(d) - g*sin(y(2))];
    dy = [y(3); y(4); A\\b];
    end
    """)
    found = check(double_pendulum.scene(), path, blame=False)
    assert found.verdict.name == verdict
    said = [words for entry in found.judged for words in entry.right_if]
    assert any("l2 = l1/2" in words for words in said) is (verdict == "UNDECIDED")
