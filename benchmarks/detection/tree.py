"""Expressions as they are written: trees that nothing simplifies.

sum(2 k x, product(M, power(L, 2), ...))        a place is a path of child numbers: (0, 2, 1)

A mutation is made on such a tree before it is written in any notation, so that what was changed,
and what it was before, are known exactly.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import prod
from typing import Any

import sympy

Path = tuple[int, ...]

FUNCTIONS = ("sin", "cos", "tan", "sign", "Abs")
"""By their names in SymPy."""


@dataclass(frozen=True)
class Tree:
    """A node: ``"number"``, ``"symbol"``, ``"sum"``, ``"product"``, ``"power"`` or a function.

    Attributes
    ----------
    value : Fraction, sympy.Symbol or None
        Of a number or symbol.
    parts : tuple of Tree
        Of a power base and exponent.
    """

    kind: str
    value: Any = None
    parts: tuple[Tree, ...] = ()

    @property
    def size(self) -> int:
        """Number of nodes."""
        return 1 + sum(part.size for part in self.parts)


def number(value: int | Fraction) -> Tree:
    """A rational number."""
    return Tree("number", Fraction(value))


def symbol(value: sympy.Symbol) -> Tree:
    """A symbol."""
    return Tree("symbol", value)


def total(*terms: Tree) -> Tree:
    """A sum, flat; of nothing it is zero."""
    flat: list[Tree] = []
    for term in terms:
        flat += term.parts if term.kind == "sum" else (term,)
    return flat[0] if len(flat) == 1 else Tree("sum", None, tuple(flat)) if flat else number(0)


def product(*factors: Tree) -> Tree:
    """A product, flat, its numbers gathered in front; of nothing it is one."""
    flat: list[Tree] = []
    for factor in factors:
        flat += factor.parts if factor.kind == "product" else (factor,)
    ratio = prod((f.value for f in flat if f.kind == "number"), start=Fraction(1))
    rest = [f for f in flat if f.kind != "number"]
    if ratio == 0 or not rest:
        return number(ratio)
    kept = rest if ratio == 1 else [number(ratio), *rest]
    return kept[0] if len(kept) == 1 else Tree("product", None, tuple(kept))


def power(base: Tree, exponent: int | Fraction) -> Tree:
    """A rational power."""
    if exponent == 1:
        return base
    if base.kind == "number" and Fraction(exponent).denominator == 1 and base.value != 0:
        return number(base.value ** int(exponent))
    return Tree("power", None, (base, number(exponent)))


def negative(tree: Tree) -> Tree:
    """The tree with its sign changed."""
    return product(number(-1), tree)


QUOTIENTS = {
    sympy.cot: lambda x: sympy.Mul(sympy.cos(x), 1 / sympy.sin(x), evaluate=False),
    sympy.sec: lambda x: 1 / sympy.cos(x),
    sympy.csc: lambda x: 1 / sympy.sin(x),
}
"""What SymPy makes of functions of pi/2 - x, as people write it."""


def read(expr: sympy.Expr) -> Tree:
    """The tree of a SymPy expression, terms and factors in the order of people."""
    if expr.is_Rational:
        return number(Fraction(int(expr.p), int(expr.q)))
    if expr.is_Symbol:
        return symbol(expr)
    if expr.is_Add:
        return total(*(read(term) for term in expr.as_ordered_terms()))
    if expr.is_Mul:
        return product(*(read(factor) for factor in expr.as_ordered_factors()))
    if expr.is_Pow and expr.exp.is_Rational:
        return power(read(expr.base), Fraction(int(expr.exp.p), int(expr.exp.q)))
    if type(expr).__name__ in FUNCTIONS:
        return Tree(type(expr).__name__, None, (read(expr.args[0]),))
    if type(expr) in QUOTIENTS:
        return read(QUOTIENTS[type(expr)](expr.args[0]))
    if expr is sympy.S.Pi:
        return Tree("pi")
    raise ValueError(f"{expr} cannot be written as a tree: {type(expr).__name__}")


def written(tree: Tree) -> sympy.Expr:
    """The SymPy expression of a tree."""
    parts = [written(part) for part in tree.parts]
    match tree.kind:
        case "number":
            return sympy.Rational(tree.value.numerator, tree.value.denominator)
        case "symbol":
            return tree.value
        case "sum":
            return sympy.Add(*parts)
        case "product":
            return sympy.Mul(*parts)
        case "power":
            return sympy.Pow(*parts)
        case "pi":
            return sympy.pi
    return getattr(sympy, tree.kind)(*parts)


def places(tree: Tree, path: Path = ()) -> Iterator[tuple[Path, Tree]]:
    """Every node with its path, from the top."""
    yield path, tree
    for i, part in enumerate(tree.parts):
        yield from places(part, (*path, i))


def at(tree: Tree, path: Path) -> Tree:
    """The node at a path."""
    for i in path:
        tree = tree.parts[i]
    return tree


def put(tree: Tree, changes: Mapping[Path, Tree]) -> Tree:
    """The tree with other nodes at some paths, put together again as people write it.

    All at once: what is put together may move its neighbours.
    """
    if () in changes:
        return changes[()]
    parts = []
    for i, part in enumerate(tree.parts):
        inner = {path[1:]: new for path, new in changes.items() if path[0] == i}
        parts.append(put(part, inner) if inner else part)
    return rebuilt(tree, parts)


def rebuilt(tree: Tree, parts: list[Tree]) -> Tree:
    """A node with other parts; signs and numbers gathered."""
    if tree.kind == "sum":
        return total(*parts)
    if tree.kind == "product":
        return product(*parts)
    if tree.kind == "power":
        return power(parts[0], parts[1].value)
    return Tree(tree.kind, tree.value, tuple(parts))


def symbols(tree: Tree) -> set[sympy.Symbol]:
    """Every symbol in a tree."""
    return {node.value for _, node in places(tree) if node.kind == "symbol"}
