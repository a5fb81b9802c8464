"""Positions, momenta, moments and inertias as the engine derives them, for the ledger's rows.

    P = sum m v_C      H_B = sum (I omega + BC x m v_C)      tau_B = sum ((r - r_B) x F + couple)

Velocities come from `mechanics.kinematics.textbook.differentiate`, forces from the loads and the
reactions as symbols. Pairs inside a free body cancel in the sums. Inertias of shapes are integrated
directly, so that they do not rest on the closed forms that a scene's definitions are made of.
"""

from collections.abc import Callable
from functools import lru_cache
from typing import Any

from sympy import Expr, Matrix, zeros

from mechanics.errors import InputError
from mechanics.kinematics.momenta import generalized_momenta, momentum_symbols
from mechanics.kinematics.textbook import differentiate
from mechanics.kinematics.textbook.motion import BodyMotion, PointMotion, inertia_matrix
from mechanics.scene import Scene
from mechanics.scene import quantities as q
from mechanics.scene.actions import Action, acting_reactions, applied_actions, moment
from mechanics.scene.places import direction, point_named
from mechanics.scene.published import Quantity
from mechanics.scene.rates import rate_table, rates
from mechanics.scene.shape_integrals import (
    integrated_centroid,
    integrated_inertia,
    integrated_mass,
)

Sides = tuple[Expr | Matrix, ...]
"""One member: every side is this. Two: the first side, and every further one."""


def derived(scene: Scene, quantity: Quantity) -> Sides:
    """What the sides of a row about this quantity have to be, in plain symbols.

    Raises
    ------
    InputError
        When the scene has no body or point of that name, or the quantity is not mechanical.
    """
    if type(quantity) not in DERIVED:
        raise InputError(f"{type(quantity).__name__} is no quantity that a scene alone gives")
    sides = DERIVED[type(quantity)](scene, quantity)
    along = getattr(quantity, "along", None)
    if along is None:
        return sides
    axis = direction(along)
    return tuple(side.dot(axis) if isinstance(side, Matrix) else side for side in sides)


def momentum(scene: Scene, bodies: q.Names) -> Matrix:
    """3 x 1 linear momentum of a free body, in kg m/s."""
    total = zeros(3, 1)
    for motion in _motions(scene, bodies):
        total += motion.body.mass * motion.centre.velocity
    return total


def moment_of_momentum(scene: Scene, bodies: q.Names, about: str | None) -> Matrix:
    """3 x 1 sum of BC x P, in kg m^2/s."""
    centre = _centre(scene, bodies, about).position
    total = zeros(3, 1)
    for motion in _motions(scene, bodies):
        arm = motion.centre.position - centre
        total += arm.cross(motion.body.mass * motion.centre.velocity)
    return total


def angular_momentum(scene: Scene, bodies: q.Names, about: str | None) -> Matrix:
    """3 x 1 angular momentum about a point, or about the mass centre of one body, in kg m^2/s."""
    total = moment_of_momentum(scene, bodies, about)
    for motion in _motions(scene, bodies):
        total += inertia_matrix(scene, motion.body, motion.rotation) * motion.angular_velocity
    return total


def moving_point_term(scene: Scene, bodies: q.Names, about: str) -> Matrix:
    """3 x 1 v_B x P, in N m."""
    return _centre(scene, bodies, about).velocity.cross(momentum(scene, bodies))


def forces(scene: Scene, bodies: q.Names) -> Matrix:
    """3 x 1 sum of the loads and reactions on a free body, reactions as symbols, in N."""
    return _total(scene, bodies, lambda action: action.force)


def moments(scene: Scene, bodies: q.Names, about: str | None) -> Matrix:
    """3 x 1 sum of the moments of loads and reactions about a point, in N m."""
    centre = _centre(scene, bodies, about).position
    return _total(scene, bodies, lambda action: moment(action, centre))


def _total(scene: Scene, bodies: q.Names, effect: Callable[[Action], Matrix]) -> Matrix:
    inside = {motion.body.name for motion in _motions(scene, bodies)}
    total = zeros(3, 1)
    for action in applied_actions(scene):
        if action.body in inside:
            total += effect(action)
    for symbol, pair in acting_reactions(scene).items():
        for action in pair:
            if action.body in inside:
                total += symbol * effect(action)
    # Opposite forces inside the free body cancel only when products are multiplied out.
    return total.expand()


def _rate(scene: Scene, vector: Matrix) -> Matrix:
    return rates(vector, rate_table(scene))


@lru_cache(maxsize=4)
def _all_motions(scene: Scene) -> tuple[BodyMotion, ...]:
    return differentiate.body_motions(scene)


def _motions(scene: Scene, bodies: q.Names) -> list[BodyMotion]:
    names = [bodies] if isinstance(bodies, str) else list(bodies)
    inside = [scene.body(name) for name in names]
    return [motion for motion in _all_motions(scene) if motion.body in inside]


def _centre(scene: Scene, bodies: q.Names, about: str | None) -> PointMotion:
    if about is not None:
        return differentiate.point_motion(scene, point_named(scene, about))
    inside = _motions(scene, bodies)
    if len(inside) != 1:
        raise InputError(
            f"{scene.name}: {len(inside)} bodies have no mass centre of one body: name the point"
            " with about="
        )
    return inside[0].centre


def _position(scene: Scene, quantity: q.Position) -> Sides:
    end = scene.position(point_named(scene, quantity.point))
    if quantity.of is None:
        return (end,)
    return (end - scene.position(point_named(scene, quantity.of)),)


def _generalized(scene: Scene, quantity: q.GeneralizedMomentum) -> Sides:
    by_name = {c.name: p for p, c in momentum_symbols(scene).items()}
    if quantity.coordinate not in by_name:
        raise InputError(
            f"{scene.name}: there is no momentum of {quantity.coordinate!r}: the coordinates are"
            f" {', '.join(by_name)}"
        )
    return (generalized_momenta(scene)[by_name[quantity.coordinate]],)


def _centroid(quantity: q.Centroid) -> Matrix:
    return Matrix([*(integrated_centroid(quantity.body) - Matrix(quantity.origin)), 0])


DERIVED: dict[type[Quantity], Callable[[Scene, Any], Sides]] = {
    q.Position: _position,
    q.Velocity: lambda s, x: (
        differentiate.point_motion(s, point_named(s, x.point)).velocity,
    ),
    q.Momentum: lambda s, x: (momentum(s, x.bodies),),
    q.GeneralizedMomentum: _generalized,
    q.RateOfMomentum: lambda s, x: (_rate(s, momentum(s, x.bodies)),),
    q.AngularMomentum: lambda s, x: (angular_momentum(s, x.bodies, x.about),),
    q.RateOfAngularMomentum: lambda s, x: (
        _rate(s, angular_momentum(s, x.bodies, x.about)),
    ),
    q.MomentOfMomentum: lambda s, x: (moment_of_momentum(s, x.bodies, x.about),),
    q.MovingPointTerm: lambda s, x: (moving_point_term(s, x.bodies, x.about),),
    q.Moment: lambda s, x: (moments(s, x.bodies, x.about),),
    q.MomentumPrinciple: lambda s, x: (
        forces(s, x.bodies), _rate(s, momentum(s, x.bodies)),
    ),
    q.AngularMomentumPrinciple: lambda s, x: (
        moments(s, x.body, None), _rate(s, angular_momentum(s, x.body, None)),
    ),
    q.MovingPointPrinciple: lambda s, x: (
        moments(s, x.bodies, x.about),
        _rate(s, angular_momentum(s, x.bodies, x.about))
        + moving_point_term(s, x.bodies, x.about),
    ),
    q.Mass: lambda s, x: (integrated_mass(x.body),),
    q.Centroid: lambda s, x: (_centroid(x),),
    q.Inertia: lambda s, x: (integrated_inertia(x.body, x.about),),
}  # fmt: skip
