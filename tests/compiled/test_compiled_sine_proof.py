"""The text of the inline sine and cosine is proved, and what is wrong with it is found."""

import functools
import re
from fractions import Fraction

import numpy as np
import pytest
from flint import arb

from mechanics.compiled.c.sine import LIMIT, sine_source
from mechanics.compiled.translation_validation.sine import MOST, verify_sine
from mechanics.compiled.translation_validation.sine.affine import (
    Affine,
    AffineForms,
    half_pi,
    half_unit,
)
from mechanics.compiled.translation_validation.sine.machine import sincos
from mechanics.compiled.translation_validation.sine.reduction import nearest_multiple, reduced
from mechanics.compiled.translation_validation.sine.walk import Function
from mechanics.errors import ExpressionError
from mechanics.kernel import Finding, Verdict
from mechanics.kernel.balls import precision
from mechanics.program.c.parse import parse

pytestmark = pytest.mark.campaign

HEAD = "#include <math.h>\n#include <stdint.h>\n"
KINDS = ("double", "float")
BITS = {"double": 53, "float": 24}


@functools.cache
def text(kind: str) -> str:
    return HEAD + sine_source(kind)


def edited(kind: str, old: str, new: str) -> Finding:
    assert text(kind).count(old) == 1, old
    return verify_sine(text(kind).replace(old, new), kind)


@pytest.mark.parametrize("kind", KINDS)
def test_the_text_is_proved(kind: str) -> None:
    found = verify_sine(text(kind), kind)
    assert found.verdict is Verdict.PROVED, found.evidence
    assert f"|x| <= {LIMIT:g}" in found.evidence
    ulps = re.match(r"off by at most ([\d.]+) and ([\d.]+) ulp", found.evidence)
    assert ulps is not None
    assert all(1 < float(ulp) <= MOST for ulp in ulps.groups())


def test_layout_comments_and_other_functions_do_not_matter() -> None:
    spread = (
        text("double").replace("    ", "\t").replace(", ", ",\n") + "int one(void) { return 1; }"
    )
    assert verify_sine(spread).verdict is Verdict.PROVED


SPOILT = [
    ("double", "0x1.5555555555548p-3", "0x1.5555555555648p-3"),
    ("double", "-0x1.5d8f94e117d01p-33", "-0x1.6d8f94e117d01p-33"),
    ("double", "0x1.555555555554bp-5", "0x1.555555555564bp-5"),
    ("double", "0x1.1a62633p-54", "0x1.1a62634p-54"),
    ("double", "const double n = shifted - 0x1.8p52", "const double n = shifted + 0x1.8p52"),
    ("double", "mechanics_fma(r * z, p0, low)", "mechanics_fma(r * z, p0, -low)"),
    ("double", "quadrant + 1u)", "quadrant + 3u)"),
    ("double", "double odd = quadrant & 1u ? c : s", "double odd = quadrant & 1u ? s : c"),
    ("double", "(n & 2u) << 62", "(n & 1u) << 62"),
    ("float", "0x1.555556p-3f", "0x1.55557ep-3f"),
    ("float", "-0.5f", "0.5f"),
    ("float", "*sine = mechanics_turnedf(odd", "*sine = mechanics_turnedf(even"),
]


@pytest.mark.parametrize(("kind", "old", "new"), SPOILT)
def test_a_spoilt_text_is_refuted(kind: str, old: str, new: str) -> None:
    found = edited(kind, old, new)
    assert found.verdict is Verdict.REFUTED, found.evidence
    assert found.witness is not None
    assert found.witness.state[0][0] == "x"


DOUBTFUL = [
    ("double", "0x1.45c06e0e68948p-86", "0x1.55c06e0e68948p-86", "1.6"),
    ("double", "return !(fabs(x) <= 1048576.0);", "return fabs(x) <= 1048576.0;", "mechanics_far"),
    ("double", "fabs(x) <= 1048576.0", "fabs(x) <= 1e9", "quotient"),
    ("double", "const double z = r * r", "const double z = z * r", "made of itself"),
    ("double", "const double z = r * r", "const double z = r / r", "/ is not supported"),
    ("double", "const double z = r * r", "double z", "no value"),
    ("float", "const float z = r * r;", "const float z = r * r; const float r2 = z;", ""),
]


@pytest.mark.parametrize(("kind", "old", "new", "why"), DOUBTFUL)
def test_doubt_is_no_success(kind: str, old: str, new: str, why: str) -> None:
    found = edited(kind, old, new)
    assert found.verdict in (Verdict.UNDECIDED, Verdict.REFUTED) or not why
    assert found.verdict is not Verdict.PROVED or "r2" in new
    assert why in found.evidence or found.verdict is Verdict.REFUTED


def test_no_text_is_no_sine() -> None:
    found = verify_sine("int one(void) { return 1; }")
    assert found.verdict is Verdict.UNDECIDED
    assert "there is no function mechanics_far" in found.evidence


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("macros", [{"__FMA__": "1"}, {}], ids=["fused", "not fused"])
def test_bounds_hold_where_they_are_tightest(kind: str, macros: dict[str, str]) -> None:
    # Next to multiples of pi/2, r is small: the reduction alone decides on the error.
    f = "f" if kind == "float" else ""
    source = parse(text(kind), defined=macros)
    number = np.float32 if kind == "float" else np.float64
    for n in (1, 2, 3, 355, 33_102, 103_993, 312_689, 573_204):
        x = float(number(n * np.longdouble(np.pi) / 2))
        with precision(300):
            exact = arb(x).sin_cos()
            for found, true in zip(sincos(source, f"mechanics_sincos{f}", x), exact, strict=True):
                unit = np.spacing(number(max(abs(found), abs(float(true)))))
                assert abs(arb(found) - true) <= MOST * float(unit)


def test_numbers_do_not_come_nearer_to_multiples_than_bounded() -> None:
    for e in (0, 3, 9):
        turns = int(2.0 ** (e + 1) / np.pi * 2) + 1
        bound = nearest_multiple(e, "float", turns)
        with precision(200):
            quarter = arb.pi() / 2
            gaps = []
            for n in range(1, turns + 1):
                middle = np.float32(float(n * quarter))
                for x in (
                    np.nextafter(middle, np.float32(0)),
                    middle,
                    np.nextafter(middle, 2 * middle),
                ):
                    if 2.0**e <= x < 2.0 ** (e + 1):
                        gaps.append(float(abs(arb(float(x)) - n * quarter)))
        assert float(bound) <= min(gaps)
        assert float(bound) > 0


def test_roundings_are_bounded() -> None:
    assert half_unit("double", Fraction(1)) == Fraction(1, 2**54)
    assert half_unit("double", 1 + Fraction(1, 2**60)) == Fraction(1, 2**53)
    assert half_unit("float", Fraction(1, 2**200)) == Fraction(1, 2**150)
    low, high = half_pi()
    assert 0 < high - low < Fraction(1, 2**390)


def test_exact_products_are_not_rounded() -> None:
    forms = AffineForms(Fraction(2**20), Fraction(4, 5))
    n = Affine("double", b=Fraction(1), grid=0)
    short, long = (Fraction(float.fromhex(h)) for h in ("0x1.921fb544p+0", "0x1.921fb54442d18p+0"))
    assert not forms.product("double", n, forms.number("double", short)).inexact
    assert forms.product("double", n, forms.number("double", long)).inexact


def test_reduction_error_is_small_beside_the_angle() -> None:
    for kind in KINDS:
        f = "f" if kind == "float" else ""
        source = parse(text(kind), defined={"__FMA__": "1"})
        for one in reduced(source, f"mechanics_sincos{f}", kind, Fraction(LIMIT)):
            # Relative to the nearest angle, in units of its rounding.
            assert one.error / one.nearest < Fraction(1, 2 ** (BITS[kind] + 2))


def test_functions_are_followed_or_refused() -> None:
    source = parse("static double f(double x) { const double y = x; return y; }")
    with pytest.raises(ExpressionError, match="there is no function g"):
        Function(source, "g", AffineForms(Fraction(1), Fraction(1)), {})
    forms = AffineForms(Fraction(1), Fraction(1))
    with pytest.raises(ExpressionError, match="x has no value"):
        Function(source, "f", forms, {})["y"]
