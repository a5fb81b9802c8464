"""What holds along the motion, for all states.

u' and the reactions as the derived equations give,    value = 0 at a point of a field ?
"""

from sympy import Expr

from mechanics.checks.ledger_compare import project_defined
from mechanics.checks.ledger_motion import put_motion
from mechanics.equations import Equations
from mechanics.kernel.trial import Answer
from mechanics.scene.rates import rate, rate_table
from mechanics.symbolic import Arithmetic, Number
from mechanics.symbolic.decide import answer

QUICK = 2.0**-40
"""Bound of the chance that a claim is wrong."""


def holds(truth: Equations, right: Expr) -> bool:
    """Whether an equation vanishes along the motion, at a point of a field."""
    value = truth.scene.plain(right)

    def experiment(a: Arithmetic) -> list[tuple[Number, Number]]:
        project_defined(a, truth.kinematics)
        put_motion(a, truth)
        return [(a.value(value), a.rational(0))]

    return answer(experiment, QUICK) is Answer.ZERO


def keeps(truth: Equations, value: Expr) -> bool:
    """Whether an expression keeps its value along the motion, at a point of a field."""
    return holds(truth, rate(value, rate_table(truth.scene)))
