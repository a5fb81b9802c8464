"""Rows without common factors: D K C^-1 y = D k,  x = C^-1 y.

    [ M + m      M L c/2 ]        [ 2 (M + m)  M c ]
    [ M L c/2    M L^2/3 ] x      [ 3 c        2   ] y,      y = (x'', L theta'')

D and C hold products of positive parameters and numbers, so nothing is divided by what may vanish.
The entries are in normal form. What was divided out can neither overflow nor cost an operation.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from math import gcd, lcm

import sympy
from sympy import Expr, Matrix, Symbol

from mechanics.kernel.ring import primitive_part
from mechanics.symbolic.canonical import canonical
from mechanics.symbolic.canonical_poly import reader


@dataclass(frozen=True)
class Primitive:
    """A square system whose rows and columns have no common factor left.

    Attributes
    ----------
    left, right : Matrix
        D K C^-1, n x n, and D k, n x 1.
    scale : tuple of Expr
        Diagonal of C: unknown j is y_j / scale_j.
    """

    left: Matrix
    right: Matrix
    scale: tuple[Expr, ...]


def primitive(left: Matrix, right: Matrix) -> Primitive:
    """Divide common factors out of the rows of K x = k, then out of the columns of K.

    Raises
    ------
    TooLarge
        If the normal form of an entry is.
    """
    n = left.rows
    rows = left.row_join(right).as_mutable()
    for i in range(n):
        number, power = common_factor(rows[i, :])
        rows[i, :] = rows[i, :].applyfunc(lambda e, f=number * power: canonical(e / f))
    scale = []
    for j in range(n):
        _, power = common_factor(rows[:, j])
        rows[:, j] = rows[:, j].applyfunc(lambda e, f=power: canonical(e / f))
        scale.append(power)
    return Primitive(rows[:, :n], rows[:, n:], tuple(scale))


def common_factor(entries: Iterable[Expr]) -> tuple[Expr, Expr]:
    """The largest number and product of powers of positive symbols that divide all entries.

    Divided by them, the entries have coprime integer coefficients and no common symbol.
    """
    known = [entry for entry in entries if entry != 0]
    positive = [s for s in set().union(*(e.free_symbols for e in known)) if s.is_positive]
    read, polynomials = reader(known)
    places = {key: place for place, key in read.ring.keys.items()}
    least: dict[Symbol, int] = {}
    top, bottom = 0, 1
    for polynomial in map(read.ring.reduced, polynomials):
        if polynomial == 0:
            continue
        part, _ = primitive_part(polynomial)
        top, bottom = gcd(top, part.numerator), lcm(bottom, part.denominator)
        for powers, _ in polynomial.terms():
            for symbol in positive:
                above, below = places.get(symbol), places.get(1 / symbol)
                power = (int(powers[above]) if above is not None else 0) - (
                    int(powers[below]) if below is not None else 0
                )
                least[symbol] = min(least.get(symbol, power), power)
    number = sympy.Rational(top, bottom) if top else sympy.S.One
    return number, sympy.Mul(*(symbol**power for symbol, power in least.items()))
