"""Reactions by Kane's auxiliary speeds: the second, independent way.

For each reaction its joint is opened (`mechanics.routes.kane_openings`): the bodies that move then
get an auxiliary speed,

    v_body <- v_body + w_j (e_j + n_j x (r_C - r_0)),    omega_body <- omega_body + w_j n_j

and the reactions enter as loads. The equations that belong to the auxiliary speeds, with these set
to zero, hold the reactions.
"""

from collections.abc import Sequence

import sympy.physics.mechanics as me
from sympy import Expr, Matrix, Symbol, eye, zeros
from sympy.physics.mechanics import KanesMethod, Point, ReferenceFrame, dynamicsymbols

from mechanics.kinematics.textbook import chain
from mechanics.kinematics.textbook.motion import BodyMotion
from mechanics.routes.dynamic import Dynamic, dynamic_speeds
from mechanics.routes.kane_openings import Opening, openings
from mechanics.routes.sympy_model import (
    SympyModel,
    Velocities,
    build,
    force_at,
    inertia_dyadic,
)
from mechanics.scene import RigidBody, Scene
from mechanics.scene.actions import Action, acting_reactions, applied_actions
from mechanics.scene.reactions import Reaction
from mechanics.scene.topology import multipliers


def auxiliary_equations(
    scene: Scene, wanted: Sequence[Symbol] = ()
) -> tuple[tuple[Symbol, Expr], ...]:
    """For each reaction that is no multiplier, an equation ``expression = 0`` that holds it.

    Parameters
    ----------
    scene : Scene
    wanted : sequence of Symbol
        Reactions; all for none.

    Returns
    -------
    tuple of (Symbol, Expr)
        In q, u, u' and the reactions, plain symbols.
    """
    kept = multipliers(scene)
    asked = wanted or [reaction.symbol for reaction in scene.reactions]
    sought = [r for r in scene.reactions if r.symbol in asked and r.symbol not in kept]
    if not sought:
        return ()
    dynamic = dynamic_speeds(scene)
    model = build(scene, dynamic)
    speeds = [dynamicsymbols(f"aux_{i}") for i in range(len(sought))]
    fields = _opened(scene, sought, speeds)
    motions = {motion.body.name: motion for motion in chain.body_motions(scene)}
    bodies = [_body(scene, m, fields[name], model, dynamic) for name, m in motions.items()]
    loads = [
        load
        for action in _actions(scene)
        for load in force_at(
            model, _at(motions[action.body], fields[action.body], action), action, dynamic
        )
    ]
    method = KanesMethod(
        model.frame,
        list(scene.coordinates),
        [dynamic.to(u) for u in scene.u],
        kd_eqs=[
            q.diff() - dynamic.to(scene.coordinate_rates[qd])
            for q, qd in zip(scene.coordinates, scene.qd, strict=True)
        ],
        u_auxiliary=speeds,
        # Solved for q' already: LU meets pivots of one only, and Cramer would take n! terms.
        kd_eqs_solver="LU",
    )
    method.kanes_equations(bodies, loads)
    rows = dynamic.back(method.auxiliary_eqs)
    return tuple(zip((reaction.symbol for reaction in sought), rows, strict=True))


Field = list[tuple[Expr, Opening]]
"""Auxiliary speeds that move a body, and how."""


def _opened(scene: Scene, sought: Sequence[Reaction], speeds: Sequence[Expr]) -> dict[str, Field]:
    """For every body the auxiliary speeds that move it."""
    fields: dict[str, Field] = {body.name: [] for body in scene.bodies}
    for opening, speed in zip(openings(scene, sought), speeds, strict=True):
        for name in opening.bodies:
            fields[name].append((speed, opening))
    return fields


def _actions(scene: Scene) -> list[Action]:
    """Applied loads, and every reaction as a load of unknown size."""
    unknown = [
        Action(a.name, a.body, a.at, symbol * a.force, symbol * a.couple)
        for symbol, pair in acting_reactions(scene).items()
        for a in pair
    ]
    return [*applied_actions(scene), *unknown]


def _extra(field: Field, at: Matrix) -> tuple[Matrix, Matrix]:
    """Velocity at a place, and angular velocity, that the auxiliary speeds add."""
    velocity, omega = zeros(3, 1), zeros(3, 1)
    for speed, opening in field:
        velocity += speed * opening.velocity(at)
        omega += speed * opening.about
    return velocity, omega


def _at(motion: BodyMotion, field: Field, action: Action) -> Velocities:
    """Velocity of the material point where an action acts, and angular velocity."""
    speed, spin = _extra(field, action.at)
    arm = action.at - motion.centre.position
    velocity = motion.centre.velocity + motion.angular_velocity.cross(arm) + speed
    return Velocities(velocity, motion.angular_velocity + spin)


def _body(
    scene: Scene, motion: BodyMotion, field: Field, model: SympyModel, dynamic: Dynamic
) -> object:
    """The body with auxiliary speeds added to its velocities; its accelerations need none."""
    body, inertial = motion.body, model.frame
    velocity, omega = _extra(field, motion.centre.position)
    plain = model.bodies[body.name]
    centre = Point(f"opened centre of {body.name}")
    centre.set_vel(inertial, plain.masscenter.vel(inertial) + model.vector(velocity, dynamic))
    centre.set_acc(inertial, plain.masscenter.acc(inertial))
    if not isinstance(body, RigidBody) or body.inertia == 0:
        return me.Particle(body.name, centre, body.mass)
    # A frame of the body's own: several bodies may share the scene's.
    turning = ReferenceFrame(f"opened {body.name}")
    turning.orient_explicit(plain.frame, eye(3))
    spin = plain.frame.ang_vel_in(inertial) + model.vector(omega, dynamic)
    turning.set_ang_vel(inertial, spin)
    turning.set_ang_acc(inertial, plain.frame.ang_acc_in(inertial))
    inertia = inertia_dyadic(scene, body, turning, dynamic)
    return me.RigidBody(body.name, centre, turning, body.mass, (inertia, centre))
