"""The scene in the symbols that a person uses: I_C in place of what the shapes give.

A definition that is the mass or inertia of a body stands for it; any other is written out.
"""

from dataclasses import replace
from functools import lru_cache
from typing import TypeGuard

from sympy import Expr, Symbol, sympify
from sympy.physics.vector import Dyadic

from mechanics.checks.ledger_compare import ordered
from mechanics.equations import Equations
from mechanics.exact import canonical
from mechanics.routes.free_body import derive
from mechanics.scene import RigidBody, Scene
from mechanics.scene.bodies import Body


def folded(truth: Equations, expression: Expr) -> tuple[Equations, Expr]:
    """Equations and an expression in the same symbols, as few of them written out as possible."""
    used = frozenset(expression.free_symbols & truth.scene.definitions.keys())
    if not used:
        return truth, expression
    other, kept = _with(truth, used)
    table: dict[Symbol, Expr] = {}
    for symbol, value in ordered(truth.scene.definitions):
        if symbol not in kept:
            table[symbol] = value.xreplace(table)
    return other, expression.xreplace(table)


@lru_cache(maxsize=16)
def _with(truth: Equations, used: frozenset[Symbol]) -> tuple[Equations, frozenset[Symbol]]:
    """Equations of the scene whose bodies have these symbols, and those that were found."""
    scene = truth.scene
    kept: set[Symbol] = set()
    bodies = tuple(_named(scene, body, used, kept) for body in scene.bodies)
    if not kept:
        return truth, frozenset()
    return derive(replace(scene, bodies=bodies)), frozenset(kept)


def _named(scene: Scene, body: Body, used: frozenset[Symbol], kept: set[Symbol]) -> Body:
    """A body with symbols for its mass and inertia, where a definition has their value."""
    for symbol in used:
        value = scene.definitions[symbol]
        if _same(body.mass, value):
            kept.add(symbol)
            body = replace(body, mass=symbol)
        elif _turning(body) and _same(body.inertia, value):
            kept.add(symbol)
            body = replace(body, inertia=symbol)
    return body


def _turning(body: Body) -> TypeGuard[RigidBody]:
    """Whether its inertia is a scalar."""
    return isinstance(body, RigidBody) and not isinstance(body.inertia, Dyadic)


def _same(one: Expr, two: Expr) -> bool:
    return bool(canonical(sympify(one) - sympify(two)) == 0)
