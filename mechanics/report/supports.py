"""What holds and drives the bodies of a drawing: ground, springs, dampers, forces, gravity."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from sympy import Expr, Mul, Symbol
from sympy.physics.vector import Point

from mechanics.report import ink
from mechanics.report.notation import in_order, svg_name
from mechanics.report.projection import View, normal, unit
from mechanics.scene import (
    Coulomb,
    Damper,
    Force,
    Gravity,
    Load,
    RigidBody,
    Spring,
    Torque,
    TorsionSpring,
)
from mechanics.scene.actions import carrier_of
from mechanics.scene.joints import Rope
from mechanics.scene.reactions import Reaction

BLOCK = (54.0, 34.0)
LANE = 22.0
"""Between springs and dampers that stand side by side, in pixels."""
SLACK = 84.0
"""Length of a spring that is drawn where it would have none, in pixels."""


@dataclass(frozen=True)
class Paper:
    """From metres on paper (y upwards) to pixels (y downwards).

    Attributes
    ----------
    scale : float
        In pixels per m.
    shift, middle : ndarray
        Pixel of the origin, and of the middle of the drawing.
    """

    scale: float
    shift: np.ndarray
    middle: np.ndarray

    def place(self, point: np.ndarray) -> np.ndarray:
        """Pixel of a point."""
        return self.shift + self.scale * point * np.array([1, -1])

    def turn(self, direction: np.ndarray) -> np.ndarray:
        """A direction in pixels, with its length in m."""
        return direction * np.array([1, -1])


def ground(view: View, paper: Paper, moving: bool = False) -> str:
    """Pins, rails and planes where the ground reacts, and ropes.

    In a picture that moves rails and planes rest, and go through all of it.
    """
    groups: dict[Point, list[Reaction]] = {}
    ropes = [joint for joint in view.scene.joints if isinstance(joint, Rope)]
    tensions = [reaction for rope in ropes for reaction in rope.reactions]
    drawn = [ink.path([paper.place(view.point(p)) for _, p in rope.ends], "line") for rope in ropes]
    for reaction in view.scene.reactions:
        if reaction.by is None and reaction.at is not None and reaction not in tensions:
            groups.setdefault(reaction.at, []).append(reaction)
    planes: list[Point] = []
    for at, held in groups.items():
        if _is_on_plane(view, at, held):
            planes.append(at)
        else:
            drawn.append(_support(view, paper, at, held, moving))
    if planes:
        around = [paper.middle] if moving else [paper.place(view.point(at)) for at in planes]
        drawn.insert(0, _plane(view, around, (0.74 if moving else 0.34) * paper.middle[0]))
    return "".join(drawn)


def _support(view: View, paper: Paper, at: Point, held: list[Reaction], moving: bool) -> str:
    place = paper.place(view.point(at))
    down = np.array([0.0, 1.0]) if view.down is None else paper.turn(view.down)
    pushes = [unit(paper.turn(view.direction(reaction.along))) for reaction in held]
    push = max(pushes, key=lambda p: abs(p @ down))
    into = push if push @ down > 0 else -push
    if _is_pin(view, at, held):
        # A ring that turns about its middle is held where it ends.
        rims = view.outlines(view.scene.body(held[0].on))
        pixels = [paper.place(point) for points in rims for point in points]
        return ink.pin(max([place, *pixels], key=lambda pixel: float(pixel @ into)), into)
    if _is_led(view, held):
        return ""  # a point mass on a string, a rod or a curve: its trace is drawn, not which
    body = view.scene.body(held[0].on)
    block = not isinstance(body, RigidBody) or body.centre == at
    foot = place + (BLOCK[1] / 2) * into if block else place
    if moving and not any(view.turns(reaction.along) for reaction in held):
        along = normal(into)
        return ink.hatching(foot - along * (along @ (foot - paper.middle)), along, into, 300)
    return ink.hatching(foot, normal(into), into, 110 if len(pushes) > 1 else 72)


def _is_pin(view: View, at: Point, held: list[Reaction]) -> bool:
    closing = {name for c in view.scene.constraints if c.holonomic for name in c.reactions}
    return not view.moves(at) or closing >= {reaction.name for reaction in held}


def _is_led(view: View, held: list[Reaction]) -> bool:
    """Whether a point mass is held in directions that turn."""
    body = view.scene.body(held[0].on)
    return not isinstance(body, RigidBody) and all(view.turns(r.along) for r in held)


def _is_on_plane(view: View, at: Point, held: list[Reaction]) -> bool:
    """Whether a body in space stands or rolls on the ground there."""
    return not view.planar and not _is_pin(view, at, held) and not _is_led(view, held)


def _plane(view: View, places: Sequence[np.ndarray], reach: float) -> str:
    """The plane of x and y around some pixels."""
    axes = np.column_stack([view.project(np.eye(3)[:, i]) * np.array([1, -1]) for i in range(2)])
    inside = np.linalg.solve(axes, np.array(places).T)
    low, high = inside.min(axis=1) - reach, inside.max(axis=1) + reach
    around = ((low[0], low[1]), (low[0], high[1]), (high[0], high[1]), (high[0], low[1]))
    return ink.path([axes @ np.array(corner) for corner in around], "plane", closed=True)


def load_symbol(view: View, paper: Paper, load: Load) -> str:
    """The symbol of one load."""
    if isinstance(load, Gravity):
        # Its arrow stands beside the axes.
        return ""
    if isinstance(load, Spring | Damper):
        return _between(view, paper, load)
    if isinstance(load, Force):
        tip = paper.place(view.point(load.at))
        along = unit(paper.turn(view.direction(load.vector)))
        start, end = tip + 32 * along, tip + 78 * along
        return ink.arrow(start, end, "force") + ink.text(
            end + 12 * along, label(load.vector.magnitude(), load.name), "force-name"
        )
    if isinstance(load, Coulomb):
        return _friction(view, paper, load)
    if isinstance(load, Torque | TorsionSpring):
        centre = paper.place(view.point(_joint_of(view, load)))
        at = centre + np.array([0.0, -38.0])
        return ink.arc(centre, 26, 0.4, 2.3, "force") + ink.text(
            at, label(Symbol(load.name), load.name), "force-name"
        )
    raise TypeError(f"no drawing is known for the load {load!r}")


def _joint_of(view: View, load: Torque | TorsionSpring) -> Point:
    """Where a torque is drawn: in space at the joint of the two bodies, else at the mass centre."""
    pair = {load.on, load.by}
    joints = [r.at for r in view.scene.reactions if {r.on, r.by} == pair and r.at is not None]
    return joints[0] if joints and not view.planar else view.scene.body(load.on).centre


def gravity_arrow(view: View, paper: Paper) -> str:
    """An arrow along gravity; nothing where that points into the paper."""
    if view.down is None:
        return ""
    along = paper.turn(view.down)
    middle = np.array([134.0, 50.0])
    start, end = middle - 22 * along, middle + 22 * along
    return ink.arrow(start, end, "force") + ink.text(
        middle + np.array([-14.0, 0.0]), svg_name("g"), "force-name"
    )


def _friction(view: View, paper: Paper, load: Coulomb) -> str:
    """An arrow beside the foot of the body, against its sliding."""
    pressing = view.scene.reaction(load.normal)
    foot = -BLOCK[1] / 2 * unit(paper.turn(view.direction(pressing.along)))
    sliding = unit(paper.turn(view.direction(load.along)))
    against = sliding if view.number(load.sliding) < 0 else -sliding
    start = paper.place(view.point(pressing.at)) + 0.6 * foot + 0.6 * BLOCK[0] * against
    end = start + 40 * against
    return ink.arrow(start, end, "force") + ink.text(
        end + 16 * against, label(load.coefficient, load.name), "force-name"
    )


def _between(view: View, paper: Paper, load: Spring | Damper) -> str:
    start, end = paper.place(view.point(load.first)), paper.place(view.point(load.second))
    wall = ""
    if load.along is not None:
        along = unit(paper.turn(view.direction(load.along)))
        if is_slack_at_anchor(view, load):
            # The anchor stands where the spring is free; it is drawn at a length that shows it.
            start = start - SLACK * along
        if not view.swings(load.first):
            wall = ink.hatching(start, normal(along), -along, 24)
        else:
            start = start + _inset(view, load, load.first, load.first_on) * along
        end = end - _inset(view, load, load.second, load.second_on) * along
    side = normal(unit(end - start))
    side = side if side[1] < 0 else -side
    place, lanes = _lane(view, load)
    aside = LANE * (place - (lanes - 1) / 2) * side
    start, end = start + aside, end + aside
    stroke = ink.zigzag(start, end) if isinstance(load, Spring) else ink.dashpot(start, end)
    constant = load.stiffness if isinstance(load, Spring) else load.coefficient
    outward = side if 2 * place >= lanes - 1 else -side
    at = (start + end) / 2 + 20 * outward
    return wall + stroke + ink.text(at, label(constant, load.name), "name")


def is_slack_at_anchor(view: View, load: Load) -> bool:
    """Whether a spring or damper along a line begins on the ground, where its end is at zero."""
    return (
        isinstance(load, Spring | Damper)
        and load.along is not None
        and not view.swings(load.first)
        and not view.slack
        and (isinstance(load, Damper) or load.length == 0)
    )


def _inset(view: View, load: Spring | Damper, point: Point, stated: str | None) -> float:
    """Pixels from the point to the edge of the body there: a mass point is drawn as a block."""
    carrier = carrier_of(view.scene, load, point, stated)
    is_block = carrier is not None and not isinstance(view.scene.body(carrier), RigidBody)
    return 0.5 * BLOCK[0] if is_block else 0.0


def _lane(view: View, load: Spring | Damper) -> tuple[int, int]:
    """Place of a spring or damper among those between the same two points, and their number."""
    ends = {load.first, load.second}
    beside = [
        other
        for other in view.scene.loads
        if isinstance(other, Spring | Damper) and {other.first, other.second} == ends
    ]
    return beside.index(load), len(beside)


def label(constant: Expr, name: str) -> str:
    """A short label: the constant where it is a number times letters, else the name."""
    factors = in_order(Mul.make_args(constant))
    if all(factor.is_Integer or isinstance(factor, Symbol) for factor in factors):
        return "".join(
            str(factor) if factor.is_Integer else svg_name(str(factor)) for factor in factors
        )
    return svg_name(name)
