"""Expressions of mechanics as polynomials with whole coefficients, in Coq's words.

    sin(a), cos(a)   ->   s_a, c_a with s_a^2 + c_a^2 = 1,    a a coordinate or an angle
    e = f            ->   d e = d f,    d a common denominator

What holds for all real s_a, c_a on the circle, and for every real number in the place of pi, holds
for sines and cosines.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field

from sympy import (
    Dummy,
    Expr,
    Poly,
    Rational,
    Symbol,
    cancel,
    cos,
    expand,
    expand_trig,
    fraction,
    igcd,
    ilcm,
    lcm,
    pi,
    sin,
    together,
)

RESERVED = frozenset(
    [
        "R",
        "as",
        "at",
        "by",
        "cofix",
        "else",
        "end",
        "exists",
        "fix",
        "for",
        "forall",
        "fun",
        "if",
        "in",
        "let",
        "match",
        "mod",
        "return",
        "then",
        "using",
        "where",
        "with",
        "Prop",
        "Set",
        "Type",
        "SProp",
    ]
)
"""Words that no variable is called."""


class NotPolynomialError(Exception):
    """An expression that is no quotient of polynomials in sines, cosines and symbols."""


@dataclass
class Names:
    """Coq's names of symbols, each once, and the circles on which sines and cosines are.

    Attributes
    ----------
    known : dict of Symbol to str
    circles : dict of str to (Symbol, Symbol)
        Sine and cosine of each angle, other symbols than any that has their name.
    pi : Symbol
    """

    known: dict[Symbol, str] = field(default_factory=dict)
    circles: dict[str, tuple[Symbol, Symbol]] = field(default_factory=dict)
    pi: Symbol = field(default_factory=lambda: Dummy("pi"))

    def of(self, symbol: Symbol) -> str:
        """The identifier of a symbol."""
        if symbol not in self.known:
            word = "".join(c if c.isascii() and (c.isalnum() or c == "_") else "_"
                           for c in symbol.name)  # fmt: skip
            if word in RESERVED or not word[0].isalpha():
                word = f"{word}_" if word[0].isalpha() else f"v{word}"
            while word in self.known.values():
                word += "_"
            self.known[symbol] = word
        return self.known[symbol]

    def on_circle(self, angle: Symbol) -> tuple[Symbol, Symbol]:
        """What stands for sine and cosine of an angle."""
        if angle.name not in self.circles:
            self.circles[angle.name] = Dummy(f"s_{angle.name}"), Dummy(f"c_{angle.name}")
        return self.circles[angle.name]


def equation(left: Expr, right: Expr, names: Names) -> tuple[Poly, Poly]:
    """Both sides times what makes them polynomials with whole coefficients, without a common one.

    Raises
    ------
    NotPolynomialError
        Saying why they are none.
    """
    sides = [together(expand(_on_circles(side, names))) for side in (left, right)]
    common = lcm(*(fraction(side)[1] for side in sides))
    tops = [expand(cancel(side * common)) for side in sides]
    symbols = sorted(set().union(*(top.free_symbols for top in tops)), key=lambda s: s.name)
    if not all(top.is_polynomial(*symbols) for top in tops):
        raise NotPolynomialError("it holds more than sums, products and quotients")
    polynomials = [Poly(top, *symbols or [Symbol("zero")]) for top in tops]
    factors = [c for polynomial in polynomials for c in polynomial.coeffs()]
    if not all(factor.is_Rational for factor in factors):
        raise NotPolynomialError("it holds numbers that are no fractions")
    whole = ilcm(1, *(factor.q for factor in factors))
    shared = igcd(0, *(factor * whole for factor in factors)) or 1
    one, two = (polynomial * Rational(whole, shared) for polynomial in polynomials)
    return one, two


def _on_circles(expression: Expr, names: Names) -> Expr:
    """With symbols in the place of sines, cosines and pi."""
    flat = expand_trig(expand(expression)).subs(pi, names.pi)
    known = {}
    for entry in flat.atoms(sin, cos):
        (angle,) = entry.args
        if not isinstance(angle, Symbol):
            raise NotPolynomialError(f"{entry} is of no single angle")
        known[entry] = names.on_circle(angle)[isinstance(entry, cos)]
    return flat.xreplace(known)


def text(polynomial: Poly, names: Names) -> str:
    """``2*m*x_ddot - T``."""
    if polynomial.is_zero:
        return "0"
    terms = []
    for powers, coefficient in polynomial.terms():
        # Coq's `nsatz` reads no powers of reals.
        factors = [
            names.of(symbol)
            for symbol, power in zip(polynomial.gens, powers, strict=True)
            for _ in range(power)
        ]
        size = abs(int(coefficient))
        if size != 1 or not factors:
            factors.insert(0, str(size))
        terms.append(("-" if coefficient < 0 else "+", "*".join(factors)))
    (sign, first), *rest = terms
    return " ".join([f"-{first}" if sign == "-" else first, *(f"{s} {t}" for s, t in rest)])


def symbols_of(polynomials: Iterable[Poly]) -> list[Symbol]:
    """Of all of them, by name."""
    found = set().union(*(polynomial.free_symbols for polynomial in polynomials))
    return sorted(found, key=lambda symbol: symbol.name)
