"""How much of a motion a person's equations determine.

rank of d(lhs - rhs)/du' beside the constraints  -  rank of the constraints    of    their freedoms
"""

from collections.abc import Sequence
from functools import partial

from sympy import Matrix

from mechanics.checks.ledger_motion import gradient
from mechanics.checks.manifold import project
from mechanics.equations import Equations
from mechanics.kernel.field import Inadmissible
from mechanics.kinematics.momenta import momenta_written_out
from mechanics.report.answer.judged import Judged
from mechanics.scene.quantities import EquationOfMotion
from mechanics.symbolic import generic_rank


def redundancy(truth: Equations, judged: Sequence[Judged]) -> str:
    """A remark where equations of motion that are shown say the same twice; empty otherwise.

    Fewer equations than freedoms are partial input, which is fine.
    """
    scene = truth.scene
    rows = [
        entry.statement.row
        for entry in judged
        if entry.finding.shown
        and entry.statement.row is not None
        and isinstance(entry.statement.row.quantity, EquationOfMotion)
    ]
    if len(rows) < 2:
        return ""
    written = partial(momenta_written_out, truth.kinematics)
    sides = [[scene.plain(written(s), r.tag) for s in r.sides[:2]] for r in rows]
    left = Matrix([gradient(scene, pair) for pair in sides])
    constraints = truth.constraint_matrix
    both = left.col_join(constraints) if constraints.rows else left
    prepare = partial(project, kinematics=truth.kinematics)
    try:
        held = generic_rank(constraints.tolist(), prepare)
        rank = generic_rank(both.tolist(), prepare) - held
    except Inadmissible:
        return ""  # no state to look at: each equation has its verdict all the same
    if rank == len(rows):
        return ""
    return (
        f"{len(rows)} equations of motion, but together they say no more than {rank} of"
        f" {len(scene.ud) - held}: the others follow from these"
    )
