"""How much a tree comes to with definitions put in: what is too much is refused, never built.

    sum, product, function   1 + sum of weights        power    weight * |exponent|
    rate                     weight * (1 + depth)      once for every dot
    A B of matrices          columns(B) weight(A) + rows(A) weight(B)

A derivative has a term for each name, with everything on the way to that name beside it.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce

from mechanics.claims.tree import (
    Call,
    Name,
    Node,
    Number,
    Power,
    Product,
    Rate,
    Sum,
    Table,
    constant,
)

HEAVIEST = 1 << 60
"""Where counting stops."""

INVERSE = 30
"""Factors of the inverse of a matrix of three rows, for each of its own."""


@dataclass(frozen=True)
class Weight:
    """Nodes of an expression, without sharing, their depth, and the shape where it is a matrix."""

    amount: int = 1
    depth: int = 1
    shape: tuple[int, int] | None = None


def weight(node: Node, defined: Mapping[str, Weight]) -> Weight:
    """What a tree comes to.

    Parameters
    ----------
    node : Node
    defined : mapping of str to Weight
        Of what names are defined by.
    """
    match node:
        case Number():
            return Weight()
        case Name(name=name, order=order):
            return _rate(defined.get(name, Weight()), order)
        case Rate(of=inner, order=order):
            return _rate(weight(inner, defined), order)
        case Product(factors=factors):
            return reduce(_times, [weight(factor, defined) for factor in factors])
        case Power(base=base, exponent=exponent):
            return _power(weight(base, defined), weight(exponent, defined), constant(exponent))
        case Call(function="transpose", arguments=(only,)):
            found = weight(only, defined)
            return Weight(found.amount, found.depth, found.shape and found.shape[::-1])
        case Call(function="partial", arguments=(of, by)):
            found = _rate(weight(of, defined), 1)
            times = (weight(by, defined).shape or (1, 1))[0]
            amount = min(found.amount * times, HEAVIEST)
            return Weight(amount, found.depth, weight(by, defined).shape)
        case Call(function="cross", arguments=(left, right)):
            one, two = weight(left, defined), weight(right, defined)
            depth = 2 + max(one.depth, two.depth)
            return Weight(min(2 * (one.amount + two.amount), HEAVIEST), depth, one.shape)
        case Call(arguments=parts) if len(parts) > 1:
            # The rate of a maximum compares each argument with all others.
            found = _together([weight(part, defined) for part in parts])
            return Weight(found.amount * len(parts), found.depth)
        case Sum(terms=parts) | Call(arguments=parts):
            return _together([weight(part, defined) for part in parts])
        case Table(rows=rows):
            cells = _together([weight(cell, defined) for row in rows for cell in row])
            return Weight(cells.amount, cells.depth, (len(rows), len(rows[0]) if rows else 0))
    return Weight()


def _together(found: Sequence[Weight]) -> Weight:
    shape = next((part.shape for part in found if part.shape), None)
    depth = 1 + max((part.depth for part in found), default=0)
    return Weight(min(1 + sum(part.amount for part in found), HEAVIEST), depth, shape)


def _times(left: Weight, right: Weight) -> Weight:
    depth = max(left.depth, right.depth + 1)
    if left.shape is None and right.shape is None:
        return Weight(min(left.amount + right.amount, HEAVIEST), depth)
    # A number stands in every entry.
    rows, inner = left.shape or (right.shape or (1, 1))[:1] * 2
    _, columns = right.shape or (inner, inner)
    amount = columns * left.amount + rows * right.amount
    return Weight(min(amount, HEAVIEST), depth + 1, (rows, columns))


def _power(base: Weight, exponent: Weight, number: Fraction | None) -> Weight:
    times = 1 if number is None else max(1, -(-abs(number.numerator) // number.denominator))
    if base.shape is not None:
        times *= INVERSE
    amount = min(base.amount * times + exponent.amount, HEAVIEST)
    return Weight(amount, 1 + max(base.depth, exponent.depth), base.shape)


def _rate(found: Weight, order: int) -> Weight:
    if not order or found.amount == 1:
        return found
    amount = min(found.amount * (1 + found.depth) ** order, HEAVIEST)
    return Weight(amount, found.depth + order, found.shape)
