"""Normal form of an expression, as an expression: equal polynomials look equal.

    sin(a)**2 x + cos(a)**2 x  ->  x,        (x + y)**2 - x**2 - 2 x y  ->  y**2,
    (p / cos(a)) cos(a)  ->  p.

Used where products that cancel must be cancelled before code is generated.
"""

from collections.abc import Sequence

import sympy

from mechanics.errors import ExpressionError
from mechanics.exact.canonical_back import Factor, Writer, generator_expression, shortest, terms
from mechanics.exact.canonical_poly import Reader, reader


def canonical(expr: sympy.Expr) -> sympy.Expr:
    """Return an expression multiplied out, with everything cancelled that cancels.

    Parameters
    ----------
    expr : sympy.Expr
        In plain symbols. Denominators, roots and other functions are kept as they are, with
        canonical arguments; sums of angles are not expanded.

    Returns
    -------
    sympy.Expr
        Equal wherever `expr` is defined; zero if the polynomial is.

    Raises
    ------
    ExpressionError
        If the expression holds nan or infinity.
    TooLarge
        If multiplying out takes more than some ten thousand terms.
    """
    result, (polynomial,) = reader([expr])
    return result.write(polynomial)


def collect_linear(
    expr: sympy.Expr, symbols: Sequence[sympy.Symbol]
) -> tuple[list[sympy.Expr], sympy.Expr]:
    """Split a linear expression: expr = sum_j coefficients[j] symbols[j] + rest.

    Parameters
    ----------
    expr : sympy.Expr
    symbols : sequence of sympy.Symbol

    Returns
    -------
    coefficients : list of sympy.Expr
        In normal form, one for each symbol.
    rest : sympy.Expr

    Raises
    ------
    ExpressionError
        If the expression is not linear in the symbols; the offending term is named.
    """
    result, (polynomial,) = reader([expr])
    polynomial = shortest(result.ring, result.ring.reduced(polynomial))
    places = {result.ring.place(symbol)[0]: j for j, symbol in enumerate(symbols)
              if symbol in result.ring.keys.values()}
    hidden = _hiding(result, set(symbols), set(places))
    groups: list[list[tuple[tuple[Factor, ...], sympy.Rational]]] = [[] for _ in symbols]
    rest = []
    writer = Writer(result.ring)
    for factors, value in terms(polynomial):
        inside = [factor for factor in factors if factor[0] in places]
        if len(inside) > 1 or any(f[1] > 1 for f in inside) or any(f[0] in hidden for f in factors):
            term = writer.total([(factors, value)])
            raise ExpressionError(f"{term} is not linear in {', '.join(map(str, symbols))}")
        if inside:
            others = tuple(factor for factor in factors if factor[0] not in places)
            groups[places[inside[0][0]]].append((others, value))
        else:
            rest.append((factors, value))
    return [writer.total(group) for group in groups], writer.total(rest)


def _hiding(result: Reader, symbols: set[sympy.Symbol], places: set[int]) -> set[int]:
    """Return the places of functions, roots and inverses that contain one of the symbols."""
    ring = result.ring
    return {
        place for place in ring.keys
        if place not in places and generator_expression(ring, place).free_symbols & symbols
    }  # fmt: skip


