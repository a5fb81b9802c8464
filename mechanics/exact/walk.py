"""A SymPy expression evaluated over any arithmetic, every shared part once.

The walk keeps its own stack, so deep expressions are safe; only function arguments recurse.
"""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational
from sympy.logic.boolalg import BooleanFalse, BooleanTrue

from mechanics.errors import ExpressionError
from mechanics.exact.angles import Combination, combination, float_as_rational, multiple_of_pi

if TYPE_CHECKING:
    from mechanics.exact.arithmetic import Arithmetic

Memo = dict[object, Any]
"""Values of expressions, and of pairs ('circle', angle)."""


def evaluate(a: Arithmetic, expr: sympy.Basic, memo: Memo) -> Any:
    """Return the value of `expr` over `a`; `memo` keeps the values of its parts.

    Raises
    ------
    ExpressionError
        If an operation has no exact meaning; the message names it.
    """
    stack = [expr]
    while stack:
        node = stack[-1]
        if node in memo:
            stack.pop()
            continue
        parts = _parts(node)
        missing = [part for part in parts if part not in memo]
        if missing:
            stack.extend(missing)
            continue
        memo[node] = _node(a, node, [memo[part] for part in parts])
        stack.pop()
    return memo[expr]


def _parts(node: sympy.Basic) -> tuple[sympy.Basic, ...]:
    """Return the arguments that are needed as numbers before `node` can be evaluated."""
    if isinstance(node, sympy.Pow):
        return () if node.base is sympy.S.Exp1 else (_without_sign(node),)
    if isinstance(node, (*_ON_ANGLES, sympy.Piecewise, Relational)):
        return ()
    return node.args


def _without_sign(power: sympy.Pow) -> sympy.Expr:
    """Return the base of a power; |x| to an even power is x to that power."""
    if isinstance(power.base, sympy.Abs) and power.exp.is_even:
        return power.base.args[0]
    return power.base


def _node(a: Arithmetic, node: sympy.Basic, parts: list[Any]) -> Any:
    if isinstance(node, sympy.Add):
        total = parts[0]
        for part in parts[1:]:
            total = total + part
        return total
    if isinstance(node, sympy.Mul):
        product = parts[0]
        for part in parts[1:]:
            product = product * part
        return product
    if isinstance(node, sympy.Pow):
        return _power(a, node, parts)
    if isinstance(node, sympy.Symbol):
        return a.symbol(node)
    if isinstance(node, sympy.Rational):
        return a.rational(Fraction(int(node.p), int(node.q)))
    if isinstance(node, sympy.Float):
        ratio = float_as_rational(node)
        return a.rational(Fraction(int(ratio.p), int(ratio.q)))
    if isinstance(node, sympy.NumberSymbol):
        return a.constant(node)
    return _function(a, node, parts)


def _power(a: Arithmetic, node: sympy.Pow, parts: list[Any]) -> Any:
    base, exponent = node.args
    if base is sympy.S.Exp1:
        return _exponential(a, exponent)
    if isinstance(exponent, sympy.Float):
        exponent = float_as_rational(exponent)
    if isinstance(exponent, sympy.Integer):
        return parts[0] ** int(exponent)
    if isinstance(exponent, sympy.Rational):
        return a.root_power(parts[0], Fraction(int(exponent.p), int(exponent.q)))
    return a.function("power", [parts[0], evaluate(a, exponent, a.memo)])


def _exponential(a: Arithmetic, argument: sympy.Expr) -> Any:
    terms, turns = combination(argument)
    numbers = [(factor, a.value(atom)) for factor, atom in terms]
    if turns:
        numbers.append((turns, a.value(sympy.pi)))
    return a.exponential(numbers)


def _circle(a: Arithmetic, argument: sympy.Expr) -> tuple[Any, Any]:
    """Return (cos, sin); kept in the memo beside the numbers under a key of its own."""
    key = ("circle", argument)
    if key not in a.memo:
        a.memo[key] = _turned(a, combination(argument))
    pair: tuple[Any, Any] = a.memo[key]
    return pair


def _turned(a: Arithmetic, angle: Combination) -> tuple[Any, Any]:
    numbers = [(factor, a.value(atom)) for factor, atom in angle.terms]
    exact = multiple_of_pi(angle.turns) if angle.turns else None
    if angle.turns and exact is None:
        return a.circle([*numbers, (angle.turns, a.value(sympy.pi))])
    c, s = a.circle(numbers)
    if exact is None:
        return c, s
    cos, sin = a.value(exact[0]), a.value(exact[1])
    return c * cos - s * sin, s * cos + c * sin


def _trigonometric(a: Arithmetic, node: sympy.Basic) -> Any:
    c, s = _circle(a, node.args[0])
    if isinstance(node, sympy.sin):
        return s
    if isinstance(node, sympy.cos):
        return c
    if isinstance(node, sympy.tan):
        return s / c
    if isinstance(node, sympy.cot):
        return c / s
    return 1 / c if isinstance(node, sympy.sec) else 1 / s


def _hyperbolic(a: Arithmetic, node: sympy.Basic) -> Any:
    grown = _exponential(a, node.args[0])
    c, s = (grown + 1 / grown) / 2, (grown - 1 / grown) / 2
    if isinstance(node, sympy.sinh):
        return s
    if isinstance(node, sympy.cosh):
        return c
    return s / c if isinstance(node, sympy.tanh) else c / s


_TRIGONOMETRIC = (sympy.sin, sympy.cos, sympy.tan, sympy.cot, sympy.sec, sympy.csc)
_HYPERBOLIC = (sympy.sinh, sympy.cosh, sympy.tanh, sympy.coth)
_ON_ANGLES = (*_TRIGONOMETRIC, *_HYPERBOLIC, sympy.exp)

_NAMED: dict[type, str] = {
    sympy.log: "log", sympy.asin: "asin", sympy.acos: "acos", sympy.atan: "atan",
    sympy.atan2: "atan2", sympy.asinh: "asinh", sympy.acosh: "acosh", sympy.atanh: "atanh",
    sympy.erf: "erf", sympy.floor: "floor", sympy.ceiling: "ceil",
}  # fmt: skip


def _function(a: Arithmetic, node: sympy.Basic, parts: list[Any]) -> Any:
    if isinstance(node, _TRIGONOMETRIC):
        return _trigonometric(a, node)
    if isinstance(node, _HYPERBOLIC):
        return _hyperbolic(a, node)
    if isinstance(node, sympy.exp):
        return _exponential(a, node.args[0])
    if isinstance(node, sympy.Abs):
        return a.absolute(parts[0])
    if isinstance(node, sympy.sign):
        return a.sign(parts[0])
    if isinstance(node, sympy.Max | sympy.Min):
        return _extreme(a, parts, 1 if isinstance(node, sympy.Max) else -1)
    if isinstance(node, sympy.Piecewise):
        return _piecewise(a, node)
    if isinstance(node, AppliedUndef):
        return a.function(f"function {node.func.__name__}", parts)
    for kind, name in _NAMED.items():
        if isinstance(node, kind):
            return a.function(name, parts)
    raise ExpressionError(
        f"{type(node).__name__} in {str(node)[:80]} has no exact meaning here: use plain symbols "
        "and elementary functions"
    )


def _extreme(a: Arithmetic, parts: list[Any], side: int) -> Any:
    """Return max (side 1) or min (side -1) by max(x, y) = (x + y + |x - y|) / 2."""
    result = parts[0]
    for part in parts[1:]:
        result = (result + part + side * a.absolute(result - part)) / 2
    return result


def _piecewise(a: Arithmetic, node: sympy.Piecewise) -> Any:
    """Fold the cases from the last to the first; the last must be unconditional."""
    *cases, (result, last) = node.args
    if not isinstance(last, BooleanTrue):
        raise ExpressionError(
            f"Piecewise {str(node)[:80]} is undefined outside its cases: add a (value, True) case"
        )
    number = a.value(result)
    for value, condition in reversed(cases):
        number = a.select(_condition(a, condition), a.value(value), number)
    return number


_RELATIONS: dict[type, tuple[str, int, bool]] = {
    sympy.StrictLessThan: ("<", 1, False),
    sympy.LessThan: ("<=", 1, False),
    sympy.StrictGreaterThan: ("<", -1, False),
    sympy.GreaterThan: ("<=", -1, False),
    sympy.Equality: ("==", 1, False),
    sympy.Unequality: ("==", 1, True),
}


def _condition(a: Arithmetic, condition: sympy.Basic) -> Any:
    """Return the indicator of a condition; `and` is the product, `not` is 1 - x."""
    if isinstance(condition, BooleanTrue | BooleanFalse):
        return a.rational(1 if isinstance(condition, BooleanTrue) else 0)
    if isinstance(condition, sympy.Not):
        return 1 - _condition(a, condition.args[0])
    if isinstance(condition, sympy.And | sympy.Or):
        both = isinstance(condition, sympy.And)
        result = a.rational(1)
        for part in condition.args:
            holds = _condition(a, part)
            result = result * (holds if both else 1 - holds)
        return result if both else 1 - result
    if type(condition) in _RELATIONS:
        relation, side, negated = _RELATIONS[type(condition)]
        holds = a.indicator(relation, side * (a.value(condition.lhs) - a.value(condition.rhs)))
        return 1 - holds if negated else holds
    raise ExpressionError(f"condition {condition} is no comparison: use <, <=, =, !=, and, or, not")
