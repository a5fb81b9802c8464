"""What holds and drives the bodies of a drawing: ground, springs, dampers, forces, gravity."""

from collections.abc import Sequence

import numpy as np
from sympy import Add, Expr, Mul, Symbol
from sympy.physics.vector import Point, Vector

from mechanics.report import strokes
from mechanics.report.coordinates import trace
from mechanics.report.notation import in_order, svg_name, svg_row
from mechanics.report.projection import Paper, View, normal, unit
from mechanics.scene import (
    Body,
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


def ground(view: View, paper: Paper, moving: bool = False) -> str:
    """Pins, rails and planes where the ground reacts, and ropes.

    In a picture that moves rails and planes rest, and go through all of it.
    """
    groups: dict[Point, list[Reaction]] = {}
    ropes = [joint for joint in view.scene.joints if isinstance(joint, Rope)]
    tensions = [reaction for rope in ropes for reaction in rope.reactions]
    drawn = [
        strokes.path([paper.place(view.point(p)) for _, p in rope.ends], "line") for rope in ropes
    ]
    for reaction in view.scene.reactions:
        if reaction.by is None and reaction.at is not None and reaction not in tensions:
            groups.setdefault(reaction.at, []).append(reaction)
    planes: list[Point] = []
    for at, held in groups.items():
        if not _is_on_plane(view, at, held):
            drawn.append(_support(view, paper, at, held, moving))
        elif any(abs(view.numbers(view.scene.vector(r.along))[2, 0]) > 1e-9 for r in held):
            planes.append(at)
    if planes:
        drawn.insert(0, _plane(view, paper, planes, moving))
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
        return strokes.pin(max([place, *pixels], key=lambda pixel: float(pixel @ into)), into)
    if _is_led(view, held):
        return ""  # a point mass on a string, a rod or a curve: its trace is drawn, not which
    body = view.scene.body(held[0].on)
    block = not isinstance(body, RigidBody) or body.centre == at
    foot = place + (BLOCK[1] / 2) * into if block else place
    if moving and not any(view.turns(reaction.along) for reaction in held):
        along = normal(into)
        return strokes.hatching(foot - along * (along @ (foot - paper.middle)), along, into, 300)
    return strokes.hatching(foot, normal(into), into, 110 if len(pushes) > 1 else 72)


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


def _plane(view: View, paper: Paper, held: Sequence[Point], moving: bool) -> str:
    """The plane of x and y around some points; its outline alone where bodies are behind it.

    In a picture that moves it reaches along all of their ways, as under those that are drawn.
    """
    led = {body.centre for body in view.scene.bodies if not isinstance(body, RigidBody)}
    ways = [view.way(at) if moving or at in led else view.point(at)[None] for at in held]
    places = [paper.place(p) for way in ways for p in way]
    reach = (0.32 if len(places) == len(held) else 0.16) * paper.middle[0]
    towards = np.cross(*view.projection)[2]
    heights = [view.place(body.centre)[2] - view.place(held[0])[2] for body in view.scene.bodies]
    style = "plane open" if min(towards * height for height in heights) < -1e-9 else "plane"
    axes = np.column_stack([view.project(np.eye(3)[:, i]) * np.array([1, -1]) for i in range(2)])
    inside = np.linalg.solve(axes, np.array(places).T)
    low, high = inside.min(axis=1) - reach, inside.max(axis=1) + reach
    around = ((low[0], low[1]), (low[0], high[1]), (high[0], high[1]), (high[0], low[1]))
    return strokes.path([axes @ np.array(corner) for corner in around], style, closed=True)


def load_symbol(view: View, paper: Paper, load: Load) -> str:
    """The symbol of one load."""
    if isinstance(load, Force | Torque) and _is_off(view, load.vector):
        return ""
    if isinstance(load, Gravity):
        # Its arrow stands beside the axes.
        return ""
    if isinstance(load, Spring | Damper):
        return _between(view, paper, load)
    if isinstance(load, Force):
        tip = paper.place(view.point(load.at))
        along = unit(paper.turn(view.direction(load.vector)))
        start, end = tip + 32 * along, tip + 78 * along
        return strokes.arrow(start, end, "force") + strokes.text(
            end + 12 * along, label(load.vector.magnitude(), load.name), "force-name"
        )
    if isinstance(load, Coulomb):
        return _friction(view, paper, load)
    if isinstance(load, Torque | TorsionSpring):
        centre = paper.place(view.point(_joint_of(view, load)))
        at = centre + np.array([0.0, -38.0])
        return strokes.arc(centre, 26, 0.4, 2.3, "force") + strokes.text(
            at, label(Symbol(load.name), load.name), "force-name"
        )
    raise TypeError(f"no drawing is known for the load {load!r}")


def _is_off(view: View, vector: Vector) -> bool:
    """Whether a load is zero with the inputs that the state names."""
    entries = view.scene.vector(vector)
    inputs = {symbol.name for symbol in entries.free_symbols & {*view.scene.input_symbols}}
    return bool(inputs) and inputs <= view.state.keys() and not view.numbers(entries).any()


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
    return strokes.arrow(start, end, "force") + strokes.text(
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
    return strokes.arrow(start, end, "force") + strokes.text(
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
            wall = strokes.hatching(start, normal(along), -along, 24)
        else:
            start = start + _inset(view, load, load.first, load.first_on) * along
        end = end - _inset(view, load, load.second, load.second_on) * along
    side = normal(unit(end - start))
    side = side if side[1] < 0 else -side
    place, lanes = _lane(view, load)
    aside = LANE * (place - (lanes - 1) / 2) * side
    start, end = start + aside, end + aside
    stroke = strokes.zigzag(start, end) if isinstance(load, Spring) else strokes.dashpot(start, end)
    constant = load.stiffness if isinstance(load, Spring) else load.coefficient
    outward = side if 2 * place >= lanes - 1 else -side
    at = (start + end) / 2 + 20 * outward
    return wall + stroke + strokes.text(at, label(constant, load.name), "name")


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
    is_block = carrier is not None and rail(view, view.scene.body(carrier)) is not None
    return 0.5 * BLOCK[0] if is_block else 0.0


def rail(view: View, body: Body) -> np.ndarray | None:
    """The way on paper of a body that slides in a plane without turning, and is drawn as a block.

    None for a body without one: it turns, is free, is led round, or moves in space.
    """
    scene = view.scene
    turns = isinstance(body, RigidBody) and scene.rotation(body.frame).free_symbols & {*scene.q}
    if not view.planar or turns or trace(view, body) is not None:
        return None
    guides = (r for r in scene.reactions if not r.parts)
    slides = [r for r in guides if r.on == body.name and r.by is None]
    if slides:
        across = slides[0].along
        return None if view.turns(across) else normal(view.direction(across))
    ways = [view.shift(body.centre, q) for q in scene.q]
    moving = [way for way in ways if np.hypot(*way) > 1e-9]
    return moving[0] if len(moving) == 1 else None


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
    """A short label: a number times letters and sums of letters; else the name."""
    factors = [_factor(factor) for factor in in_order(Mul.make_args(constant))]
    return svg_name(name) if None in factors else svg_row(map(str, factors))


def _factor(factor: Expr) -> str | None:
    """A number, a letter, or a sum of two letters in brackets."""
    if factor.is_Integer:
        return str(factor)
    if isinstance(factor, Symbol):
        return svg_name(factor.name)
    terms = [term.as_coeff_Mul() for term in Add.make_args(factor)]
    if len(terms) != 2 or any(abs(n) != 1 or not isinstance(s, Symbol) for n, s in terms):
        return None
    (sign, first), (other, second) = sorted(terms, key=lambda term: (int(-term[0]), term[1].name))
    before, between = ("" if sign > 0 else "\u2212"), ("+" if other > 0 else "\u2212")
    names = svg_name(first.name), svg_name(second.name)
    return svg_row((f"({before}", names[0], f" {between} ", names[1], ")"))
