"""Lagrange's equation of a joint that is opened along a reaction, which holds the reaction.

    r -> r + w e                              of every body outboard of the joint
    d/dt (dT/dw') - dT/dw = Q_w               at w = w' = w'' = 0

The bodies are moved, not turned, so that T is that of their mass centres.
"""

from collections.abc import Sequence

from sympy import Add, Dummy, Expr, Matrix, Rational, S, Symbol

from mechanics.errors import SingularError
from mechanics.scene import Scene
from mechanics.scene.actions import acting_reactions, applied_actions
from mechanics.scene.rates import coordinate_rate_table, rate, rates
from mechanics.scene.topology import tree


def opened_equations(scene: Scene, wanted: Sequence[Symbol]) -> tuple[tuple[Symbol, Expr], ...]:
    """For each of the reactions an equation ``expression = 0`` that holds it.

    Returns
    -------
    tuple of (Symbol, Expr)
        In q, u, u' and the reactions, plain symbols.

    Raises
    ------
    SingularError
        When a reaction closes a loop of bodies.
    """
    return tuple((symbol, _equation(scene, symbol)) for symbol in wanted)


def _equation(scene: Scene, symbol: Symbol) -> Expr:
    bodies = tree(scene)
    reaction = scene.reaction(symbol.name)
    outer = next((name for name in bodies.order if reaction in bodies.joints[name]), None)
    if outer is None:
        raise SingularError(
            f"{scene.name}: the reaction {symbol}, on which friction depends, closes a loop of"
            " bodies: friction is derived in a tree of bodies"
        )
    moved = bodies.subtree(outer)
    along = scene.vector(reaction.along, reaction.name)
    loads = [action for action in applied_actions(scene) if action.body in moved]
    forces = [load.force for load in loads]
    forces += [
        unknown * action.force
        for unknown, actions in acting_reactions(scene).items()
        for action in actions
        if action.body in moved
    ]
    generalized = Add(*(force.dot(along) for force in forces))
    return scene.plain(_inertia(scene, moved, along)) - generalized


def _inertia(scene: Scene, moved: Sequence[str], along: Matrix) -> Expr:
    """d/dt (dT/dw') - dT/dw in q, q' and q''."""
    w, wd, wdd = (Dummy(name, real=True) for name in ("w", "w_dot", "w_ddot"))
    table = coordinate_rate_table(scene) | {w: wd, wd: wdd}
    terms = []
    for name in moved:
        body = scene.body(name)
        velocity = rates(scene.position(body.centre) + w * along, table)
        terms.append(Rational(1, 2) * body.mass * velocity.dot(velocity))
    kinetic = Add(*terms)
    closed = dict.fromkeys((w, wd, wdd), S.Zero)
    return (rate(kinetic.diff(wd), table) - kinetic.diff(w)).xreplace(closed)
