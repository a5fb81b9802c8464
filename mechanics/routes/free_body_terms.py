"""Momentum equations of every isolated body, term by term in SymPy: what blame looks at.

    sum F = dp/dt,    sum tau_C = dH_C/dt        for each body, along the directions in use

Velocities come from `mechanics.kinematics.textbook.differentiate`.
"""

from collections.abc import Sequence

from sympy import Add, Expr, Matrix, S, Symbol

from mechanics.equations import FreeBodyRow
from mechanics.kinematics.textbook.directions import AXES, Directions, used_directions
from mechanics.kinematics.textbook.motion import BodyMotion, inertia_matrix
from mechanics.scene import RigidBody, Scene
from mechanics.scene.actions import Action, acting_reactions, applied_actions, by_body, moment
from mechanics.scene.geometry import components
from mechanics.scene.rates import rate_table, rates
from mechanics.scene.topology import Tree
from mechanics.symbolic import tidy


def free_body_rows(
    scene: Scene, bodies: Tree, motions: dict[str, BodyMotion]
) -> tuple[FreeBodyRow, ...]:
    """Momentum equations of every isolated body, in tree order."""
    applied = applied_actions(scene)
    reactions = acting_reactions(scene)
    units = [action for pair in reactions.values() for action in pair]
    directions = used_directions(tuple(motions.values()), (*applied, *units))
    loads = by_body(applied)
    rows: list[FreeBodyRow] = []
    for name in bodies.order:
        held = {
            symbol: action
            for symbol, pair in reactions.items()
            for action in pair
            if action.body == name
        }
        motion = motions[name]
        axes = _axes(scene, bodies, name, directions)
        rows += _linear(motion, axes, loads.get(name, []), held)
        if motion.turns:
            rows += _angular(scene, motion, directions, loads.get(name, []), held)
    return tuple(rows)


def _axes(
    scene: Scene, bodies: Tree, name: str, directions: Directions
) -> list[tuple[str, Matrix]]:
    """Directions for linear momentum: those of the reactions at the inboard joint.

    A joint whose reactions are given in a turning frame is written along that frame, so that each
    row holds one of them and elimination divides by nothing.
    """
    frames = {
        frame
        for reaction in bodies.joints[name]
        if reaction.at is not None
        for frame, _ in components(reaction.along)
    }
    frame = frames.pop() if len(frames) == 1 else scene.frame
    rotation = scene.rotation(frame)
    axes = [(f"{frame.name}.{AXES[i]}", rotation[:, i]) for i in range(3)]
    return [
        (axis, column)
        for axis, column in axes
        if any(column[i] != 0 for i in directions.translation)
    ]


def _linear(
    motion: BodyMotion,
    axes: Sequence[tuple[str, Matrix]],
    loads: Sequence[Action],
    held: dict[Symbol, Action],
) -> list[FreeBodyRow]:
    mass, centre = motion.body.mass, motion.centre
    return [
        FreeBodyRow(
            motion.body.name,
            "linear",
            along,
            axis,
            momentum=mass * _dot(centre.velocity, along),
            rate=mass * _dot(centre.acceleration, along),
            applied=Add(*(_dot(load.force, along) for load in loads)),
            coefficients=_nonzero({s: _dot(unit.force, along) for s, unit in held.items()}),
        )
        for axis, along in axes
    ]


def _angular(
    scene: Scene,
    motion: BodyMotion,
    directions: Directions,
    loads: Sequence[Action],
    held: dict[Symbol, Action],
) -> list[FreeBodyRow]:
    if not isinstance(motion.body, RigidBody):
        return []
    centre = motion.centre.position
    momentum = inertia_matrix(scene, motion.body, motion.rotation) * motion.angular_velocity
    growth = rates(momentum, rate_table(scene))
    torque = sum((moment(load, centre) for load in loads), Matrix.zeros(3, 1))
    arms = {symbol: moment(unit, centre) for symbol, unit in held.items()}
    return [
        FreeBodyRow(
            motion.body.name,
            "angular",
            Matrix([int(i == k) for i in range(3)]),
            f"{scene.frame.name}.{AXES[k]}",
            momentum=momentum[k],
            rate=growth[k],
            applied=torque[k],
            coefficients=_nonzero({symbol: arm[k] for symbol, arm in arms.items()}),
        )
        for k in directions.rotation
    ]


def _dot(vector: Matrix, along: Matrix) -> Expr:
    return Add(*(vector[i] * along[i] for i in range(3) if along[i] != 0 and vector[i] != 0))


def _nonzero(coefficients: dict[Symbol, Expr]) -> tuple[tuple[Symbol, Expr], ...]:
    """Coefficients in the normal form: one that cancels must not be taken for a pivot."""
    tidied = {symbol: tidy(value) for symbol, value in coefficients.items()}
    return tuple((symbol, value) for symbol, value in tidied.items() if value != S.Zero)
