"""What couples the joints and links of a robot beside the tree: motors, tendons, ties, loops.

F = (gain_0 + gain_1 L + gain_2 L') input + bias_0 + bias_1 L + bias_2 L',   L = sum c_j q_j   (1)
q = rest + sum c_k (q_other - other_rest)^k                                                    (2)
"""

from sympy import Expr, ImmutableMatrix, Integer
from sympy.physics.mechanics import Point, dynamicsymbols

from mechanics.errors import InputError
from mechanics.importers.parts import Parts, action, identifier, turned
from mechanics.importers.robot import Actuation, Cable, Closure, Coupling, Polynomial
from mechanics.scene import ball, damper, holonomic, spring, weld
from mechanics.scene.reactions import Reaction

_T = dynamicsymbols._t


def couple(parts: Parts, own: Coupling) -> None:
    """Loads, reactions and constraints of a coupling, beside the others.

    Raises
    ------
    InputError
        When it ties what has no single freedom.
    """
    if isinstance(own, Actuation):
        _actuate(parts, own)
    elif isinstance(own, Cable):
        name = identifier(own.name)
        first, second = (_place(parts, *end, f"{name}_{k}") for k, end in enumerate(own.ends))
        ends = {
            key: parts.spots[link].body
            for key, (link, _) in zip(("first_on", "second_on"), own.ends, strict=True)
        }
        if own.stiffness:
            parts.loads.append(
                spring(f"spring_{name}", first, second, own.stiffness, None, own.length, **ends)
            )
        if own.damping:
            parts.loads.append(damper(f"damping_{name}", first, second, own.damping, **ends))
    elif isinstance(own, Polynomial):
        _tie(parts, own)
    else:
        _close(parts, own)


def _actuate(parts: Parts, own: Actuation) -> None:
    """Equation (1)."""
    drives = [(parts.drives[joint], factor) for joint, factor in own.terms]
    length: Expr = sum((c * drive.q for drive, c in drives), Integer(0))
    state = (Integer(1), length, length.diff(_T))
    name = identifier(own.name)
    size = sum((b * part for b, part in zip(own.bias, state, strict=True)), Integer(0))
    if own.gain is not None:
        (motor,) = dynamicsymbols(f"{parts.name(name)},")
        parts.inputs.append(motor)
        size += motor * sum((b * part for b, part in zip(own.gain, state, strict=True)), Integer(0))
    for k, (drive, factor) in enumerate(drives, start=1):
        end = f"_{k}" if len(drives) > 1 else ""
        parts.load(f"actuator_{name}{end}", factor * size, drive)


def tied(own: Polynomial, other: Expr) -> Expr:
    """q of equation (2)."""
    x = other - own.other_rest
    return own.rest + sum((c * x**k for k, c in enumerate(own.coefficients)), Integer(0))


def _tie(parts: Parts, own: Polynomial) -> None:
    """Equation (2), and the couples or forces that maintain it: their sizes differ by its slope."""
    for joint in (own.joint, own.other):
        if joint is not None and joint not in parts.drives:
            raise InputError(
                f"joint {own.joint}: it is tied to {own.other!r}: both have to turn or to slide"
            )
    drive, name = parts.drives[own.joint], f"{identifier(own.name)}_tie"
    tie, gap = action(name, drive, Integer(1)), drive.q - own.rest
    if own.other is not None:
        other = parts.drives[own.other]
        gap = drive.q - tied(own, other.q)
        slope = gap.diff(other.q)
        if slope != 0:
            tie = Reaction(tie.name, tie.on, tie.by, tie.along, tie.at,
                           (action(name, other, slope),))  # fmt: skip
    parts.reactions.append(tie)
    parts.constraints.append(holonomic(f"{name}d", gap, name))


def _close(parts: Parts, own: Closure) -> None:
    first, second = own.first, own.second
    turn = own.turn
    if parts.spots[second[0]].body is None:
        # The ground is the parent.
        first, second = second, first
        turn = None if turn is None else ImmutableMatrix(turn.T)
    ends = (parts.spots[first[0]], parts.spots[second[0]])
    name = parts.name(own.name)
    at, point = (_place(parts, *end, f"{name}_{k}") for k, end in enumerate((first, second)))
    parent, child = ends[0].body, ends[1].body
    if child is None or child == parent:
        raise InputError(f"constraint {own.name}: it ties {first[0]!r} to itself")
    if turn is None:
        joint = ball(name, parent, child, at=at, frame=ends[0].frame, onto=point)
    else:
        frame = turned(ends[0].frame, turn, f"{name}_frame")
        joint = weld(name, parent, child, at=at, frame=frame, onto=(point, ends[1].frame))
    parts.joints.append(joint)


def _place(parts: Parts, link: str, column: tuple[Expr, ...], name: str) -> Point:
    return parts.step(parts.spots[link], column, name, name)
