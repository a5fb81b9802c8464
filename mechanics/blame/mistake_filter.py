"""Which statements vanish along the motion of a derivation with a mistake, at a point of a field.

    (u', R) from the wrong rows        factors . (u', R) + rest = 0 ?

A wrong answer has a chance of 2^-40 at most; what is found is proved afterwards.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from sympy import Expr, Symbol

from mechanics.blame.mistakes.fault_model import Fault, Part, split
from mechanics.checks.ledger_compare import project_defined
from mechanics.equations import Equations
from mechanics.errors import ExpressionError
from mechanics.kernel.field import Inadmissible
from mechanics.kinematics.momenta import momenta_written_out
from mechanics.scene.published import Published
from mechanics.symbolic import Arithmetic, Number
from mechanics.symbolic.pivots import pivot_columns
from mechanics.symbolic.point import Point

Motion = dict[Symbol, Number]


@dataclass(frozen=True)
class Stated:
    """A statement along the motion, linear in accelerations and reactions.

    Attributes
    ----------
    index : int
        Of the statement.
    factors : tuple of (Symbol, Expr)
        Of the unknowns that it holds.
    """

    index: int
    row: Published
    residual: Expr
    factors: tuple[tuple[Symbol, Expr], ...]
    rest: Expr
    refuted: bool


def explaining(
    truth: Equations, stated: Sequence[Stated], faults: Iterable[Fault]
) -> list[tuple[Fault, frozenset[int]]]:
    """Mistakes along whose motion statements vanish, and the indices of these."""
    found: list[tuple[Fault, frozenset[int]]] = []
    a = Arithmetic()
    project_defined(a, truth.kinematics)
    try:
        _, point = a.residues(list(a.assigned.values()))
    except Inadmissible:
        return []
    for fault in faults:
        motion = _motion(a, point, truth, fault)
        zero = frozenset(s.index for s in stated if motion and _vanishes(a, point, s, motion))
        if zero:
            found.append((fault, zero))
    return found


def _motion(a: Arithmetic, point: Point, truth: Equations, fault: Fault) -> Motion | None:
    """Accelerations and reactions with the mistake; None where it leaves them undetermined."""
    size = len(fault.unknowns)
    matrix, right = [], []
    for row in fault.rows:
        *factors, rest = _row(a, row, fault.unknowns)
        matrix.append(factors)
        right.append(-rest)
    if fault.held:
        idle = [a.rational(0)] * (size - len(truth.scene.ud))
        for i in range(truth.constraint_matrix.rows):
            matrix.append([*(a.value(entry) for entry in truth.constraint_matrix[i, :]), *idle])
            right.append(a.value(truth.constraint_bias[i]))
    if len(matrix) != size:
        return None
    try:
        residues = [[point.value(entry) for entry in row] for row in matrix]
    except Inadmissible:
        return None
    if len(pivot_columns(residues, point.prime)) < size:
        return None
    return dict(zip(fault.unknowns, a.solve(matrix, right), strict=True))


def _row(a: Arithmetic, row: Sequence[Part], unknowns: tuple[Symbol, ...]) -> list[Number]:
    """Factors of the unknowns in a row, and its rest."""
    total = [a.rational(0)] * (len(unknowns) + 1)
    for count, piece in row:
        factors, rest = split(piece.value, unknowns)
        for i, entry in enumerate((*factors, rest)):
            if entry != 0:
                total[i] = total[i] + a.value(entry) * count
    return total


def _vanishes(a: Arithmetic, point: Point, stated: Stated, motion: Motion) -> bool:
    try:
        return _zero(a, point, stated, motion)
    except (ExpressionError, Inadmissible):
        return False  # it holds what no field knows, such as the imaginary unit


def _zero(a: Arithmetic, point: Point, stated: Stated, motion: Motion) -> bool:
    total = a.value(stated.rest)
    for symbol, factor in stated.factors:
        if symbol not in motion:
            return False
        total = total + a.value(factor) * motion[symbol]
    return point.value(total) == 0


def stated(truth: Equations, index: int, row: Published, residual: Expr, refuted: bool) -> Stated:
    """A statement split into unknowns and rest.

    Raises
    ------
    ExpressionError
        When it is not linear in them.
    TooLarge
        When it outgrows the normal form.
    """
    scene = truth.scene
    unknowns = (*scene.ud, *(reaction.symbol for reaction in scene.reactions))
    residual = momenta_written_out(truth.kinematics, residual)
    factors, rest = split(scene.plain(residual), unknowns)
    held = tuple(pair for pair in zip(unknowns, factors, strict=True) if pair[1] != 0)
    return Stated(index, row, residual, held, rest, refuted)
