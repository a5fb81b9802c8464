"""Lagrange's equations, by SymPy's `LagrangesMethod` on SymPy's own kinematics.

    d/dt (dL/dq') - dL/dq = Q + A^T lambda,    L = T - V

Conservative loads enter as their potential, everything else as a generalized force. Where speeds
are not q', the result is carried over by q' = N u + n:

    N^T M N u' = N^T (f - M (N' u + n')) + N^T A^T lambda

so that the rows stay power-conjugate to u. Friction enters with the reaction that presses as an
unknown, which the equation of an opened joint gives.
"""

import re
from collections.abc import Sequence
from dataclasses import replace

import sympy.physics.mechanics as me
from sympy import Dummy, Expr, Matrix, Symbol, zeros
from sympy.physics.mechanics import LagrangesMethod
from sympy.physics.vector import dynamicsymbols

from mechanics.equations import Equations, Matrices
from mechanics.routes.friction_reactions import opened, pressed, pressing
from mechanics.routes.sympy_model import SympyModel, cramer, plain, tidied
from mechanics.scene import Scene
from mechanics.scene.actions import frictions
from mechanics.scene.loads import CONSERVATIVE


def derive(scene: Scene) -> Equations:
    """Equations of motion by Lagrange's method, with multipliers for every constraint."""
    equations = _common_form(scene, lagranges_method(scene))
    return _with_friction(equations) if frictions(scene) else equations


def lagranges_method(scene: Scene) -> LagrangesMethod:
    """SymPy's object for a scene, with the equations formed."""
    model = SympyModel(scene, _replaced(scene))
    potential = sum(model.potential(load) for load in scene.loads if isinstance(load, CONSERVATIVE))
    others = [load for load in scene.loads if not isinstance(load, CONSERVATIVE)]
    constraints = [(model.scalar(c.expression), c.holonomic) for c in scene.constraints]
    method = LagrangesMethod(
        _kinetic_energy(model) - potential,
        list(scene.coordinates),
        forcelist=model.loads(others),
        frame=model.frame,
        hol_coneqs=[expression for expression, of_position in constraints if of_position],
        nonhol_coneqs=[expression for expression, of_position in constraints if not of_position],
    )
    method.form_lagranges_equations()
    return method


def _kinetic_energy(model: SympyModel) -> Expr:
    return me.kinetic_energy(model.frame, *model.bodies.values())


def _replaced(scene: Scene) -> dict[Expr, Expr]:
    """Speeds in q and q', for which SymPy drops loads silently, and names that SymPy takes.

    SymPy names its multipliers lam1, lam2, ...: a parameter of that name would merge with one.
    """
    clashing = [s for s in scene.parameters if re.fullmatch(r"lam\d+", s.name)]
    return dict(scene.speeds) | {s: Dummy(s.name, **s.assumptions0) for s in clashing}


def _common_form(scene: Scene, method: LagrangesMethod) -> Equations:
    names = tuple(Symbol(f"lambda{i + 1}", real=True) for i in range(len(scene.constraints)))
    parts = matrices_of(method)
    if scene.speeds:
        parts = _in_speeds(scene, *parts)
    back = {dummy: symbol for symbol, dummy in _replaced(scene).items() if symbol.is_Symbol}
    mass, forcing, reactions, matrix, bias = (plain(scene, part, back) for part in parts)
    matrices = Matrices(tidied(scene, mass), tidied(scene, forcing), reactions, matrix, bias)
    return Equations(scene, "lagrange_sympy", names, True, textbook=matrices)


def matrices_of(method: LagrangesMethod) -> tuple[Matrix, ...]:
    """M, f, B, A and b with M q'' = f + B lambda, A q'' = b."""
    n, m = len(method.q), len(method.coneqs)
    mass, forcing = method.mass_matrix[:, :n], method.forcing
    if not m:
        return mass, forcing, zeros(n, 0), zeros(0, n), zeros(0, 1)
    # The mass matrix carries -B beside M; the full one has A in its last rows.
    matrix = method.mass_matrix_full[2 * n :, n : 2 * n]
    return mass, forcing, -method.mass_matrix[:, n:], matrix, method.forcing_full[2 * n :, :]


def _in_speeds(
    scene: Scene, mass: Matrix, forcing: Matrix, reactions: Matrix, matrix: Matrix, bias: Matrix
) -> tuple[Matrix, ...]:
    """The equations in q' carried over to the declared speeds."""
    t, model = dynamicsymbols._t, SympyModel(scene)
    table = {q.diff(t): rate for rotation in scene.rotations
             for q, rate in zip(rotation.coordinates, rotation.rates, strict=True)}  # fmt: skip
    turning = {u for rotation in scene.rotations for u in rotation.speeds}
    others = [(u, model.scalar(value)) for u, value in scene.speeds if u not in turning]
    qd = [q.diff(t) for q in scene.coordinates]
    if unknown := [rate for rate in qd if rate not in table]:
        definitions = Matrix([value for _, value in others])
        rest = definitions.xreplace(dict.fromkeys(unknown, 0))
        solved = cramer(definitions.jacobian(unknown), Matrix([u for u, _ in others]) - rest)
        table |= zip(unknown, solved, strict=True)
    rates = Matrix([table[rate] for rate in qd])
    speeds = Matrix([u for u, _ in scene.speeds])
    change = rates.jacobian(speeds)
    drift = rates.diff(t).xreplace(dict.fromkeys(speeds.diff(t), 0)).xreplace(table)
    mass, forcing, reactions, matrix, bias = (
        part.xreplace(table) for part in (mass, forcing, reactions, matrix, bias)
    )
    return (
        change.T * mass * change,
        change.T * (forcing - mass * drift),
        change.T * reactions,
        matrix * change,
        bias - matrix * drift,
    )


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


def opened_equations(scene: Scene, wanted: Sequence[Symbol]) -> tuple[tuple[Symbol, Expr], ...]:
    """For each of the reactions an equation ``expression = 0`` that holds it.

    Lagrange's equation of a joint that is opened by w along the reaction, at w = w' = w'' = 0;
    the reactions enter as loads.

    Returns
    -------
    tuple of (Symbol, Expr)
        In q, u, u' and the reactions, plain symbols.

    Raises
    ------
    SingularError
        When a reaction closes a loop of bodies.
    """
    t = dynamicsymbols._t
    distances = [dynamicsymbols(f"opened_{symbol.name}") for symbol in wanted]
    model = SympyModel(scene, {}, opened(scene, wanted, distances))
    method = LagrangesMethod(
        _kinetic_energy(model),
        distances,
        forcelist=[*model.loads(scene.loads), *model.reactions()],
        frame=model.frame,
    )
    rows = method.form_lagranges_equations()
    closed = {w.diff(t, order) if order else w: 0 for w in distances for order in range(3)}
    return tuple(
        (symbol, scene.plain(row.xreplace(closed)))
        for symbol, row in zip(wanted, rows, strict=True)
    )
