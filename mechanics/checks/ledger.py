"""The ledger: every published row against the quantity that it is about, as the engine derives it.

    typed side  =  derived side        (never typed = typed)

A row that holds only when the scene's definitions (I_C for what the shapes give) are expanded is
proved too; its evidence says so. A rounded number stands for all that round to it.
"""

from collections.abc import Sequence

from sympy import Expr, Float, Matrix
from sympy.matrices import MatrixBase

from mechanics.checks.ledger_compare import equal, rounded
from mechanics.checks.ledger_energy import ENERGIES, check_energy
from mechanics.checks.ledger_momenta import DERIVED, VECTORS, derived
from mechanics.checks.ledger_motion import check_equation, check_reaction
from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.kernel import Finding
from mechanics.kinematics.momenta import momenta_written_out
from mechanics.kinematics.symbolic import Kinematics
from mechanics.scene import Scene
from mechanics.scene.published import Published, Quantity
from mechanics.scene.quantities import EquationOfMotion, Identity, ReactionValue
from mechanics.scene.symbols import entries

QUANTITIES: tuple[type[Quantity], ...] = (
    *VECTORS, *DERIVED, *ENERGIES, EquationOfMotion, ReactionValue, Identity,
)  # fmt: skip
"""What this ledger can check; rows about other quantities belong to other checks."""


def check_row(
    scene: Scene, row: Published, equations: Equations | None = None, where: Sequence[Expr] = ()
) -> Finding:
    """Compare every typed side of a row with the quantity that the row is about.

    Parameters
    ----------
    equations : Equations, optional
        Of one route; needed by rows about equations of motion and reactions along the motion.
    where : sequence of Expr
        What is positive at all states that are looked at, in coordinates and parameters; for rows
        about equations of motion, reactions and identities.

    Returns
    -------
    Finding
        REFUTED with a witness where one side differs from what is derived.

    Raises
    ------
    InputError
        When the row is about a quantity of another check, has too few sides, or needs equations.
    SceneError
        When a side holds a function of time that the scene does not have.
    """
    subject = f"{row.tag} {row.label}"
    own = equations is not None and equations.scene is scene
    kinematics = equations.kinematics if equations is not None and own else Kinematics(scene)
    sides = [plain_side(kinematics, side, subject) for side in row.sides]
    quantity = row.quantity
    if isinstance(quantity, EquationOfMotion | ReactionValue):
        if equations is None:
            raise InputError(f"{subject}: it holds along the motion: pass equations=")
        if not own:
            raise InputError(
                f"{subject}: the equations belong to another scene, {equations.scene.name}: pass"
                " those of this one"
            )
        if isinstance(quantity, ReactionValue):
            return check_reaction(
                subject, quantity.name, _enough(sides, 1, subject), equations, where
            )
        return check_equation(subject, _enough(sides, 2, subject), equations, where)
    if isinstance(quantity, Identity):
        first, *others = _enough(sides, 2, subject)
        ones = [entry for _ in others for entry in entries(first)]
        rights = [entry for side in others for entry in entries(side)]
        return equal(kinematics, subject, ones, rights, where)
    if where:
        raise InputError(f"{subject}: it is judged at all states: leave out where= for it")
    if isinstance(quantity, ENERGIES):
        return check_energy(kinematics, quantity, sides, subject)
    targets = derived(kinematics, quantity)
    _enough(sides, len(targets), subject)
    # The last target is what every further side has to be.
    pairs = [(side, targets[min(i, len(targets) - 1)]) for i, side in enumerate(sides)]
    lefts = [entry for typed, _ in pairs for entry in entries(typed)]
    rights = [entry for _, target in pairs for entry in entries(target)]
    if len(lefts) != len(rights):
        raise InputError(
            f"{subject}: {len(lefts)} entries typed for {len(rights)} derived: name the axis with"
            " along=, or type a 3 x 1 matrix"
        )
    if any(left.has(Float) for left in lefts):
        (left,), (right,) = lefts, rights
        return rounded(kinematics, subject, left, right)
    return equal(kinematics, subject, lefts, rights)


def plain_side(kinematics: Kinematics, side: Expr | MatrixBase, where: str) -> Expr | Matrix:
    """A typed side in plain symbols, vectors entry by entry, generalized momenta written out."""
    if isinstance(side, MatrixBase):
        return Matrix(side).applyfunc(lambda entry: plain_side(kinematics, entry, where))
    return kinematics.scene.plain(momenta_written_out(kinematics, side), where)


def _enough(sides: list[Expr], needed: int, subject: str) -> list[Expr]:
    if len(sides) < needed:
        raise InputError(
            f"{subject}: {len(sides)} of {needed} sides typed: type every side of the equation"
        )
    return sides
