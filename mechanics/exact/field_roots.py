"""Roots in the field: w = x**(1/k) is the k-th root among the squares.

The squares form a group of odd order (p - 1)/2. With p = -1 (mod 840) that order is prime to 2, 3,
5 and 7, so every square has exactly one k-th root there, and

    sqrt(a b) = sqrt(a) sqrt(b),      sqrt(L**2) = L

hold whenever a, b and L are squares, as they do for positive numbers. A radicand that is no square
is a negative one, and the point is drawn again.

What a root does to the error bound of `field`: w joins a new element to the field of fractions.

- If x is no k-th power there (k prime), w has k conjugates. N is replaced by its norm, the product
  over them, whose degree and height are k times as large. W = (P Q**(k-1))**(1/k), w = W / Q for
  x = P / Q, grows along every ray like a polynomial of degree (deg P + (k-1) deg Q)/k, whatever the
  branch, so the rules of `field_number` bound the norm.
- If x = y**k for odd k, then w = y, in the reals and in the field, where odd roots are unique.
- If x = y**2, then w = +y or -y: in the reals by the sign of y, in the field by its quadratic
  character. They may differ. `field_trial` tells these cases apart and counts them.

Roots of 2, 3, 5 and 7 are joined before all others; each is new to all that came before it.
"""

from __future__ import annotations

from fractions import Fraction
from math import isqrt, log2
from typing import TYPE_CHECKING

from mechanics.errors import ExpressionError
from mechanics.exact.field_number import FieldNumber
from mechanics.exact.field_size import Size
from mechanics.exact.signals import Inadmissible

if TYPE_CHECKING:
    from mechanics.exact.field import FieldArithmetic

PRIMES = (2, 3, 5, 7)


def power(a: FieldArithmetic, number: FieldNumber, exponent: Fraction) -> FieldNumber:
    """Return a rational power, root by prime root.

    Raises
    ------
    Inadmissible
        If the radicand is no square here.
    ExpressionError
        If the denominator of the exponent has a prime factor above 7.
    """
    degree, result = exponent.denominator, number
    for k in PRIMES:
        while degree % k == 0:
            result, degree = root(a, result, k), degree // k
    if degree != 1:
        raise ExpressionError(
            f"power {exponent}: roots of degree 2, 3, 5, 7 and their products only; rewrite it"
        )
    return result**exponent.numerator


def root(a: FieldArithmetic, x: FieldNumber, k: int) -> FieldNumber:
    """Return the k-th root for k = 2, 3, 5 or 7; equal radicands have one root."""
    if x.residue == 0:
        size = Size()
        size.add(x)
        a.count_branch(size.degree, size.height)
        return a.rational(0)
    key = (k, x.residue)
    if key not in a.roots:
        a.sighted(x)
        ratio = a.ratios.get(x.residue) if k == 2 and not x.numerator else None
        a.roots[key] = _joined(a, x, k) if ratio is None else _surd(a, ratio)
    return a.roots[key]


def _joined(a: FieldArithmetic, x: FieldNumber, k: int) -> FieldNumber:
    p, half = a.prime, (a.prime - 1) // 2
    square = pow(x.residue, half, p) == 1
    if k == 2:
        a.square_roots += 1
        if not square:
            a.memory.not_squares.add(a.square_roots - 1)
    if not square and (k == 2 or a.real):
        raise Inadmissible("a radicand is negative")
    a.log2_conjugates += log2(k)
    residue = pow(x.residue, pow(k, -1, half), p)
    if not square or (not a.real and k == 2 and a.source.random() < 0.5):
        residue = p - residue
    degree = (x.numerator + (k - 1) * x.denominator) / k
    return FieldNumber(a, residue, degree, x.denominator, x.height, x.token)


def _surd(a: FieldArithmetic, ratio: Fraction) -> FieldNumber:
    """Return the square root of a rational; those of 2, 3, 5, 7 exist by the choice of prime."""
    if ratio < 0:
        raise Inadmissible("a radicand is negative")
    rest, result = ratio.numerator * ratio.denominator, a.rational(1)
    for q in PRIMES:
        count = 0
        while rest % q == 0:
            rest, count = rest // q, count + 1
        result = result * q ** (count // 2)
        if count % 2:
            result = result * _surd_of_prime(a, q)
    if isqrt(rest) ** 2 == rest:
        return result * isqrt(rest) / ratio.denominator
    return result * _joined(a, a.rational(rest), 2) / ratio.denominator


def _surd_of_prime(a: FieldArithmetic, q: int) -> FieldNumber:
    if ("surd", q) not in a.atoms:
        a.log2_conjugates += 1
        residue = pow(q, (a.prime + 1) // 4, a.prime)
        a.atoms["surd", q] = FieldNumber(a, residue, 0.0, 0.0, log2(q), 0)
    return a.atoms["surd", q]
