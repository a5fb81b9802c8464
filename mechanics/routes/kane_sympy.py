"""Kane's equations, by SymPy's `KanesMethod`.

    F_r + F_r* = 0,    F_r = sum v_r . F + omega_r . T,    F_r* = - sum m a . v_r + ...

Constraints make speeds dependent. Friction enters with the reaction that presses as an unknown,
which an auxiliary speed gives.
"""

from collections.abc import Sequence

from sympy import Expr, Matrix, zeros
from sympy.physics.mechanics import KanesMethod

from mechanics.equations import Equations, Matrices
from mechanics.kinematics.constraints import constraint_rows, velocity_forms
from mechanics.kinematics.textbook import chain
from mechanics.routes.common import tidied
from mechanics.routes.dynamic import Dynamic, dynamic_speeds
from mechanics.routes.kane_reactions import auxiliary_equations
from mechanics.routes.pressing import pressed, pressing
from mechanics.routes.sympy_model import SympyModel, Velocities, build, force_at
from mechanics.scene import Scene
from mechanics.scene.actions import (
    Action,
    applied_actions,
    frictions,
    load_actions,
)
from mechanics.symbolic import independent_rows

NAME = "kane_sympy"


def derive(scene: Scene) -> Equations:
    """Equations of motion by Kane's method; dependent speeds where there are constraints."""
    dynamic = dynamic_speeds(scene)
    if scene.constraints:
        return _with_dependent_speeds(scene, dynamic)
    mass, forcing = _matrices(scene, dynamic, kanes_method(scene, dynamic))
    if frictions(scene):
        return _with_friction(scene, mass, forcing)
    n = len(scene.u)
    matrices = Matrices(mass, forcing, zeros(n, 0), zeros(0, n), zeros(0, 1))
    return Equations(scene, NAME, (), True, textbook=matrices)


def kanes_method(scene: Scene, dynamic: Dynamic) -> KanesMethod:
    """SymPy's object for a scene without its constraints, with the equations formed."""
    model = build(scene, dynamic)
    method = _method(scene, dynamic, model, list(range(len(scene.u))))
    method.kanes_equations(list(model.bodies.values()), _applied(scene, model, dynamic))
    return method


def _with_friction(scene: Scene, mass: Matrix, forcing: Matrix) -> Equations:
    """The forces hold the reactions that press; auxiliary speeds give these."""
    contact = pressed(scene, auxiliary_equations(scene, pressing(scene)))
    n = len(scene.u)
    matrices = Matrices(*contact.put_into(mass, forcing), zeros(n, 0), zeros(0, n), zeros(0, 1))
    reactions = contact.solve(scene.ud)
    return Equations(scene, NAME, (), False, textbook=matrices, reactions=reactions)


def _with_dependent_speeds(scene: Scene, dynamic: Dynamic) -> Equations:
    model = build(scene, dynamic)
    loads = _applied(scene, model, dynamic)
    dependent = dependent_speeds(scene)
    order = [i for i in range(len(scene.u)) if i not in dependent] + dependent
    method = _method(scene, dynamic, model, order, dependent)
    method.kanes_equations(list(model.bodies.values()), loads)
    free = len(order) - len(dependent)
    mass, forcing = _matrices(scene, dynamic, method)
    # SymPy orders the columns independent speeds first.
    back = [order.index(i) for i in range(len(order))]
    square, right = mass.extract(list(range(mass.rows)), back), forcing
    matrices = Matrices(
        square[:free, :], right[:free, :], zeros(free, 0), square[free:, :], right[free:, :]
    )
    return Equations(scene, NAME, (), False, textbook=matrices)


def _matrices(scene: Scene, dynamic: Dynamic, method: KanesMethod) -> tuple[Matrix, Matrix]:
    """M and f in plain symbols."""
    found = (tidied(scene, dynamic.back(m)) for m in (method.mass_matrix, method.forcing))
    mass, forcing = found
    return mass, forcing


def dependent_speeds(scene: Scene) -> list[int]:
    """Indices of the last speeds that the constraints can be solved for."""
    matrix, _ = constraint_rows(scene)
    backwards = list(range(matrix.cols))[::-1]
    columns = [list(matrix[:, i]) for i in backwards]
    return sorted(backwards[k] for k in independent_rows(columns))


def _method(
    scene: Scene,
    dynamic: Dynamic,
    model: SympyModel,
    order: Sequence[int],
    dependent: Sequence[int] = (),
) -> KanesMethod:
    """KanesMethod, constraints by Cramer's rule: LU divides by zero at plain states."""
    t_rates = {q: f.diff() for q, f in zip(scene.qd, scene.coordinates, strict=True)}
    kinematic = [t_rates[qd] - dynamic.to(scene.coordinate_rates[qd]) for qd in scene.qd]
    speeds = [dynamic.to(u) for u in scene.u]
    options: dict[str, object] = {}
    coordinates = [dynamic.to(q) for q in scene.q]
    q_dependent: list[Expr] = []
    if dependent:
        holonomic = [c for c in scene.constraints if c.holonomic]
        options["u_dependent"] = [speeds[i] for i in dependent]
        options["velocity_constraints"] = [dynamic.to(form) for form in velocity_forms(scene)]
        if holonomic:
            q_dependent = [coordinates[i] for i in dependent][-len(holonomic) :]
            options["q_dependent"] = q_dependent
            options["configuration_constraints"] = [
                dynamic.to(scene.plain(c.expression)) for c in holonomic
            ]
    return KanesMethod(
        model.frame,
        [q for q in coordinates if q not in q_dependent],
        [speeds[i] for i in order if i not in dependent],
        kd_eqs=kinematic,
        # Solved for q' already: LU meets pivots of one only, and Cramer would take n! terms.
        kd_eqs_solver="LU",
        constraint_solver="CRAMER",
        **options,
    )


def _applied(scene: Scene, model: SympyModel, dynamic: Dynamic) -> list[tuple[object, object]]:
    """All loads of a scene; friction with the reaction that presses as an unknown."""
    rubbing = [action for load in frictions(scene) for action in load_actions(scene, load)]
    return _loads(scene, model, dynamic, (*applied_actions(scene), *rubbing))


def _loads(
    scene: Scene, model: SympyModel, dynamic: Dynamic, actions: Sequence[Action]
) -> list[tuple[object, object]]:
    """Loads on SymPy's points and frames; a force at a mass centre uses the point that is there."""
    centres = {body.name: scene.position(body.centre) for body in scene.bodies}
    found: list[tuple[object, object]] = []
    others: list[Action] = []
    for action in actions:
        if any(action.couple) or action.at != centres[action.body]:
            others.append(action)
        else:
            point = model.bodies[action.body].masscenter
            found.append((point, model.vector(action.force, dynamic)))
    if others:
        motions = {motion.body.name: motion for motion in chain.body_motions(scene)}
        for action in others:
            motion = motions[action.body]
            arm = action.at - motion.centre.position
            velocity = motion.centre.velocity + motion.angular_velocity.cross(arm)
            moving = Velocities(velocity, motion.angular_velocity)
            found += force_at(model, moving, action, dynamic)
    return found
