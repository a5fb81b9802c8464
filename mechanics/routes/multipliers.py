"""Elimination of the reactions, from the leaves of the tree of bodies to its root.

A row reads  ``value = sum_j c_j R_j``  with value = rate - applied. For each reaction at the
inboard joint of a body one of the body's rows is solved for it, and the solution is put into every
other row that holds it:

    row_i <- row_i - (c_i / c_p) row_p                       c_p a number
    row_i <- c_p row_i - c_i row_p                           otherwise: nothing is divided by c_p

A reaction that closes a loop of bodies belongs to no joint of the tree (ropes over one pulley, the
teeth of two wheels): those are solved for last, from whatever rows are left. Here rows are SymPy's,
for reports and for what blame looks at; routes eliminate in `mechanics.routes`.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Add, Expr, Matrix, Mul, S, Symbol

from mechanics.equations import Equations
from mechanics.errors import SingularError
from mechanics.symbolic import tidy


@dataclass
class Row:
    """A row while it is worked on: value = sum of coefficients times reactions."""

    body: str
    value: Expr
    coefficients: dict[Symbol, Expr]


@dataclass(frozen=True)
class Solved:
    """A reaction solved from a row of a body: R = (value - sum of the others) / pivot."""

    reaction: Symbol
    body: str
    pivot: Expr
    row: Row

    @property
    def value(self) -> Expr:
        """The reaction in the accelerations and the reactions that were not solved for before."""
        others = (
            -c * symbol for symbol, c in self.row.coefficients.items() if symbol != self.reaction
        )
        return Add(self.row.value, *others) / self.pivot


def solve_for(work: list[Row], reactions: Sequence[Symbol], body: str = "") -> list[Solved]:
    """Solve rows for reactions and put the solutions into the other rows, in place.

    Raises
    ------
    SingularError
        When no row determines a reaction.
    """
    waiting, solved = list(reactions), []
    while waiting:
        reaction, pivot = _pivot(work, body, waiting)
        waiting.remove(reaction)
        work.remove(pivot)
        solved.append(Solved(reaction, pivot.body, pivot.coefficients[reaction], pivot))
        for row in work:
            if reaction in row.coefficients:
                _subtract(row, pivot, reaction)
    return solved


def _pivot(work: Sequence[Row], body: str, waiting: Sequence[Symbol]) -> tuple[Symbol, Row]:
    """The reaction and row with the simplest coefficient, rows of the body itself first."""
    candidates = [
        (not row.coefficients[reaction].is_number, row.body != body, index, reaction, row)
        for reaction in waiting
        for index, row in enumerate(work)
        if row.coefficients.get(reaction, S.Zero) != 0
    ]
    if not candidates:
        raise SingularError(
            f"reactions {', '.join(map(str, waiting))}: no momentum equation determines them: are"
            " they redundant? A loop may need more coordinates, and holonomic(...) constraints that"
            " name them"
        )
    *_, reaction, row = min(candidates, key=lambda entry: entry[:3])
    return reaction, row


def _subtract(row: Row, pivot: Row, reaction: Symbol) -> None:
    own, divisor = row.coefficients.pop(reaction), pivot.coefficients[reaction]
    if divisor.is_number:
        scale, factor = S.One, own / divisor
    else:
        scale, factor = divisor, own
    row.value = Add(Mul(scale, row.value), Mul(-factor, pivot.value))
    merged = {symbol: scale * value for symbol, value in row.coefficients.items()}
    for symbol, value in pivot.coefficients.items():
        if symbol != reaction:
            merged[symbol] = merged.get(symbol, S.Zero) - factor * value
    tidied = {symbol: tidy(value) for symbol, value in merged.items()}
    row.coefficients = {symbol: value for symbol, value in tidied.items() if value != 0}


def multipliers_of(equations: Equations) -> tuple[tuple[Symbol, Expr], ...]:
    """The reactions that maintain the constraints, in u' and those of them that stand before.

    As many rows of M u' - f = B lambda are solved for them, the shortest first.

    Raises
    ------
    SingularError
        When the rows do not determine them.
    """
    rates = list(equations.mass * Matrix(equations.scene.ud) - equations.forcing)
    rows = []
    for i, rate in sorted(enumerate(rates), key=lambda entry: int(entry[1].count_ops())):
        held = zip(equations.multipliers, equations.reaction_matrix[i, :], strict=True)
        rows.append(Row("", rate, {symbol: factor for symbol, factor in held if factor != 0}))
    solved = solve_for(rows, equations.multipliers)
    return tuple((step.reaction, step.value) for step in reversed(solved))
