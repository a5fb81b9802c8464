"""M, C and G that three functions of one file return, and what else their object may hold."""

from functools import cache
from pathlib import Path

import pytest
from sympy.physics.mechanics import dynamicsymbols

import mechanics
from benchmarks.corpus.builders import P, two_link_arm
from mechanics.errors import InputError
from mechanics.report.answer.check import Check

HARMLESS = "what is not here changes nothing"
MATLAB = """function M = get_mass_matrix(q, m1, m2, l1, l2)
a = m2*l1*l2*cos(q(2));
M = [(m1 + m2)*l1^2 + m2*l2^2 + 2*a, m2*l2^2 + a; m2*l2^2 + a, m2*l2^2];
end
function C = get_coriolis(q, dq, m2, l1, l2)
h = m2*l1*l2*sin(q(2));
C = [-h*dq(2), -h*(dq(1) + dq(2)); h*dq(1), 0];
end
function G = get_gravity(q, m1, m2, l1, l2, g)
G = [(m1 + m2)*g*l1*cos(q(1)) + m2*g*l2*cos(q(1) + q(2)); m2*g*l2*cos(q(1) + q(2))];
end
"""
CPP = """Matrix Arm::getM(Vector& q)
{
  M(0,0) = (m1 + m2)*l1*l1 + m2*(l2*l2 + 2*l1*l2*cos(q(1)));
  M(0,1) = m2*(l2*l2 + l1*l2*cos(q(1)));
  M(1,0) = M(0,1);
  M(1,1) = m2*l2*l2;
  return M;
}
Matrix Arm::getC(Vector& q, Vector& qd)
{
  double h = m2*l1*l2*sin(q(1));
  C(0,0) = -h*qd(1);
  C(0,1) = -h*(qd(0) + qd(1));
  C(1,0) = h*qd(0);
  C(1,1) = 0;
  return C;
}
Vector Arm::getG(Vector& q)
{
  G(0) = (m1 + m2)*g*l1*cos(q(0)) + m2*g*l2*cos(q(0) + q(1));
  G(1) = m2*g*l2*cos(q(0) + q(1));
  return G;
}
"""
FILES = {"arm.m": MATLAB, "arm.cpp": CPP}


@cache
def _arm(heavy: bool) -> mechanics.Scene:
    q1, q2, t1, t2 = dynamicsymbols("q1 q2 t1 t2")
    m1, m2, l1, l2, g = P("m1:kg m2:kg l1:m l2:m g:m/s^2")
    weight = g if heavy else 0
    return two_link_arm((q1, q2), l1, (m1, l1, 0), (m2, l2, 0), weight, (t1, t2), (t1, t2))


def _checked(folder: Path, name: str, text: str, *, heavy: bool = True, **how: object) -> Check:
    path = folder / name
    path.write_text(text)
    return mechanics.check(_arm(heavy), path, blame=False, **how)


@pytest.mark.parametrize("name", FILES)
def test_three_functions_are_one_equation(name: str, tmp_path: Path) -> None:
    found = _checked(tmp_path, name, FILES[name])
    assert found.verdict.name == "PROVED"
    assert not found.beside


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("name", "written", "wrong"),
    [
        ("arm.m", "+ 2*a", "+ a"), ("arm.m", "h*dq(1), 0", "h*dq(2), 0"),
        ("arm.m", "g*l1*cos", "g*l1*sin"), ("arm.cpp", "= m2*l2*l2", "= m2*l1*l2"),
        ("arm.cpp", "C(1,0) = h", "C(1,0) = -h"), ("arm.cpp", "C(1,1) = 0", "C(1,1) = h"),
        ("arm.cpp", "G(1) = m2", "G(1) = m1"),
    ],
)  # fmt: skip
def test_a_mistake_in_any_of_them_is_refuted(
    name: str, written: str, wrong: str, tmp_path: Path
) -> None:
    assert written in FILES[name]
    found = _checked(tmp_path, name, FILES[name].replace(written, wrong))
    assert found.verdict.name == "REFUTED"


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("name", "written", "other"),
    [
        ("arm.m", "get_gravity", "get_friction"), ("arm.m", "get_coriolis", "get_mass"),
        ("arm.cpp", "getC", "getK"), ("arm.cpp", "getG", "getGain"),
        ("arm.m", "m2, l1, l2)\nh", "m2, l1, get_gravity)\nl2 = get_gravity; h"),
    ],
)  # fmt: skip
def test_functions_of_other_names_are_not_put_together(
    name: str, written: str, other: str, tmp_path: Path
) -> None:
    assert written in FILES[name]
    with pytest.raises(InputError):
        _checked(tmp_path, name, FILES[name].replace(written, other))


@pytest.mark.parametrize("name", FILES)
def test_without_gravity_two_functions_are_all(name: str, tmp_path: Path) -> None:
    last = "function G" if name == "arm.m" else "Vector Arm::getG"
    text = FILES[name][: FILES[name].index(last)]
    assert _checked(tmp_path, name, text, heavy=False).verdict.name == "PROVED"
    wrong = text.replace("l2*sin", "l2*cos")
    assert wrong != text
    assert _checked(tmp_path, name, wrong, heavy=False).verdict.name == "REFUTED"
    with pytest.raises(InputError, match="2 functions"):
        _checked(tmp_path, name, text)


def test_signs_of_parts_are_left_open(tmp_path: Path) -> None:
    found = _checked(tmp_path, "arm.m", MATLAB.replace("G = [", "G = -["))
    assert found.verdict.name == "UNDECIDED"


def test_what_a_method_does_not_set_of_its_object_is_asked_for(tmp_path: Path) -> None:
    text = CPP.replace("  C(1,1) = 0;\n", "")
    found = _checked(tmp_path, "arm.cpp", text)
    assert found.verdict.name == "UNDECIDED"
    assert "entries of C that getC does not set are 0" in " ".join(str(found).split())
    declared = _checked(tmp_path, "arm.cpp", text, convention=HARMLESS)
    assert declared.verdict.name == "PROVED"
    assert f"convention: {HARMLESS}" in str(declared)
    wrong = _checked(tmp_path, "arm.cpp", text.replace("C(1,0) = h", "C(1,0) = -h"))
    assert wrong.verdict.name == "REFUTED"


@pytest.mark.parametrize(
    "more", ["C(1,1) += h;", "C(k,k) = 0;", "if (h > 0) C(1,1) = h;", "C = C + M;"]
)
def test_what_is_set_otherwise_is_not_taken_for_nothing(more: str, tmp_path: Path) -> None:
    text = CPP.replace("C(1,1) = 0;", more)
    try:
        found = _checked(tmp_path, "arm.cpp", text, convention=HARMLESS)
    except InputError:
        return
    assert found.verdict.name not in ("PROVED", "CERTIFIED")


@pytest.mark.parametrize(
    "before",
    ["Arm::Arm() { C(1,1) = 5; }", "struct Arm { Matrix C = ones(); };", "Arm::Arm() : C(5) {}",
     "void Arm::reset() { C.setOnes(); }"],
)  # fmt: skip
def test_what_the_file_sets_elsewhere_is_not_nothing(before: str, tmp_path: Path) -> None:
    text = before + "\n" + CPP.replace("  C(1,1) = 0;\n", "")
    try:
        found = _checked(tmp_path, "arm.cpp", text, convention=HARMLESS)
    except InputError:
        return
    assert found.verdict.name not in ("PROVED", "CERTIFIED")


HEADER = '#include "arm.h"\n'


def test_a_header_that_is_not_here_leaves_all_open_unless_it_changes_nothing(
    tmp_path: Path,
) -> None:
    wrong = CPP.replace("C(1,0) = h", "C(1,0) = -h")
    for text, verdict in ((CPP, "PROVED"), (wrong, "REFUTED")):
        found = _checked(tmp_path, "arm.cpp", HEADER + text)
        assert found.verdict.name == "UNDECIDED"
        assert f"--convention '{HARMLESS}'" in " ".join(str(found).split())
        declared = _checked(tmp_path, "arm.cpp", HEADER + text, convention=HARMLESS)
        assert declared.verdict.name == verdict


FLAT = """#include <math.h>
%s
void inertia_of_arm(const double q[2], double %s[4], double m1, double m2, double l1, double l2)
{
  double c = cos(q[1]);
  %s[0] = (m1 + m2)*l1*l1 + m2*l2*l2 + 2*m2*l1*l2*c;
  %s[1] = m2*l2*l2 + m2*l1*l2*c;
  %s[2] = %s[1];
  %s[3] = m2*l2*l2;
}
"""


def _flat(name: str, first: str = "") -> str:
    return FLAT % (first, *(name,) * 6)


@pytest.mark.parametrize("ending", ["c", "cpp"])
def test_a_matrix_in_one_row_is_known_by_its_name(ending: str, tmp_path: Path) -> None:
    """It takes no speeds: no rates of the state are it."""
    text = _flat("M")
    assert _checked(tmp_path, f"a.{ending}", text).verdict.name == "PROVED"
    for right, wrong in (("2*m2*l1", "m2*l1"), ("l2;\n}", "l1;\n}")):
        assert right in text
        found = _checked(tmp_path, f"a.{ending}", text.replace(right, wrong))
        assert found.verdict.name == "REFUTED"
    with pytest.raises(InputError, match="takes no speeds"):
        _checked(tmp_path, f"a.{ending}", _flat("out"))


def test_c_with_a_header_of_its_own_is_open(tmp_path: Path) -> None:
    text = _flat("M", HEADER)
    wrong = text.replace("2*m2*l1", "m2*l1")
    for told, verdict in ((text, "PROVED"), (wrong, "REFUTED")):
        assert _checked(tmp_path, "a.c", told).verdict.name == "UNDECIDED"
        found = _checked(tmp_path, "a.c", told, convention=HARMLESS)
        assert found.verdict.name == verdict
    with pytest.raises(InputError):  # C's abs is one of integers
        _checked(tmp_path, "a.c", text.replace("cos(q[1])", "cos(abs(q[1]))"), convention=HARMLESS)
