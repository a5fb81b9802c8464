"""Equilibria: what a text says of theta_0, where the scene has theta, or of theta at equilibrium.

    cos(theta_0) = g / (Omega^2 R)    ->    g = Omega^2 R cos(theta_0): then nothing accelerates

The equation is solved for a parameter that it holds in the first degree, which is put into what is
left of the equation of motion at rest: that has to vanish.
"""

from collections.abc import Iterator
from dataclasses import replace

from sympy import Expr, S, Symbol

from mechanics.claims.guess import equilibrium_of
from mechanics.claims.prose import of_equilibrium
from mechanics.claims.statement import Statement
from mechanics.equations import Equations
from mechanics.scene.published import Published
from mechanics.scene.quantities import Identity
from mechanics.symbolic import is_zero


def at_rest(truth: Equations, statement: Statement) -> Statement:
    """The statement; one about an equilibrium as what it says of the equation of motion.

    Parameters
    ----------
    truth : Equations
    statement : Statement
    """
    row, written, scene = statement.row, statement.written, truth.scene
    if row is None or written is None or len(scene.q) != 1 or scene.speeds:
        return statement
    if not isinstance(row.quantity, Identity) or len(row.sides) != 2:
        return statement
    sides = [scene.plain(side) for side in row.sides]
    held = set().union(*(side.free_symbols for side in sides))
    (q,) = scene.q
    unknown = held - {*scene.parameters, *scene.definitions}
    if len(unknown) != 1:
        return statement
    (value,) = unknown
    named = statement.doubt and equilibrium_of(written.naming, value.name) == q.name
    if not named and not (value == q and of_equilibrium(written.text, written.start)):
        return statement
    for vanishing in _left_over(truth, sides[0] - sides[1], value):
        note = f"{value} is read as {q} at an equilibrium"
        found = replace(row, sides=(scene.pressed(vanishing), S.Zero))
        return _said(statement, found, note)
    return statement


def _said(statement: Statement, row: Published, note: str) -> Statement:
    notes = (*statement.notes, note)
    return replace(statement, row=row, doubt="", notes=notes, written=None)


def _left_over(truth: Equations, difference: Expr, value: Symbol) -> Iterator[Expr]:
    """What accelerates at rest, with a parameter put in that makes a difference vanish."""
    scene = truth.scene
    (q,) = scene.q
    still = dict.fromkeys((*scene.qd, *scene.u, *scene.ud, *scene.input_symbols), S.Zero)
    (force,) = (row.xreplace(still) for row in truth.residual)
    if is_zero(force):
        return  # it rests everywhere, so what is said of one place says nothing
    for parameter in sorted(difference.free_symbols & {*scene.parameters}, key=str):
        slope = difference.diff(parameter)
        if slope != 0 and not slope.has(parameter):
            solved = (parameter - difference / slope).cancel().xreplace({value: q})
            if solved.is_zero:
                continue  # m theta_0 = 0 says nothing of theta_0 where m vanishes
            yield force.xreplace({parameter: solved})
