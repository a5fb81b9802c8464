"""Normal form of an expression, as an expression: equal polynomials look equal.

    sin(a)**2 x + cos(a)**2 x  ->  x,        (x + y)**2 - x**2 - 2 x y  ->  y**2,
    (p / cos(a)) cos(a)  ->  p.

Used where products that cancel must be cancelled before code is generated.
"""

from collections.abc import Sequence

import sympy
from flint import fmpq_mpoly

from mechanics.errors import ExpressionError
from mechanics.kernel.ring import Ring, TooLarge
from mechanics.symbolic.canonical_back import generator_expression
from mechanics.symbolic.canonical_poly import Reader, reader
from mechanics.symbolic.independence import generic_rank


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


def tidy(expr: sympy.Expr) -> sympy.Expr:
    """Return `canonical` of an expression where that is small, else zero or the expression.

    For where a normal form is only a convenience, but what is zero must be seen to be. That is
    certain for what is not zero, and else but for a chance below 2^-90 (`generic_rank`).
    """
    try:
        return canonical(expr)
    except TooLarge:
        return expr if generic_rank([[expr]]) else sympy.S.Zero


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
    result, parts, rest = _split(expr, symbols)
    return [result.write(part) for part in parts], result.write(rest)


def _split(
    expr: sympy.Expr, symbols: Sequence[sympy.Symbol]
) -> tuple[Reader, list[fmpq_mpoly], fmpq_mpoly]:
    result, (polynomial,) = reader([expr])
    ring = result.ring
    rest = ring.reduced(polynomial)
    known = set(ring.keys.values())
    places = {symbol: ring.place(symbol) for symbol in symbols if symbol in known}
    parts = {symbol: rest.derivative(place) for symbol, place in places.items()}
    hidden = _hiding(result, set(symbols), set(places.values()))
    free = hidden.union(places.values())
    if _holds(rest, hidden) or any(_holds(part, free) for part in parts.values()):
        term = result.write(_not_linear(ring, rest, set(places.values()), hidden))
        raise ExpressionError(f"{term} is not linear in {', '.join(map(str, symbols))}")
    for symbol, part in parts.items():
        rest -= part * ring.gen(places[symbol])
    return result, [parts.get(symbol, ring.constant(0)) for symbol in symbols], rest


def _holds(polynomial: fmpq_mpoly, places: set[int]) -> bool:
    """Tell whether one of the generators at these places occurs."""
    degrees = polynomial.degrees()
    return any(degrees[place] > 0 for place in places)


def _not_linear(
    ring: Ring, polynomial: fmpq_mpoly, places: set[int], hidden: set[int]
) -> fmpq_mpoly:
    """Return the first term that is not linear, or hides a symbol in a function."""
    return next(
        polynomial.context().from_dict({powers: value})
        for powers, value in polynomial.terms()
        if sum(powers[place] for place in places) > 1 or any(powers[place] for place in hidden)
    )


def _hiding(result: Reader, symbols: set[sympy.Symbol], places: set[int]) -> set[int]:
    """Return the places of functions, roots and inverses that contain one of the symbols."""
    ring = result.ring
    return {
        place for place in ring.keys
        if place not in places and generator_expression(ring, place).free_symbols & symbols
    }  # fmt: skip
