"""Elimination of reactions from rows that are linear in them.

row:    value = sum_j c_j R_j
row_i <- row_i - (c_i / c_p) row_p                       c_p a number
row_i <- c_p row_i - c_i row_p                           otherwise: nothing is divided by c_p
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

from mechanics.errors import SingularError
from mechanics.program.builder import Node
from mechanics.program.residues import Residues
from mechanics.routes.rows import coefficients, remainder


@dataclass
class Row:
    """A row while it is worked on: value = sum of coefficients times reactions.

    `place` is where it stood before the elimination.
    """

    body: int
    value: Node
    coefficients: dict[int, Node]
    place: int = -1


@dataclass(frozen=True)
class Solved:
    """A reaction solved from a row: R = (value - sum of the others) / pivot."""

    reaction: int
    row: Row


@dataclass
class Elimination:
    """Rows that are left, and how each reaction was solved for.

    `anywhere` proposes what is zero at all states, `closed` what is where the constraints hold.
    """

    anywhere: Residues
    closed: Residues
    work: list[Row]
    solved: list[Solved] = field(default_factory=list)

    def solve_for(self, reactions: Sequence[int], body: int | None, names: Sequence[str]) -> None:
        """Solve rows for reactions, rows of the body itself first.

        Raises
        ------
        SingularError
            When no row determines a reaction.
        """
        waiting = list(reactions)
        while waiting:
            candidates = [
                (row.coefficients[reaction].constant is None, row.body != body, index, reaction)
                for reaction in waiting
                for index, row in enumerate(self.work)
                if reaction in row.coefficients
                and not self.closed.is_zero(row.coefficients[reaction])
            ]
            if not candidates:
                raise SingularError(
                    f"reactions {', '.join(names[r] for r in waiting)}: no momentum equation"
                    " determines them: are they redundant? A loop may need more coordinates, and"
                    " holonomic(...) constraints that name them"
                )
            _, _, index, reaction = min(candidates)
            waiting.remove(reaction)
            pivot = self.work.pop(index)
            self.solved.append(Solved(reaction, pivot))
            for row in self.work:
                if reaction in row.coefficients:
                    self._subtract(row, pivot, reaction)

    def _subtract(self, row: Row, pivot: Row, reaction: int) -> None:
        own, divisor = row.coefficients.pop(reaction), pivot.coefficients[reaction]
        number = divisor.constant
        keep, factor = (1, own / number) if number is not None else (divisor, own)
        row.value = row.value * keep - factor * pivot.value
        merged = {r: c * keep for r, c in row.coefficients.items()}
        for r, c in pivot.coefficients.items():
            if r != reaction:
                merged[r] = merged[r] - factor * c if r in merged else -(factor * c)
        row.coefficients = nonzero(self.anywhere, merged)

    def reactions(self, unknown: dict[int, Node]) -> dict[int, Node]:
        """Each reaction in u' and the unknowns that stay: the last solved holds no other."""
        values = dict(unknown)
        for step in reversed(self.solved):
            total = step.row.value
            for reaction, coefficient in step.row.coefficients.items():
                if reaction != step.reaction:
                    total = total - coefficient * values[reaction]
            values[step.reaction] = total / step.row.coefficients[step.reaction]
        return values


OPENED = -2
"""Stands for the body of a row that lets a joint open."""


def without_pressing(
    filters: tuple[Residues, Residues],
    rows: Sequence[Node],
    opened: Sequence[Node],
    pressing: dict[int, Node],
    names: Sequence[str],
) -> tuple[tuple[Node, ...], dict[int, Node]]:
    """Rows free of the reactions that friction depends on, and these reactions.

    Parameters
    ----------
    filters : pair of Residues
        For what is zero at all states, and for what is where the constraints hold.
    rows : sequence of Node
        Projected on the speeds: a pressing reaction enters them by its friction only, and a pivot
        there would vanish where nothing slides.
    opened : sequence of Node
        A row for each pressing reaction, of the motion that opens its joint.
    pressing : dict of int to Node
        The reactions, as inputs.
    names : sequence of str
        Of all reactions.

    Raises
    ------
    SingularError
        When no row determines a reaction.
    """
    if not pressing:
        return tuple(rows), {}
    unknowns = tuple(pressing.values())
    every = [*rows, *opened]
    anywhere, closed = filters
    rests = remainder(anywhere.builder, every, unknowns)
    work = []
    for i, (rest, held) in enumerate(zip(rests, coefficients(every, unknowns), strict=True)):
        signed = {index: -c for index, c in zip(pressing, held, strict=True)}
        work.append(Row(OPENED if i >= len(rows) else 0, rest, nonzero(anywhere, signed)))
    elimination = Elimination(anywhere, closed, work)
    elimination.solve_for(list(pressing), OPENED, names)
    return tuple(row.value for row in elimination.work), elimination.reactions({})


def nonzero(filter_: Residues, coefficients: dict[int, Node]) -> dict[int, Node]:
    """Coefficients without those that vanish."""
    tidy = {reaction: filter_.tidy(c) for reaction, c in coefficients.items()}
    return {reaction: c for reaction, c in tidy.items() if not c.is_zero}
