"""Which of many candidates can be right: all of them at one point of a field, in one evaluation.

    candidate at the point = what is derived there

The motion is put in once for all candidates. What passes has to be proved; what does not is wrong,
but for a chance of 2^-20.
"""

from collections.abc import Sequence

from sympy import Expr
from sympy.matrices import MatrixBase

from mechanics.checks.ledger_compare import ordered
from mechanics.checks.ledger_energy import SHARES, kinetic_energy, mass_matrix
from mechanics.checks.ledger_motion import put_motion
from mechanics.equations import Equations
from mechanics.errors import ExpressionError
from mechanics.exact import Arithmetic, Number
from mechanics.exact.field_trial import trial
from mechanics.exact.signals import Inadmissible
from mechanics.kinematics.manifold import settle, settle_accelerations
from mechanics.scene import Scene
from mechanics.scene import quantities as q
from mechanics.scene.potential import potential
from mechanics.scene.published import Published

QUICK = -20.0
"""Bound, as a power of two, of the look."""

Pairs = list[tuple[Number, Number]]


def glance(truth: Equations, candidates: Sequence[Sequence[Published]]) -> list[bool]:
    """Whether all rows of each candidate can be right.

    Parameters
    ----------
    truth : Equations
    candidates : sequence of sequence of Published
        With sides in plain symbols.

    Returns
    -------
    list of bool
        True too where the look does not tell: roots, which have two signs, and quantities that only
        the ledger compares.
    """
    possible = [True] * len(candidates)
    for moving in (True, False):
        _look(truth, candidates, possible, moving)
    return possible


def _look(
    truth: Equations, candidates: Sequence[Sequence[Published]], possible: list[bool], moving: bool
) -> None:
    """Rule out candidates by their rows along the motion, or by all others."""
    looked = [
        (k, row)
        for k, rows in enumerate(candidates)
        for row in rows
        if isinstance(row.quantity, q.EquationOfMotion | q.ReactionValue) is moving
    ]
    if not looked:
        return
    wrong: set[int] = set()

    def experiment(a: Arithmetic) -> Pairs:
        wrong.clear()
        settle(truth.scene, a)
        for symbol, expression in ordered(truth.scene.definitions):
            a.assign(symbol, a.value(expression))
        if moving:
            put_motion(a, truth)
        else:
            settle_accelerations(truth.scene, a)
        wrong.update(k for k, row in looked if possible[k] and _differs(a, truth.scene, row))
        return [(a.rational(0), a.rational(0))]

    try:
        trial(experiment, QUICK, None)
    except (ExpressionError, ValueError):
        return  # the full check will say what is wrong
    for k in wrong:
        possible[k] = False


def _differs(a: Arithmetic, scene: Scene, row: Published) -> bool:
    """Whether a row is not right at a point."""
    before = _unsure(a)
    try:
        differences = [left - right for left, right in _pairs(a, scene, row)]
    except (Inadmissible, ExpressionError):
        return False
    # Roots and moduli have a sign, which one point does not tell.
    return _unsure(a) == before and not all(a.is_zero(number) for number in differences)


def _unsure(a: Arithmetic) -> tuple[int, int]:
    return getattr(a, "square_roots", 0), len(getattr(a, "kinks", ()))


def _pairs(a: Arithmetic, scene: Scene, row: Published) -> Pairs:
    """Typed and derived values of a row."""
    first, *others = row.sides
    match row.quantity:
        case q.EquationOfMotion() | q.Identity():
            return [(a.value(first), a.value(side)) for side in others]
        case q.ReactionValue(name=name):
            symbol = scene.reaction(name).symbol
            return [(a.value(side), a.value(symbol)) for side in row.sides]
        case q.KineticEnergy():
            return [(a.value(side), a.value(kinetic_energy(scene))) for side in row.sides]
        case q.PotentialEnergy() | q.TotalEnergy() | q.Lagrangian():
            kinetic, stored = SHARES[type(row.quantity)]
            energy = kinetic * kinetic_energy(scene) + stored * potential(scene)
            return _up_to_a_constant(a, scene, row.sides, energy)
        case q.MassMatrix():
            return [
                (a.value(left), a.value(right))
                for side in row.sides
                if isinstance(side, MatrixBase)
                for left, right in zip(side, mass_matrix(scene), strict=False)
            ]
    return []


def _up_to_a_constant(
    a: Arithmetic, scene: Scene, sides: Sequence[Expr], derived: Expr
) -> list[tuple[Number, Number]]:
    """An energy less what it is at q = u = 0."""
    still = dict.fromkeys((*scene.q, *scene.u), 0)
    above = a.value(derived) - a.value(derived.xreplace(still))
    return [(a.value(side) - a.value(side.xreplace(still)), above) for side in sides]
