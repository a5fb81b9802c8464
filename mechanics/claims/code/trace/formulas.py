"""The formulas of code as the code has them, which SymPy would put together while they are made.

k*(-2*x1 + x1)   stays that, where its expression is -k*x1        a node of None has no formula
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import partial

import casadi
from sympy import Expr, Symbol, preorder_traversal

from mechanics.claims.from_sympy import CALLS, Untreeable, tree_of
from mechanics.claims.place import Refused
from mechanics.claims.tree import (
    Call,
    Name,
    Node,
    Number,
    Power,
    Product,
    Sum,
    constant,
    inverse,
    negative,
    product,
    total,
)
from mechanics.program.casadi_reader import Instruction

ZERO, ONE, MINUS = (Number(0, Fraction(value)) for value in (0, 1, -1))

LOCAL = "="
"""Begins a name in a formula that is the code's own, so that it is no symbol of the scene."""

MOST_NODES = 2500
"""Of a formula, everything that is used twice counted twice."""


@dataclass(frozen=True)
class Known:
    """A formula, and how many nodes it has at most."""

    node: Node
    count: int


Formula = Known | None


@dataclass(frozen=True)
class Assignment:
    """A formula that code gives a name.

    Attributes
    ----------
    tree : Node
    place : str
        ``cart.py, line 12``
    """

    tree: Node
    place: str


Assignments = Mapping[str, Assignment]
"""By name, in their order."""


@dataclass(frozen=True)
class Authored:
    """A formula, and the assignments that it is made with."""

    tree: Node
    assigned: Assignments = field(default_factory=dict)


NONE: Mapping[int, tuple[str, str]] = {}

Formulas = Mapping[Expr, Authored]
"""The formulas of outputs, by the expressions that they are."""


def leaf(expression: Expr) -> Formula:
    """A symbol under its own name, or a constant."""
    count = sum(1 for _ in preorder_traversal(expression))
    try:
        return Known(tree_of(expression, lambda symbol: Name(0, symbol.name)), count)
    except Untreeable:
        return None


def _joined(make: Callable[..., Node]) -> Callable[..., Formula]:
    def apply(*parts: Formula) -> Formula:
        known = [part for part in parts if part is not None]
        count = 1 + sum(part.count for part in known)
        if len(known) < len(parts) or count > MOST_NODES:
            return None
        try:
            return Known(make(*(part.node for part in known)), count)
        except Refused:
            return None  # too large, or a division by zero: the expression tells

    return apply


def _sign(node: Node) -> tuple[int, tuple[Node, ...]]:
    """The sign of a product, and its factors without it."""
    if not isinstance(node, Product):
        return 1, (node,)
    first, *rest = node.factors
    if first != MINUS:
        return 1, node.factors
    sign, factors = _sign(product(0, rest))
    return -sign, factors


def _product(a: Node, b: Node) -> Node:
    if constant(a) == 0 or constant(b) == 0:
        return ZERO
    (one, left), (other, right) = _sign(a), _sign(b)
    inner = product(0, [factor for factor in (*left, *right) if factor != ONE] or [ONE])
    return inner if one == other else negative(inner)


def _sum(a: Node, b: Node) -> Node:
    terms = [t for node in (a, b) for t in (node.terms if isinstance(node, Sum) else (node,))]
    return total(0, [term for term in terms if constant(term) != 0] or [ZERO])


def _minus(node: Node) -> Node:
    return _product(MINUS, node)


def _over(node: Node) -> Node:
    sign, factors = _sign(node)
    below = inverse(product(0, list(factors)))
    return below if sign > 0 else negative(below)


added = _joined(_sum)
subtracted = _joined(lambda a, b: _sum(a, _minus(b)))
multiplied = _joined(_product)
divided = _joined(lambda a, b: _product(a, _over(b)))
raised = _joined(lambda a, b: Power(0, a, b))
negated = _joined(_minus)


def called(name: str, *arguments: Formula) -> Formula:
    """A function of the trees, by its name there."""
    if name not in CALLS.values():
        return None
    return _joined(lambda *parts: Call(0, name, parts))(*arguments)


def _power(exponent: Fraction) -> Callable[[Formula], Formula]:
    return _joined(lambda a: Power(0, a, Number(0, exponent)))


def _where(condition: Formula, value: Formula) -> Formula:
    """A value where a condition is known to hold, zero where it is known not to."""
    if condition is None or condition.node not in (ZERO, ONE):
        return None
    return value if condition.node == ONE else Known(ZERO, 1)


def _truth(decide: Callable[..., bool]) -> Callable[..., Formula]:
    """A truth of others that are known."""

    def apply(*parts: Formula) -> Formula:
        if any(part is None or part.node not in (ZERO, ONE) for part in parts):
            return None
        held = decide(*(part is not None and part.node == ONE for part in parts))
        return Known(ONE if held else ZERO, 1)

    return apply


OPERATIONS: dict[int, Callable[..., Formula]] = {
    casadi.OP_IF_ELSE_ZERO: _where, casadi.OP_NOT: _truth(lambda a: not a),
    casadi.OP_AND: _truth(lambda a, b: a and b), casadi.OP_OR: _truth(lambda a, b: a or b),
    casadi.OP_ASSIGN: lambda a: a,
    casadi.OP_ADD: added, casadi.OP_SUB: subtracted, casadi.OP_MUL: multiplied,
    casadi.OP_DIV: divided, casadi.OP_NEG: negated,
    casadi.OP_POW: raised, casadi.OP_CONSTPOW: raised,
    casadi.OP_SQ: _power(Fraction(2)), casadi.OP_INV: _power(Fraction(-1)),
    casadi.OP_SQRT: _power(Fraction(1, 2)),
    casadi.OP_TWICE: _joined(lambda a: _product(Number(0, Fraction(2)), a)),
    **{operation: partial(called, name) for operation, name in (
        (casadi.OP_SIN, "sin"), (casadi.OP_COS, "cos"), (casadi.OP_TAN, "tan"),
        (casadi.OP_ASIN, "asin"), (casadi.OP_ACOS, "acos"), (casadi.OP_ATAN, "atan"),
        (casadi.OP_ATAN2, "atan2"), (casadi.OP_SINH, "sinh"), (casadi.OP_COSH, "cosh"),
        (casadi.OP_TANH, "tanh"), (casadi.OP_EXP, "exp"), (casadi.OP_LOG, "log"),
        (casadi.OP_FABS, "abs"), (casadi.OP_SIGN, "sign"), (casadi.OP_FMAX, "max"),
        (casadi.OP_FMIN, "min"),
    )},
}  # fmt: skip
"""Of the graphs of CasADi, and of C, which is lowered to the same."""


def of_graph(
    instructions: Sequence[Instruction],
    inputs: Sequence[Sequence[Expr]],
    rational: Callable[[Fraction], Expr],
    named: Mapping[int, tuple[str, str]] = NONE,
    assigned: dict[str, Assignment] | None = None,
) -> list[Formula]:
    """The formula of every node of straight-line code.

    `rational` says what a constant is, `named` which nodes the code gives a name and where;
    `assigned` learns these.
    """
    found: list[Formula] = []
    for place, (op, operands, number) in enumerate(instructions):
        if number is not None:
            found.append(leaf(rational(number)))
        elif op == casadi.OP_INPUT:
            found.append(leaf(inputs[operands[0]][operands[1]]))
        elif op in OPERATIONS:
            found.append(OPERATIONS[op](*(found[i] for i in operands)))
        else:
            found.append(None)
        last = found[-1]
        if place in named and last is not None and assigned is not None:
            found[-1] = given_a_name(last, *named[place], assigned)
    return found


def given_a_name(formula: Known, name: str, place: str, assigned: dict[str, Assignment]) -> Known:
    """A formula as the name that it is assigned to, where that is free for it."""
    key = f"{LOCAL}{name}"
    if isinstance(formula.node, Number) or not name.isascii():
        return formula
    if isinstance(formula.node, Name):
        alias = name.isidentifier() and not formula.node.name.startswith(LOCAL)
        if alias and assigned.setdefault(key, Assignment(formula.node, place)).tree != formula.node:
            assigned[key] = Assignment(ZERO, place)  # it is two things
        return formula
    if key in assigned and isinstance(assigned[key].tree, Name):
        del assigned[key]
    if assigned.setdefault(key, Assignment(formula.node, place)).tree != formula.node:
        return formula
    return Known(Name(0, key), 1)


def renamed(node: Node, name_of: Callable[[Symbol], Name]) -> Node:
    """A formula whose symbols have the names of a naming."""
    match node:
        case Name(name=name):
            return node if name.startswith(LOCAL) else name_of(Symbol(name, real=True))
        case Sum(terms=inner):
            return Sum(0, tuple(renamed(part, name_of) for part in inner))
        case Product(factors=inner):
            return Product(0, tuple(renamed(part, name_of) for part in inner))
        case Power(base=base, exponent=exponent):
            return Power(0, renamed(base, name_of), renamed(exponent, name_of))
        case Call(function=function, arguments=inner):
            return Call(0, function, tuple(renamed(part, name_of) for part in inner))
    return node
