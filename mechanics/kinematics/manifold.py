"""Points on the constraint manifold, in any arithmetic.

phi(q; p) = 0      solved for what it holds linearly (link lengths first), or as a square
A(q) u + a = 0     solved for dependent speeds
A(q) u' = b        solved for dependent accelerations, where a statement holds free ones
"""

from collections.abc import Sequence
from functools import lru_cache
from itertools import combinations

from sympy import Expr, S, Symbol

from mechanics.errors import ExpressionError
from mechanics.kinematics.constraints import velocity_forms
from mechanics.scene import Scene
from mechanics.scene.rates import rate, rate_table
from mechanics.symbolic import Arithmetic, Number, canonical, collect_linear, independent_rows

Solvable = tuple[tuple[Symbol, ...], list[list[Expr]], list[Expr]]
"""Unknowns, coefficients and rest: coefficients times unknowns plus rest is zero."""


def settle(scene: Scene, a: Arithmetic, virtual: bool = False) -> None:
    """Give dependent quantities the values that the constraints ask for.

    Must run before any other expression is evaluated in this arithmetic. Virtual velocities satisfy
    A u = 0, with every prescribed motion stopped.

    Raises
    ------
    ExpressionError
        When no quantity is known for which a configuration constraint can be solved.
    """
    if not scene.constraints:
        return
    settle_configuration(scene, a)
    _solve(a, *_speeds(scene, virtual))


@lru_cache(maxsize=32)
def _speeds(scene: Scene, virtual: bool) -> Solvable:
    forms = velocity_forms(scene)
    if virtual:
        still = dict.fromkeys(scene.u, S.Zero)
        forms = [form - form.xreplace(still) for form in forms]
    return _dependent(forms, scene.u)


def settle_accelerations(scene: Scene, a: Arithmetic) -> None:
    """Give dependent accelerations the values that the constraints ask for; after `settle`."""
    if scene.constraints:
        _solve(a, *_accelerations(scene))


@lru_cache(maxsize=32)
def _accelerations(scene: Scene) -> Solvable:
    table = rate_table(scene)
    return _dependent([rate(form, table) for form in velocity_forms(scene)], scene.ud)


def settle_configuration(scene: Scene, a: Arithmetic) -> None:
    """Solve the configuration constraints: together where they are linear, else one by one."""
    closing = [scene.plain(c.expression, c.name) for c in scene.constraints if c.holonomic]
    if not closing:
        return
    linear = _linear(scene, tuple(closing))
    if linear is not None:
        unknown, rows, rest = linear
        for symbol, number in zip(unknown, _solve(a, unknown, rows, rest), strict=True):
            if symbol.is_positive:
                a.require_positive(number)
        return
    for symbol, (square, slope, rest) in _quadratic(scene, closing):
        two, one, zero = (a.value(entry) for entry in (square, slope, rest))
        root = a.sqrt(one * one - 4 * two * zero)
        if symbol.is_positive and slope == 0:
            # Of two opposite solutions, the positive one.
            root = -root if square.is_negative else root
        else:
            root = root * _either_sign(a, symbol)
        number = (root - one) / (2 * two)
        if symbol.is_positive:
            a.require_positive(number)
        a.assign(symbol, number)


def _either_sign(a: Arithmetic, symbol: Symbol) -> Number:
    """1 or -1, sqrt(z^2) / z of a free z: what holds on one branch only is not shown."""
    free = a.value(Symbol(f"branch_of_{symbol.name}", real=True))
    return a.sqrt(free * free) / free


def _solve(
    a: Arithmetic, unknown: Sequence[Symbol], rows: Sequence[Sequence[Expr]], rest: Sequence[Expr]
) -> list[Number]:
    numbers = a.solve(
        [[a.value(entry) for entry in row] for row in rows], [-a.value(entry) for entry in rest]
    )
    for symbol, number in zip(unknown, numbers, strict=True):
        a.assign(symbol, number)
    return numbers


def _held(scene: Scene, closing: Sequence[Expr]) -> list[Symbol]:
    """What the constraints may be solved for: parameters first, for angles stay free that way."""
    return [s for s in (*scene.parameters, *scene.q) if any(s in e.free_symbols for e in closing)]


@lru_cache(maxsize=32)
def _linear(scene: Scene, closing: tuple[Expr, ...]) -> Solvable | None:
    for unknown in combinations(_held(scene, closing), len(closing)):
        try:
            split = [collect_linear(expression, unknown) for expression in closing]
        except ExpressionError:
            continue  # not linear in this set: the next one may do
        rows = [list(coefficients) for coefficients, _ in split]
        if len(independent_rows(rows)) == len(rows):
            return unknown, rows, [rest for _, rest in split]
    return None


def _quadratic(
    scene: Scene, closing: Sequence[Expr]
) -> list[tuple[Symbol, tuple[Expr, Expr, Expr]]]:
    """For each constraint a quantity that it alone holds, and the coefficients of its square."""
    found = []
    for i, expression in enumerate(closing):
        others = {s for k, e in enumerate(closing) if k != i for s in e.free_symbols}
        split = None
        for symbol in _held(scene, [expression]):
            split = None if symbol in others else _in_powers(expression, symbol)
            if split is not None:
                found.append((symbol, split))
                break
        if split is None:
            raise ExpressionError(
                f"{scene.name}: the configuration constraints are linear in no {len(closing)}"
                " quantities together, and one of them is quadratic in nothing that it alone"
                " holds, so no exact point on them is known"
            )
    return found


def _in_powers(expression: Expr, symbol: Symbol) -> tuple[Expr, Expr, Expr] | None:
    """(a, b, c) of a s^2 + b s + c; None for any other function of s."""
    square = canonical(expression.diff(symbol, 2) / 2)
    slope = canonical(expression.diff(symbol) - 2 * square * symbol)
    rest = canonical(expression - square * symbol**2 - slope * symbol)
    if square == 0 or any(symbol in e.free_symbols for e in (square, slope, rest)):
        return None
    return square, slope, rest


def _dependent(forms: Sequence[Expr], symbols: Sequence[Symbol]) -> Solvable:
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
