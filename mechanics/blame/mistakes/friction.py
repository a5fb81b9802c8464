"""Friction that presses wrongly.

mu N_0 sign(v) for mu N sign(v)        N_0 what the contact bears at rest: the weight
mu sign(v) for mu N sign(v)            the coefficient taken for a force
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from sympy import Expr, S, Symbol

from mechanics.blame.mistakes.fault_model import Change, Fault, Part, Right
from mechanics.blame.pieces import Kind, Piece
from mechanics.routes.friction_reactions import pressed, pressing
from mechanics.routes.lagrange_sympy import opened_equations
from mechanics.scene import Scene
from mechanics.scene.actions import frictions


def faults(right: Right) -> Iterator[Fault]:
    """Every friction with every mistake that people make with it."""
    if not frictions(right.scene):
        return
    weights = _at_rest(right.scene)
    for load in frictions(right.scene):
        normal = Symbol(load.normal, real=True)
        for value, words in (
            (weights[normal], f"uses the value of {load.normal} at rest, not in motion"),
            (S.One, f"is the coefficient alone, without {load.normal}"),
        ):
            words = f"friction {load.name} {words}"
            yield from right.fault(words, _pressing_with(load.name, normal, value))


def _at_rest(scene: Scene) -> dict[Symbol, Expr]:
    """What the reactions bear when nothing moves."""
    found = pressed(scene, opened_equations(scene, pressing(scene))).solve(scene.ud)
    still = dict.fromkeys((*scene.ud, *scene.u), S.Zero)
    return {symbol: value.xreplace(still) for symbol, value in found}


def _pressing_with(name: str, normal: Symbol, value: Expr) -> Change:
    """Puts a value for the reaction into the friction of that name."""

    def change(piece: Piece) -> Sequence[Part]:
        if piece.origin.kind is not Kind.LOAD or piece.origin.name != name:
            return ((S.One, piece),)
        return ((S.One, replace(piece, value=piece.value.xreplace({normal: value}))),)

    return change
