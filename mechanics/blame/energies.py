"""Energies against equations: which of the two is wrong, and by how much they disagree.

rows of Lagrange from an energy - right rows = d/dt(dD/dq') - dD/dq,    D = written L - right L
rate of energy = power of the loads                                     along the motion
"""

from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Add, Expr, S

from mechanics.blame.derivation import Derivation
from mechanics.blame.entries import SIGNS
from mechanics.blame.mistakes.fault_model import Fault, Right
from mechanics.blame.motion import keeps
from mechanics.blame.pieces import Kind, Origin, Piece
from mechanics.blame.reference import Reference
from mechanics.blame.shape import shortest
from mechanics.blame.terms import terms_of
from mechanics.claims.statement import Statement
from mechanics.kernel import Finding, Verdict
from mechanics.kinematics.momenta import momenta_written_out
from mechanics.scene import Scene
from mechanics.scene.published import Published
from mechanics.scene.quantities import EquationOfMotion
from mechanics.scene.rates import coordinate_rate_table, rate, speeds_in_rates


@dataclass(frozen=True)
class WrongEnergy:
    """A refuted energy.

    Attributes
    ----------
    index : int
        Of its statement.
    kinetic, potential : Expr
        How much of each is too much, in the scene's symbols.
    mixed : bool
        Whether it is an energy of both kinds.
    """

    index: int
    row: Published
    kinetic: Expr
    potential: Expr
    mixed: bool = False


def wrong_energies(
    derivation: Derivation, statements: Sequence[Statement], findings: Sequence[Finding]
) -> list[WrongEnergy]:
    """The refuted energies among statements, and how far they are off."""
    found = []
    for index, (statement, finding) in enumerate(zip(statements, findings, strict=True)):
        row = statement.row
        if row is None or finding.verdict is not Verdict.REFUTED or type(row.quantity) not in SIGNS:
            continue
        side = momenta_written_out(derivation.truth.kinematics, row.sides[-1])
        found.append(_off(derivation, index, row, side))
    return found


def _off(derivation: Derivation, index: int, row: Published, side: Expr) -> WrongEnergy:
    """What is too much: of an energy of both kinds, terms with speeds are kinetic."""
    scene, (kinetic, potential) = derivation.scene, SIGNS[type(row.quantity)]
    right = kinetic * Add(*(piece.value for piece in derivation.kinetic))
    right += potential * Add(*(piece.value for piece in derivation.potential))
    excess = side - right
    still = dict.fromkeys((*scene.u, *scene.qd), S.Zero)
    resting = excess.xreplace(still) if potential else S.Zero
    mixed = bool(kinetic and potential)
    return WrongEnergy(index, row, excess - resting, resting * (potential or 1), mixed)


def wrong_rows(scene: Scene, energies: Sequence[WrongEnergy]) -> tuple[Expr, ...]:
    """By how much Lagrange's equations from these energies differ, one for each coordinate."""
    total = Add(*(energy.kinetic - energy.potential for energy in energies))
    total = total.xreplace(speeds_in_rates(scene))
    clock = coordinate_rate_table(scene)
    rows = [
        rate(total.diff(qd), clock) - total.diff(q) for q, qd in zip(scene.q, scene.qd, strict=True)
    ]
    return tuple(scene.plain(row) for row in rows)


def energy_fault(right: Right, energies: Sequence[WrongEnergy]) -> Fault | None:
    """The derivation from the energies as they are written; None where reactions are asked for."""
    if right.free or not energies:
        return None
    scene = right.scene
    # What T and V have too much, T + V and L have too.
    pure = [energy for energy in energies if not energy.mixed]
    extra = wrong_rows(scene, pure or energies[:1])
    origin = Origin(Kind.LINEAR, "the energy as it is written")
    rows = []
    for u, row in zip(scene.u, right.rows, strict=True):
        weights = [scene.coordinate_rates[qd].diff(u) for qd in scene.qd]
        added = Add(*(w * value for w, value in zip(weights, extra, strict=True)))
        rows.append((*row, (S.One, Piece(origin, added))))
    words = "it follows from the energy as it is written, which is wrong"
    return Fault(words, tuple(rows), right.unknowns)


def blamed(
    reference: Reference,
    statements: Sequence[Statement],
    findings: Sequence[Finding],
    energies: Sequence[WrongEnergy],
) -> dict[int, str]:
    """What each wrong energy means for the equations beside it, by the index of its statement."""
    own = [
        finding
        for statement, finding in zip(statements, findings, strict=True)
        if statement.row is not None and isinstance(statement.row.quantity, EquationOfMotion)
    ]
    fine = bool(own) and all(finding.shown for finding in own)
    found = {}
    for energy in energies:
        words = "the equations are right, this energy is not: " if fine else ""
        rows = ", ".join(str(entry) for entry in _shown(reference, energy))
        words += f"derived from it, the equations would differ by ({rows})"
        if not keeps(reference.truth, energy.kinetic + energy.potential):
            words += "; along the motion its rate is not the power of the loads"
        found[energy.index] = words
    return found


def _shown(reference: Reference, energy: WrongEnergy) -> list[Expr]:
    """The rows in the symbols of the statement, written out and shortest."""
    plain = momenta_written_out(reference.truth.kinematics, energy.row.sides[-1])
    other, side = reference.folded(plain)
    off = _off(other.derivation, energy.index, energy.row, side)
    return [shortest(terms, {})[0] for terms in terms_of(wrong_rows(other.truth.scene, [off]))]
