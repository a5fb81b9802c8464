"""Known mistakes that explain a refuted statement, each proved before it is named.

    statement vanishes along the motion of the derivation with the mistake in it, for all states

One point of a field sorts out nearly all of them; the proof is that of the ledger.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from mechanics.blame.difference import residual
from mechanics.blame.energies import WrongEnergy, blamed, energy_fault, wrong_energies
from mechanics.blame.mistake_filter import Stated, explaining, stated
from mechanics.blame.mistakes import loads
from mechanics.blame.mistakes.fault_model import Fault, Right, equations
from mechanics.blame.nearest import nearest
from mechanics.blame.power import unbalanced
from mechanics.blame.reference import Reference
from mechanics.blame.terms import terms_of
from mechanics.checks.ledger import check_row
from mechanics.claims.statement import Statement
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, MechanicsError
from mechanics.kernel import Finding, Verdict
from mechanics.kernel.ring import TooLarge
from mechanics.scene.quantities import EquationOfMotion, ReactionValue

MOST = 3
"""Explanations of one statement; a system of one freedom may have many that say the same."""

LARGEST_PAIRED = 5
"""Number of speeds up to which two mistakes at once are tried."""

UNBALANCED = (
    "the energy beside them is right: along the equations as written its rate is not the power of"
    " the loads"
)


def explanations(
    reference: Reference, statements: Sequence[Statement], findings: Sequence[Finding]
) -> tuple[tuple[str, ...], ...]:
    """Known mistakes that were proved to be the reason, for each statement.

    Parameters
    ----------
    findings : sequence of Finding
        Their verdicts; only what is REFUTED is explained.

    Returns
    -------
    tuple of tuple of str
        For each statement. Mistakes of a derivation that explain all statements at once are
        preferred to those that explain a single equation; two at once are tried where no single
        one explains all.
    """
    truth = reference.truth
    found: list[list[str]] = [[] for _ in statements]
    energies = wrong_energies(reference.derivation, statements, findings)
    for index, words in blamed(reference, statements, findings, energies).items():
        found[index].append(words)
    along = list(_along(truth, statements, findings))
    refuted = [one for one in along if one.refuted]
    for one in refuted:
        found[one.index] += _of_one_equation(reference, one)
    if refuted:
        for fault, indices in _of_derivation(reference, along, energies):
            waiting = [s for s in refuted if s.index in indices and len(found[s.index]) < MOST]
            wrong = equations(truth, fault) if waiting else truth
            for one in waiting:
                if _proved(wrong, one):
                    found[one.index].append(fault.words)
        if unbalanced(reference.derivation, statements, findings, along):
            for one in refuted:
                found[one.index].append(UNBALANCED)
    return tuple(tuple(dict.fromkeys(words)) for words in found)


def _along(
    truth: Equations, statements: Sequence[Statement], findings: Sequence[Finding]
) -> Iterator[Stated]:
    """What is stated along the motion."""
    for index, (s, finding) in enumerate(zip(statements, findings, strict=True)):
        if s.row is None or finding.verdict is Verdict.UNDECIDED:
            continue
        if isinstance(s.row.quantity, EquationOfMotion | ReactionValue):
            try:
                yield stated(
                    truth, index, s.row, residual(s.row), finding.verdict is Verdict.REFUTED
                )
            except (ExpressionError, TooLarge):
                continue  # not linear in the accelerations: no derivation gives such an equation


def _of_one_equation(reference: Reference, one: Stated) -> list[str]:
    """Mistakes that make a moment equation exactly the one that is written."""
    other, expression = reference.folded(one.residual)
    scene = other.truth.scene
    moving = {*scene.u, *scene.qd, *scene.ud, *scene.input_symbols}
    try:
        (written,) = terms_of([expression], cleared=True, moving=moving)
        candidates = other.wrong_moments
    except (ExpressionError, TooLarge):
        return []
    found = []
    for candidate in candidates:
        near = next(iter(nearest(written, [candidate], moving, scene.ud)), None)
        if near is not None and not near.different:
            found.append(candidate.words)
    return found


def _of_derivation(
    reference: Reference, along: Sequence[Stated], energies: Sequence[WrongEnergy]
) -> list[tuple[Fault, frozenset[int]]]:
    """Mistakes of the whole derivation with what they explain: all statements, or else some."""
    truth, scene = reference.truth, reference.truth.scene
    reactions = {reaction.symbol for reaction in scene.reactions}
    asked = any(symbol in reactions for one in along for symbol, _ in one.factors)
    mistakes = reference.mistakes_of_free_bodies if asked else reference.mistakes
    faults = mistakes.faults
    if (from_energy := energy_fault(mistakes.right, energies)) is not None:
        faults = (from_energy, *faults)
    single = explaining(truth, along, faults)
    whole = [pair for pair in single if len(pair[1]) == len(along)]
    if not whole and len(scene.u) <= LARGEST_PAIRED:
        double = explaining(truth, along, _pairs(mistakes.right, faults))
        whole = [pair for pair in double if len(pair[1]) == len(along)]
    return whole or single


def _pairs(right: Right, faults: Sequence[Fault]) -> Iterator[Fault]:
    """A mistake of another kind, and one of a load besides."""
    own = {fault.words for fault in loads.faults(right)}
    for fault in faults:
        if fault.words not in own:
            wrong = replace(right, rows=fault.rows)
            for more in loads.faults(wrong):
                yield replace(fault, words=f"{fault.words}; {more.words}", rows=more.rows)


def _proved(wrong: Equations, one: Stated) -> bool:
    try:
        return check_row(wrong.scene, one.row, wrong).shown
    except MechanicsError:
        return False  # what is no statement along the wrong motion explains nothing
