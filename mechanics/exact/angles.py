"""An angle as a rational linear combination: alpha = sum_i r_i a_i + r pi.

Cosine and sine of such a sum follow from those of the a_i by the group law of the unit circle,
(c1, s1) (c2, s2) = (c1 c2 - s1 s2, s1 c2 + c1 s2), so that nothing has to be expanded.
"""

from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

import sympy


class Combination(NamedTuple):
    """An expanded argument: terms (factor, atom without numerical factor) and a multiple of pi."""

    terms: tuple[tuple[Fraction, sympy.Expr], ...]
    turns: Fraction


@lru_cache(maxsize=65536)
def combination(argument: sympy.Expr) -> Combination:
    """Return an argument of sin, cos or exp as a rational linear combination of atoms.

    Atoms are symbols, products, or whatever else is left without a rational factor; the number 1
    is the atom of a rational constant.
    """
    if isinstance(argument, sympy.Symbol):
        return Combination(((Fraction(1), argument),), Fraction(0))
    terms, turns = [], Fraction(0)
    for term in sympy.Add.make_args(sympy.expand(exact(argument))):
        factor, atom = term.as_coeff_Mul(rational=True)
        if factor.is_zero:
            continue
        ratio = Fraction(int(factor.p), int(factor.q))
        if atom is sympy.S.Pi:
            turns += ratio
        else:
            terms.append((ratio, atom))
    return Combination(tuple(terms), turns)


def exact(expr: sympy.Expr) -> sympy.Expr:
    """Return the expression with every binary float replaced by the rational that it is."""
    floats = expr.atoms(sympy.Float)
    return expr.xreplace({number: float_as_rational(number) for number in floats})


def float_as_rational(number: sympy.Float) -> sympy.Rational:
    """Return the dyadic rational that a SymPy float stores: (-1)**sign * mantissa * 2**exponent."""
    sign, mantissa, exponent, _ = number._mpf_
    return sympy.Rational((-1) ** sign * int(mantissa)) * sympy.Integer(2) ** int(exponent)


@lru_cache(maxsize=4096)
def multiple_of_pi(turns: Fraction) -> tuple[sympy.Expr, sympy.Expr] | None:
    """Return cosine and sine of turns * pi in radicals, or None where SymPy knows none."""
    angle = sympy.Rational(turns.numerator, turns.denominator) * sympy.pi
    pair = sympy.cos(angle), sympy.sin(angle)
    if any(part.has(sympy.cos, sympy.sin) for part in pair):
        return None
    return pair
