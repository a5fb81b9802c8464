"""Points on the constraint manifold, in any arithmetic.

    phi(q; p) = 0      solved for parameters that it holds linearly (link lengths), or not needed
    A(q) u + a = 0     solved for dependent speeds
"""

from collections.abc import Sequence
from itertools import combinations

from sympy import Expr, Symbol

from mechanics.errors import ExpressionError
from mechanics.exact import Arithmetic, Number, collect_linear, independent_rows
from mechanics.kinematics.constraints import velocity_forms
from mechanics.scene import Scene

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
    forms = velocity_forms(scene)
    free, rows, rest = _speeds(scene, forms)
    _solve(a, free, rows, rest)


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


def _speeds(
    scene: Scene, forms: Sequence[Expr]
) -> tuple[tuple[Symbol, ...], list[list[Expr]], list[Expr]]:
    split = [collect_linear(form, scene.u) for form in forms]
    columns = [[row[i] for row, _ in split] for i in range(len(scene.u))]
    backwards = list(range(len(columns)))[::-1]
    picked = sorted(backwards[k] for k in independent_rows([columns[i] for i in backwards]))
    rows = [[row[i] for i in picked] for row, _ in split]
    others = [
        rest + sum(row[i] * u for i, u in enumerate(scene.u) if i not in picked)
        for row, rest in split
    ]
    return tuple(scene.u[i] for i in picked), rows, others
