"""Total time derivative on plain symbols.

de/dt = sum_s (de/ds) s'        over coordinates, speeds, inputs, and t itself
"""

from collections.abc import Iterable, Mapping

from sympy import Add, Expr, Matrix, S, Symbol, sympify

from mechanics.scene.scene import Scene
from mechanics.scene.symbols import DOTS, plain_symbol
from mechanics.scene.symbols import TIME as TIME


def rate_table(scene: Scene) -> dict[Symbol, Expr]:
    """Rate of every symbol that changes with time: q' = N u + n, u', input rates, t' = 1."""
    table: dict[Symbol, Expr] = dict(
        zip(scene.q, (scene.coordinate_rates[qd] for qd in scene.qd), strict=True)
    )
    table.update(zip(scene.u, scene.ud, strict=True))
    return table | _given_rates(scene)


def coordinate_rate_table(scene: Scene) -> dict[Symbol, Expr]:
    """The same with q' and q'' as symbols of their own, whatever the speeds are."""
    table: dict[Symbol, Expr] = dict(zip(scene.q, scene.qd, strict=True))
    second = [plain_symbol(q, 2) for q in scene.coordinates]
    table.update(zip(scene.qd, second, strict=True))
    return table | _given_rates(scene)


def _given_rates(scene: Scene) -> dict[Symbol, Expr]:
    table: dict[Symbol, Expr] = {TIME: S.One}
    for function in scene.inputs:
        for order in range(len(DOTS) - 1):
            table[plain_symbol(function, order)] = plain_symbol(function, order + 1)
    return table


def speeds_in_rates(scene: Scene) -> dict[Symbol, Expr]:
    """Every speed u in q and q', both plain symbols; empty where u is q'."""
    if not scene.speeds:
        return {}
    pairs = zip(scene.u, scene.speeds, strict=True)
    return {u: scene.rates(definition) for u, (_, definition) in pairs}


def rate(expression: Expr, table: Mapping[Symbol, Expr]) -> Expr:
    """Time derivative of an expression, given the rate of each symbol in it.

    Symbols that the table does not know are constant. The result is not expanded.
    """
    expression = sympify(expression)
    if expression.is_Add:
        # Term by term, so that each term is differentiated only by the symbols it has.
        return Add(*(rate(term, table) for term in expression.args))
    moving = [symbol for symbol in expression.free_symbols if symbol in table]
    moving.sort(key=lambda symbol: symbol.name)
    return Add(*(expression.diff(symbol) * table[symbol] for symbol in moving))


def rates(column: Iterable[Expr], table: Mapping[Symbol, Expr]) -> Matrix:
    """`rate` of each entry, as a column matrix."""
    return Matrix([rate(entry, table) for entry in column])
