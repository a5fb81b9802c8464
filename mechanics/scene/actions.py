"""Loads and reactions as forces and couples on bodies, in inertial components.

spring    tension = k (d - l),  d = along . (r_2 - r_1)  or  |r_2 - r_1|
damper    tension = c d'
friction  -mu N sign(v) along the direction of sliding, N the reaction that presses
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

from sympy import Abs, Expr, Matrix, S, Symbol, sign, sqrt, zeros
from sympy.physics.vector import Point

from mechanics.errors import SceneError
from mechanics.scene.loads import (
    Coulomb,
    Damper,
    Force,
    Gravity,
    Load,
    Spring,
    Torque,
    TorsionSpring,
)
from mechanics.scene.rates import rate, rate_table
from mechanics.scene.scene import Scene


@dataclass(frozen=True)
class Action:
    """A force and a couple that one load or one reaction exerts on one body.

    Attributes
    ----------
    name : str
        Of the load or reaction.
    body : str
    at : Matrix
        3 x 1 position where the force acts, in m; where a couple acts does not matter.
    force, couple : Matrix
        3 x 1, inertial components, in N and N m. For a reaction: per unit of the unknown.
    """

    name: str
    body: str
    at: Matrix
    force: Matrix
    couple: Matrix


def applied_actions(scene: Scene) -> tuple[Action, ...]:
    """Every load that depends on no reaction, as actions on bodies; see `acting_reactions`."""
    found: list[Action] = []
    for load in scene.loads:
        if not isinstance(load, Coulomb):
            found += load_actions(scene, load)
    return tuple(found)


def load_actions(scene: Scene, load: Load) -> list[Action]:
    """One load as actions on bodies; friction with the symbol of the reaction that presses.

    Raises
    ------
    SceneError
        When it cannot be told which body carries the point of a load.
    """
    none = zeros(3, 1)
    if isinstance(load, Gravity):
        field = scene.vector(load.field, load.name)
        return [
            Action(load.name, body.name, scene.position(body.centre), body.mass * field, none)
            for body in scene.bodies
            if body.mass != 0
        ]
    if isinstance(load, Spring | Damper):
        distance, direction = elongation(scene, load)
        if isinstance(load, Spring):
            tension = scene.plain(load.stiffness, load.name) * (
                distance - scene.plain(load.length, load.name)
            )
        else:
            tension = scene.plain(load.coefficient, load.name) * rate(distance, rate_table(scene))
        ends = ((load.first, load.by, direction), (load.second, load.on, -direction))
        pulls = [
            Action(load.name, carrier, scene.position(point), tension * pull, none)
            for point, stated, pull in ends
            if (carrier := carrier_of(scene, load, point, stated)) is not None
        ]
        if not pulls:
            raise SceneError(
                f"load {load.name}: both ends are on the ground, where it does nothing: name the"
                " bodies with on= and by="
            )
        return pulls
    if isinstance(load, Force):
        force, at = scene.vector(load.vector, load.name), scene.position(load.at)
        carrier = carrier_of(scene, load, load.at, load.on)
        if carrier is None:
            raise SceneError(f"force {load.name}: it acts on the ground, where it does nothing")
        return _pair(load.name, carrier, load.by, at, force, none)
    if isinstance(load, Coulomb):
        return _friction(scene, load)
    if isinstance(load, Torque):
        couple = scene.vector(load.vector, load.name)
    elif isinstance(load, TorsionSpring):
        angle, stiffness = (scene.plain(e, load.name) for e in (load.angle, load.stiffness))
        couple = -stiffness * angle * scene.vector(load.axis, load.name)
    else:
        raise SceneError(f"load {load!r}: it is none of the loads of mechanics.scene.loads")
    return _pair(load.name, load.on, load.by, none, none, couple)


def unit_reactions(scene: Scene) -> dict[Symbol, list[Action]]:
    """For each reaction its unknown and the actions of a unit of it, on both bodies."""
    none = zeros(3, 1)
    table: dict[Symbol, list[Action]] = {}
    for reaction in scene.reactions:
        along = scene.vector(reaction.along, reaction.name)
        if reaction.at is None:
            pair = _pair(reaction.name, reaction.on, reaction.by, none, none, along)
        else:
            at = scene.position(reaction.at)
            pair = _pair(reaction.name, reaction.on, reaction.by, at, along, none)
        table[reaction.symbol] = pair
    return table


def acting_reactions(scene: Scene) -> dict[Symbol, list[Action]]:
    """For each reaction the actions of a unit of it, with the friction that it brings.

    A pressing reaction with friction is one force that leans against the sliding.
    """
    table = unit_reactions(scene)
    for load in frictions(scene):
        symbol = Symbol(load.normal, real=True)
        table[symbol] = [
            replace(unit, force=unit.force + rubbing.force.xreplace({symbol: S.One}))
            for unit, rubbing in zip(table[symbol], _friction(scene, load), strict=True)
        ]
    return table


def frictions(scene: Scene) -> tuple[Coulomb, ...]:
    """The loads that depend on reactions."""
    return tuple(load for load in scene.loads if isinstance(load, Coulomb))


def _friction(scene: Scene, load: Coulomb) -> list[Action]:
    """-mu N sign(v) on the body that the reaction N acts on, the opposite on the other."""
    normal = scene.reaction(load.normal)
    pressing = normal.symbol * scene.plain(load.coefficient, load.name)
    size = -pressing * sign(scene.plain(load.sliding, load.name))
    force = size * scene.vector(load.along, load.name)
    at = scene.position(normal.at)
    return _pair(load.name, normal.on, normal.by, at, force, zeros(3, 1))


def elongation(scene: Scene, load: Spring | Damper) -> tuple[Expr, Matrix]:
    """Distance d of a spring or damper and the unit direction from its first to its second end."""
    span = scene.position(load.second) - scene.position(load.first)
    if load.along is not None:
        direction = scene.vector(load.along, load.name)
        return span.dot(direction), direction
    distance = sqrt(sum(entry**2 for entry in span))
    if distance.has(Abs):
        raise SceneError(
            f"load {load.name}: its ends move on one line, so that its length is {distance}:"
            " give the direction with along="
        )
    return distance, span / distance


def carrier_of(scene: Scene, load: Load, point: Point, stated: str | None) -> str | None:
    """Name of the body that carries a point; None for the ground and for supports moved by hand."""
    if stated is not None:
        return stated
    centred = [body.name for body in scene.bodies if body.centre == point]
    if len(centred) == 1:
        return centred[0]
    position = scene.position(point)
    if not centred and not (position.free_symbols & set(scene.q)):
        return None
    raise SceneError(
        f"load {load.name}: it cannot be told which body carries point {point.name}:"
        " name it with on= or by="
    )


def moment(action: Action, about: Matrix) -> Matrix:
    """3 x 1 moment of an action about a point, in N m: (r - r_B) x F + couple."""
    return (action.at - about).cross(action.force) + action.couple


def by_body(actions: tuple[Action, ...]) -> Mapping[str, list[Action]]:
    """Actions grouped by the body they act on."""
    groups: dict[str, list[Action]] = {}
    for action in actions:
        groups.setdefault(action.body, []).append(action)
    return groups


def _pair(
    name: str, on: str, by: str | None, at: Matrix, force: Matrix, couple: Matrix
) -> list[Action]:
    own = [Action(name, on, at, force, couple)]
    return own if by is None else [*own, Action(name, by, at, -force, -couple)]
