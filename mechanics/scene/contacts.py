"""Whether friction is declared so that it can be derived.

    N > 0       by a condition: where the reaction does not press, there is no such contact
    mu >= 0     or it would push

The accelerations determine N and N determines them, which is worked out for a reaction of a joint
in a tree of bodies: a constraint or a loop would bring in reactions that the joint does not have.
"""

from sympy import Symbol

from mechanics.errors import SceneError
from mechanics.nearest import instead
from mechanics.scene.declaration import Declaration
from mechanics.scene.loads import Coulomb
from mechanics.symbolic import canonical


def check_contacts(scene: Declaration) -> None:
    """Every friction has a reaction that presses, and a condition that says so.

    Raises
    ------
    SceneError
        Names the load.
    """
    loads = [load for load in scene.loads if isinstance(load, Coulomb)]
    for load in loads:
        _normal(scene, load)
        _pressed(scene, load)
        if canonical(scene.plain(load.sliding, load.name)) == 0:
            raise SceneError(
                f"load {load.name}: nothing slides there, so that it does nothing: give the sliding"
                " velocity, or leave the friction out"
            )
        if scene.plain(load.coefficient, load.name).is_negative:
            raise SceneError(
                f"load {load.name}: the coefficient {load.coefficient} is negative: friction takes"
                " energy out, with a coefficient of zero or more"
            )
        if scene.constraints:
            raise SceneError(
                f"load {load.name}: {scene.name} has constraints, with which friction is not"
                " derived: choose coordinates that need none, or leave the friction out"
            )
    for one, two in ((a, b) for i, a in enumerate(loads) for b in loads[:i]):
        if one.normal == two.normal:
            raise SceneError(
                f"load {one.name}: the friction of reaction {one.normal} is load {two.name}"
                " already: declare one with the sum of the coefficients"
            )


def _normal(scene: Declaration, load: Coulomb) -> None:
    named = [reaction for reaction in scene.reactions if reaction.name == load.normal]
    if not named:
        known = instead(load.normal, [reaction.name for reaction in scene.reactions], "reactions")
        raise SceneError(f"load {load.name}: there is no reaction {load.normal!r}: {known}")
    if named[0].at is None:
        raise SceneError(
            f"load {load.name}: {load.normal} is a couple, which presses nowhere: name a reaction"
            " with a point"
        )


def _pressed(scene: Declaration, load: Coulomb) -> None:
    """One of the conditions is that the reaction is positive."""
    symbol = Symbol(load.normal, real=True)
    if not any(condition.margin == symbol for condition in scene.conditions):
        raise SceneError(
            f"load {load.name}: it holds while {load.normal} presses: say what happens where it"
            f" does not, by condition(..., {load.normal} > 0, 'lifts off') among conditions="
        )
