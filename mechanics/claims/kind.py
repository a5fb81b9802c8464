"""What scalar sides are about, told by what they hold.

x''            an equation of motion
N1 = ...       a reaction along the motion
p_theta = ...  a generalized momentum; with its rate p_theta' an equation of motion
neither        an identity
"""

from collections.abc import Mapping
from typing import Any

from sympy import Expr, S

from mechanics.claims.about import LETTERS, OF_CONSTANTS
from mechanics.claims.names import Naming
from mechanics.claims.sides import scalar
from mechanics.claims.statement import Letter
from mechanics.claims.tree import Name, Node
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

STIFF = ("K",)
"""Letters for a kinetic energy that are as often a constant: only where speeds are held."""


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


def letter_on_left(
    naming: Naming, words: Mapping[str, str], left: Node, sides: tuple[Any, ...]
) -> Letter | None:
    """The name on the left, where it may mean several things.

    Parameters
    ----------
    naming : Naming
    words : mapping of str to str
        Quantities that the person gave names.
    left : Node
    sides : tuple
        As they were built, without the left.
    """
    if not isinstance(left, Name) or left.order or not sides or not scalar(sides):
        return None
    said, own = words.get(left.name, ""), naming.knows(left.name)
    if not said and left.name not in LETTERS:
        return None
    scene = naming.vocabulary.scene
    moving = {symbol for side in sides for symbol in scene.plain(side).free_symbols}
    if not said and left.name in STIFF and not moving & {*scene.u, *scene.qd}:
        return None
    constants = {*naming.vocabulary.constants.values()}
    constant = all(side.free_symbols and side.free_symbols <= constants for side in sides)
    meant = {word for rank in LETTERS.get(left.name, ()) for word in rank}
    if not said and meant <= OF_CONSTANTS and (own or not constant):
        return None
    return Letter(left.name, tuple(map(naming.vocabulary.scene.pressed, sides)), said, own)


def moves_a_constant(naming: Naming, letter: Letter) -> bool:
    """Whether a constant of the scene is said to hold speeds: a length L that is the Lagrangian."""
    found = naming.lookup(letter.name)
    if found is None or found[0] in naming.vocabulary.reactions:
        return False
    scene = naming.vocabulary.scene
    moving = {*scene.u, *scene.qd}
    held = any(scene.plain(side).free_symbols & moving for side in letter.sides)
    return found[0] in naming.vocabulary.constants and held
