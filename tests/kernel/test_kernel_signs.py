"""Signs of expressions at all states."""

from fractions import Fraction

import pytest

from mechanics.kernel.signs import (
    ANY,
    NEGATIVE,
    NOT_NEGATIVE,
    NOT_POSITIVE,
    POSITIVE,
    ZERO,
    Fact,
    Forms,
)
from mechanics.program import Builder

B = Builder()
X, Y, THETA, PHI = (B.input(name) for name in ("x", "y", "theta", "phi"))
M, K = B.input("m"), B.input("k")
TWO, THREE, FIVE, SIX = (B.constant(n).sqrt() for n in (2, 3, 5, 6))
PENTAGON = (10 - 2 * FIVE).sqrt() / 4
"""sin(pi/5) = 0.587785..."""

COSINE = THETA.cos()
BERNSTEIN = sum(
    c * (1 + COSINE) ** i * (1 - COSINE) ** (3 - i) for i, c in enumerate((1, 60, 3, 20))
)
"""Bernstein's form in (1 + cos)/2, whose coefficients are all positive; its terms are not."""

SIGNS = {
    "a sum of Bernstein polynomials": (BERNSTEIN, POSITIVE),
    "terms": (M * X * X + K, POSITIVE),
    "terms of both signs": (M * X * X - K, ANY),
    "below": (-1 - X * X, NEGATIVE),
    "a completed square": (X * X + X * Y + Y * Y, NOT_NEGATIVE),
    "a square": (X * X - 2 * X * Y + Y * Y, NOT_NEGATIVE),
    "a quotient": (X * X / (K + Y * Y), NOT_NEGATIVE),
    "a determinant": (M + K - K * (THETA - PHI).cos() * (PHI - THETA).cos(), POSITIVE),
    "Bernstein": (2 + THETA.cos() * PHI.sin(), POSITIVE),
    "Bernstein, touching": (1 - THETA.cos(), NOT_NEGATIVE),
    "sines and cosines": (THETA.sin() ** 2 + THETA.cos() ** 2 - 1, ZERO),
    "a modulus": (abs(X) + M, POSITIVE),
    "a root": ((X * X + 1).sqrt(), POSITIVE),
    "a root squared": ((X * X + 1).sqrt() ** 2 - X * X, POSITIVE),
    "the larger of x and 0": ((X + abs(X)) / 2, NOT_NEGATIVE),
    "the smaller of x and 0": ((X - abs(X)) / 2, NEGATIVE | ZERO),
    "a modulus by a root": ((X * X).sqrt() - abs(X), ZERO),
    "Cauchy-Schwarz": (1 - (X * Y + 1) ** 2 / ((1 + X * X) * (1 + Y * Y)), NOT_NEGATIVE),
    "sines of opposite angles": ((X - Y).sin() + (Y - X).sin(), ZERO),
    "cosines of opposite angles": ((X - Y).cos() - (Y - X).cos(), ZERO),
    "a ratio of opposite sines": ((X - Y).sin() / (Y - X).sin() + 1, ZERO),
    "the sine of a difference": (
        1 - (THETA.cos() * PHI.cos() + THETA.sin() * PHI.sin()) ** 2,
        NOT_NEGATIVE,
    ),
    "the sine of a sum": (
        (THETA.cos() * PHI.cos() - THETA.sin() * PHI.sin()) ** 2 - 1,
        NOT_POSITIVE,
    ),
    "the cosine of a sum": (
        2 - 2 * (THETA.sin() * PHI.cos() + PHI.sin() * THETA.cos()) ** 2,
        NOT_NEGATIVE,
    ),
    "more than the sine of a sum": (THETA.cos() * PHI.cos() - THETA.sin() * PHI.sin(), ANY),
    "a modulus squared": (abs(X - Y) ** 2 - (X - Y) ** 2, ZERO),
    "squares that are zero at a sample": ((X + 1) ** 2 + (8 * Y + 3) ** 2, NOT_NEGATIVE),
    "squares that are zero at another": ((Y + 1) ** 2 + (8 * X + 3) ** 2, NOT_NEGATIVE),
    "a root in a root": (PENTAGON * M - M * Fraction(58778, 10**5), POSITIVE),
    "a root in a root, from above": (
        PENTAGON * X * X - X * X * Fraction(58779, 10**5),
        NOT_POSITIVE,
    ),
    "roots whose product is a root": (
        PENTAGON * (10 + 2 * FIVE).sqrt() - B.constant(5).sqrt(),
        ZERO,
    ),
    "nearly that": (
        PENTAGON * (10 + 2 * FIVE).sqrt() - B.constant(5).sqrt() + Fraction(1, 10**90),
        POSITIVE,
    ),
    "a nested root that is a sum": ((5 + 2 * SIX).sqrt() - TWO - THREE, ZERO),
    "a fraction in a nested root": ((Fraction(1, 2) + TWO / 4).sqrt() - Fraction(12, 13), POSITIVE),
    "a sine of a number": (B.constant(Fraction(3, 10)).sin() - Fraction(3, 10), NEGATIVE),
    "pi": (B.pi - Fraction(355, 113), NEGATIVE),
    "pi and a root": (B.pi - TWO - THREE, NEGATIVE),
    "a number without a root": (1 - FIVE, NEGATIVE),
    "a choice": (B.less(X, Y).choose(X * X + 1, K), POSITIVE),
    "a choice of both signs": (B.less(X, Y).choose(-1 - X * X, K), ANY),
    "a choice of what is not positive": (B.less(X, Y).choose(-X * X, -K), NEGATIVE | ZERO),
    "a truth value": (B.less(X, Y), NOT_NEGATIVE),
    "nothing is known": (X - Y, ANY),
}


@pytest.mark.parametrize("name", SIGNS)
def test_sign(name):
    node, expected = SIGNS[name]
    forms = Forms(B, [node.number], {"m", "k"}.__contains__)
    assert forms.sign_of(forms.forms[node.number]) == expected


POWERS = {
    "a power of what is positive": (K.power(X), POSITIVE),
    "a power of anything": (X.power(Y), NOT_NEGATIVE),
}


@pytest.mark.parametrize("name", POWERS)
def test_sign_of_a_power(name):
    node, expected = POWERS[name]
    forms = Forms(B, [node.number], {"m", "k"}.__contains__)
    assert forms.sign_of(forms.forms[node.number]) == expected


WHERE = {
    "a number on a line": (X - Y, [X - Y - K], POSITIVE),
    "a quotient": (X, [M * X - K], POSITIVE),
    "a quotient below": (X, [M * X + K], NEGATIVE),
    "a divisor below": (X, [-M * X - K], NEGATIVE),
    "what vanishes and more": (M * X * X + K * X + K, [M * X + K], POSITIVE),
    "a form of both": (M**2 * X**2 - K**2 * Y**2 + K, [M * X - K * Y], POSITIVE),
    "a square that is known": (X * X - 1, [X * X - K - 1], POSITIVE),
    "a cosine by its sine": (1 - 2 * THETA.cos() ** 2, [THETA.sin() - 1 - K], POSITIVE),
    "a cosine by a sine below zero": (1 - 2 * THETA.cos() ** 2, [THETA.sin() + 1 + K], POSITIVE),
    "a cosine and its sine": (THETA.cos() ** 2 - 1 + X * X, [THETA.sin() - X], ZERO),
    "one after the other": (X, [X - Y, Y - K], POSITIVE),
    "a divisor without a sign": (X, [Y * X - K], ANY),
    "another unknown": (X, [Y - K], ANY),
    "nothing": (X - Y, [], ANY),
    "what is positive everywhere": (X * X + K, [X - Y], POSITIVE),
    "a root": ((X * X - Y).sqrt(), [X * X - Y - K], POSITIVE),
    "a root and a mass": (M * (X * X - Y).sqrt(), [X * X - Y - K], POSITIVE),
    "a root that is zero there": ((X * X - Y).sqrt(), [X * X - Y], NOT_NEGATIVE),
    "a root and a square": (X * X * (X * X - Y).sqrt(), [X * X - Y - K], NOT_NEGATIVE),
    "a square": (X * X, [X * X - Y - K], NOT_NEGATIVE),
}


@pytest.mark.parametrize("name", WHERE)
def test_sign_where_others_are_zero(name):
    node, zero, expected = WHERE[name]
    forms = Forms(B, [node.number, *(z.number for z in zero)], {"m", "k"}.__contains__)
    polynomials = [forms.forms[z.number].above for z in zero]
    assert forms.sign_on(forms.forms[node.number], polynomials) == expected


NOT_ZERO = NEGATIVE | POSITIVE
KNOWN = {
    "the fact": (X - Y, X - Y, POSITIVE, POSITIVE),
    "its negative": (Y - X, X - Y, POSITIVE, NEGATIVE),
    "a multiple": (3 * X - 3 * Y, X - Y, NOT_NEGATIVE, NOT_NEGATIVE),
    "a negative multiple": (3 * Y - 3 * X, X - Y, NOT_NEGATIVE, NOT_POSITIVE),
    "the fact and more": (X, X - 1, POSITIVE, POSITIVE),
    "the fact, zero too, and more": (X, X - K, NOT_NEGATIVE, POSITIVE),
    "the fact and a square": (X, X - Y * Y, NOT_NEGATIVE, NOT_NEGATIVE),
    "less than the negative": (-X, X - K, POSITIVE, NEGATIVE),
    "the fact and less": (X, X + K, POSITIVE, ANY),
    "what is not positive says nothing of more": (X, X - 1, NOT_POSITIVE, ANY),
    "a square that is not zero": (X, X * X - K, NOT_NEGATIVE, NOT_ZERO),
    "a square that may be zero": (X, X * X, NOT_NEGATIVE, ANY),
    "a square of two terms": (X - Y, X * X - K, POSITIVE, ANY),
    "a modulus": (X - Y, abs(X - Y), POSITIVE, NOT_ZERO),
    "a modulus that may be zero": (X - Y, abs(X - Y), NOT_NEGATIVE, ANY),
    "a modulus of others": (X - Y, abs(X), POSITIVE, ANY),
    "a product": (M * (X - Y), X - Y, POSITIVE, POSITIVE),
    "another fact": (X, Y, POSITIVE, ANY),
}


@pytest.mark.parametrize("name", KNOWN)
def test_sign_where_a_fact_holds(name):
    node, fact, signs, expected = KNOWN[name]
    forms = Forms(B, [node.number, fact.number], {"m", "k"}.__contains__)
    known = Fact(forms.forms[fact.number].above, signs)
    assert forms.sign_of(forms.forms[node.number], [known]) == expected
    assert forms.sign_of(forms.forms[node.number]) == ANY
