"""Parts of vectors of Eigen, and what it solves."""

from functools import partial
from pathlib import Path

import pytest

from systems import rod_pendulum
from tests.verdict_of import NOT_READ, verdict_in

SCENE = rod_pendulum.scene()
ROD = """#include <Eigen/Dense>
Eigen::Vector2d rates(const Eigen::Vector2d& x, double u, double m, double l, double g) {
  auto q = x.segment(0, 1);
  Eigen::Vector<double, 1> v = x.tail(1);
  Eigen::Matrix<double, 2, 2> M{{1, 0}, {0, m*l*l/3}};
  Eigen::Vector2d f{{v[0]}, {m*g*l/2*std::sin(q[0]) + u}};
  Eigen::Vector2d dx;
  dx.segment(0, 2) = M.partialPivLu().solve(f);
  return dx;
}
"""
SOLVED = "dx.segment(0, 2) = M.partialPivLu().solve(f);"


_verdict = partial(verdict_in, SCENE, "rod.cpp")


@pytest.mark.sample(4)
@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("", ""),
        ("partialPivLu", "colPivHouseholderQr"),
        ("M.partialPivLu().solve(f)", "M.inverse()*f"),
        ("M.partialPivLu().solve(f)", "M.transpose().lu().solve(f)"),
        ("x.segment(0, 1)", "x.head(1)"),
        ("x.segment(0, 1)", "x.head<1>()"),
        ("x.segment(0, 1)", "x.segment<1>(0)"),
        ("x.segment(0, 1)", "x.template segment<1>(0)"),
        ("dx.segment(0, 2) =", "dx.segment<2>(0) ="),
        ("x.tail(1)", "x.segment(1, 1)"),
        ("dx.segment(0, 2) =", "dx ="),
        (SOLVED, "dx.head(1) = v; dx.segment(1, 1) = M.lu().solve(f).tail(1);"),
    ],
)
def test_what_is_right_is_proved(old: str, new: str, tmp_path: Path) -> None:
    assert _verdict(ROD.replace(old, new) if old else ROD, tmp_path) == "PROVED"


@pytest.mark.sample(6)
@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("m*l*l/3", "m*l*l"),
        ("+ u", "- u/2"),
        ("x.segment(0, 1)", "x.segment(1, 1)"),
        ("x.segment(0, 1)", "x.segment(0, 3)"),
        ("x.segment(0, 1)", "x.segment(2, 1)"),
        ("x.segment(0, 1)", "x.segment<1>(1)"),
        ("x.tail(1)", "x.head(1)"),
        ("x.tail(1)", "x.tail(2)"),
        ("partialPivLu", "llt"),
        ("partialPivLu", "ldlt"),
        ("partialPivLu", "diagonal"),
        ("M.partialPivLu()", "f.partialPivLu()"),
        ("solve(f)", "solve(x)"),
        ("M.partialPivLu().solve(f)", "M*f"),
        (SOLVED, "dx.segment(0, 1) = M.lu().solve(f);"),
        (SOLVED, "dx.segment(1, 1) = v; dx.head(1) = M.lu().solve(f).tail(1);"),
        (SOLVED, "dx.head(1) = v;"),
        (SOLVED, f"q[0] = 0; {SOLVED}"),
        (SOLVED, f"auto w = dx.segment(0, 1); {SOLVED} w[0] = 0;"),
        (SOLVED, f"{SOLVED} dx.tail(1) = 2*dx.tail(1);"),
        (SOLVED, f"M(1, 1) = m*l*l; {SOLVED}"),
        ("Eigen::Matrix<double, 2, 2> M", "Own M"),
        ("#include", "struct Own { double a; Own head(int) { return *this; } };\n#include"),
        ("std::sin", "sin"),
    ],
)
def test_what_is_wrong_is_not_proved(old: str, new: str, tmp_path: Path) -> None:
    assert old in ROD
    text = ROD.replace(old, new)
    if new == "sin":
        text = text.replace("Eigen::Vector2d rates", "double sin(double t) { return t; }\n"
                            "Eigen::Vector2d rates", 1)  # fmt: skip
    elif new.startswith("struct"):
        text = text.replace("const Eigen::Vector2d& x", "const Own& x")
    assert _verdict(text, tmp_path) in ("REFUTED", "UNDECIDED", "not read")


def test_a_wrong_term_is_refuted(tmp_path: Path) -> None:
    assert _verdict(ROD.replace("m*l*l/3", "m*l*l"), tmp_path) == "REFUTED"
    assert _verdict(ROD.replace("x.segment(0, 1)", "x.segment(1, 1)"), tmp_path) == "REFUTED"


STEPS = """#include <Eigen/Dense>
Eigen::Vector2d rates(const Eigen::Vector2d& x, double u, double m, double l, double g) {{
  Eigen::Vector2d d = x;
  {} d(1) = 0; d(0) = {};
  d(1) = 3*g/(2*l)*std::sin(x(0)) + 3*u/(m*l*l);
  return d;
}}
"""


@pytest.mark.parametrize(
    ("name", "value"),
    [("2*d", "t(1)/2"), ("-d", "-t(1)"), ("d + d", "t(1)/2"), ("d", "t(1)"), ("d.tail(1)", "t(0)")],
)
def test_auto_computes_again_what_a_type_keeps(name: str, value: str, tmp_path: Path) -> None:
    kept = f"Eigen::VectorXd t = {name};"
    assert _verdict(STEPS.format(kept, value), tmp_path) == "PROVED"
    if name == "d":
        return
    for again in (f"auto t = {name};", f"auto s = {name}; auto t = s;"):
        assert _verdict(STEPS.format(again, value), tmp_path) == "not read"
        assert _verdict(STEPS.format(again, value).replace("d(1) = 0;", ""), tmp_path) != "REFUTED"


@pytest.mark.parametrize(
    "text",
    [
        STEPS.format("Eigen::Ref<Eigen::Vector2d> t = d;", "t(1)"),
        STEPS.format("auto s = d.head(2); s << 0, x(1);", "x(1)"),
        STEPS.format("auto t = d.tail(1); d << 0, 0;", "t(0)"),
    ],
)
def test_a_part_by_another_name_is_not_read(text: str, tmp_path: Path) -> None:
    assert _verdict(text, tmp_path) == "not read"


MADE = """#include <Eigen/Dense>
#include <cmath>
using Eigen::Vector2d;
Vector2d rates(const Vector2d& y, double u, double m, double l, double g) {
  %s
}
"""
ACCELERATION = "3*g/(2*l)*std::sin(y.x()) + 3*u/(m*l*l)"


@pytest.mark.parametrize(
    ("body", "verdict"),
    [
        (f"Vector2d d(y.y(), {ACCELERATION}); return d;", "PROVED"),
        (f"return Vector2d(y.y(), {ACCELERATION});", "PROVED"),
        (f"Vector2d d = Eigen::Vector2d(y(1), {ACCELERATION}); return d;", "PROVED"),
        (f"Vector2d d; d.x() = y.y(); d.y() = {ACCELERATION}; return d;", "PROVED"),
        (f"Vector2d d({ACCELERATION}, y.y()); return d;", "REFUTED"),
        (f"Vector2d d(y.y(), {ACCELERATION.replace('3*u', '2*u')}); return d;", "REFUTED"),
        (f"Vector2d d; d.y() = y.y(); d.x() = {ACCELERATION}; return d;", "REFUTED"),
        ("Vector2d d(y.y()); return d;", NOT_READ),
        (f"Vector2d d(y.y(), {ACCELERATION}, 0.0); return d;", NOT_READ),
        (f"Vector2d d(y.y(), {ACCELERATION.replace('x()', 'z()')}); return d;", NOT_READ),
    ],
)  # fmt: skip
def test_a_vector_is_made_of_its_entries(body: str, verdict: str, tmp_path: Path) -> None:
    assert _verdict(MADE % body, tmp_path) == verdict
