"""Signs of expressions at all states."""

import pytest

from mechanics.kernel.signs import ANY, NEGATIVE, NOT_NEGATIVE, POSITIVE, ZERO, Forms
from mechanics.program import Builder

B = Builder()
X, Y, THETA, PHI = (B.input(name) for name in ("x", "y", "theta", "phi"))
M, K = B.input("m"), B.input("k")

SIGNS = {
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
    "a square that is known": (X * X - 1, [X * X - K - 1], POSITIVE),
    "a cosine by its sine": (1 - 2 * THETA.cos() ** 2, [THETA.sin() - 1 - K], POSITIVE),
    "one after the other": (X, [X - Y, Y - K], POSITIVE),
    "a divisor without a sign": (X, [Y * X - K], ANY),
    "another unknown": (X, [Y - K], ANY),
    "nothing": (X - Y, [], ANY),
    "what is positive everywhere": (X * X + K, [X - Y], POSITIVE),
}


@pytest.mark.parametrize("name", WHERE)
def test_sign_where_others_are_zero(name):
    node, zero, expected = WHERE[name]
    forms = Forms(B, [node.number, *(z.number for z in zero)], {"m", "k"}.__contains__)
    polynomials = [forms.forms[z.number].above for z in zero]
    assert forms.sign_on(forms.forms[node.number], polynomials) == expected
