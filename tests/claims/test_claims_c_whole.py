"""Integers of C that stand for parameters are divided as C divides them, never as real numbers."""

import pytest

import mechanics
from mechanics.errors import InputError
from systems import rod_pendulum

SCENE = rod_pendulum.scene()
RATES = "3*g/(2*l)*sin(th) + 3*u/(m*l*l)"
HALVED = "3*g/(4*half)*sin(th) + 3*u/(m*l*l)"


def verdict(above: str, body: str, formula: str, arguments: str = "double m, double g") -> str:
    text = f"#include <math.h>\n{above}\ndouble acc(double th, double u, {arguments})\n"
    text += f"{{ {body} return {formula}; }}\n"
    (judged,) = mechanics.check(SCENE, text, notation="c", blame=False).judged
    return judged.finding.verdict.name


@pytest.mark.parametrize(
    ("above", "body", "formula"),
    [
        ("#define l 5", "double half = l/2;", HALVED),
        ("#define l 5\n#define half (l/2)", "", HALVED),
        ("#define l 5\n#define twice (2*l)\n#define other (3/twice)", "", f"{RATES} + 0*other"),
        ("static const int l = 5;", "double half = l/2;", HALVED),
        ("static const int l = 5;\nstatic const double half = l/2;", "", HALVED),
        ("", "int l = 5; double half = l/2;", HALVED),
        ("#define L 5", "double half = L/2;", HALVED.replace("l*l", "L*L")),
        ("#define l 5", "int k = 2; double half = l/k;", HALVED),
        ("#define l 5", "double half = (double) (l/2);", HALVED),
        ("#define l 5", "double half = l % 3;", HALVED),
        ("#define l 100000", "", "3*g/(2*l)*sin(th) + 3*u/(l*l*m)"),
        ("#define l 5", "double z = l - 6u;", f"{RATES} + 0*z"),
    ],
)  # fmt: skip
def test_what_c_does_with_integers_is_no_formula_of_reals(above, body, formula):
    with pytest.raises(InputError, match="integer"):
        verdict(above, body, formula)


@pytest.mark.parametrize(
    ("above", "body", "formula"),
    [
        ("#define l 5", "double half = 0.5*l;", HALVED),
        ("#define l 5", "double half = (double) l/2;", HALVED),
        ("#define l 5.0", "double half = l/2;", HALVED),
        ("static const int l = 5;", "", RATES),
        ("", "const int l = 5;", RATES),
        ("static const double l = 5;", "double half = l/2;", HALVED),
    ],
)  # fmt: skip
def test_integers_beside_doubles_are_doubles(above, body, formula):
    assert verdict(above, body, formula) == "PROVED"


CPP = [
    ("constexpr int l = 5;", "double half = l/2;", HALVED),
    ("constexpr auto l = 5;", "auto half = l/2;", HALVED),
    ("const int l = 100000;", "", "3*g/(2.0*l)*sin(th) + 3*u/(l*l*m)"),
    ("#define l 5", "double half = l/2;", HALVED),
]


@pytest.mark.parametrize("suffix", [".cpp", ".ino"])
@pytest.mark.parametrize(("above", "body", "formula"), CPP)
def test_integers_of_cpp_are_told_from_parameters(tmp_path, suffix, above, body, formula):
    file = tmp_path / f"mine{suffix}"
    head = "double acc(double th, double u, double m, double g)"
    file.write_text(f"#include <cmath>\n{above}\n{head}\n{{ {body} return {formula}; }}\n")
    # An int of a small processor has 16 bits, which 100000 does not fit.
    words = "an integer of the code stands for a parameter|l is int: 100000 does not fit"
    with pytest.raises(InputError, match=words):
        mechanics.check(SCENE, file, blame=False)
