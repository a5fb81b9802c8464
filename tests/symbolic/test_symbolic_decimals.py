"""Enclosures contain the true value; printed decimals match within half a unit, exactly."""

from decimal import ROUND_HALF_EVEN, Decimal
from fractions import Fraction

import mpmath
import pytest
import sympy as sp
from flint import arb
from hypothesis import given
from hypothesis import strategies as st

from mechanics.errors import ExpressionError
from mechanics.symbolic import decimal_matches, enclose

x = sp.Symbol("x", real=True)


def test_a_printed_root():
    half = enclose(1 / sp.sqrt(2), {})
    assert decimal_matches(half, "0.7071")
    assert decimal_matches(half, "0.71")
    assert decimal_matches(-half, "\N{MINUS SIGN}0.7071")
    assert not decimal_matches(half, "0.7072")
    assert not decimal_matches(half, "0.70710")


def test_exponents_and_ties():
    assert decimal_matches(arb("0.00125"), "1.25e-3")
    assert decimal_matches(arb(1) / 8, "0.13")
    assert decimal_matches(arb(1) / 8, "0.12")
    assert not decimal_matches(arb(1) / 8, "0.125001")
    assert decimal_matches(arb(880), "8.8e2")


def test_a_wide_enclosure_proves_nothing():
    assert not decimal_matches(arb(1) / 2 + arb(0, 1), "0.5")
    assert not decimal_matches(arb.nan(), "0.5")


@pytest.mark.parametrize("text", ["one", "", "inf", "nan"])
def test_what_is_no_decimal_says_so(text):
    with pytest.raises(ValueError, match="decimal number: write it like"):
        decimal_matches(arb(1), text)


@given(st.fractions(-100, 100), st.integers(0, 12))
def test_rounding_matches(value, places):
    with_digits = Decimal(value.numerator) / Decimal(value.denominator)
    printed = with_digits.quantize(Decimal(1).scaleb(-places), rounding=ROUND_HALF_EVEN)
    ball = enclose(x, {x: value}, bits=200)
    unit = Fraction(1, 10**places)
    off = abs(value - Fraction(printed))
    assert decimal_matches(ball, f"{printed:f}") or off == unit / 2
    assert not decimal_matches(ball, f"{printed + Decimal(2).scaleb(-places):f}")


@pytest.mark.campaign
@given(st.fractions(-10, 10, max_denominator=1000))
def test_enclosures_contain_what_another_library_computes(value):
    expr = sp.sin(x) * sp.exp(x) + sp.Abs(x) / sp.sqrt(1 + x**2) + sp.Max(x, sp.pi) + sp.atan2(x, 2)
    ball = enclose(expr, {x: value}, bits=90)
    with mpmath.workdps(60):
        v = mpmath.mpf(value.numerator) / value.denominator
        wanted = (mpmath.sin(v) * mpmath.exp(v) + abs(v) / mpmath.sqrt(1 + v * v)
                  + max(v, mpmath.pi) + mpmath.atan2(v, 2))  # fmt: skip
        middle = mpmath.mpf(ball.mid().str(60, radius=False))
        assert abs(wanted - middle) < mpmath.mpf(10) ** -15
    assert ball.rad() < arb("1e-20")


def test_missing_values_are_named():
    with pytest.raises(ExpressionError, match="symbol x has no value"):
        enclose(x, {})
    with pytest.raises(ExpressionError, match="function f has no value"):
        enclose(sp.Function("f")(x), {x: 1})


def test_undefined_is_not_finite():
    assert not enclose(sp.sqrt(x), {x: -1}).is_finite()
    assert not enclose(1 / x, {x: 0}).is_finite()
    assert not enclose(sp.log(x), {x: -1}).is_finite()
