"""Copies of typed rows with one sign flipped: of a term, an entry, a relation or a word."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from sympy import Basic, Expr, ImmutableMatrix, sympify
from sympy.core.relational import Relational
from sympy.matrices import MatrixBase

from mechanics.scene.published import Published


def flips(side: Any) -> Iterator[Any]:
    """Copies of a side with one sign flipped."""
    if isinstance(side, str):
        yield {"stable": "unstable", "unstable": "stable"}[side]
    elif isinstance(side, MatrixBase):
        for i, entry in enumerate(side):
            for flipped in flips(entry):
                yield ImmutableMatrix(*side.shape, [*side[:i], flipped, *side[i + 1 :]])
    elif isinstance(side, Relational):
        for left in flips(side.lhs):
            yield side.func(left, side.rhs, evaluate=False)
        for right in flips(side.rhs):
            yield side.func(side.lhs, right, evaluate=False)
        yield side.reversedsign.func(side.lhs, side.rhs, evaluate=False)
    else:
        side = sympify(side)
        if side != 0:
            yield -side
        yield from inner_flips(side)


def inner_flips(expression: Basic) -> Iterator[Expr]:
    """Copies of an expression with one term of one sum in it flipped."""
    for i, part in enumerate(expression.args):
        before, after = expression.args[:i], expression.args[i + 1 :]
        if expression.is_Add:
            yield expression.func(*before, -part, *after)
        for flipped in inner_flips(part):
            yield expression.func(*before, flipped, *after)


def flipped_rows(row: Published) -> Iterator[Published]:
    """Copies of a row with one sign flipped."""
    for i, side in enumerate(row.sides):
        for flipped in flips(side):
            yield replace(row, sides=(*row.sides[:i], flipped, *row.sides[i + 1 :]))
