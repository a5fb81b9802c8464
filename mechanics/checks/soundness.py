"""Whether a scene with constraints can be right, at points where they hold.

Scenes without constraints are checked as programs: `mechanics.checks.programs.admissible`.

ideal       the power of a unit of each reaction vanishes on the velocities the scene admits
complete    rank of the reactions = freedoms of the isolated bodies - independent speeds
regular     the mass matrix resists every motion that the constraints admit
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sympy import Add, Expr, Matrix, S, Symbol

from mechanics.checks.metric import metric
from mechanics.checks.sliding import check_sliding
from mechanics.errors import ExpressionError, SceneError
from mechanics.exact import collect_linear, generic_rank, independent_rows, is_zero
from mechanics.kinematics.chain import body_motions
from mechanics.kinematics.constraints import constraint_rows, velocity_forms
from mechanics.kinematics.directions import AXES, Directions, used_directions
from mechanics.kinematics.manifold import on_the_manifold
from mechanics.kinematics.motion import BodyMotion
from mechanics.scene import RigidBody, Scene
from mechanics.scene.actions import Action, applied_actions, moment, unit_reactions
from mechanics.scene.loads import TorsionSpring
from mechanics.scene.rates import rate, rate_table
from mechanics.scene.topology import multipliers


@dataclass(frozen=True)
class Freedom:
    """One freedom of one isolated body: its partial velocities, and what each reaction does to it.

    Attributes
    ----------
    body : str
    words : str
        ``"translation along x"``.
    partial : list of Expr
        Coefficients of u in the velocity component.
    reactions : list of Expr
        Component of a unit of each reaction.
    """

    body: str
    words: str
    partial: list[Expr]
    reactions: list[Expr]


def check_sound(scene: Scene) -> None:
    """Refuse a scene that cannot be right.

    Raises
    ------
    SceneError
        For redundant constraints, a reaction that does work, reactions that are incomplete or
        redundant, a scalar inertia in a scene that leaves its plane, a singular mass matrix.
    """
    motions = {motion.body.name: motion for motion in body_motions(scene)}
    reactions = unit_reactions(scene)
    units = [action for pair in reactions.values() for action in pair]
    directions = used_directions(tuple(motions.values()), (*applied_actions(scene), *units))
    _linear_constraints(scene)
    matrix, _ = constraint_rows(scene)
    _redundant(scene, matrix)
    _torsion(scene, motions)
    check_sliding(scene, motions)
    _scalar_inertias(scene, motions, directions)
    freedoms = _freedoms(scene, motions, reactions, directions)
    powers = _powers(scene, freedoms, tuple(reactions))
    _ideal(scene, powers, matrix)
    _complete(scene, freedoms, tuple(reactions))
    _maintained(scene, powers)
    _regular(scene, motions, matrix)


def _linear_constraints(scene: Scene) -> None:
    for form, constraint in zip(velocity_forms(scene), scene.constraints, strict=True):
        try:
            coefficients, rest = collect_linear(form, scene.u)
        except ExpressionError as error:
            raise SceneError(
                f"constraint {constraint.name}: it is not linear in the speeds: {error}"
            ) from None
        if any(e.free_symbols & set(scene.ud) for e in (*coefficients, rest)):
            raise SceneError(
                f"constraint {constraint.name}: it holds accelerations: state it for coordinates or"
                " for their rates"
            )
        if all(entry == 0 for entry in coefficients):
            raise SceneError(
                f"constraint {constraint.name}: it restricts no speed: is it an identity?"
            )


def _redundant(scene: Scene, matrix: Matrix) -> None:
    kept = independent_rows(matrix.tolist()) if matrix.rows else []
    redundant = [c.name for i, c in enumerate(scene.constraints) if i not in kept]
    if redundant:
        others = [c.name for i, c in enumerate(scene.constraints) if i in kept]
        raise SceneError(
            f"{scene.name}: redundant constraints: {', '.join(redundant)} follow from"
            f" {', '.join(others)}: remove them with their reactions"
        )


def _scalar_inertias(scene: Scene, motions: dict[str, BodyMotion], directions: Directions) -> None:
    if directions.normal is not None:
        return
    for name, motion in motions.items():
        body = motion.body
        if isinstance(body, RigidBody) and motion.turns and isinstance(body.inertia, Expr):
            raise SceneError(
                f"body {name}: its inertia {body.inertia} is a scalar, but the scene leaves its"
                " plane: give a Dyadic about the mass centre"
            )


def _torsion(scene: Scene, motions: Mapping[str, BodyMotion]) -> None:
    """The angle of a torsion spring grows with the turning of `on` relative to `by`."""
    for load in scene.loads:
        if not isinstance(load, TorsionSpring):
            continue
        turning = motions[load.on].angular_velocity
        if load.by is not None:
            turning = turning - motions[load.by].angular_velocity
        grown = turning.dot(scene.vector(load.axis, load.name))
        counted = rate(scene.plain(load.angle, load.name), rate_table(scene))
        if is_zero(grown - counted) is False:
            raise SceneError(
                f"load {load.name}: the angle {load.angle} is not how far {load.on!r} turns about"
                f" {load.axis} relative to {load.by or 'the ground'!r}: correct the angle, its"
                " sign, or the axis"
            )


def _freedoms(
    scene: Scene,
    motions: dict[str, BodyMotion],
    reactions: dict[Symbol, list[Action]],
    directions: Directions,
) -> list[Freedom]:
    found = []
    for name, motion in motions.items():
        held = [
            next((action for action in pair if action.body == name), None)
            for pair in reactions.values()
        ]
        centre = motion.centre.position
        kinds = [("translation along", motion.centre.velocity, directions.translation, "force")]
        if motion.turns:
            omega = motion.angular_velocity
            kinds.append(("rotation about", omega, directions.rotation, "moment"))
        for words, velocity, axes, kind in kinds:
            for i in axes:
                coefficients, _ = collect_linear(velocity[i], scene.u)
                row = [
                    S.Zero if unit is None
                    else unit.force[i] if kind == "force"
                    else moment(unit, centre)[i]
                    for unit in held
                ]  # fmt: skip
                found.append(Freedom(name, f"{words} {AXES[i]}", list(coefficients), row))
    return found


def _powers(
    scene: Scene, freedoms: Sequence[Freedom], symbols: Sequence[Symbol]
) -> dict[Symbol, list[Expr]]:
    """For each reaction the power of a unit of it, as coefficients of u."""
    return {
        symbol: [
            Add(*(f.partial[i] * f.reactions[j] for f in freedoms)) for i in range(len(scene.u))
        ]
        for j, symbol in enumerate(symbols)
    }


def _ideal(scene: Scene, powers: Mapping[Symbol, list[Expr]], matrix: Matrix) -> None:
    """The power of a unit is a combination of the constraints' rows: zero where they hold."""
    closed = on_the_manifold(scene)
    for symbol, power in powers.items():
        if generic_rank([*matrix.tolist(), power], closed) > matrix.rows:
            raise SceneError(
                f"reaction {symbol}: it does work on velocities that the scene admits: correct its"
                " point, its direction or its bodies, or declare it as a load"
            )


def _maintained(scene: Scene, powers: Mapping[Symbol, list[Expr]]) -> None:
    """The reactions that constraints name act against their violation, each in its own way."""
    kept = multipliers(scene)
    closed = on_the_manifold(scene)
    independent = independent_rows([powers[symbol] for symbol in kept], closed)
    for i, constraint in enumerate(scene.constraints):
        if i not in independent:
            raise SceneError(
                f"constraint {constraint.name}: the reaction {kept[i]} does not maintain it: name"
                " the one that does work when it is violated"
            )


def _complete(scene: Scene, freedoms: Sequence[Freedom], symbols: Sequence[Symbol]) -> None:
    wanted = len(freedoms) - scene.degrees_of_freedom
    columns = [[f.reactions[j] for f in freedoms] for j in range(len(symbols))]
    closed = on_the_manifold(scene)
    independent = independent_rows(columns, closed)
    if len(independent) < len(columns):
        extra = ", ".join(str(symbols[j]) for j in range(len(columns)) if j not in independent)
        raise SceneError(
            f"{scene.name}: the reactions {extra} follow from the others, so no equation of motion"
            " determines them: remove them, or let a body or joint give way"
        )
    if len(independent) == wanted:
        return
    # A freedom that neither a reaction holds nor a speed moves is the one that was forgotten.
    moved = [[f.partial[i] for f in freedoms] for i in range(len(scene.u))]
    spanned = [*columns, *moved]
    have = generic_rank(spanned, closed)
    for k, freedom in enumerate(freedoms):
        alone = [[S(int(i == k)) for i in range(len(freedoms))]]
        if generic_rank([*spanned, *alone], closed) > have:
            raise SceneError(
                f"{scene.name}: the reactions are incomplete ({len(independent)} of {wanted}):"
                f" nothing holds body {freedom.body} in {freedom.words}: declare the reaction"
            )
    raise SceneError(
        f"{scene.name}: {len(independent)} independent reactions for {len(freedoms)} freedoms of"
        f" the isolated bodies and {scene.degrees_of_freedom} independent speeds: {wanted} wanted"
    )


def _regular(scene: Scene, motions: dict[str, BodyMotion], matrix: Matrix) -> None:
    """[[M, A^T], [A, 0]] has full rank, with M = sum J^T m J."""
    mass = metric(scene, tuple(motions.values()))
    n, c = len(scene.u), matrix.rows
    if c:
        lower = matrix.row_join(Matrix.zeros(c, c))
        mass = mass.row_join(matrix.T).col_join(lower)
    rows = independent_rows(mass.tolist(), on_the_manifold(scene))
    if len(rows) < n + c:
        free = next(i for i in range(n + c) if i not in rows)
        speed = scene.u[free] if free < n else "the constraints"
        raise SceneError(
            f"{scene.name}: the mass matrix is singular: nothing resists a change of {speed}:"
            " is a mass or an inertia zero that must not be?"
        )
