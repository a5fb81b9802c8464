"""The rate of an energy against the power of the loads, along a motion.

d(T + V)/dt - power = sum_r u_r row_r        of Lagrange's equations; zero along the true motion
"""

from collections.abc import Sequence

from sympy import Expr, S

from mechanics.blame.derivation import Derivation
from mechanics.blame.entries import SIGNS
from mechanics.blame.mistake_filter import Stated
from mechanics.blame.motion import QUICK
from mechanics.checks.ledger_compare import project_defined
from mechanics.claims.statement import Statement
from mechanics.kernel import Finding
from mechanics.kernel.trial import Answer
from mechanics.scene.actions import frictions
from mechanics.symbolic import Arithmetic, Number, canonical
from mechanics.symbolic.decide import answer


def unbalanced(
    derivation: Derivation,
    statements: Sequence[Statement],
    findings: Sequence[Finding],
    along: Sequence[Stated],
) -> bool:
    """Whether a right energy stands beside equations along which it does not change as it should.

    d(T + V)/dt - power = sum_r u_r row_r at the accelerations that the equations give; they have to
    be as many as the speeds, in a scene without constraints and prescribed motions.
    """
    scene = derivation.scene
    energy = any(
        finding.shown and s.row is not None and type(s.row.quantity) in SIGNS
        for s, finding in zip(statements, findings, strict=True)
    )
    rows = [one for one in along if all(symbol in scene.ud for symbol, _ in one.factors)]
    if not energy or scene.constraints or len(rows) != len(scene.u) or frictions(scene):
        return False
    if any(not form.is_zero for form in _drift(derivation)):
        return False

    def experiment(a: Arithmetic) -> list[tuple[Number, Number]]:
        project_defined(a, derivation.truth.kinematics)
        matrix = [
            [a.value(dict(row.factors).get(symbol, S.Zero)) for symbol in scene.ud] for row in rows
        ]
        accelerations = a.solve(matrix, [-a.value(row.rest) for row in rows])
        for symbol, number in zip(scene.ud, accelerations, strict=True):
            a.assign(symbol, number)
        growth = a.rational(0)
        for u, row in zip(scene.u, derivation.generalized_rows, strict=True):
            growth = growth + a.value(u) * a.value(row.value)
        return [(growth, a.rational(0))]

    return answer(experiment, QUICK) is Answer.NONZERO


def _drift(derivation: Derivation) -> list[Expr]:
    """Velocities of the mass centres and bodies at rest: of what is moved by hand."""
    still = dict.fromkeys(derivation.scene.u, S.Zero)
    motions = derivation.bodies.values()
    columns = [m.centre.velocity for m in motions] + [m.angular_velocity for m in motions]
    return [canonical(entry.xreplace(still)) for column in columns for entry in column]
