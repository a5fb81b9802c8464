"""Each term of an equation with its value at a witness state.

L*theta_ddot + 2*g*sin(theta) = 0    ->    L*theta_ddot = -0.958851, 2*g*sin(theta) = 1.91771
"""

from fractions import Fraction

from sympy import Add, Expr, S

from mechanics.claims.from_sympy import Untreeable
from mechanics.claims.spelling import Spelling
from mechanics.claims.statement import Statement
from mechanics.errors import ExpressionError
from mechanics.kernel import Witness
from mechanics.kernel.balls import enclose
from mechanics.program import Builder
from mechanics.program.sympy_reader import read
from mechanics.report.answer.witness import short_value

Values = list[tuple[str, str]]


def term_values(statement: Statement, witness: Witness | None) -> Values:
    """Terms of both sides and their values.

    Parameters
    ----------
    statement : Statement
    witness : Witness or None
        Where the sides of its row differ.

    Returns
    -------
    list of (str, str)
        Terms in the notation of the statement. Nothing for matrices, for sides of one term each,
        whose values the witness has, and where the state does not determine every term.
    """
    sides = statement.row.sides if statement.row and witness else ()
    if not all(isinstance(side, Expr) for side in sides):
        return []
    terms = [term for side in sides for term in Add.make_args(side) if term != S.Zero]
    if not witness or not any(isinstance(side, Add) for side in sides):
        return []
    builder = Builder()
    try:
        program = builder.program({"terms": read(builder, terms)})
    except ExpressionError:
        return []  # what has no formula has no terms
    state = dict((*witness.solved, *witness.state))
    if not all(name in state for name in program.inputs):
        return []
    values = enclose(program, {name: Fraction(state[name]) for name in program.inputs})["terms"]
    return [
        (_spelled(statement, term), short_value(value.str(20)) if value.is_finite() else "no value")
        for term, value in zip(terms, values, strict=True)
    ]


def _spelled(statement: Statement, term: Expr) -> str:
    """A term as the person would write it."""
    if statement.written is None:
        return str(term)
    try:
        return Spelling(statement.written, set())(statement.written.tree(term))
    except Untreeable:
        return str(term)
