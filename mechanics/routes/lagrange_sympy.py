"""Lagrange's equations, by SymPy's `LagrangesMethod`.

    d/dt (dL/dq') - dL/dq = Q + A^T lambda,    L = T - V

Conservative loads enter as their potential, everything else as a generalized force. Where speeds
are not q', the result is carried over by q' = N u + n:

    N^T M N u' = N^T (f - M (N' u + n')) + N^T A^T lambda

so that the rows stay power-conjugate to u. Friction enters with the reaction that presses as an
unknown, which the equation of an opened joint gives.
"""

from dataclasses import replace

from sympy import Add, Expr, Matrix, Rational, Symbol, zeros
from sympy.physics.mechanics import LagrangesMethod, Point, ReferenceFrame

from mechanics.equations import Equations, Matrices
from mechanics.kinematics.textbook import differentiate
from mechanics.kinematics.textbook.motion import BodyMotion, inertia_matrix
from mechanics.routes.common import tidied
from mechanics.routes.dynamic import Dynamic, dynamic_rates
from mechanics.routes.lagrange_openings import opened_equations
from mechanics.routes.pressing import pressed, pressing
from mechanics.scene import Scene
from mechanics.scene.actions import frictions, load_actions
from mechanics.scene.loads import CONSERVATIVE
from mechanics.scene.potential import potential
from mechanics.scene.rates import rate, rate_table, speeds_in_rates
from mechanics.symbolic import canonical


def derive(scene: Scene) -> Equations:
    """Equations of motion by Lagrange's method, with multipliers for every constraint."""
    motions = {m.body.name: m for m in differentiate.body_motions_in_rates(scene)}
    dynamic = dynamic_rates(scene)
    method = _method(scene, motions, dynamic, kinetic_energy(scene, motions) - potential(scene))
    equations = _common_form(scene, method, dynamic)
    return _with_friction(equations) if frictions(scene) else equations


def lagranges_method(scene: Scene) -> LagrangesMethod:
    """SymPy's object for a scene, with the equations formed."""
    motions = {m.body.name: m for m in differentiate.body_motions_in_rates(scene)}
    lagrangian = kinetic_energy(scene, motions) - potential(scene)
    return _method(scene, motions, dynamic_rates(scene), lagrangian)


def _method(
    scene: Scene, motions: dict[str, BodyMotion], dynamic: Dynamic, lagrangian: Expr
) -> LagrangesMethod:
    back = speeds_in_rates(scene)
    constraints = [
        (dynamic.to(scene.rates(c.expression).xreplace(back)), c.holonomic)
        for c in scene.constraints
    ]
    frame = ReferenceFrame("inertial")
    method = LagrangesMethod(
        dynamic.to(lagrangian),
        [dynamic.to(q) for q in scene.q],
        forcelist=_forces(scene, motions, dynamic, frame),
        frame=frame,
        hol_coneqs=[expression for expression, of_position in constraints if of_position],
        nonhol_coneqs=[expression for expression, of_position in constraints if not of_position],
    )
    method.form_lagranges_equations()
    return method


def _with_friction(equations: Equations) -> Equations:
    """The forces hold the reactions that press, which the equations of opened joints give."""
    scene = equations.scene
    contact = pressed(scene, opened_equations(scene, pressing(scene)))
    mass, forcing = contact.put_into(equations.mass, equations.forcing)
    return replace(
        equations.with_matrices(mass=mass, forcing=forcing),
        conjugate=False,
        reactions=contact.solve(scene.ud),
    )


def kinetic_energy(scene: Scene, motions: dict[str, BodyMotion]) -> Expr:
    """T = sum of m v^2 / 2 + omega . I omega / 2, in q and q'."""
    half = Rational(1, 2)
    terms = []
    for motion in motions.values():
        speed = motion.centre.velocity
        terms.append(half * motion.body.mass * Add(*(entry**2 for entry in speed)))
        if motion.turns:
            inertia = inertia_matrix(scene, motion.body, motion.rotation)
            omega = motion.angular_velocity
            terms.append(half * canonical(omega.dot(inertia * omega)))
    return Add(*terms)


def _forces(
    scene: Scene, motions: dict[str, BodyMotion], dynamic: Dynamic, frame: ReferenceFrame
) -> list[tuple[object, object]]:
    """Non-conservative loads on points and frames whose velocities are written in q'.

    SymPy drops, silently, loads on points whose velocities are written in speeds.
    """
    back = speeds_in_rates(scene)
    found: list[tuple[object, object]] = []

    def vector(column: Matrix) -> object:
        entries = [dynamic.to(entry.xreplace(back)) for entry in column]
        return entries[0] * frame.x + entries[1] * frame.y + entries[2] * frame.z

    for load in scene.loads:
        if isinstance(load, CONSERVATIVE):
            continue
        for action in load_actions(scene, load):
            motion = motions[action.body]
            arm = action.at - motion.centre.position
            if action.force != zeros(3, 1):
                point = Point(f"{action.name} on {action.body}")
                speed = motion.centre.velocity + motion.angular_velocity.cross(arm)
                point.set_vel(frame, vector(speed))
                found.append((point, vector(action.force)))
            if action.couple != zeros(3, 1):
                turning = ReferenceFrame(f"{action.name} on {action.body}")
                turning.set_ang_vel(frame, vector(motion.angular_velocity))
                found.append((turning, vector(action.couple)))
    return found


def _common_form(scene: Scene, method: LagrangesMethod, dynamic: Dynamic) -> Equations:
    n, m = len(scene.q), len(scene.constraints)
    mass = tidied(scene, dynamic.back(method.mass_matrix[:, :n]))
    forcing = tidied(scene, dynamic.back(method.forcing))
    names = tuple(Symbol(f"lambda{i + 1}", real=True) for i in range(m))
    matrix, bias, reactions = zeros(0, n), zeros(0, 1), zeros(n, 0)
    if m:
        # The mass matrix carries -B beside M; the full one has A in its last rows.
        reactions = -dynamic.back(method.mass_matrix[:, n:])
        matrix = dynamic.back(method.mass_matrix_full[2 * n :, n : 2 * n])
        bias = dynamic.back(method.forcing_full[2 * n :, :])
    if scene.speeds:
        mass, forcing, reactions, matrix, bias = _in_speeds(
            scene, mass, forcing, reactions, matrix, bias
        )
    matrices = Matrices(mass, forcing, reactions, matrix, bias)
    return Equations(scene, "lagrange_sympy", names, True, textbook=matrices)


def _in_speeds(
    scene: Scene, mass: Matrix, forcing: Matrix, reactions: Matrix, matrix: Matrix, bias: Matrix
) -> tuple[Matrix, Matrix, Matrix, Matrix, Matrix]:
    """The equations in q' carried over to the declared speeds."""
    columns = [scene.coordinate_rates[qd] for qd in scene.qd]
    change = Matrix(columns).jacobian(scene.u)
    table = rate_table(scene)
    still = dict.fromkeys(scene.ud, 0)
    drift = Matrix([rate(column, table).xreplace(still) for column in columns])
    swap = dict(scene.coordinate_rates)
    mass, forcing, reactions, matrix, bias = (
        part.xreplace(swap) for part in (mass, forcing, reactions, matrix, bias)
    )
    return (
        change.T * mass * change,
        change.T * (forcing - mass * drift),
        change.T * reactions,
        matrix * change,
        bias - matrix * drift,
    )
