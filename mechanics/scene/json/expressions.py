"""Expressions as trees: an operation with its operands, a name, or a number.

["multiply", "m", ["power", "L", 2], ["cos", "theta"], ["derivative", "theta", 2]]

A name is that of a coordinate, a speed, an input or a parameter. A whole number may be long; any
other number is ``["constant", "1/3"]``, or a decimal, which is the fraction that it prints. Nothing
is evaluated: what is read may come from anybody.
"""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from decimal import Decimal
from fractions import Fraction
from typing import Any

import sympy
from sympy import Add, Expr, Integer, Mul, Piecewise, Pow, Rational, Symbol, pi, sympify
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational
from sympy.physics.vector import dynamicsymbols

from mechanics.errors import InputError
from mechanics.program.operations import OPERATIONS
from mechanics.scene.declared import decimals
from mechanics.scene.symbols import name_of

DEEPEST = 100
LONGEST_NUMBER = 200
"""Digits above and below."""
LARGEST_EXPONENT = 64
MOST_ENTRIES = 200_000
"""Of all trees of a scene together."""

NUMBER = re.compile(rf"-?\d{{1,{LONGEST_NUMBER}}}(/\d{{1,{LONGEST_NUMBER}}})?", re.ASCII)
MANY = ("add", "multiply", "and", "or")
"""Take two operands or more."""
PLAIN: dict[str, tuple[int, Callable[..., Any]]] = {
    "add": (2, Add),
    "multiply": (2, Mul),
    "subtract": (2, lambda x, y: x - y),
    "divide": (2, lambda x, y: x / y),
    "negate": (1, lambda x: -x),
    "power": (2, Pow),
    "sqrt": (1, sympy.sqrt),
}
OF_ANGLES = ("sin", "cos", "tan", "asin", "acos", "atan", "atan2")
FUNCTIONS: dict[str, tuple[int, Callable[..., Any]]] = PLAIN | {
    row.name: (row.arity, getattr(sympy, row.sympy))
    for row in OPERATIONS
    if row.sympy and row.arity and row.name not in PLAIN and row.name != "select"
}
"""Name, number of operands, and what SymPy calls it."""
RELATIONS = {"<": sympy.Lt, "<=": sympy.Le, ">": sympy.Gt, ">=": sympy.Ge}
_HEADS = {head: name for name, (_, head) in FUNCTIONS.items() if isinstance(head, type)}


@dataclass
class Names:
    """What names stand for, and how much has been read."""

    moving: Mapping[str, Expr]
    constants: Mapping[str, Symbol] = field(default_factory=dict)
    reactions: frozenset[str] = frozenset()
    left: int = MOST_ENTRIES


def refuse(path: str, words: str) -> InputError:
    """An error that names the place, as a path of JSON."""
    return InputError(f"scene, at {path}: {words}")


def write(expression: Any, name: Callable[[Symbol], Any]) -> Any:
    """The tree of an expression.

    Parameters
    ----------
    expression : Expr or number
    name : callable
        The tree of a symbol.

    Raises
    ------
    InputError
        If it holds something that has no place in JSON; that is named.
    """
    e = decimals(sympify(expression))
    if isinstance(e, Integer) and abs(e) < 10**15:
        return int(e)
    if isinstance(e, Rational):
        return ["constant", str(e)]
    if e is pi:
        return ["pi"]
    if isinstance(e, Symbol):
        return name(e)
    if isinstance(e, AppliedUndef):
        return name_of(e)
    if isinstance(e, sympy.Derivative):
        inner = e.expr
        if isinstance(inner, AppliedUndef):
            return ["derivative", name_of(inner), int(e.derivative_count)]
        return write(e.doit(), name)
    if isinstance(e, Piecewise):
        return _cases(list(e.args), name)
    if isinstance(e, sympy.StrictGreaterThan | sympy.GreaterThan):
        e = e.reversed
    if head := _HEADS.get(type(e)):
        return [head, *(write(part, name) for part in e.args)]
    raise InputError(
        f"scene: {type(e).__name__} in {str(e)[:60]!r} cannot be written as JSON: write the"
        " expression without it"
    )


def _cases(cases: list[Any], name: Callable[[Symbol], Any]) -> Any:
    value, condition = cases[0].args
    if condition is sympy.true:
        return write(value, name)
    if len(cases) == 1:
        raise InputError("scene: a Piecewise has no value where none of its conditions holds")
    return ["select", write(condition, name), write(value, name), _cases(cases[1:], name)]


def read(tree: Any, names: Names, path: str, depth: int = 0) -> Expr:
    """The expression of a tree.

    Parameters
    ----------
    tree : number, str or list
    path : str
        For messages.

    Raises
    ------
    InputError
        Names the place and what stands there.
    """
    value = _read(tree, names, path, depth)
    if not isinstance(value, Expr):
        raise refuse(path, "a truth value stands in place of a number")
    if value.has(sympy.nan, sympy.oo, -sympy.oo, sympy.zoo) or value.is_real is False:
        raise refuse(path, f"{str(value)[:40]} is not finite and real")
    return value


def _read(tree: Any, names: Names, path: str, depth: int) -> Any:
    names.left -= 1
    if names.left < 0:
        raise refuse(path, f"the expressions have more than {MOST_ENTRIES} entries")
    if depth > DEEPEST:
        raise refuse(path, f"an expression is nested more than {DEEPEST} deep")
    if isinstance(tree, str):
        return _named(tree, names, path)
    if isinstance(tree, int | Decimal) and not isinstance(tree, bool):
        return number(tree, path)
    if not isinstance(tree, list) or not tree or not isinstance(tree[0], str):
        raise refuse(path, 'a number, a name or a list such as ["cos", "theta"] expected')
    head, rest = tree[0], tree[1:]
    if head in _LEAVES:
        return _LEAVES[head](rest, names, path)
    if head == "select":
        return _select(rest, names, path, depth)
    if head not in FUNCTIONS:
        known = ", ".join([*_LEAVES, *FUNCTIONS, "select"])
        raise refuse(path, f"{head[:40]!r} is no operation: they are {known}")
    arity, function = FUNCTIONS[head]
    if len(rest) != arity and not (head in MANY and len(rest) > arity):
        raise refuse(path, f"{head} has {len(rest)} operands, {arity} expected")
    operands = [
        _read(part, names, f"{path}[{k}]", depth + 1) for k, part in enumerate(rest, start=1)
    ]
    truths = head in ("and", "or", "not")
    for k, operand in enumerate(operands, start=1):
        if isinstance(operand, Expr) == truths:
            wanted = "truth values" if truths else "numbers"
            raise refuse(f"{path}[{k}]", f"{head} takes {wanted}")
    _bounded(head, operands, path)
    return function(*operands)


def _bounded(head: str, operands: list[Any], path: str) -> None:
    """A short text cannot stand for a number without end, nor for a search for digits."""
    if head == "power":
        base, exponent = operands
        if exponent.is_number and not (
            exponent.is_Rational and max(abs(exponent.p), exponent.q) <= LARGEST_EXPONENT
        ):
            raise refuse(path, f"an exponent of at most {LARGEST_EXPONENT} expected")
        if (
            base.is_Rational
            and (abs(base.p).bit_length() + base.q.bit_length())
            * (abs(exponent.p) if exponent.is_Rational else 1)
            > 10 * LONGEST_NUMBER
        ):
            raise refuse(path, f"a number of more than {LONGEST_NUMBER} digits")
    elif head not in (*PLAIN, *OF_ANGLES) and all(
        isinstance(e, Expr) and e.is_number for e in operands
    ):
        raise refuse(path, f"{head} of constants: write the number that it is")


def number(value: int | Decimal, path: str) -> Expr:
    """A number that JSON has, exactly."""
    exact = Decimal(value)
    if not exact.is_finite() or abs(exact.adjusted()) > LONGEST_NUMBER:
        raise refuse(path, f"a number of at most {LONGEST_NUMBER} digits expected")
    return Rational(Fraction(value))


def _named(name: str, names: Names, path: str) -> Expr:
    if name in names.moving:
        return names.moving[name]
    if name in names.constants:
        return names.constants[name]
    raise refuse(
        path,
        f"{name[:40]!r} is no coordinate, speed, input or parameter: declare it in parameters",
    )


def _constant(rest: list[Any], names: Names, path: str) -> Expr:
    if len(rest) != 1 or not isinstance(rest[0], str) or not NUMBER.fullmatch(rest[0]):
        raise refuse(path, f"a fraction in a string, of {LONGEST_NUMBER} digits at most, expected")
    try:
        return Rational(Fraction(rest[0]))
    except ZeroDivisionError:
        raise refuse(path, f"{rest[0]} divides by 0") from None


def _pi(rest: list[Any], names: Names, path: str) -> Expr:
    if rest:
        raise refuse(path, "pi has no operands")
    return pi


def _time(rest: list[Any], names: Names, path: str) -> Expr:
    if rest:
        raise refuse(path, "time has no operands")
    return dynamicsymbols._t


def _reaction(rest: list[Any], names: Names, path: str) -> Expr:
    if len(rest) != 1 or not isinstance(rest[0], str) or rest[0] not in names.reactions:
        known = ", ".join(sorted(names.reactions)) or "none"
        raise refuse(path, f"the name of a reaction expected: they are {known}")
    return Symbol(rest[0], real=True)


def _derivative(rest: list[Any], names: Names, path: str) -> Expr:
    if (
        len(rest) != 2
        or not isinstance(rest[0], str)
        or rest[0] not in names.moving
        or type(rest[1]) is not int
        or not 1 <= rest[1] <= 3
    ):
        raise refuse(path, "a coordinate, speed or input and an order of 1 to 3 expected")
    return names.moving[rest[0]].diff(dynamicsymbols._t, rest[1])


def _select(rest: list[Any], names: Names, path: str, depth: int) -> Expr:
    if len(rest) != 3:
        raise refuse(path, f"select has {len(rest)} operands, 3 expected: condition, then, else")
    condition = _read(rest[0], names, f"{path}[1]", depth + 1)
    if isinstance(condition, Expr):
        raise refuse(f"{path}[1]", "a condition expected")
    yes, no = (read(rest[k], names, f"{path}[{k + 1}]", depth + 1) for k in (1, 2))
    return Piecewise((yes, condition), (no, True))


_LEAVES: dict[str, Callable[[list[Any], Names, str], Expr]] = {
    "constant": _constant,
    "pi": _pi,
    "time": _time,
    "reaction": _reaction,
    "derivative": _derivative,
}


def relation(tree: Any, names: Names, path: str) -> Relational:
    """``["<=", left, right]``."""
    if not isinstance(tree, list) or len(tree) != 3 or tree[0] not in (*RELATIONS,):
        raise refuse(path, 'an inequality such as [">", ["reaction", "N"], 0] expected')
    left, right = (read(tree[k], names, f"{path}[{k}]") for k in (1, 2))
    return RELATIONS[tree[0]](left, right, evaluate=False)
