"""How much a statement may hold so that it is judged again under other conventions and values.

Each try is a decision of its own; of nested functions of sums one takes seconds.
"""

from collections.abc import Sequence

from sympy import Function

from mechanics.claims.statement import Statement

MOST_FUNCTIONS = 64
"""Different sines, roots of names and other functions of all statements together."""


def may_be_tried(statements: Sequence[Statement]) -> bool:
    """Whether statements are judged again under what their author may have meant.

    Parameters
    ----------
    statements : sequence of Statement
    """
    sides = (side for s in statements if s.row is not None for side in s.row.sides)
    return len(set().union(*(side.atoms(Function) for side in sides))) <= MOST_FUNCTIONS
