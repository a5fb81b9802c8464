"""The equations of motion as most people write them: Lagrange's, multiplied out, in short.

d/dt(dL/dq') - dL/dq = Q    ->    sum of coefficient * acceleration = the rest, shortest

They say the same as those that a statement was compared with, which the cross-check proves.
"""

from sympy import Add, Expr, S, Symbol

from mechanics.blame.shape import shortest
from mechanics.blame.terms import terms_of
from mechanics.equations import Equations, Line
from mechanics.routes.derivation import by_route

MOST = 4
"""Speeds up to which they are derived for a page: beyond, nobody compares by eye."""


def lines_of(derived: Equations) -> tuple[str, tuple[Line, ...]]:
    """The route whose rows are shown beside a person's, and its rows.

    Where a scene has constraints, or Lagrange's equations are too long to be read, these are the
    rows that the statements were compared with.
    """
    scene = derived.scene
    if not scene.constraints and len(scene.u) <= MOST:
        own = by_route("lagrange", scene)
        if own.textbook is not None:
            return "lagrange", tuple(
                Line(_left(row.left, scene.ud), _short(row.right), row.label)
                for row in own.result.lines
            )
    return derived.route, derived.result.lines


def _left(side: Expr, accelerations: tuple[Symbol, ...]) -> Expr:
    parts = [_short(side.expand().coeff(one)) * one for one in accelerations]
    return Add(*parts)


def _short(side: Expr) -> Expr:
    (terms,) = terms_of([S(side)])
    return shortest(terms, {})[0]
