"""Nodes of a scene's mechanism as SymPy expressions in the scene's own symbols."""

import sys
from collections.abc import Sequence

from sympy import Expr, Symbol

from mechanics.mechanism import Mechanism
from mechanics.program.builder import Node
from mechanics.program.sympy_printer import expressions
from mechanics.scene import Scene
from mechanics.scene.rates import TIME
from mechanics.scene.symbols import DOTS, plain_symbol
from mechanics.symbolic import operations, tidy


class Printer:
    """Nodes of a scene's mechanism in the scene's own plain symbols.

    Parameters
    ----------
    mechanism : Mechanism
        Of that scene.
    """

    def __init__(self, scene: Scene, mechanism: Mechanism) -> None:
        self.scene, self.builder = scene, mechanism.builder
        self.symbols = symbols(scene)

    def __call__(self, nodes: Sequence[Node]) -> tuple[Expr, ...]:
        """SymPy expressions of nodes; equal parts are one object, so that size is no matter."""
        program = self.builder.program({"nodes": nodes})
        return expressions(program, self.symbols, limit=sys.maxsize)["nodes"]

    def short(self, nodes: Sequence[Node]) -> tuple[Expr, ...]:
        """The same, or the normal form where that is shorter: sines and cosines that cancel."""
        return tuple(min(e, tidy(e), key=operations) for e in self(nodes))

    def expanded(self, nodes: Sequence[Node]) -> tuple[Expr, ...]:
        """The same in the normal form."""
        return tuple(map(tidy, self(nodes)))

    def symbol(self, node: Node) -> Symbol:
        """The symbol of an input."""
        (symbol,) = self((node,))
        return symbol


def symbols(scene: Scene) -> dict[str, Symbol]:
    """Every symbol that can stand in the equations of a scene, by name; others are real."""
    found = [*scene.q, *scene.qd, *(plain_symbol(q, 2) for q in scene.coordinates)]
    found += [*scene.u, *scene.ud, *scene.parameters, *scene.definitions, TIME]
    found += [plain_symbol(f, order) for f in scene.inputs for order in range(len(DOTS))]
    found += [reaction.symbol for reaction in scene.reactions]
    found += [Symbol(f"lambda{i + 1}", real=True) for i in range(len(scene.constraints))]
    return {symbol.name: symbol for symbol in found}
