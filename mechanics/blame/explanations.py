"""Known mistakes that explain a refuted statement, each proved before it is named.

    statement vanishes along the motion of the derivation with the mistake in it, for all states

A glance at one point of a field sorts out nearly all of them; the proof is that of the ledger.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

from sympy import Expr, Symbol

from mechanics.blame.difference import residual
from mechanics.blame.energies import WrongEnergy, blamed, energy_slip, wrong_energies
from mechanics.blame.folded import folded
from mechanics.blame.mistakes.known import KNOWN
from mechanics.blame.mistakes.slip import Slip, equations, right, split
from mechanics.blame.mistakes.turning import wrong_rows
from mechanics.blame.nearest import nearest
from mechanics.blame.terms import terms_of
from mechanics.checks.ledger import check_row
from mechanics.checks.ledger_compare import ordered
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, MechanicsError
from mechanics.exact import Arithmetic, Finding, Number, SingularHere, TooLarge, Verdict
from mechanics.exact.field_trial import trial
from mechanics.kinematics.manifold import settle
from mechanics.reading.statement import Statement
from mechanics.scene import Scene
from mechanics.scene.published import Published
from mechanics.scene.quantities import EquationOfMotion, ReactionValue

MOST = 3
"""Explanations of one statement; a system of one freedom may have many that say the same."""

QUICK = -40.0


@dataclass(frozen=True)
class Claim:
    """A statement along the motion as a residual, and whether it is refuted."""

    index: int
    row: Published
    residual: Expr
    refuted: bool


def explanations(
    truth: Equations, statements: Sequence[Statement], findings: Sequence[Finding]
) -> tuple[tuple[str, ...], ...]:
    """Known mistakes that were proved to be the reason, for each statement.

    Parameters
    ----------
    truth : Equations
        Derived, with reactions.
    statements : sequence of Statement
    findings : sequence of Finding
        Their verdicts; only what is REFUTED is explained.

    Returns
    -------
    tuple of tuple of str
        For each statement. A mistake that explains all statements at once comes before one that
        explains a single equation.
    """
    found: list[list[str]] = [[] for _ in statements]
    energies = wrong_energies(truth, statements, findings)
    for index, words in blamed(truth, statements, findings, energies).items():
        found[index].append(words)
    claims = _claims(statements, findings)
    for claim in claims:
        if claim.refuted:
            found[claim.index] += _of_one_equation(truth, claim)
    if any(claim.refuted for claim in claims):
        _of_derivation(truth, claims, energies, found)
    return tuple(tuple(dict.fromkeys(words))[:MOST] for words in found)


def _claims(statements: Sequence[Statement], findings: Sequence[Finding]) -> list[Claim]:
    return [
        Claim(index, s.row, residual(s.row), finding.verdict is Verdict.REFUTED)
        for index, (s, finding) in enumerate(zip(statements, findings, strict=True))
        if s.row is not None
        and not s.doubt
        and isinstance(s.row.quantity, EquationOfMotion | ReactionValue)
        and finding.verdict is not Verdict.UNDECIDED
    ]


def _of_one_equation(truth: Equations, claim: Claim) -> list[str]:
    """Mistakes that make a moment equation exactly the one that is written."""
    other, expression = folded(truth, claim.residual)
    scene = other.scene
    moving = {*scene.u, *scene.qd, *scene.ud, *scene.input_symbols}
    try:
        (written,) = terms_of([expression], cleared=True, moving=moving)
        candidates = wrong_rows(scene)
    except (ExpressionError, TooLarge):
        return []
    found = []
    for candidate in candidates:
        near = nearest(written, [candidate], moving, scene.ud)
        if near is not None and not near.different:
            found.append(candidate.words)
    return found


def _of_derivation(
    truth: Equations, claims: list[Claim], energies: list[WrongEnergy], found: list[list[str]]
) -> None:
    """Mistakes of the whole derivation: those first that explain every statement."""
    whole: list[tuple[Slip, list[Claim]]] = []
    single: list[tuple[Slip, list[Claim]]] = []
    for slip, right_ones in _glances(truth, claims, energies):
        refuted = [claim for claim in claims if claim.refuted and claim.index in right_ones]
        if len(right_ones) == len(claims):
            whole.append((slip, refuted))
        elif refuted:
            single.append((slip, refuted))
    for slip, explained in whole or single:
        waiting = [claim for claim in explained if len(found[claim.index]) < MOST]
        if waiting:
            wrong = equations(truth, slip)
            for claim in waiting:
                if _proved(wrong, claim):
                    found[claim.index].append(slip.words)


def _proved(wrong: Equations, claim: Claim) -> bool:
    try:
        return check_row(wrong.scene, claim.row, wrong).shown
    except MechanicsError:
        return False  # what is no statement about the motion with the mistake explains nothing


def _glances(
    truth: Equations, claims: list[Claim], energies: list[WrongEnergy]
) -> list[tuple[Slip, set[int]]]:
    """For each mistake the claims that vanish along its motion, at one point of a field."""
    scene = truth.scene
    known = (*scene.ud, *(reaction.symbol for reaction in scene.reactions))
    linear = [(claim, *parts) for claim in claims if (parts := _linear(scene, claim, known))]
    reactions = any(factor != 0 for _, factors, _ in linear for factor in factors[len(scene.ud) :])
    slips = _slips(scene, reactions)
    if (from_energy := energy_slip(right(scene, reactions), energies)) is not None:
        slips = (from_energy, *slips)
    result: list[tuple[Slip, set[int]]] = []

    def experiment(a: Arithmetic) -> list[tuple[Number, Number]]:
        settle(scene, a)
        for symbol, expression in ordered(scene.definitions):
            a.assign(symbol, a.value(expression))
        result.clear()
        for slip in slips:
            motion = _motion(a, truth, slip)
            if motion is None:
                continue
            zero = {
                claim.index
                for claim, factors, rest in linear
                if _vanishes(a, dict(zip(known, factors, strict=True)), rest, motion)
            }
            if zero:
                result.append((slip, zero))
        return [(a.rational(0), a.rational(0))]

    trial(experiment, QUICK, None)
    return list(result)


@lru_cache(maxsize=16)
def _slips(scene: Scene, with_reactions: bool) -> tuple[Slip, ...]:
    """Every known mistake that this scene lets one make."""
    derivation = right(scene, with_reactions)
    return tuple(slip for known in KNOWN for slip in known(derivation))


def _linear(
    scene: Scene, claim: Claim, known: tuple[Symbol, ...]
) -> tuple[tuple[Expr, ...], Expr] | None:
    """A statement split into factors of the unknowns and a rest; None where it is not linear."""
    try:
        return split(scene.plain(claim.residual), known)
    except (ExpressionError, TooLarge):
        return None


def _motion(a: Arithmetic, truth: Equations, slip: Slip) -> dict[Symbol, Number] | None:
    """Accelerations and reactions with the mistake in the derivation; None where there are none."""
    matrix, right_side = [], []
    for row in slip.rows:
        parts = [split(piece.value, slip.unknowns) for piece in row]
        matrix.append([
            _sum(a, [factors[i] for factors, _ in parts]) for i in range(len(slip.unknowns))
        ])  # fmt: skip
        right_side.append(-_sum(a, [rest for _, rest in parts]))
    if slip.held:
        others = len(slip.unknowns) - len(truth.scene.ud)
        for i in range(truth.constraint_matrix.rows):
            entries = [a.value(entry) for entry in truth.constraint_matrix[i, :]]
            matrix.append([*entries, *(a.rational(0) for _ in range(others))])
            right_side.append(a.value(truth.constraint_bias[i]))
    if any(len(row) != len(matrix) for row in matrix):
        return None
    try:
        numbers = a.solve(matrix, right_side)
    except SingularHere:
        return None
    return dict(zip(slip.unknowns, numbers, strict=True))


def _sum(a: Arithmetic, entries: Sequence[Expr]) -> Number:
    total = a.rational(0)
    for entry in entries:
        if entry != 0:
            total = total + a.value(entry)
    return total


def _vanishes(
    a: Arithmetic, factors: dict[Symbol, Expr], rest: Expr, motion: dict[Symbol, Number]
) -> bool:
    """Whether a statement, linear in the unknowns, is zero along a motion."""
    total = a.value(rest)
    for symbol, factor in factors.items():
        if factor != 0:
            if symbol not in motion:
                return False
            total = total + a.value(factor) * motion[symbol]
    return a.is_zero(total)
