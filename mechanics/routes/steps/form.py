"""The common form of the equations, in which every route ends.

    sum_j M_ij u'_j + what depends on the state alone  =  what inputs do        M_ii > 0

Rows are power-conjugate to the speeds, so that they are the same by whatever route.
"""

from __future__ import annotations

from dataclasses import replace

from sympy import Add, Expr, Mul, Rational

from mechanics.equations import Equations, Line, Term
from mechanics.scene import Scene
from mechanics.scene.symbols import plain_symbol


def has_common_form(scene: Scene) -> bool:
    """Whether the rows of all routes are combinations of each other by numbers alone.

    Constraints leave multipliers or dependent speeds, friction the reaction that presses.
    """
    return not scene.constraints and not any(hasattr(load, "reaction") for load in scene.loads)


def common_form(equations: Equations) -> tuple[Line, ...]:
    """The equations as numbered lines, E1 the first.

    Parameters
    ----------
    equations : Equations
        By a route whose rows are power-conjugate to u, written out.
    """
    if not has_common_form(equations.scene):
        return tuple(
            replace(line, number=f"E{k}") for k, line in enumerate(equations.result.lines, start=1)
        )
    return tuple(_line(equations, i, f"E{i + 1}") for i in range(equations.mass.rows))


def _line(equations: Equations, row: int, number: str) -> Line:
    scene = equations.scene
    left = [
        Term(Mul(entry, unknown))
        for entry, unknown in zip(equations.mass.row(row), scene.ud, strict=True)
        if entry != 0
    ]
    inputs = {plain_symbol(f, order) for f in scene.inputs for order in range(3)}
    state, driven = _parted(equations.forcing[row], inputs)
    left += [Term(-part) for part in Add.make_args(state) if part != 0]
    right = tuple(Term(part) for part in driven) or Rational(0)
    return Line(tuple(left), right, "", number)


def _parted(forcing: Expr, inputs: set[Expr]) -> tuple[Expr, list[Expr]]:
    """What does not hold the inputs, and what each of them does."""
    state: list[Expr] = []
    driven: list[Expr] = []
    for part in Add.make_args(forcing):
        (driven if part.free_symbols & inputs else state).append(part)
    rest, found = Add(*driven), []
    for symbol in sorted(inputs, key=str):
        slope = rest.diff(symbol)
        if slope != 0 and not slope.free_symbols & inputs:
            flat = slope.expand()
            short = flat if flat.count_ops() <= slope.count_ops() else slope
            found.append(Mul(short, symbol, evaluate=short.is_Number))
            rest = (rest - slope * symbol).expand()
    return Add(*state, rest) if not rest.free_symbols & inputs else Add(*state), (
        found if not rest.free_symbols & inputs else [*found, rest]
    )
