"""The reactions that maintain constraints: solved from the rows of a route, or as multipliers.

row(q, u, u', lambda) = 0        as many rows as there are multipliers, the shortest first
"""

from collections.abc import Collection, Sequence

from sympy import Add, Expr, Symbol

from mechanics.equations import Equations
from mechanics.kinematics import differentiate
from mechanics.kinematics.printer import Printer
from mechanics.mechanism import Mechanism
from mechanics.routes.elimination import Elimination, Row, Solved, nonzero
from mechanics.routes.lagrange import virtual_power
from mechanics.routes.loads import unit_reactions
from mechanics.routes.rows import acceleration_forms, coefficients, remainder


def meanings(mechanism: Mechanism) -> dict[str, tuple[int, str, str]]:
    """Lagrange's multipliers as reactions: ``{"lambda1": (-1, "T", "T_length")}``.

    That is lambda1 = -T, where the reaction T maintains the constraint T_length.

    The power of a unit of the reaction is that of the gradient of the constraint, or opposite,
    where the constraints hold; multipliers of which neither is true are left out.
    """
    if not mechanism.constraints:
        return {}
    motions = differentiate.motions(mechanism)
    units = unit_reactions(mechanism, motions.poses)
    _, closed = mechanism.filters
    named, names = {}, [constraint.name for constraint in mechanism.constraints]
    forms = coefficients(acceleration_forms(mechanism), mechanism.ud)
    for k, (row, index) in enumerate(zip(forms, mechanism.multipliers, strict=True), start=1):
        powers = virtual_power(mechanism, motions, units[index])
        for sign in (1, -1):
            if all(closed.is_zero(p - sign * a) for p, a in zip(powers, row, strict=True)):
                named[f"lambda{k}"] = (sign, mechanism.reactions[index].name, names[k - 1])
    return named


def meaning_words(
    mechanism: Mechanism, shown: Collection[str], formula: str = "{name} = {sign}{reaction}"
) -> list[str]:
    """What each of the multipliers that are shown is: the reaction that maintains a constraint."""
    if not any(name.startswith("lambda") for name in shown):
        return []
    return [
        formula.format(name=name, sign="-" if sign < 0 else "", reaction=reaction)
        + f", which maintains the constraint {constraint}"
        for name, (sign, reaction, constraint) in meanings(mechanism).items()
        if name in shown
    ]


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
