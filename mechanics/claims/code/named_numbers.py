"""Numbers that code returns by the names of what they are.

double tau2(..., double q1dd, double q2dd)    the input tau2 of the scene, that this motion needs
void f(..., double *T1, double *T2)           the reactions T1 and T2 of the scene
def rope_tension(theta, theta_dot, m, g)      a tension: each reaction of the scene is tried
"""

import re
from collections.abc import Collection, Sequence

from sympy import Expr

from mechanics.claims.about import OTHERS, named_quantity
from mechanics.claims.code.outputs import TITLE, Claim, spoken
from mechanics.claims.code.trace.tracing import Outputs
from mechanics.claims.names import Naming
from mechanics.claims.prose import NOUNS
from mechanics.claims.statement import Letter
from mechanics.errors import InputError
from mechanics.scene.quantities import EquationOfMotion, ReactionValue

FORCES = (" force", " forces")
"""How names of functions end that return some force."""

BESIDE = re.compile(r" (?:with|without|no|under|by|for|from|per|and|to|at) [a-z]+(?: [a-z]+)?$")
"""How names end with what is only there: pendulum_with_torque, accel_from_force."""


def named_numbers(
    naming: Naming, outputs: Outputs, about: str | None, title: str, passed: Collection[Expr]
) -> tuple[list[Claim], Letter | None]:
    """Claims of outputs by their names, and the word for a number that is looked for in the scene.

    Parameters
    ----------
    naming : Naming
    outputs : Outputs
    about : str, optional
        What the person says that they are.
    title : str
        Of the function.
    passed : collection of Expr
        All that is an argument.

    Returns
    -------
    claims : list of Claim
        Empty where their names tell nothing.
    letter : Letter or None

    Raises
    ------
    InputError
        Where a number is called a force or a torque, and nothing says which.
    """
    entries = [entry for value in outputs.values for entry in value]
    names = [TITLE.sub("", name) for name in outputs.names or (title,)]
    if about is not None:
        names = about.replace(",", " ").split()
    if claims := _of_the_scene(naming, names, entries, passed):
        return claims, None
    if len(entries) != 1:
        return [], None
    moves = {*passed} & {*naming.vocabulary.scene.ud}
    word = about if about in OTHERS else None if about or moves else _noun(title)
    if word is None:
        return [], None
    sides = (naming.vocabulary.scene.pressed(entries[0]),)
    return [(title, named_quantity(word), sides)], Letter(title, sides, word, returned=True)


def _of_the_scene(
    naming: Naming, names: Sequence[str], entries: Sequence[Expr], passed: Collection[Expr]
) -> list[Claim]:
    """Claims of numbers whose names are all inputs or reactions of the scene; empty for others.

    An input is what a motion needs, where code takes accelerations and not this input. What else
    returns one may be a law of control.
    """
    scene = naming.vocabulary.scene
    reactions = {one.name for one in scene.reactions}
    moves = {*passed} & {*scene.ud}
    inputs = {
        str(symbol): symbol for symbol in scene.input_symbols if moves and symbol not in passed
    }
    claims: list[Claim] = []
    for name, entry in zip(names, entries, strict=False):
        if name in reactions:
            claims.append((name, ReactionValue(name), (entry,)))
        elif name in inputs:
            claims.append((name, EquationOfMotion(), (inputs[name], entry)))
    return claims if len(claims) == len(names) == len(entries) else []


def _noun(title: str) -> str | None:
    """The word for what the name of a function ends with."""
    words = f" {spoken(title)}"
    if BESIDE.search(words):
        return None
    ends = ((f" {noun}", word) for nouns, word in NOUNS for noun in nouns.lower().split("|"))
    word = next((word for noun, word in ends if words.endswith(noun)), None)
    if word == "torque" or (word is None and words.endswith(FORCES)):
        raise InputError(
            f"{title} returns a force or a torque, and nothing says which: say what it is: --about"
            " (about=) can be reaction, tension, torque, equation of motion, or a reaction's name"
        )
    return word if word in OTHERS else None
