"""SymPy's own equations of one of its models, beside those that its bodies and loads imply.

    M u' = f of the model        against the scene's accelerations                              (1)
    the same, of the scene without a load, a constraint, ...         where (1) is refuted       (2)

A cause is named where (2) is shown: a load that is dropped or counted twice, a constraint or a
potential energy that is not read, a velocity that is put into a Lagrangian.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import sympy.physics.mechanics as me
from sympy import Derivative, Expr, Float, Matrix, S, Symbol, nan, zeros, zoo
from sympy.physics.vector import dynamicsymbols

from mechanics.checks.admissible import check_scene
from mechanics.checks.energy import kinetic
from mechanics.checks.statements import equal
from mechanics.crosscheck.programs import Programs, derive_rows, same_motion
from mechanics.equations import Equations, Matrices
from mechanics.errors import MechanicsError
from mechanics.importers.sympy_loads import ENERGY
from mechanics.importers.sympy_model import form_equations, is_rigid, written
from mechanics.importers.sympy_system import to_sympy
from mechanics.kernel import Finding, Verdict, undecided
from mechanics.program.builder import Node
from mechanics.program.forward import tangent
from mechanics.program.sympy_reader import read
from mechanics.routes.lagrange_sympy import matrices_of
from mechanics.scene import Force, Gravity, Scene, Torque
from mechanics.scene.declared import decimals
from mechanics.scene.symbols import plain_symbol, plain_table, to_plain

ROUTE = "kane"
NOT_FINITE = (
    "they hold nan: a pivot of SymPy's LU decomposition is zero, or constraints are redundant; form"
    " them with constraint_solver='CRAMER'"
)


def own_equations(scene: Scene, model: Any) -> Equations:
    """M u' = f as SymPy forms it, over the speeds of the scene made from the model.

    Parameters
    ----------
    scene : Scene
        Made by `from_sympy`.
    model : System, KanesMethod or LagrangesMethod
    """
    method = form_equations(model)
    table = _table(scene, method)
    names: tuple[Symbol, ...] = ()
    if isinstance(method, me.LagrangesMethod):
        matrices = matrices_of(method)
        names = tuple(Symbol(f"lambda{k + 1}", real=True) for k in range(matrices[2].cols))
    else:
        matrices = _kane(method)
    speeds = _speeds(method)
    resting = _resting(method)
    plain = [_plain(scene, written(part.xreplace(resting)), table) for part in matrices]
    columns = [plain_name(speed) for speed in speeds]
    mass, forcing, reactions, held, bias = plain
    wide, rows = zeros(mass.rows, len(scene.u)), zeros(held.rows, len(scene.u))
    for k, u in enumerate(scene.u):
        if u.name in columns:
            wide[:, k] = mass[:, columns.index(u.name)]
            rows[:, k] = held[:, columns.index(u.name)]
    for constraint in scene.constraints:
        # Coordinates that stand for what a model says by velocities alone are the scene's.
        if constraint.name.endswith("_rate"):
            form = scene.plain(constraint.expression.diff(dynamicsymbols._t), constraint.name)
            row = Matrix([form]).jacobian(scene.ud)
            rows = rows.col_join(row)
            rest = form.xreplace(dict.fromkeys(scene.ud, 0))
            bias = bias.col_join(Matrix([-rest]))
    return Equations(
        scene, "sympy", names, False, textbook=Matrices(wide, forcing, reactions, rows, bias)
    )


def plain_name(speed: Expr) -> str:
    """Name of a speed, or of the rate of a coordinate, among the scene's plain symbols."""
    if isinstance(speed, Derivative):
        return plain_symbol(speed.expr, 1).name
    return plain_symbol(speed).name


def _speeds(method: Any) -> list[Expr]:
    if isinstance(method, me.LagrangesMethod):
        return [q.diff(dynamicsymbols._t) for q in method.q]
    return list(method.u)


def _resting(method: Any) -> dict[Expr, Expr]:
    """Auxiliary speeds and their rates are zero."""
    speeds = getattr(method, "_uaux", ())
    return {part: S.Zero for u in speeds for part in (u.diff(dynamicsymbols._t), u)}


def _kane(method: Any) -> tuple[Matrix, ...]:
    mass, forcing = method.mass_matrix, method.forcing
    free = len(method.u) - len(method._k_dnh[:, 0] if method._k_dnh else ())
    return (
        mass[:free, :],
        forcing[:free, :],
        zeros(free, 0),
        mass[free:, :],
        forcing[free:, :],
    )


def _table(scene: Scene, method: Any) -> dict[Expr, Expr]:
    speeds = [u for u in _speeds(method) if not isinstance(u, Derivative)]
    return plain_table((*scene.coordinates, *speeds, *scene.inputs))


def _plain(scene: Scene, matrix: Matrix, table: dict[Expr, Expr]) -> Matrix:
    known = {s.name: s for s in (*scene.q, *scene.u, *scene.ud, *scene.parameters)}
    known |= {s.name: s for s in scene.input_symbols}

    def entry(expression: Expr) -> Expr:
        plain = to_plain(decimals(expression), table, "SymPy's equations")
        free = plain.free_symbols - {dynamicsymbols._t}
        named = {s: known.get(s.name, Symbol(s.name, real=True)) for s in free}
        return plain.xreplace(named).xreplace(scene.coordinate_rates)

    return Matrix(matrix.rows, matrix.cols, [entry(e) for e in matrix])


def compare_own(scene: Scene, model: Any, programs: Programs | None = None) -> list[Finding]:
    """Statement (1), and where it is refuted those of (2) that are shown.

    Parameters
    ----------
    model : System, KanesMethod or LagrangesMethod
        What the scene was made from.
    programs : Programs, optional
        Of the scene.
    """
    kind = type(model).__name__
    own = own_equations(scene, model)
    programs = programs or derive_rows(check_scene(scene), [ROUTE])
    subject = f"SymPy's {kind} = its bodies, loads and constraints: accelerations"
    if any(part.has(nan, zoo) for part in own.system):
        # A finding, and not an error: the scene that was made from the model may be right.
        return [undecided(subject, NOT_FINITE)]
    found = same_motion(subject, programs, next(iter(programs.routes)), own)
    if found.verdict is not Verdict.REFUTED:
        return [found]
    method = form_equations(model)
    if isinstance(method, me.LagrangesMethod):
        causes = list(_put_in(scene, method, programs))
    else:
        causes = list(_accelerations(scene, method, programs))
    return [found, *(causes or _floats(scene, method, programs) or _causes(scene, own, kind))]


def _floats(scene: Scene, method: Any, programs: Programs) -> list[Finding]:
    """Whether SymPy's equations are those of the scene once their numbers are exact."""
    if not any(part.has(Float) for part in (method.mass_matrix, method.forcing)):
        return []
    subject = (
        "the cause: numbers of the model are floats, whose products SymPy rounds: with exact"
        " numbers its equations = those"
    )
    exact = own_equations(scene, to_sympy(scene))
    found = same_motion(subject, programs, next(iter(programs.routes)), exact)
    return [found] if found.shown else []


def _put_in(scene: Scene, method: Any, programs: Programs) -> Iterator[Finding]:
    """Whether L = T - V only where motion constraints hold: they were put into it."""
    mechanism = programs.mechanism
    if all(c.holonomic for c in scene.constraints):
        return
    (energy,) = _plain(scene, Matrix([written(method._L[0])]), _table(scene, method))
    still = energy.xreplace(dict.fromkeys(scene.u, S.Zero))
    left, rest = read(mechanism.builder, (energy, still))
    found = equal(
        "the cause: the Lagrangian is that of the bodies where the motion constraints hold, which"
        " are put into it: add multipliers for them instead",
        mechanism,
        [left],
        [kinetic(mechanism) + rest],
    )
    if found.shown:
        yield found


def _accelerations(scene: Scene, method: Any, programs: Programs) -> Iterator[Finding]:
    """Accelerations that are set and are not the derivatives of the velocities that are."""
    root, mechanism, table = method._inertial, programs.mechanism, _table(scene, method)
    resting = _resting(method)

    def nodes(vector: Any) -> tuple[Node, ...]:
        column = _plain(scene, vector.to_matrix(root).xreplace(resting), table)
        return read(mechanism.builder, list(column))

    for body in method.bodies:
        point, frame = body.masscenter, body.frame if is_rigid(body) else None
        pairs = [(point.name, point._acc_dict.get(root), point._vel_dict.get(root), "")]
        if frame is not None:
            given = frame._ang_acc_dict.get(root), frame._ang_vel_dict.get(root)
            pairs.append((frame.name, *given, "angular "))
        for name, acceleration, velocity, kind in pairs:
            if acceleration is None or velocity is None:
                continue
            rates = tangent(nodes(velocity), mechanism.rates)
            subject = (
                f"the cause: the {kind}acceleration of {name} that is set = the derivative of its"
                f" {kind}velocity"
            )
            found = equal(subject, mechanism, nodes(acceleration), rates)
            if found.verdict is Verdict.REFUTED:
                yield found


@dataclass(frozen=True)
class Change:
    """What SymPy's class may have read instead of the scene, in words."""

    words: str
    scene: Scene


def _causes(scene: Scene, own: Equations, kind: str) -> Iterator[Finding]:
    """The first change of each sort for which SymPy's equations are those of the scene."""
    for change in _changes(scene):
        try:
            programs = derive_rows(check_scene(change.scene), [ROUTE])
        except MechanicsError:
            continue
        equations = replace(own, scene=change.scene)
        subject = f"the cause: {kind} {change.words}: its equations = those"
        found = same_motion(subject, programs, ROUTE, equations)
        if found.shown:
            yield found
            return


def _changes(scene: Scene) -> Iterator[Change]:
    """One load after the other dropped or doubled, all of a kind, constraints left out."""
    loads = scene.loads
    for k, load in enumerate(loads):
        rest = (*loads[:k], *loads[k + 1 :])
        told = "does not count the potential energy" if _energy(load) else "drops the load"
        yield Change(f"{told} {load.name}", replace(scene, loads=rest))
    for k, load in enumerate(loads):
        doubled = (*loads[:k], _twice(load), *loads[k + 1 :])
        yield Change(f"counts {load.name} twice, as a load and as a potential energy",
                     replace(scene, loads=doubled))  # fmt: skip
    forces = tuple(load for load in loads if not isinstance(load, Force | Torque))
    if len(loads) - len(forces) > 1:
        dropped = [load.name for load in loads if load not in forces]
        yield Change(f"drops the loads {', '.join(dropped)}", replace(scene, loads=forces))
    if len(loads) > 1:
        yield Change("drops all loads", replace(scene, loads=()))
    stated = [c for c in scene.constraints if not c.name.endswith("_rate")]
    positions = [c for c in stated if c.holonomic]
    for gone in (*([c] for c in stated), positions, stated):
        if gone:
            names = ", ".join(c.name for c in gone)
            yield Change(f"does not keep {names}", _without(scene, gone))


def _energy(load: Any) -> bool:
    return bool(load.name.startswith(ENERGY))


def _twice(load: Any) -> Any:
    if isinstance(load, Gravity):
        return replace(load, field=2 * load.field)
    return replace(load, vector=2 * load.vector)


def _without(scene: Scene, gone: Any) -> Scene:
    names = {c.name for c in gone}
    lost = {name for c in gone for name in c.reactions}
    return replace(
        scene,
        constraints=tuple(c for c in scene.constraints if c.name not in names),
        reactions=tuple(r for r in scene.reactions if r.name not in lost),
    )
