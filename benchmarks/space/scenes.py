"""Scenes in space: trees of turning and sliding joints, and arms whose geometry is published.

Denavit-Hartenberg tables (modified form): Corke and Armstrong-Helouvry, A meta-study of PUMA 560
dynamics, Robotica 13 (1995); the documentation of the Franka Emika robot; Universal Robots' table.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from sympy import Expr, Rational, Symbol, pi
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    gravity,
    reaction,
    reaction_couple,
    torque,
)
from systems import pendulum_chain

AXES = "xyz"


@dataclass(frozen=True)
class Joint:
    """One joint and the body beyond it.

    Attributes
    ----------
    parent : int
        Number of the joint that carries it, counted from 0; -1 for the ground.
    axis : int
        0, 1, 2 for x, y, z.
    turning : bool
        Else it slides.
    turns : tuple of (axis, angle)
        Fixed turns from the frame of the parent to that of the joint at rest.
    offset : three expressions
        From the parent's joint to this one, in the parent's frame.
    mass : expression or None
        None: the joint carries nothing but the next one.
    centre : three expressions
        Of the mass, in the body's frame.
    inertia : six expressions
        xx, yy, zz, xy, yz, zx about the mass centre.
    """

    parent: int
    axis: int = 2
    turning: bool = True
    turns: tuple[tuple[int, Any], ...] = ()
    offset: Sequence[Any] = (0, 0, 0)
    mass: Any = None
    centre: Sequence[Any] = (0, 0, 0)
    inertia: Sequence[Any] = field(default_factory=lambda: (0,) * 6)


def positive(*names: str) -> tuple[Symbol, ...]:
    return tuple(Symbol(name, positive=True) for name in names)


def real(*names: str) -> tuple[Symbol, ...]:
    return tuple(Symbol(name, real=True) for name in names)


def general(i: int) -> dict[str, Any]:
    """Mass, mass centre and inertia of a body as ten symbols."""
    (mass,) = positive(f"m{i}")
    centre = real(f"cx{i}", f"cy{i}", f"cz{i}")
    moments = positive(f"Ixx{i}", f"Iyy{i}", f"Izz{i}")
    return {
        "mass": mass, "centre": centre,
        "inertia": (*moments, *real(f"Ixy{i}", f"Iyz{i}", f"Izx{i}")),
    }  # fmt: skip


def scene(name: str, joints: Sequence[Joint], *, torques: bool = False) -> Scene:
    """The scene of a tree of joints, with every reaction declared.

    A joint without a body moves the next one: their reactions are those of the body that follows,
    so only bodies that follow one such chain have fewer.
    """
    ground, origin = ReferenceFrame("N"), Point("O")
    (g,) = positive("g")
    q = dynamicsymbols(f"q1:{len(joints) + 1}")
    tau = dynamicsymbols(f"tau1:{len(joints) + 1}") if torques else ()
    frames, points, carriers = [], [], []
    bodies: list[RigidBody | Particle] = []
    reactions, loads = [], [gravity(-g * ground.z)]
    for i, joint in enumerate(joints, start=1):
        first = joint.parent < 0
        outer = ground if first else frames[joint.parent]
        point = origin if first else points[joint.parent]
        inner = None if first else carriers[joint.parent]
        if any(joint.offset):
            axes = zip(joint.offset, (outer.x, outer.y, outer.z), strict=True)
            point = point.locatenew(f"J{i}", sum(c * axis for c, axis in axes if c != 0))
        frame = outer
        for k, (axis, angle) in enumerate(joint.turns):
            frame = frame.orientnew(f"A{i}_{k}", "Axis", (angle, _axis(frame, axis)))
        along = _axis(frame, joint.axis)
        if joint.turning:
            frame = frame.orientnew(f"B{i}", "Axis", (q[i - 1], along))
        else:
            point = point.locatenew(f"S{i}", q[i - 1] * along)
        frames.append(frame)
        points.append(point)
        if joint.mass is None:
            carriers.append(inner)
            continue
        body = f"body{i}"
        carriers.append(body)
        axes = zip(joint.centre, (frame.x, frame.y, frame.z), strict=True)
        arm = [c * axis for c, axis in axes if c != 0]
        centre = point.locatenew(f"C{i}", sum(arm)) if arm else point
        bodies.append(RigidBody(body, centre, frame, joint.mass, inertia(frame, *joint.inertia)))
        free = _free(joints, i - 1)
        for kind, make in (
            ("F", lambda *words: reaction(words[0], point, *words[1:])),  # noqa: B023
            ("C", reaction_couple),
        ):
            for axis in range(3):
                if (kind == "C", axis) not in free:
                    words = (f"{kind}{AXES[axis]}{i}", body, inner, _axis(frame, axis))
                    reactions.append(make(*words))
        if torques:
            loads.append(torque(f"T{i}", tau[i - 1] * along, body, inner))
    return Scene(
        name, ground, origin, tuple(q), tuple(bodies), tuple(loads), tuple(reactions),
        inputs=tuple(tau),
    )  # fmt: skip


def _axis(frame: ReferenceFrame, k: int) -> Any:
    return (frame.x, frame.y, frame.z)[k]


def _free(joints: Sequence[Joint], i: int) -> set[tuple[bool, int]]:
    """(whether it turns, axis) of the freedoms between a body and the one that carries it."""
    found = {(joints[i].turning, joints[i].axis)}
    while (i := joints[i].parent) >= 0 and joints[i].mass is None:
        found.add((joints[i].turning, joints[i].axis))
    return found


def _modified(rows: Sequence[tuple[Expr, Expr, Expr]]) -> list[Joint]:
    """Joints of a serial arm from a table of (alpha, a, d) in the modified form."""
    found = []
    for i, (alpha, a, d) in enumerate(rows, start=1):
        quarter = {0: (0, 1), pi / 2: (1, 0), -pi / 2: (-1, 0)}
        s, c = quarter[alpha]
        turns = ((0, alpha),) if alpha != 0 else ()
        found.append(Joint(i - 2, turns=turns, offset=(a, -d * s, d * c), **general(i)))
    return found


def puma560() -> Scene:
    """Six turning joints, general inertias."""
    a2, a3, d3, d4 = real("a2", "a3", "d3", "d4")
    table = [(0, 0, 0), (-pi / 2, 0, 0), (0, a2, d3), (-pi / 2, a3, d4), (pi / 2, 0, 0)]
    return scene("PUMA 560", _modified([*table, (-pi / 2, 0, 0)]))


def panda() -> Scene:
    """Seven turning joints, general inertias."""
    d1, d3, d5, a4, a7 = real("d1", "d3", "d5", "a4", "a7")
    table = [
        (0, 0, d1), (-pi / 2, 0, 0), (pi / 2, 0, d3), (pi / 2, a4, 0), (-pi / 2, -a4, d5),
        (pi / 2, 0, 0), (pi / 2, a7, 0),
    ]  # fmt: skip
    return scene("Panda", _modified(table))


def ur5(numbers: bool = True) -> Scene:
    """Six turning joints, the second to fourth parallel; else general inertias.

    Masses, mass centres and inertias, those of cylinders, as in the model of the robot that its
    makers publish.
    """
    table = [
        (0, 0, "0.089159"), (pi / 2, 0, 0), (0, "-0.425", 0), (0, "-0.39225", "0.10915"),
        (pi / 2, 0, "0.09465"), (-pi / 2, 0, "0.0823"),
    ]  # fmt: skip
    joints = _modified([(alpha, Rational(a), Rational(d)) for alpha, a, d in table])
    if not numbers:
        return scene("UR5 with general inertias", joints)
    bodies = (
        # mass, mass centre, moments of inertia
        ("3.7", (0, 0, 0), ("0.010267495893", "0.010267495893", "0.00666")),
        ("8.393", ("-0.28", 0, "0.13585"), ("0.0151074", "0.22689067591", "0.22689067591")),
        ("2.275", ("-0.25", 0, "0.01615"), ("0.004095", "0.049443313556", "0.049443313556")),
        ("1.219", (0, 0, "-0.093"), ("0.111172755531", "0.111172755531", "0.21942")),
        ("1.219", (0, 0, "-0.09465"), ("0.111172755531", "0.111172755531", "0.21942")),
        ("0.1879", (0, 0, "-0.0823"), ("0.0171364731454", "0.0171364731454", "0.033822")),
    )
    found = [
        Joint(
            joint.parent, turns=joint.turns, offset=joint.offset, mass=Rational(mass),
            centre=tuple(map(Rational, centre)),
            inertia=(*map(Rational, moments), 0, 0, 0),
        )
        for joint, (mass, centre, moments) in zip(joints, bodies, strict=True)
    ]  # fmt: skip
    return scene("UR5 with its numbers", found)


def arm(count: int) -> Scene:
    """A serial arm of turning joints, general inertias, offsets and a fixed turn at each joint."""
    return scene(
        f"arm of {count}",
        [
            Joint(
                i - 2,
                axis=i % 3,
                turns=(((i + 1) % 3, Symbol(f"beta{i}", real=True)),),
                offset=real(f"rx{i}", f"ry{i}", f"rz{i}"),
                **general(i),
            )
            for i in range(1, count + 1)
        ],
    )


def floating(count: int) -> Scene:
    """A floating base, three sliding and three turning joints, and legs of six joints on it."""
    joints = [Joint(i - 1, axis=i, turning=False) for i in range(3)]
    joints += [Joint(2, axis=0), Joint(3, axis=1), Joint(4, axis=2, **general(6))]
    for i in range(7, count + 7):
        parent = 5 if (i - 7) % 6 == 0 else i - 2
        offset = real(f"rx{i}", f"ry{i}", f"rz{i}")
        turns = (((i + 1) % 3, Symbol(f"beta{i}", real=True)),)
        joints.append(Joint(parent, axis=i % 3, turns=turns, offset=offset, **general(i)))
    return scene(f"floating base with {count} joints", joints)


def tree(count: int) -> Scene:
    """A tree of turning joints: every fifth body starts a branch at the third before it."""
    joints = []
    for i in range(1, count + 1):
        parent = i - 5 if i % 5 == 0 else i - 2
        offset = real(f"rx{i}", f"ry{i}", f"rz{i}")
        joints.append(Joint(parent, axis=i % 3, offset=offset, **general(i)))
    return scene(f"tree of {count} bodies", joints)


def chain(count: int) -> Scene:
    """The cart with a pendulum chain."""
    return pendulum_chain.scene(count)
