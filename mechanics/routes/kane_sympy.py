"""Kane's equations, by SymPy's `KanesMethod` on SymPy's own kinematics.

    F_r + F_r* = 0,    F_r = sum v_r . F + omega_r . T,    F_r* = - sum m a . v_r + ...

Constraints make speeds dependent. Friction enters with the reaction that presses as an unknown,
which an auxiliary speed gives.
"""

from collections.abc import Sequence

from sympy import Expr, Matrix, Symbol, zeros
from sympy.physics.mechanics import KanesMethod
from sympy.physics.vector import dynamicsymbols

from mechanics.equations import Equations, Matrices
from mechanics.routes.friction_reactions import Reactions, opened, pressed, pressing
from mechanics.routes.sympy_model import SympyModel, cramer, plain, tidied
from mechanics.scene import Scene
from mechanics.scene.actions import frictions
from mechanics.symbolic import independent_rows

NAME = "kane_sympy"


def derive(scene: Scene) -> Equations:
    """Equations of motion by Kane's method; dependent speeds where there are constraints."""
    method = kanes_method(scene)
    n, free = len(scene.u), len(scene.u) - len(scene.constraints)
    order = [[*method.u].index(u) for u in _speeds(scene)]
    # SymPy orders the columns independent speeds first.
    square = _plain(scene, method.mass_matrix).extract(list(range(n)), order)
    right = _plain(scene, method.forcing)
    mass, forcing = square[:free, :], right[:free, :]
    reactions: Reactions = ()
    if frictions(scene):
        contact = pressed(scene, opened_equations(scene, pressing(scene)))
        mass, forcing = contact.put_into(mass, forcing)
        reactions = contact.solve(scene.ud)
    matrices = Matrices(mass, forcing, zeros(free, 0), square[free:, :], right[free:, :])
    conjugate = free == n and not reactions
    return Equations(scene, NAME, (), conjugate, textbook=matrices, reactions=reactions)


def kanes_method(scene: Scene) -> KanesMethod:
    """SymPy's object for a scene, with the equations formed."""
    model = SympyModel(scene)
    # LU divides by zero at ordinary states.
    method = KanesMethod(
        model.frame, **arguments(model), kd_eqs_solver=cramer, constraint_solver="CRAMER"
    )
    method.kanes_equations(list(model.bodies.values()), model.loads(scene.loads))
    return method


def arguments(model: SympyModel) -> dict[str, list[Expr]]:
    """Coordinates, speeds, kinematical equations and constraints, as KanesMethod names them."""
    scene, speeds = model.scene, _speeds(model.scene)
    definitions = [model.scalar(value) for _, value in scene.speeds] or [
        q.diff(dynamicsymbols._t) for q in scene.coordinates
    ]
    turning = {u for rotation in scene.rotations for u in rotation.speeds}
    pairs = zip(speeds, definitions, strict=True)
    kinematic = [value - u for u, value in pairs if u not in turning]
    for rotation in scene.rotations:
        rates = zip(rotation.coordinates, rotation.rates, strict=True)
        kinematic += [q.diff(dynamicsymbols._t) - rate for q, rate in rates]
    if scene.constraints:
        coordinates, speeds, options = _constraints(model, speeds, kinematic)
        return {"q_ind": coordinates, "u_ind": speeds, "kd_eqs": kinematic, **options}
    return {"q_ind": list(scene.coordinates), "u_ind": speeds, "kd_eqs": kinematic}


def _constraints(
    model: SympyModel, speeds: Sequence[Expr], kinematic: Sequence[Expr]
) -> tuple[list[Expr], list[Expr], dict[str, list[Expr]]]:
    """Independent coordinates and speeds, and what KanesMethod is told of the others."""
    scene, t = model.scene, dynamicsymbols._t
    stated = [(model.scalar(c.expression), c.holonomic) for c in scene.constraints]
    forms = [one.diff(t) if holonomic else one for one, holonomic in stated]
    free = KanesMethod(
        model.frame, scene.coordinates, speeds, kd_eqs=kinematic, kd_eqs_solver=cramer
    )
    rates = Matrix(forms).xreplace(free.kindiffdict()).jacobian(speeds)
    last = dependent_columns(_plain(scene, rates))
    positions = [one for one, holonomic in stated if holonomic]
    u_dependent = [speeds[i] for i in last]
    q_dependent = [scene.coordinates[i] for i in last][len(last) - len(positions) :]
    return (
        [q for q in scene.coordinates if q not in q_dependent],
        [u for u in speeds if u not in u_dependent],
        {
            "u_dependent": u_dependent,
            "velocity_constraints": forms,
            "q_dependent": q_dependent,
            "configuration_constraints": positions,
        },
    )


def _speeds(scene: Scene) -> list[Expr]:
    """The declared speeds; where u is q', dynamic symbols of their own."""
    return [u for u, _ in scene.speeds] or [dynamicsymbols(u.name) for u in scene.u]


def _plain(scene: Scene, matrix: Matrix) -> Matrix:
    t = dynamicsymbols._t
    table: dict[Expr, Expr] = {}
    for function, u, ud in zip(_speeds(scene), scene.u, scene.ud, strict=True):
        table |= {function: u, function.diff(t): ud}
    return tidied(scene, plain(scene, matrix, table))


def dependent_columns(matrix: Matrix) -> list[int]:
    """Indices of the last speeds that the constraints can be solved for."""
    backwards = list(range(matrix.cols))[::-1]
    columns = [list(matrix[:, i]) for i in backwards]
    return sorted(backwards[k] for k in independent_rows(columns))


def opened_equations(scene: Scene, wanted: Sequence[Symbol]) -> tuple[tuple[Symbol, Expr], ...]:
    """For each of the reactions an equation ``expression = 0`` that holds it.

    Its joint is opened by an auxiliary speed along the reaction, and the reactions enter as loads.
    Kane's method is given the auxiliary speeds only; all else is a function of time.

    Returns
    -------
    tuple of (Symbol, Expr)
        In q, u, u' and the reactions, plain symbols.
    """
    distances = [dynamicsymbols(f"opened_{symbol.name}") for symbol in wanted]
    speeds = [dynamicsymbols(f"opening_{symbol.name}") for symbol in wanted]
    model = SympyModel(scene, {}, opened(scene, wanted, distances))
    method = KanesMethod(
        model.frame,
        distances,
        speeds,
        kd_eqs=[w.diff() - u for w, u in zip(distances, speeds, strict=True)],
    )
    loads = [*model.loads(scene.loads), *model.reactions()]
    active, inertial = method.kanes_equations(list(model.bodies.values()), loads)
    t = dynamicsymbols._t
    closed = dict.fromkeys((*distances, *speeds, *(u.diff(t) for u in speeds)), 0)
    rows = (active + inertial).xreplace(closed)
    return tuple((s, scene.plain(row)) for s, row in zip(wanted, rows, strict=True))
