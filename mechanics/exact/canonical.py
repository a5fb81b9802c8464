"""Normal form of an expression, as an expression: equal polynomials look equal.

    sin(a)**2 x + cos(a)**2 x  ->  x,        (x + y)**2 - x**2 - 2 x y  ->  y**2,
    (p / cos(a)) cos(a)  ->  p.

Used where products that cancel must be cancelled before code is generated.
"""

from collections.abc import Sequence

import sympy
from flint import fmpq

from mechanics.errors import ExpressionError
from mechanics.exact.canonical_back import generator_expression
from mechanics.exact.canonical_poly import Reader, reader

Terms = dict[tuple[int, ...], fmpq]
"""Coefficients by the powers of all generators."""


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
    ring = result.ring
    known = set(ring.keys.values())
    places = {ring.place(symbol)[0]: j for j, symbol in enumerate(symbols) if symbol in known}
    hidden = _hiding(result, set(symbols), set(places))
    groups: list[Terms] = [{} for _ in range(len(symbols) + 1)]
    for powers, value in ring.reduced(polynomial).terms():
        inside = [place for place in places if powers[place]]
        if sum(powers[place] for place in inside) > 1 or any(powers[place] for place in hidden):
            term = result.write(ring.from_terms({powers: value}))
            raise ExpressionError(f"{term} is not linear in {', '.join(map(str, symbols))}")
        group = groups[places[inside[0]] if inside else -1]
        group[tuple(0 if k in places else power for k, power in enumerate(powers))] = value
    *coefficients, rest = (result.write(ring.from_terms(group)) for group in groups)
    return coefficients, rest


def _hiding(result: Reader, symbols: set[sympy.Symbol], places: set[int]) -> set[int]:
    """Return the places of functions, roots and inverses that contain one of the symbols."""
    ring = result.ring
    return {
        place for place in ring.keys
        if place not in places and generator_expression(ring, place).free_symbols & symbols
    }  # fmt: skip
