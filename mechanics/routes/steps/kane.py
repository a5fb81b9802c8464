r"""Kane's method step by step.

F_r  = sum of F . dv/du_r + T . domega/du_r                     generalized active forces
F*_r = -sum of m a . dv/du_r + (I alpha + omega x I omega) . domega/du_r
F_r + F*_r = 0
"""

from collections.abc import Sequence

from sympy import Add, Expr, Matrix, Mul, Rational, S

from mechanics.equations import Line, Step, Term
from mechanics.kinematics import chain
from mechanics.kinematics.motion import BodyMotion, Motions, body_motions
from mechanics.program.builder import Node
from mechanics.program.derivatives import gradient
from mechanics.program.vectors import Vector, add, cross, dot, scale, subtract, times
from mechanics.routes.kane import unknown_reactions
from mechanics.routes.loads import Wrench, acting_reactions, applied, by_body
from mechanics.routes.steps.writer import (
    FULL,
    Numbers,
    Writer,
    arrival,
    kinematics,
    pressed_step,
    worked_loads,
    worked_out,
)


def steps(writer: Writer) -> tuple[Step, ...]:
    """Kinematics, partial velocities, active and inertia forces, equations of motion."""
    mechanism, numbers = writer.mechanism, Numbers("K")
    motions = chain.motions(mechanism)
    bodies = body_motions(mechanism, motions)
    first = kinematics(writer, numbers, motions, accelerations=True)
    shown = mechanism.u if len(mechanism.u) <= FULL else mechanism.u[:1]
    groups = by_body(mechanism, _loads(writer, motions))
    names = [writer.printer.symbol(speed).name for speed in shown]
    force = writer.letter("active")
    partials = [
        line
        for speed, name in zip(shown, names, strict=True)
        for line in _partial_lines(writer, numbers, bodies, speed, name)
    ]
    parts = [_active(writer, bodies, groups, speed) for speed in shown]
    active = [
        worked_loads(
            numbers, rf"{force}_{{<<{name}>>}}", _products(writer, bodies, groups, speed), terms
        )
        for speed, name, terms in zip(shown, names, parts, strict=True)
    ]
    against = [_inertia(writer, bodies, speed) for speed in shown]
    inertia = [
        numbers(rf"{force}^{{*}}_{{<<{name}>>}}", tuple(terms) or S.Zero)
        for name, terms in zip(names, against, strict=True)
    ]
    rows: list[Line] = []
    ends: list[tuple[str, Expr]] = []
    for k, name in enumerate(names):
        terms = (*parts[k], *against[k])
        words = f"({active[k][-1].number}) and ({inertia[k].number}) into {_law(force, name)}"
        lines = worked_out(numbers, terms, words)
        rows += lines
        ends.append((lines[-1].number, Add(*(term.value for term in terms))))
    pressed, ends = pressed_step(writer, numbers, ends)
    few = "" if shown == mechanism.u else " Shown for the first speed; the others go alike."
    left_out = (
        ""
        if writer.mechanism.constraints
        else (" Reactions do no work on these motions, so that they are left out.")
    )
    return (
        first,
        Step(
            "Partial velocities",
            "How the velocities depend on each speed." + few,
            tuple(partials),
        ),
        Step(
            "Generalized active forces",
            "Each load times the partial velocity of the point where it acts." + left_out,
            tuple(line for lines in active for line in lines),
        ),
        Step(
            "Generalized inertia forces",
            "Minus mass times acceleration, times the partial velocity of the mass centre; minus"
            " the rate of angular momentum, times the partial angular velocity.",
            tuple(inertia),
        ),
        Step("Kane's equations", "Active and inertia forces are in balance.", tuple(rows)),
        *pressed,
        arrival(writer, ends),
    )


def _law(force: str, name: str) -> str:
    return rf"${force}_{{<<{name}>>}} + {force}^{{*}}_{{<<{name}>>}} = 0$"


def _loads(writer: Writer, motions: Motions) -> list[Wrench]:
    """Loads, and the reactions that stay as unknowns."""
    mechanism = writer.mechanism
    units = acting_reactions(mechanism, motions.poses)
    own = [
        Wrench(unit.name, unit.body, unit.at, scale(size, unit.force), scale(size, unit.couple))
        for index, size in unknown_reactions(mechanism).items()
        for unit in units[index]
    ]
    return [*applied(mechanism, motions), *own]


def _partial(vector: Vector, speed: Node) -> Vector:
    return tuple(gradient([entry], [1], (speed,))[0] for entry in vector)


def _partial_lines(
    writer: Writer, numbers: Numbers, bodies: Sequence[BodyMotion], speed: Node, name: str
) -> list[Line]:
    found = []
    for index, motion in enumerate(bodies):
        label = writer.centre(index)
        vectors = [("v", motion.centre.velocity)]
        if motion.turning is not None:
            vectors.append((r"\omega", motion.turning.omega))
        for letter, vector in vectors:
            column = writer.vector(_partial(vector, speed))
            if any(column):
                left = rf"\frac{{\partial \vec{{{letter}}}_{{{label}}}}}{{\partial <<{name}>>}}"
                found.append(numbers(left, column))
    return found


def _active(
    writer: Writer, bodies: Sequence[BodyMotion], groups: list[list[Wrench]], speed: Node
) -> list[Term]:
    merged: dict[str, Node] = {}
    for motion, wrenches in zip(bodies, groups, strict=True):
        for load in wrenches:
            power = dot(load.force, _partial(motion.centre.velocity, speed))
            if motion.turning is not None:
                moment = load.moment(motion.centre.position)
                power = power + dot(moment, _partial(motion.turning.omega, speed))
            merged[load.name] = merged[load.name] + power if load.name in merged else power
    return [*writer.of_loads(merged)]


def _products(
    writer: Writer, bodies: Sequence[BodyMotion], groups: list[list[Wrench]], speed: Node
) -> dict[str, Expr]:
    """For each load, force times partial velocity and couple times partial angular velocity."""
    found: dict[str, Expr] = {}
    for motion, wrenches in zip(bodies, groups, strict=True):
        slope = _partial(motion.centre.velocity, speed)
        turn = _partial(motion.turning.omega, speed) if motion.turning is not None else None
        for load in wrenches:
            at, power = slope, Add()
            if turn is not None:
                at = add(slope, cross(turn, subtract(load.at, motion.centre.position)))
                power = _times(writer.vector(load.couple), writer.vector(turn))
            if not all(entry.is_zero for entry in load.force):
                power += _times(writer.vector(load.force), writer.vector(at))
            found[load.name] = found.get(load.name, Add()) + power
    return found


def _inertia(writer: Writer, bodies: Sequence[BodyMotion], speed: Node) -> list[Term]:
    """One term for each body that the speed moves, with its acceleration as a bracket."""
    mechanism, found = writer.mechanism, []
    for body, motion in zip(mechanism.bodies, bodies, strict=True):
        partial = writer.vector(_partial(motion.centre.velocity, speed))
        (mass,) = writer.printer((body.mass,))
        push = _times(writer.vector(motion.centre.acceleration), partial)
        if push != 0:
            found.append(Term(Mul(Rational(-1), mass, push, evaluate=False)))
        if motion.turning is None or motion.inertia is None:
            continue
        omega, alpha = motion.turning.omega, motion.turning.alpha
        rate = add(times(motion.inertia, alpha), cross(omega, times(motion.inertia, omega)))
        turning = _times(writer.vector(rate), writer.vector(_partial(omega, speed)))
        if turning != 0:
            found.append(Term(-turning))
    return found


def _times(one: Matrix, other: Matrix) -> Expr:
    """The scalar product, not multiplied out."""
    pairs = zip(one, other, strict=True)
    return Add(*(Mul(b, a, evaluate=a.is_Number or b.is_Number) for a, b in pairs if a and b))
