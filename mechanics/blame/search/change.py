"""One edit at one node, with what it is worth: the smaller its cost the likelier it is.

token (sign, number, symbol, function, power)  <  term dropped  <  term added  <  term replaced
"""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from mechanics.blame.result import Mistake
from mechanics.claims.tree import Call, Node, Number, Power, Product, Sum

TOKEN, DROPPED, ADDED, REPLACED = 1.0, 1.4, 1.6, 2.6
"""Costs; two tokens are cheaper than a term that is replaced."""

SECOND = 0.2
"""What a change costs more that inserts or removes a factor instead of exchanging one."""

HINT = 0.02
"""What makes a change less likely than another one of its kind."""


RATIOS = tuple(
    sorted(
        {Fraction(n, d) for n in (1, 2, 3, 4, 5, 6, 8, 12) for d in (1, 2, 3, 4, 5, 6, 8, 12)}
        - {Fraction(1)},
        key=lambda ratio: ratio.numerator * ratio.denominator,
    )[:36]
)
"""Factors that are tried; others are found where one edit is enough."""


Wrap = Callable[[Node], Node]


@dataclass(frozen=True, eq=False)
class Change:
    """An edit.

    Attributes
    ----------
    index : int
        The node that is replaced, in its tree; of a term that is added, the sum.
    node : Node or None
        What stands there instead; None for a term or factor that is left out.
    at : int
        The node whose value is known with the change: `index`, or the function around it.
    values : tuple of int
        Its residue at each point.
    wrap : callable or None
        Makes `node` of what stands there, for edits that keep it: a sign, a factor, a term added.
        They go together with edits below.
    """

    index: int
    node: Node | None
    mistake: Mistake
    cost: float
    at: int
    values: tuple[int, ...]
    wrap: Wrap | None = None


def size_of(ratio: Fraction) -> float:
    """How unlikely a number is: its digits, from 0 for one; a whole one is likelier."""
    digits = (abs(ratio.numerator) * ratio.denominator).bit_length()
    return (digits + (ratio.denominator > 1) / 2) * HINT / 4


def minus(node: Node) -> Node:
    """The node with the other sign, without two signs in a row."""
    if isinstance(node, Product):
        for i, factor in enumerate(node.factors):
            if isinstance(factor, Number) and factor.value == -1:
                rest = (*node.factors[:i], *node.factors[i + 1 :])
                return rest[0] if len(rest) == 1 else Product(node.at, rest)
    if isinstance(node, Number):
        return Number(node.at, -node.value)
    return Product(node.at, (Number(node.at, Fraction(-1)), node))


def one_of_squares(node: Node, around: Node | None) -> bool:
    """Whether a node is one of the squares of x'^2 + y'^2, which nobody subtracts."""
    terms = around.terms if isinstance(around, Sum) else ()
    return node in terms and all(isinstance(term, Power) for term in terms)


def is_minus(node: Node) -> bool:
    """Whether a node begins with a minus sign."""
    if isinstance(node, Number):
        return node.value < 0
    return isinstance(node, Product) and any(
        isinstance(factor, Number) and factor.value == -1 for factor in node.factors
    )


def times(factor: Node, node: Node) -> Node:
    """A product with a factor in front, behind the sign; sines and cosines stand last."""
    if is_minus(node) and isinstance(node, Product):
        return minus(times(factor, minus(node)))
    inner = node.factors if isinstance(node, Product) else (node,)
    if isinstance(factor, Call):
        return Product(node.at, (*inner, factor))
    return Product(node.at, (factor, *inner))


def plus(term: Node, node: Node) -> Node:
    """A sum with one more term; nought is nothing."""
    if isinstance(node, Number) and node.value == 0:
        return term
    terms = node.terms if isinstance(node, Sum) else (node,)
    return Sum(node.at, (*terms, term))


def raised(base: Node, exponent: int) -> Node:
    """A power; the base itself for the exponent one."""
    return base if exponent == 1 else Power(base.at, base, Number(base.at, Fraction(exponent)))
