"""The rate of an energy against the power of the loads, along a motion.

d(T + V)/dt - power = sum_r u_r row_r        of Lagrange's equations; zero along the true motion
"""

from collections.abc import Sequence

from sympy import Expr, S

from mechanics.blame.entries import SIGNS
from mechanics.blame.glance import Stated
from mechanics.blame.origin import QUICK
from mechanics.blame.pieces import motions_of
from mechanics.blame.rows import generalized_rows
from mechanics.checks.ledger_compare import project_defined
from mechanics.checks.ledger_motion import put_motion
from mechanics.equations import Equations
from mechanics.kernel import Finding
from mechanics.kernel.trial import Answer
from mechanics.reading.statement import Statement
from mechanics.scene import Scene
from mechanics.scene.actions import frictions
from mechanics.scene.rates import rate, rate_table
from mechanics.symbolic import Arithmetic, Number, canonical
from mechanics.symbolic.decide import answer


def keeps(truth: Equations, value: Expr) -> bool:
    """Whether an expression keeps its value along the motion, at a point of a field."""
    growth = rate(value, rate_table(truth.scene))

    def experiment(a: Arithmetic) -> list[tuple[Number, Number]]:
        project_defined(truth.kinematics.manifold, a)
        put_motion(a, truth)
        return [(a.value(growth), a.rational(0))]

    return answer(experiment, QUICK) is Answer.ZERO


def unbalanced(
    truth: Equations,
    statements: Sequence[Statement],
    findings: Sequence[Finding],
    along: Sequence[Stated],
) -> bool:
    """Whether a right energy stands beside equations along which it does not change as it should.

    d(T + V)/dt - power = sum_r u_r row_r at the accelerations that the equations give; they have to
    be as many as the speeds, in a scene without constraints and prescribed motions.
    """
    scene = truth.scene
    energy = any(
        finding.shown and s.row is not None and type(s.row.quantity) in SIGNS
        for s, finding in zip(statements, findings, strict=True)
    )
    rows = [one for one in along if all(symbol in scene.ud for symbol, _ in one.factors)]
    if not energy or scene.constraints or len(rows) != len(scene.u) or frictions(scene):
        return False
    if any(not form.is_zero for form in _drift(scene)):
        return False
    own = generalized_rows(scene)

    def experiment(a: Arithmetic) -> list[tuple[Number, Number]]:
        project_defined(truth.kinematics.manifold, a)
        matrix = [
            [a.value(dict(row.factors).get(symbol, S.Zero)) for symbol in scene.ud] for row in rows
        ]
        found = a.solve(matrix, [-a.value(row.rest) for row in rows])
        for symbol, number in zip(scene.ud, found, strict=True):
            a.assign(symbol, number)
        growth = a.rational(0)
        for u, row in zip(scene.u, own, strict=True):
            growth = growth + a.value(u) * a.value(row.value)
        return [(growth, a.rational(0))]

    return answer(experiment, QUICK) is Answer.NONZERO


def _drift(scene: Scene) -> list[Expr]:
    """Velocities of the mass centres and bodies at rest: of what is moved by hand."""
    still = dict.fromkeys(scene.u, S.Zero)
    motions = motions_of(scene).bodies.values()
    columns = [m.centre.velocity for m in motions] + [m.angular_velocity for m in motions]
    return [canonical(entry.xreplace(still)) for column in columns for entry in column]
