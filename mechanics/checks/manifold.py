"""Points on the constraint manifold, in any arithmetic.

phi(q; p) = 0      solved for parameters that it holds linearly (link lengths), or not needed
A(q) u + a = 0     solved for dependent speeds
A(q) u' = b        solved for dependent accelerations, where a statement holds free ones
"""

from collections.abc import Sequence
from itertools import combinations

from sympy import Expr, Symbol

from mechanics.errors import ExpressionError
from mechanics.exact import Arithmetic, Number, collect_linear, independent_rows
from mechanics.kinematics.constraints import velocity_forms
from mechanics.scene import Scene
from mechanics.scene.rates import rate, rate_table

Linear = tuple[list[list[Expr]], list[Expr]]
"""Coefficients and rest: coefficients times unknowns plus rest is zero."""


def settle(scene: Scene, a: Arithmetic) -> None:
    """Give dependent quantities the values that the constraints ask for.

    Must run before any other expression is evaluated in this arithmetic.

    Raises
    ------
    ExpressionError
        When a configuration constraint is linear in no set of parameters.
    """
    if not scene.constraints:
        return
    settle_configuration(scene, a)
    _solve(a, *_dependent(velocity_forms(scene), scene.u))


def settle_accelerations(scene: Scene, a: Arithmetic) -> None:
    """Give dependent accelerations the values that the constraints ask for; after `settle`."""
    if scene.constraints:
        table = rate_table(scene)
        forms = [rate(form, table) for form in velocity_forms(scene)]
        _solve(a, *_dependent(forms, scene.ud))


def settle_configuration(scene: Scene, a: Arithmetic) -> None:
    """Solve the configuration constraints for parameters that they hold linearly."""
    closing = [scene.plain(c.expression, c.name) for c in scene.constraints if c.holonomic]
    if closing:
        unknown, rows, rest = _parameters(scene, closing)
        for number in _solve(a, unknown, rows, rest):
            a.require_positive(number)


def _solve(
    a: Arithmetic, unknown: Sequence[Symbol], rows: Sequence[Sequence[Expr]], rest: Sequence[Expr]
) -> list[Number]:
    numbers = a.solve(
        [[a.value(entry) for entry in row] for row in rows], [-a.value(entry) for entry in rest]
    )
    for symbol, number in zip(unknown, numbers, strict=True):
        a.assign(symbol, number)
    return numbers


def _parameters(
    scene: Scene, closing: Sequence[Expr]
) -> tuple[tuple[Symbol, ...], list[list[Expr]], list[Expr]]:
    held = [p for p in scene.parameters if any(p in e.free_symbols for e in closing)]
    for unknown in combinations(held, len(closing)):
        try:
            split = [collect_linear(expression, unknown) for expression in closing]
        except ExpressionError:
            continue  # not linear in this set: the next one may do
        rows = [list(coefficients) for coefficients, _ in split]
        if len(independent_rows(rows)) == len(rows):
            return unknown, rows, [rest for _, rest in split]
    raise ExpressionError(
        f"{scene.name}: the configuration constraints are linear in no"
        f" {len(closing)} parameters together, so no exact point on them is known"
    )


def _dependent(
    forms: Sequence[Expr], symbols: Sequence[Symbol]
) -> tuple[tuple[Symbol, ...], list[list[Expr]], list[Expr]]:
    """As many symbols as there are forms, the last ones that the forms determine."""
    split = [collect_linear(form, symbols) for form in forms]
    columns = [[row[i] for row, _ in split] for i in range(len(symbols))]
    backwards = list(range(len(columns)))[::-1]
    picked = sorted(backwards[k] for k in independent_rows([columns[i] for i in backwards]))
    rows = [[row[i] for i in picked] for row, _ in split]
    others = [
        rest + sum(row[i] * symbol for i, symbol in enumerate(symbols) if i not in picked)
        for row, rest in split
    ]
    return tuple(symbols[i] for i in picked), rows, others
