"""Positions, momenta, moments and inertias as the engine derives them, for the ledger's rows.

    P = sum m v_C      H_B = sum (I omega + BC x m v_C)      tau_B = sum ((r - r_B) x F + couple)

They are derived as programs, along the chain, and printed; reactions are symbols, and pairs inside
a free body cancel. Inertias of shapes are integrated directly, so that they do not rest on the
closed forms that a scene's definitions are made of.
"""

from collections.abc import Callable
from typing import Any

from sympy import Expr, Matrix

from mechanics.errors import InputError
from mechanics.kinematics.motion import PointMotion
from mechanics.kinematics.symbolic import Kinematics
from mechanics.program.forward import tangent
from mechanics.program.vectors import Vector, add, cross, scale, subtract, times, zeros
from mechanics.routes.kane import derive
from mechanics.routes.loads import Wrench, acting_reactions, applied, balanced, together
from mechanics.routes.rows import remainder
from mechanics.scene import quantities as q
from mechanics.scene.momenta import momentum_symbols
from mechanics.scene.places import direction
from mechanics.scene.published import Quantity
from mechanics.scene.shape_integrals import (
    integrated_centroid,
    integrated_inertia,
    integrated_mass,
)

Sides = tuple[Expr | Matrix, ...]
"""One member: every side is this. Two: the first side, and every further one."""


def derived(kinematics: Kinematics, quantity: Quantity) -> Sides:
    """What the sides of a row about this quantity have to be, in plain symbols.

    Raises
    ------
    InputError
        When the scene has no body or point of that name, or the quantity is not mechanical.
    """
    sides: Sides
    if type(quantity) in VECTORS:
        vectors = VECTORS[type(quantity)](kinematics, quantity)
        sides = tuple(Matrix(kinematics.printer(vector)) for vector in vectors)
    elif type(quantity) in DERIVED:
        sides = DERIVED[type(quantity)](kinematics, quantity)
    else:
        raise InputError(f"{type(quantity).__name__} is no quantity that a scene alone gives")
    along = getattr(quantity, "along", None)
    if along is None:
        return sides
    axis = direction(along)
    return tuple(side.dot(axis) if isinstance(side, Matrix) else side for side in sides)


def momentum(moving: Kinematics, bodies: q.Names) -> Vector:
    """Linear momentum of a free body, in kg m/s."""
    own = (
        scale(moving.mechanism.bodies[i].mass, moving.moving[i].centre.velocity)
        for i in _inside(moving, bodies)
    )
    return add(zeros(moving.mechanism.builder), *own)


def moment_of_momentum(moving: Kinematics, bodies: q.Names, about: str | None) -> Vector:
    """Sum of BC x P, in kg m^2/s."""
    total, centre = zeros(moving.mechanism.builder), _centre(moving, bodies, about).position
    for i in _inside(moving, bodies):
        arm = subtract(moving.moving[i].centre.position, centre)
        total = add(total, cross(arm, momentum(moving, moving.scene.bodies[i].name)))
    return total


def angular_momentum(moving: Kinematics, bodies: q.Names, about: str | None) -> Vector:
    """Angular momentum about a point, or about the mass centre of one body, in kg m^2/s."""
    total = moment_of_momentum(moving, bodies, about)
    for i in _inside(moving, bodies):
        turning, inertia = moving.moving[i].turning, moving.moving[i].inertia
        if turning is not None and inertia is not None:
            total = add(total, times(inertia, turning.omega))
    return total


def moving_point_term(moving: Kinematics, bodies: q.Names, about: str) -> Vector:
    """v_B x P, in N m."""
    return cross(_centre(moving, bodies, about).velocity, momentum(moving, bodies))


def forces(moving: Kinematics, bodies: q.Names) -> Vector:
    """Sum of the loads and reactions on a free body, reactions as inputs, in N."""
    return _total(moving, bodies, lambda wrench: wrench.force)


def moments(moving: Kinematics, bodies: q.Names, about: str | None) -> Vector:
    """Sum of the moments of loads and reactions about a point, in N m."""
    centre = _centre(moving, bodies, about).position
    return _total(moving, bodies, lambda wrench: wrench.moment(centre))


def _total(moving: Kinematics, bodies: q.Names, effect: Callable[[Wrench], Vector]) -> Vector:
    mechanism, inside = moving.mechanism, set(_inside(moving, bodies))
    total = zeros(mechanism.builder)
    for wrench in applied(mechanism, moving.motions):
        if wrench.body in inside:
            total = add(total, effect(wrench))
    units = acting_reactions(mechanism, moving.motions.poses)
    for reaction, pair in zip(mechanism.reactions, units, strict=True):
        own = [unit for unit in pair if unit.body in inside]
        if own and not balanced(pair, own):
            size = mechanism.builder.input(reaction.name)
            total = add(total, scale(size, effect(together(own))))
    return total


def _rate(moving: Kinematics, vector: Vector) -> Vector:
    return tuple(tangent(vector, moving.mechanism.rates))


def _inside(moving: Kinematics, bodies: q.Names) -> list[int]:
    """Places of the named bodies, in scene order."""
    names = [bodies] if isinstance(bodies, str) else list(bodies)
    inside = [moving.scene.body(name) for name in names]
    return [i for i, body in enumerate(moving.scene.bodies) if body in inside]


def _centre(moving: Kinematics, bodies: q.Names, about: str | None) -> PointMotion:
    if about is not None:
        return moving.point_nodes(about)
    inside = _inside(moving, bodies)
    if len(inside) != 1:
        raise InputError(
            f"{moving.scene.name}: {len(inside)} bodies have no mass centre of one body: name the"
            " point with about="
        )
    return moving.moving[inside[0]].centre


def _position(moving: Kinematics, quantity: q.Position) -> Vector:
    end = moving.point_nodes(quantity.point).position
    if quantity.of is None:
        return end
    return subtract(end, moving.point_nodes(quantity.of).position)


def _generalized(moving: Kinematics, quantity: q.GeneralizedMomentum) -> Sides:
    by_name = {c.name: p for p, c in momentum_symbols(moving.scene).items()}
    if quantity.coordinate not in by_name:
        raise InputError(
            f"{moving.scene.name}: there is no momentum of {quantity.coordinate!r}: the coordinates"
            f" are {', '.join(by_name)}"
        )
    return (moving.momenta[by_name[quantity.coordinate]],)


def _driving(moving: Kinematics, quantity: q.GeneralizedForce) -> Sides:
    scene = moving.scene
    if not scene.unconstrained or moving.mechanism.frictions:
        what = "friction" if scene.unconstrained else "constraints"
        raise InputError(
            f"{scene.name} has {what}: inverse dynamics has no one answer: write residuals, with"
            " the inputs among the arguments"
        )
    by_name = {u.name: row for u, row in zip(scene.u, derive(moving.mechanism).values, strict=True)}
    build = moving.mechanism.builder
    inputs = [build.input(symbol.name) for symbol in scene.input_symbols]
    (row,) = remainder(build, [by_name[quantity.speed]], inputs)
    return (moving.printer([row])[0],)


def _centroid(quantity: q.Centroid) -> Matrix:
    return Matrix([*(integrated_centroid(quantity.body) - Matrix(quantity.origin)), 0])


VECTORS: dict[type[Quantity], Callable[[Kinematics, Any], tuple[Vector, ...]]] = {
    q.Position: lambda k, x: (_position(k, x),),
    q.Velocity: lambda k, x: (k.point_nodes(x.point).velocity,),
    q.Momentum: lambda k, x: (momentum(k, x.bodies),),
    q.RateOfMomentum: lambda k, x: (_rate(k, momentum(k, x.bodies)),),
    q.AngularMomentum: lambda k, x: (angular_momentum(k, x.bodies, x.about),),
    q.RateOfAngularMomentum: lambda k, x: (
        _rate(k, angular_momentum(k, x.bodies, x.about)),
    ),
    q.MomentOfMomentum: lambda k, x: (moment_of_momentum(k, x.bodies, x.about),),
    q.MovingPointTerm: lambda k, x: (moving_point_term(k, x.bodies, x.about),),
    q.Moment: lambda k, x: (moments(k, x.bodies, x.about),),
    q.MomentumPrinciple: lambda k, x: (
        forces(k, x.bodies), _rate(k, momentum(k, x.bodies)),
    ),
    q.AngularMomentumPrinciple: lambda k, x: (
        moments(k, x.body, None), _rate(k, angular_momentum(k, x.body, None)),
    ),
    q.MovingPointPrinciple: lambda k, x: (
        moments(k, x.bodies, x.about),
        add(
            _rate(k, angular_momentum(k, x.bodies, x.about)),
            moving_point_term(k, x.bodies, x.about),
        ),
    ),
}  # fmt: skip
"""As nodes."""

DERIVED: dict[type[Quantity], Callable[[Kinematics, Any], Sides]] = {
    q.GeneralizedMomentum: _generalized,
    q.GeneralizedForce: _driving,
    q.Mass: lambda k, x: (integrated_mass(x.body),),
    q.Centroid: lambda k, x: (_centroid(x),),
    q.Inertia: lambda k, x: (integrated_inertia(x.body, x.about),),
}
"""As expressions."""
