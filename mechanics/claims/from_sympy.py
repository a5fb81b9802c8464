"""An expression of SymPy's as a tree of what a person wrote.

Add -> Sum        Mul -> Product, its sign and number first        Pow -> Power        sin -> Call
"""

from collections.abc import Callable
from fractions import Fraction

import sympy
from sympy import Add, Expr, Mul, Pow, Rational, Symbol

from mechanics.claims.place import Refused
from mechanics.claims.tree import Call, Name, Node, Number, Power, Product, Sum


class Untreeable(Exception):
    """An expression holds what no tree can: cases, derivatives, or it is too large for one."""


def tree_of(expression: Expr, named: Callable[[Symbol], Name]) -> Node:
    """The tree of an expression in plain symbols, which get names as they are asked for.

    Raises
    ------
    Untreeable
        Where it holds what the trees do not know, or is larger than they may be: what a person
        may not write at once (``x**64``), products of it can come to.
    """
    try:
        return _tree(expression, named)
    except Refused as reason:
        raise Untreeable(reason.words) from None


def _tree(expression: Expr, named: Callable[[Symbol], Name]) -> Node:
    if isinstance(expression, Rational):
        return _number(expression)
    if isinstance(expression, Symbol):
        return named(expression)
    if isinstance(expression, Add):
        # SymPy keeps terms in an order of its own; people read the one that it prints.
        terms = expression.as_ordered_terms() if len(expression.args) < 30 else expression.args
        return Sum(0, tuple(_tree(term, named) for term in terms))
    if isinstance(expression, Mul):
        return _product(expression, named)
    if isinstance(expression, Pow):
        return Power(0, _tree(expression.base, named), _tree(expression.exp, named))
    if expression is sympy.pi:
        return Call(0, "pi", ())
    if isinstance(expression, sympy.Function) and type(expression).__name__ in CALLS:
        name = CALLS[type(expression).__name__]
        return Call(0, name, tuple(_tree(argument, named) for argument in expression.args))
    raise Untreeable(type(expression).__name__)


CALLS = {
    **{name: name for name in (
        "sin", "cos", "tan", "cot", "sec", "csc", "asin", "acos", "atan", "sinh", "cosh", "tanh",
        "coth", "asinh", "acosh", "atanh", "exp", "log", "sign", "atan2",
    )},
    "Abs": "abs", "Max": "max", "Min": "min",
}  # fmt: skip
"""SymPy's names of functions, and those of the trees."""


def _number(value: Rational) -> Node:
    ratio = Fraction(int(value.p), int(value.q))
    if ratio >= 0:
        return Number(0, ratio)
    return Product(0, (Number(0, Fraction(-1)), Number(0, -ratio)))


def _product(expression: Mul, named: Callable[[Symbol], Name]) -> Node:
    coefficient, factors = expression.as_coeff_mul()
    nodes: list[Node] = []
    if coefficient.is_Rational:
        ratio = Fraction(int(coefficient.p), int(coefficient.q))
        nodes += [Number(0, abs(ratio))] if abs(ratio) != 1 else []
    else:
        ratio = Fraction(1)
        nodes.append(_tree(coefficient, named))
    nodes += [_tree(factor, named) for factor in factors]
    inner = nodes[0] if len(nodes) == 1 else Product(0, tuple(nodes))
    return Product(0, (Number(0, Fraction(-1)), inner)) if ratio < 0 else inner
