"""What was derived, as plain expressions: the left side of the first step of the chain.

left x = right,  x = (u', lambda)        q' = rates        kinetic, potential, momenta, reactions
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from sympy import Expr, Matrix, S, Symbol, zeros

from mechanics.compiled.custody.derived_program import GROUPS, DerivedProgram, derived_program
from mechanics.compiled.graphs import Graphs
from mechanics.compiled.mechanical import totals
from mechanics.equations import ProgramEquations
from mechanics.scene.rates import TIME


@dataclass(frozen=True, eq=False)
class Derived:
    """Expressions in plain symbols, before parameters are fixed.

    Attributes
    ----------
    scene, route : str
    symbols : mapping of str to tuple of Symbol
        By group, in the order of the arrays.
    fixed : mapping of Symbol to Expr
        Exact values of parameters that are no input.
    time : int or None
        Entry of the inputs that is the time.
    unknowns : tuple of Symbol
        u' and the multipliers.
    left, right : Matrix
        Of the linear system for the unknowns.
    mass, forcing : Matrix
    rates : tuple of Expr
        q'.
    kinetic, potential : Expr
    linear, angular : tuple of Expr
        Momenta.
    reactions : tuple of (Symbol, Expr)
        In terms of the unknowns, too.
    rows : tuple of Expr
        M u' - f - B lambda as it was derived, where M and f have not been written out; `left` and
        `right` then hold the constraints only.
    """

    scene: str
    route: str
    symbols: Mapping[str, tuple[Symbol, ...]]
    fixed: Mapping[Symbol, Expr]
    time: int | None
    unknowns: tuple[Symbol, ...]
    left: Matrix
    right: Matrix
    mass: Matrix
    forcing: Matrix
    rates: tuple[Expr, ...]
    kinetic: Expr = S.Zero
    potential: Expr = S.Zero
    linear: tuple[Expr, ...] = ()
    angular: tuple[Expr, ...] = ()
    reactions: tuple[tuple[Symbol, Expr], ...] = field(default=())
    rows: tuple[Expr, ...] = ()


Known = Derived | DerivedProgram
"""What was derived, written out or as a program."""

WITH_TOTALS = frozenset({"energy", "momenta", "inverse_dynamics"})
"""Functions that need energies."""
OF_ROWS = frozenset({"forward_dynamics", "coordinate_rates", "energy", "momenta"})
"""Functions that can be judged by rows that are not split into M and f."""


def derived(graphs: Graphs, functions: Sequence[str], by_rows: bool = False) -> Known:
    """What was derived, as far as some functions need it.

    With `by_rows`, M and f of a long chain are not written out where rows can judge.
    """
    if isinstance(graphs.derived, ProgramEquations):
        return derived_program(graphs.derived, graphs.quantities, graphs.fixed)
    equations, scene = graphs.derived, graphs.derived.scene
    by_rows = by_rows and bool(equations.rows) and OF_ROWS.issuperset(functions)
    by_rows = by_rows and (equations.long or not equations.readable)
    if by_rows:
        count = len(equations.multipliers)
        constraints = equations.constraint_matrix
        left = constraints.row_join(zeros(constraints.rows, count))
        right, mass, forcing = equations.constraint_bias, zeros(0, 0), zeros(0, 1)
    else:
        left, right = equations.system
        mass, forcing = equations.mass, equations.forcing
    symbols = {g: tuple(e.symbol for e in getattr(graphs.quantities, g)) for g in GROUPS}
    times = [i for i, symbol in enumerate(symbols["inputs"]) if symbol == TIME]
    known = totals(scene) if WITH_TOTALS & set(functions) else None
    momenta = "momenta" in functions
    return Derived(
        scene=scene.name,
        route=equations.route,
        symbols=symbols,
        fixed=graphs.fixed,
        time=times[0] if times else None,
        unknowns=tuple(equations.unknowns),
        left=left,
        right=right,
        mass=mass,
        forcing=forcing,
        rates=tuple(scene.coordinate_rates[qd] for qd in scene.qd),
        kinetic=known.kinetic if known else S.Zero,
        potential=known.potential if known and "energy" in functions else S.Zero,
        linear=tuple(known.linear_momentum) if known and momenta else (),
        angular=tuple(known.angular_momentum) if known and momenta else (),
        reactions=tuple(equations.reactions) if "reactions" in functions else (),
        rows=equations.rows if by_rows else (),
    )
