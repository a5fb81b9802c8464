"""The reactions that maintain constraints, solved from the rows of a route.

row(q, u, u', lambda) = 0        as many rows as there are multipliers, the shortest first
"""

from collections.abc import Sequence

from sympy import Add, Expr, Symbol

from mechanics.equations import Equations
from mechanics.kinematics.printer import Printer
from mechanics.routes.elimination import Elimination, Row, Solved, nonzero
from mechanics.routes.rows import coefficients, remainder


def multipliers_of(equations: Equations) -> tuple[tuple[Symbol, Expr], ...]:
    """The reactions that maintain the constraints, in u' and those of them that stand before.

    Raises
    ------
    InputError
        When the equations were given as matrices.
    SingularError
        When the rows do not determine them.
    """
    mechanism, rows = equations.program
    build, unknowns = mechanism.builder, rows.multipliers
    values = sorted(rows.values, key=lambda value: build.program({"row": (value,)}).count)
    anywhere, closed = mechanism.filters
    work = []
    rests = remainder(build, values, unknowns)
    for rest, held in zip(rests, coefficients(values, unknowns), strict=True):
        work.append(Row(0, rest, nonzero(anywhere, {i: -c for i, c in enumerate(held)})))
    elimination = Elimination(anywhere, closed, work)
    symbols, printer = equations.multipliers, Printer(equations.scene, mechanism)
    elimination.solve_for(range(len(unknowns)), None, [symbol.name for symbol in symbols])
    steps = reversed(elimination.solved)
    return tuple((symbols[s.reaction], solution(printer, s, symbols)) for s in steps)


def solution(printer: Printer, step: Solved, symbols: Sequence[Symbol]) -> Expr:
    """A reaction in u' and those that were not solved for before, by the symbol of each."""
    value, *factors = printer.short((step.row.value, *step.row.coefficients.values()))
    others = dict(zip(step.row.coefficients, factors, strict=True))
    pivot = others.pop(step.reaction)
    return Add(value, *(-factor * symbols[i] for i, factor in others.items())) / pivot
