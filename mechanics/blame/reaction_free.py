"""Equations without the reactions of constraints, in the speeds that are free.

A u = a    u_tied = T u_free + t        row_free + T^T row_tied: what the constraints do drops out
"""

from collections.abc import Sequence
from itertools import combinations

from sympy import Expr, S, Symbol

from mechanics.blame.pieces import Piece, merged
from mechanics.blame.rows import Row
from mechanics.blame.view import View
from mechanics.scene.rates import rate
from mechanics.symbolic import collect_linear, independent_rows
from mechanics.symbolic.cramer import cramer


def reduced_rows(view: View, tied: tuple[int, ...]) -> tuple[Row, ...]:
    """Equations of the free speeds, with the tied ones put in.

    Parameters
    ----------
    tied : tuple of int
        Indices of speeds that the constraints determine, as `tied_speeds` finds them.
    """
    solution = _solved(view.forms, [view.speeds[i] for i in tied])
    table: dict[Symbol, Expr] = {
        view.speeds[i]: value for i, value in zip(tied, solution, strict=True)
    }
    lifted = {
        view.accelerations[i]: rate(value, view.clock).xreplace(table)
        for i, value in zip(tied, solution, strict=True)
    }
    rows, reduced = view.rows, []
    for i, speed in enumerate(view.speeds):
        if i in tied:
            continue
        weights = [(S.One, rows[i])]
        weights += [(v.diff(speed), rows[k]) for k, v in zip(tied, solution, strict=True)]
        pieces = merged((w, piece) for w, row in weights for piece in row.pieces)
        values = (
            Piece(p.origin, p.value.xreplace(lifted).xreplace(lifted).xreplace(table))
            for p in pieces
        )
        reduced.append(Row(f"equation of {speed.name} with the constraints put in", tuple(values)))
    return tuple(reduced)


def tied_speeds(view: View, wanted: frozenset[Symbol]) -> tuple[int, ...] | None:
    """Indices of speeds that the constraints determine; the wanted ones stay free if they can."""
    forms = view.forms
    pairs = list(zip(view.speeds, view.accelerations, strict=True))
    order = sorted(range(len(pairs)), key=lambda i: (len(wanted & set(pairs[i])), -i))
    for chosen in combinations(order, len(forms)):
        rates = [view.speeds[i] for i in chosen]
        if len(independent_rows([collect_linear(form, rates)[0] for form in forms])) == len(forms):
            return tuple(chosen)
    return None


def _solved(forms: Sequence[Expr], tied: Sequence[Symbol]) -> list[Expr]:
    """The tied speeds in the free ones."""
    numerators, denominator = cramer(forms, tied)
    return [numerator / denominator for numerator in numerators]
