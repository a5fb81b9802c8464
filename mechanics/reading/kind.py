"""What scalar sides are about, told by what they hold.

x''            an equation of motion
N1 = ...       a reaction along the motion
p_theta = ...  a generalized momentum; with its rate p_theta' an equation of motion
neither        an identity
"""

from collections.abc import Mapping
from typing import Any

from sympy import Expr, S

from mechanics.reading.about import ENERGY_NAMES
from mechanics.reading.names import Naming
from mechanics.reading.sides import scalar
from mechanics.reading.tree import Name, Node
from mechanics.scene import Scene
from mechanics.scene.momenta import momentum_symbols, rate_symbol
from mechanics.scene.published import Quantity
from mechanics.scene.quantities import (
    EquationOfMotion,
    GeneralizedMomentum,
    Identity,
    ReactionValue,
)
from mechanics.scene.symbols import plain_symbol


def kind_of(scene: Scene, sides: tuple[Expr, ...]) -> tuple[Quantity, tuple[Expr, ...], str]:
    """The quantity, the sides that its rows have, and a note on what was added."""
    plain = [scene.plain(side) for side in sides]
    symbols = set().union(*(side.free_symbols for side in plain))
    second = {plain_symbol(q, 2) for q in scene.coordinates}
    momenta = momentum_symbols(scene)
    moving = bool(symbols & {*scene.ud, *second, *map(rate_symbol, momenta)})
    reactions = [r.symbol for r in scene.reactions if r.symbol in symbols]
    if len(sides) > 1 and sides[0] in reactions:
        return ReactionValue(str(sides[0])), sides[1:], ""
    if len(sides) > 1 and sides[0] in momenta:
        return GeneralizedMomentum(momenta[sides[0]].name), sides[1:], ""
    if moving and len(sides) == 1:
        return EquationOfMotion(), (*sides, S.Zero), "one side only: it is taken to be zero"
    if moving:
        return EquationOfMotion(), sides, ""
    if reactions and len(sides) == 2:
        for symbol in reactions:
            slope = (sides[0] - sides[1]).diff(symbol)
            if slope.is_number and slope != 0:
                solved = symbol - (sides[0] - sides[1]) / slope
                return ReactionValue(symbol.name), (solved,), f"solved for {symbol}"
    if reactions and len(sides) > 1:
        return EquationOfMotion(), sides, "it holds reactions, so it is looked at along the motion"
    return Identity(), sides, ""


def energy_defined(naming: Naming, name: str, sides: tuple[Any, ...]) -> str | None:
    """The energy that a name stands for which the scene does not have, by what it is defined as.

    T = 2 pi sqrt(l/g) is a period: what pi and constants make is no kinetic energy.
    """
    energy = ENERGY_NAMES.get(name) if scalar(sides) else None
    constants = {*naming.vocabulary.constants.values()}
    period = all(side.has(S.Pi) and side.free_symbols <= constants for side in sides)
    return None if energy == "kinetic energy" and period else energy


def energy_named(
    naming: Naming, words: Mapping[str, str], left: Node, sides: tuple[Any, ...]
) -> str | None:
    """The energy that the name on the left means, though the scene has such a name.

    Parameters
    ----------
    naming : Naming
    words : mapping of str to str
        Quantities that the person gave names.
    left : Node
    sides : tuple
        As they were built.
    """
    if not isinstance(left, Name) or left.order or len(sides) < 2:
        return None
    if left.name in words:
        return words[left.name]
    found = naming.lookup(left.name)
    if found is None or found[0] in naming.vocabulary.reactions or not scalar(sides):
        return None
    scene = naming.vocabulary.scene
    if found[0] in naming.vocabulary.constants and sides[1].free_symbols & {*scene.u, *scene.qd}:
        # A length has no speeds in it, so this L is the Lagrangian.
        return ENERGY_NAMES.get(left.name)
    return None
