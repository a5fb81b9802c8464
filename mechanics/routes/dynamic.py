"""Plain symbols to SymPy's dynamic symbols and back, for the adapters over SymPy's methods."""

import re
from collections.abc import Iterable
from dataclasses import dataclass

from sympy import Dummy, Expr, ImmutableMatrix, Matrix
from sympy.matrices import MatrixBase
from sympy.physics.vector import dynamicsymbols

from mechanics.scene import Scene
from mechanics.scene.symbols import plain_table


@dataclass(frozen=True)
class Dynamic:
    """Two tables, one the inverse of the other."""

    forward: dict[Expr, Expr]
    backward: dict[Expr, Expr]

    def to(self, expression: Expr) -> Expr:
        """Plain to dynamic."""
        return expression.xreplace(self.forward)

    def back(self, matrix: MatrixBase) -> Matrix:
        """Dynamic to plain, entry by entry; equal entries are translated once."""
        done: dict[Expr, Expr] = {}
        entries = [
            done[entry] if entry in done else done.setdefault(entry, entry.xreplace(self.backward))
            for entry in ImmutableMatrix(matrix)
        ]
        return Matrix(*matrix.shape, entries)


def dynamic_rates(scene: Scene) -> Dynamic:
    """q, inputs and their derivatives: what Lagrange's method works on.

    SymPy names its multipliers lam1, lam2, ...: a parameter of that name would merge with one, and
    is replaced by a dummy.
    """
    clashing = {
        symbol: Dummy(symbol.name, **symbol.assumptions0)
        for symbol in scene.parameters
        if re.fullmatch(r"lam\d+", symbol.name)
    }
    return _inverted(_derivatives((*scene.coordinates, *scene.inputs)) | clashing)


def dynamic_speeds(scene: Scene) -> Dynamic:
    """q, u and u' with u a dynamic symbol of its own: what Kane's method works on."""
    t = dynamicsymbols._t
    forward = _derivatives(scene.inputs) | dict(zip(scene.q, scene.coordinates, strict=True))
    for u, ud in zip(scene.u, scene.ud, strict=True):
        function = dynamicsymbols(u.name)
        forward |= {u: function, ud: function.diff(t)}
    return _inverted(forward)


def _derivatives(functions: Iterable[Expr]) -> dict[Expr, Expr]:
    return {plain: dynamic for dynamic, plain in plain_table(functions).items()}


def _inverted(forward: dict[Expr, Expr]) -> Dynamic:
    return Dynamic(forward, {value: key for key, value in forward.items()})
