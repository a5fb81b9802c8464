"""Statements that are true whatever moves, and so say nothing about a scene.

0 = 0        m = m        sin(q)^2 + cos(q)^2 = 1        not:  omega = theta_dot
"""

from collections.abc import Container
from dataclasses import replace

from sympy import sympify
from sympy.matrices import MatrixBase

from mechanics.claims.about import ENERGY_NAMES
from mechanics.claims.partials import PARTIAL
from mechanics.claims.statement import Statement
from mechanics.claims.tree import Call, Name, Node, Product, Rate, Table
from mechanics.equations import Equations
from mechanics.judge.converted_rows import in_plain_symbols
from mechanics.kernel import Finding, undecided
from mechanics.scene.momenta import momentum_symbols, rate_symbol
from mechanics.scene.published import Published
from mechanics.scene.quantities import EquationOfMotion, Identity
from mechanics.symbolic import is_zero

WORDS = "it is an identity, true of every motion, so it says nothing about the scene"


def with_content(statement: Statement, finding: Finding) -> Finding:
    """The finding, but UNDECIDED for an identity that holds without anything of the scene.

    One name for another (``omega = theta_dot``) says what the person calls things, and code that
    returns the rate of a coordinate says which it is: these stay.
    """
    row, written = statement.row, statement.written
    if row is None or not isinstance(row.quantity, Identity):
        return finding
    code = statement.demands.code if written is None else written.notation == "code"
    if code or statement.derived:
        return finding
    if not finding.shown or _names(statement):
        return finding
    first, *others = row.sides
    if any(isinstance(side, MatrixBase) for side in row.sides):
        return finding
    if all(is_zero(first - side) for side in others):
        return undecided(finding.subject, WORDS)
    return finding


def derives(statement: Statement) -> bool:
    """Whether a side is the derivative of an energy that the person wrote: a step."""
    written = statement.written
    own = dict(written.definitions) if written is not None else {}
    return written is not None and any(_of_energy(side, own) for side in written.sides)


def _of_energy(node: Node, own: Container[str]) -> bool:
    match node:
        case Call(function=function, arguments=(Name(name=name), _)) if function == PARTIAL:
            return name in own and name in ENERGY_NAMES
        case Rate(of=inner) | Product(factors=(_, inner)):
            return _of_energy(inner, own)
    return False


def as_step(truth: Equations, statement: Statement) -> Statement:
    """A step that holds whatever moves, as the identity that it is: d/dt dL/dq' = m q''.

    So is the rate of a momentum as its definition has it, p' = d/dt (m q') = m q''.
    """
    row = statement.row
    if row is None or not isinstance(row.quantity, EquationOfMotion):
        return statement
    rates = {rate_symbol(p) for p in momentum_symbols(truth.scene)}
    if any(sympify(side).free_symbols & rates for side in row.sides):
        row = in_plain_symbols(truth.kinematics, row)
    elif not derives(statement):
        return statement
    first, *others = row.sides
    if not others or not all(is_zero(first - side) for side in others):
        return statement
    return replace(statement, row=replace(row_of(statement), quantity=Identity()))


def row_of(statement: Statement) -> Published:
    """The row of a statement that has one."""
    assert statement.row is not None
    return statement.row


def _column(side: Node) -> bool:
    """Whether it is a column or row of names: du[1:2] = u[3:4]."""
    cells = [cell for row in side.rows for cell in row] if isinstance(side, Table) else []
    return bool(cells) and all(isinstance(cell, Name) for cell in cells)


def _names(statement: Statement) -> bool:
    """Whether a side is a name of the person's own, or every side a name; no two are the same.

    What is left after definitions cancel (``R + u = F`` for ``R = F - u``) is no excuse: F is the
    scene's.
    """
    written = statement.written
    if written is None or len(written.sides) < 2:
        return False
    own = dict(written.definitions)
    named = [(side.name, side.order) for side in written.sides if isinstance(side, Name)]
    if all(map(_column, written.sides)):
        return len({*written.sides}) == len(written.sides)
    if len(set(named)) < len(named):
        return False
    partial = any(isinstance(s, Call) and s.function == PARTIAL for s in written.sides)
    if (partial and len(named) == 1) or derives(statement):
        return True  # q' = dH/dp says something about H
    return len(named) == len(written.sides) or any(name in own for name, _ in named)
