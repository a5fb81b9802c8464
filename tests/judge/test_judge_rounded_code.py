"""Code that rounds to single precision among doubles: wrong by more, or right if that is exact."""

from pathlib import Path

import pytest

from mechanics import check
from mechanics.errors import InputError
from systems import rod_pendulum

SCENE = rod_pendulum.scene()
EXACT = "single precision as exact"
HEAD = "double acc(double theta, double theta_dot, double u, double m, double l, double g)"
BODIES = (
    "const float k = 1.5f; return k*g/l*sin(theta) + 3*u/(m*l*l);",
    "float s = sin(theta); return 1.5*g/l*s + 3*u/(m*l*l);",
    "return (float)(1.5*g)/l*sin(theta) + 3*u/(m*l*l);",
    "float a[2]; a[0] = 1.5*g/l; a[1] = 3*u/(m*l*l); return a[0]*sin(theta) + a[1];",
)
WRONG = ("sin(theta) + 3*", "sin(2*theta) + 3*"), ("3*u/(m*l*l)", "3*u/(m*l)"), ("1.5", "2.5")


def _checked(body: str, ending: str, folder: Path, before: str = "", **how: object):
    path = folder / f"own.{ending}"
    path.write_text(f"#include <math.h>\n{before}\n{HEAD}\n{{ {body} }}\n")
    return check(SCENE, path, blame=False, **how)


@pytest.mark.sample(3)
@pytest.mark.parametrize("ending", ["c", "cpp"])
@pytest.mark.parametrize("body", BODIES)
def test_what_is_right_in_exact_numbers_is_right_if_these_count(
    body: str, ending: str, tmp_path: Path
) -> None:
    found = _checked(body, ending, tmp_path)
    assert found.verdict.name == "UNDECIDED"
    assert f"--convention '{EXACT}'" in found.judged[0].finding.evidence
    declared = _checked(body, ending, tmp_path, convention=EXACT)
    assert declared.verdict.name == "PROVED"
    assert "convention: single precision counts as exact" in str(declared)


@pytest.mark.sample(3)
@pytest.mark.parametrize("ending", ["c", "cpp"])
@pytest.mark.parametrize("body", BODIES)
def test_what_is_wrong_by_more_than_roundings_is_refuted(
    body: str, ending: str, tmp_path: Path
) -> None:
    wrong = [body.replace(a, b) for a, b in WRONG if a in body]
    assert wrong
    for one in wrong:
        assert _checked(one, ending, tmp_path).verdict.name == "REFUTED"
        assert _checked(one, ending, tmp_path, convention=EXACT).verdict.name == "REFUTED"


@pytest.mark.parametrize("ending", ["c", "cpp"])
def test_a_difference_like_a_rounding_is_open(ending: str, tmp_path: Path) -> None:
    body = BODIES[0].replace("1.5f", "1.500001f")
    assert _checked(body, ending, tmp_path).verdict.name == "UNDECIDED"


@pytest.mark.parametrize("ending", ["c", "cpp"])
@pytest.mark.parametrize(
    ("before", "body"),
    [
        ("", "float k = 1.5; if (k < 1.5) { k = 2.0; } return k*g/l*sin(theta) + 3*u/(m*l*l);"),
        ("", "float k = 0.7f; return (k*10 < 7 ? 1.5 : 2)*g/l*sin(theta) + 3*u/(m*l*l);"),
        ("", "float k = 0.7f; return (0.5 + floor(k*10)/7)*g/l*sin(theta) + 3*u/(m*l*l);"),
        ("", "float k = 0.7f; return (1.5 + (k*10 > 7.5))*g/l*sin(theta) + 3*u/(m*l*l);"),
        ("", "float k = 1e8f; return ((k + 1.5) - k)*g/l*sin(theta) + 3*u/(m*l*l);"),
        ("", "float k = 0.7f; return (1.5 + fmod(k*10, 7))*g/l*sin(theta) + 3*u/(m*l*l);"),
        ("", "float k = 0.1f; return (1.5 + (int)(k*10))*g/l*sin(theta) + 3*u/(m*l*l);"),
        ("#define LESS(x) ((x) < 7 ? 1.5 : 2.0)",
         "float k = 0.7f; return LESS(k*10)*g/l*sin(theta) + 3*u/(m*l*l);"),
        ("static double s(double x) { return x < 7 ? 1.5 : 2; }",
         "float k = 0.7f; return s(k*10)*g/l*sin(theta) + 3*u/(m*l*l);"),
        ("static double s(double x) { return lround(x); }",
         "float k = 0.7f; return s(k*2)*1.5*g/l*sin(theta) + 3*u/(m*l*l);"),
    ],
)  # fmt: skip
def test_what_a_rounding_may_make_another_one_is_not_read(
    before: str, body: str, ending: str, tmp_path: Path
) -> None:
    with pytest.raises(InputError):
        _checked(body, ending, tmp_path, before, convention=EXACT)


@pytest.mark.sample(4)
@pytest.mark.parametrize(
    ("before", "body", "endings"),
    [
        ("#define real float", "real s = sin(theta); return 1.5*g/l*s + 3*u/(m*l*l);", "c cpp"),
        ("typedef float real;", "const real s = sin(theta); return 1.5*g/l*s + 3*u/(m*l*l);",
         "cpp"),
        ("using real = float;", "real s = sin(theta); return 1.5*g/l*s + 3*u/(m*l*l);", "cpp"),
        ("", "float const s = sin(theta); return 1.5*g/l*s + 3*u/(m*l*l);", "c cpp"),
        ("", "auto s = 0.5f; s = sin(theta); return 1.5*g/l*s + 3*u/(m*l*l);", "cpp"),
        ("", "return 4.5*(1.0f/3.0f)*g/l*sin(theta) + 3*u/(m*l*l);", "c cpp"),
        ("", "return 4.5*(1/3.0f)*g/l*sin(theta) + 3*u/(m*l*l);", "c cpp"),
        ("", "return 1.5*((4096.0f*4096.0f + 1.0f) - 4096.0f*4096.0f)*g/l*sin(theta)"
         " + 3*u/(m*l*l);", "c cpp"),
        ("", "return 1.5*g/l*sin(theta) + 3*u/(m*l*fmaxf(l, -l));", "c cpp"),
        ("", "double c = cbrtf(l); return 1.5*g/l*sin(theta) + 3*u/(m*c*c*c*l);", "c"),
        ("", "return fmaf(1.5*g/l, sin(theta), 3*u/(m*l*l));", "c"),
        ("", "std::array<float, 1> s; s[0] = sin(theta); return 1.5*g/l*s[0] + 3*u/(m*l*l);",
         "cpp"),
        ("", "Eigen::Vector2f s; s << sin(theta), 0; return 1.5*g/l*s(0) + 3*u/(m*l*l);", "cpp"),
        ("", "Eigen::Matrix<float, 2, 1> s; s(0) = sin(theta); return 1.5*g/l*s(0) + 3*u/(m*l*l);",
         "cpp"),
    ],
)  # fmt: skip
def test_single_precision_by_other_words_is_single_precision(
    before: str, body: str, endings: str, tmp_path: Path
) -> None:
    for ending in endings.split():
        assert _checked(body, ending, tmp_path, before).verdict.name == "UNDECIDED"


def test_it_stands_beside_another_option(tmp_path: Path) -> None:
    how = {"convention": EXACT, "values": {"g": 9.81}}
    assert _checked(BODIES[0], "c", tmp_path, **how).verdict.name == "PROVED"


def test_an_argument_that_is_not_used_is_no_double_among_others(tmp_path: Path) -> None:
    text = """struct State { float theta; float theta_dot; };
float acc(const State &s, float u, float m, float l, float g, double t)
{ const float k = 0.3f; return 5*k*g/l*sinf(s.theta) + 3*u/(m*l*l) + 0*%s; }
"""
    path = tmp_path / "own.cpp"
    for last, verdict in (("u", "PROVED"), ("t", "UNDECIDED")):
        path.write_text(f"#include <math.h>\n{text % last}")
        assert check(SCENE, path, blame=False).verdict.name == verdict


@pytest.mark.parametrize(
    "lost", ["16777217.0f - 16777216.0f", "1e8f + 1.0f - 1e8f", "1e39f*0.0f + 1.0f"]
)
def test_a_literal_beside_which_single_precision_loses_a_one_is_refused(
    tmp_path: Path, lost: str
) -> None:
    path = tmp_path / "a.c"
    path.write_text(
        "#include <math.h>\nfloat accel(float theta, float m, float l, float g, float u) {\n"
        f"  return ({lost})*(3*g/(2*l)*sinf(theta) + 3*u/(m*l*l));\n}}\n"
    )
    with pytest.raises(InputError, match="single precision loses"):
        check(SCENE, path, convention=EXACT)
