"""What a scene says, as graphs: expressions of its geometry and loads at the fixed values.

e = sum_j c_j u'_j + r        what is linear in accelerations, split
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property

import casadi as ca
from sympy import Expr, Symbol

from mechanics.compiled.forms.bodies.affine import Affine, Vector
from mechanics.compiled.translate import Translator
from mechanics.scene import Scene
from mechanics.scene.rates import rate_table
from mechanics.symbolic import collect_linear


@dataclass(frozen=True)
class Reading:
    """Expressions of a scene, in plain symbols, to graphs.

    Attributes
    ----------
    scene : Scene
    translate : Translator
    fixed : mapping of Symbol to Expr
        Parameters that are numbers.
    """

    scene: Scene
    translate: Translator
    fixed: Mapping[Symbol, Expr]

    @cached_property
    def rates(self) -> dict[Symbol, Expr]:
        """Rate of every symbol that changes with time."""
        return rate_table(self.scene)

    def __call__(self, expression: Expr) -> ca.SX:
        """The graph of an expression."""
        return self.translate(expression.xreplace(dict(self.fixed)))

    def column(self, entries: Iterable[Expr]) -> tuple[ca.SX, ...]:
        """The graphs of some expressions."""
        return tuple(self(entry) for entry in entries)

    def affine(self, expression: Expr) -> Affine:
        """An expression that is linear in u', in the unknowns u'."""
        ud = set(self.scene.ud) & expression.free_symbols
        if not ud:
            return Affine({}, self(expression))
        unknowns = [symbol for symbol in self.scene.ud if symbol in ud]
        coefficients, rest = collect_linear(expression, unknowns)
        graphs = {u: self(c) for u, c in zip(unknowns, coefficients, strict=True)}
        return Affine({u: c for u, c in graphs.items() if not c.is_zero()}, self(rest))

    def vector(self, entries: Iterable[Expr]) -> Vector:
        """Expressions that are linear in u', as `affine`."""
        return tuple(self.affine(entry) for entry in entries)

    @cached_property
    def _positive(self) -> set[int]:
        """Graphs of the parameters that are more than zero."""
        named = (p for p in self.scene.parameters if p.is_positive and p not in self.fixed)
        return {self.translate(p).element_hash() for p in named}

    def nonzero(self, graph: ca.SX) -> bool:
        """Whether a graph is known not to vanish: products and quotients of what is positive."""
        if graph.is_constant():
            return not graph.is_zero()
        if graph.is_symbolic():
            return graph.element_hash() in self._positive
        if any(graph.is_op(operation) for operation in (ca.OP_NEG, ca.OP_SQ, ca.OP_TWICE)):
            return self.nonzero(graph.dep(0))
        if any(graph.is_op(operation) for operation in (ca.OP_MUL, ca.OP_DIV)):
            return self.nonzero(graph.dep(0)) and self.nonzero(graph.dep(1))
        return False
