"""The scene in the symbols that a person uses: I_C in place of what the shapes give.

A definition that is the mass or inertia of a body stands for it; any other is written out.
"""

from dataclasses import replace
from typing import TypeGuard

from sympy import Expr, Symbol, sympify
from sympy.physics.vector import Dyadic

from mechanics.checks.ledger_compare import ordered
from mechanics.equations import Equations
from mechanics.routes.derivation import by_route
from mechanics.scene import RigidBody, Scene
from mechanics.scene.bodies import Body
from mechanics.symbolic import canonical


def kept_symbols(scene: Scene, expression: Expr) -> frozenset[Symbol]:
    """Definitions that need not be written out beside an expression."""
    held = expression.free_symbols
    return frozenset(s for s in scene.definitions if s in held or _unasked(scene, s, held))


def _unasked(scene: Scene, symbol: Symbol, held: set[Symbol]) -> bool:
    """Whether the bodies have a symbol, and nothing that only its definition holds is asked for."""
    own = set().union(*(_massive(body) for body in scene.bodies))
    return symbol in own and not (scene.definitions[symbol].free_symbols - own) & held


def _massive(body: Body) -> set[Symbol]:
    inertia = body.inertia.free_symbols if _turning(body) else set()
    return set(body.mass.free_symbols | inertia)


def folded(truth: Equations, kept: frozenset[Symbol]) -> tuple[Equations, frozenset[Symbol]]:
    """Equations of the scene whose bodies have these symbols, and those that are in use."""
    scene = truth.scene
    table = {s: v for s, v in ordered(scene.definitions) if s not in kept}
    bodies = tuple(_named(scene, body, kept, table) for body in scene.bodies)
    used = kept & set().union(*(_massive(body) for body in bodies))
    if bodies == scene.bodies:
        return truth, used
    return by_route("free_body", replace(scene, bodies=bodies)), used


def _named(scene: Scene, body: Body, kept: frozenset[Symbol], table: dict[Symbol, Expr]) -> Body:
    """A body with kept symbols for its mass and inertia, and others written out."""
    body = replace(body, mass=_symbol(scene, body.mass.xreplace(table), kept))
    if _turning(body):
        body = replace(body, inertia=_symbol(scene, body.inertia.xreplace(table), kept))
    return body


def _symbol(scene: Scene, value: Expr, kept: frozenset[Symbol]) -> Expr:
    """The kept symbol that stands for a value, or the value."""
    if value in kept:
        return value
    return next((s for s in kept if _same(value, scene.definitions[s])), value)


def _turning(body: Body) -> TypeGuard[RigidBody]:
    """Whether its inertia is a scalar."""
    return isinstance(body, RigidBody) and not isinstance(body.inertia, Dyadic)


def _same(one: Expr, two: Expr) -> bool:
    return bool(canonical(sympify(one) - sympify(two)) == 0)
