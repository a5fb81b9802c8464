"""Numbers that a file, a class or the function around computes from others: formulas in these.

    total_mass = masspole + masscart                ->    total_mass stands for mp + mc
    self.ml = self.m*self.l    (in __init__)        ->    ml stands for m*l

Only what is assigned once, by plain arithmetic of what stands for parameters, and has the value
that the formula gives: within 4 units in the last place.
"""

import ast
from collections.abc import Callable, Mapping
from fractions import Fraction
from math import isfinite, isinf, isnan, ulp
from typing import Any

import sympy
from sympy import Expr, Rational

from mechanics.claims.code.constants import ULPS, constant_of
from mechanics.claims.code.python.closure_assignments import Scope, scopes
from mechanics.claims.code.python.closure_numbers import held
from mechanics.claims.code.python.containers import is_number
from mechanics.errors import InputError
from mechanics.symbolic import operations

LARGEST, DEEPEST = 60, 12
"""Operations of a formula, and names that stand for names."""

FUNCTIONS = {"sqrt": sympy.sqrt, "float": lambda x: x}


def derived(function: Callable[..., Any], known: Mapping[str, Expr]) -> dict[str, Expr]:
    """Formulas of numbers that a function holds, in what those of `known` names stand for."""
    found: dict[str, Expr] = {}
    values: dict[str, list[float]] = {}
    for scope in scopes(function):
        for key in scope.assigned:
            name, value = key.lstrip("."), scope.values.get(key)
            if name in known or value is None or not is_number(value) or not isfinite(value):
                continue
            numbers: dict[Expr, Fraction | None] = {}
            formula = _named(key, scope, known, numbers, 0)
            if formula is None or not formula.free_symbols or not _is(formula, numbers, value):
                continue
            values.setdefault(name, []).append(value)
            if found.setdefault(name, formula) != formula:
                known = {**known, name: formula}  # two formulas: which one is meant is not plain
                del found[name]
    # A name of the file may be another one's inside the function around.
    own = held(function, found).numbers
    return {n: formula for n, formula in found.items() if n not in own or own[n] in values[n]}


def _is(formula: Expr, numbers: Mapping[Expr, Fraction | None], value: float) -> bool:
    """Whether a formula has a value; that of what nothing keeps cannot be told."""
    if None in numbers.values():
        return True
    table = {s: Rational(n.numerator, n.denominator) for s, n in numbers.items() if n is not None}
    exact = sympy.N(formula.xreplace(table), 40)
    if not (exact.is_Float or exact.is_Rational):
        return False
    return bool(abs(exact - Rational(value)) <= ULPS * Rational(ulp(float(value))))


def _named(
    key: str, scope: Scope | None, known: Mapping[str, Expr], numbers: dict[Expr, Fraction | None],
    depth: int,
) -> Expr | None:  # fmt: skip
    """What a name stands for where it is used; `numbers` learns values of symbols."""
    while scope is not None and key not in scope.values and key not in scope.assigned:
        scope = scope.around
    if scope is None or depth > DEEPEST:
        return None
    name, value = key.lstrip("."), scope.values.get(key)
    if name in known and value is not None and is_number(value) and not isinf(value):
        symbol, number = known[name], None if isnan(value) else Fraction(value)
        return symbol if numbers.setdefault(symbol, number) == number else None
    if key not in scope.assigned:
        return None
    try:
        found = _formula(scope.assigned[key], scope, known, numbers, depth + 1)
    except (InputError, RecursionError):
        return None
    return found if found is not None and operations(found) <= LARGEST else None


def _formula(
    node: ast.expr, scope: Scope, known: Mapping[str, Expr], numbers: dict[Expr, Fraction | None],
    depth: int,
) -> Expr | None:  # fmt: skip
    """Plain arithmetic as an expression; None for anything else."""

    def of(part: ast.expr) -> Expr | None:
        return _formula(part, scope, known, numbers, depth)

    match node:
        case ast.Constant(value=int() | float() as value) if is_number(value):
            return constant_of(float(value))[0]
        case ast.Name(id=name):
            return _named(name, scope, known, numbers, depth)
        case ast.Attribute(value=ast.Name(id="self"), attr=name):
            return _named(f".{name}", scope, known, numbers, depth)
        case ast.Attribute(value=ast.Name(id="math" | "np" | "numpy"), attr="pi"):
            return sympy.pi
        case ast.Attribute(value=owner, attr=name) if name in known:
            number = _field(owner, name, scope)
            if number is None or numbers.setdefault(known[name], number) != number:
                return None
            return known[name]
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            found = of(inner)
            return None if found is None else -found
        case ast.Call(func=ast.Name(id=name) | ast.Attribute(attr=name), args=[inner],
                      keywords=[]) if name in FUNCTIONS:  # fmt: skip
            found = of(inner)
            return None if found is None else FUNCTIONS[name](found)
        case ast.BinOp(left=left, op=operation, right=right):
            a, b = of(left), of(right)
            return None if a is None or b is None else _both(a, operation, b)
    return None


def _field(owner: ast.expr, name: str, scope: Scope | None) -> Fraction | None:
    """The number that a record of the object has by a name: self.params.m, or p.m of p."""
    own = isinstance(owner, ast.Attribute) and isinstance(owner.value, ast.Name)
    key = f".{owner.attr}" if isinstance(owner, ast.Attribute) else getattr(owner, "id", "")
    while scope is not None and key not in scope.values and key not in scope.assigned:
        scope = scope.around
    if scope is None:
        return None
    if own and key in scope.values:
        value = (
            vars(scope.values[key]).get(name) if hasattr(scope.values[key], "__dict__") else None
        )
        return Fraction(value) if value is not None and is_number(value) else None
    node = None if own else scope.assigned.get(key)
    return _field(node, name, scope) if isinstance(node, ast.Attribute) else None


def _both(a: Expr, operation: ast.operator, b: Expr) -> Expr | None:
    match operation:
        case ast.Add():
            return a + b
        case ast.Sub():
            return a - b
        case ast.Mult():
            return a * b
        case ast.Div() if b != 0:
            return a / b
        case ast.Pow() if b.is_Rational and abs(b) <= 8:
            return a**b
    return None
