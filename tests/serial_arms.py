"""Serial arms in space: turning joints, fixed turns and offsets between them, general inertias.

A joint turns about x, y or z of its frame; before it comes a fixed turn of the frame. Every body
has a mass centre and a full inertia matrix, every joint five reactions and a motor. The same arm
comes in numbers for `benchmarks.space.textbook`, made from the lists that the scene is made from.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import cycle, islice

import numpy as np
from sympy import Expr, S, pi
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from benchmarks.space.textbook import Link, turn
from mechanics.scene import (
    RigidBody,
    Scene,
    gravity,
    parameters,
    reaction,
    reaction_couple,
    torque,
)

QUARTER = pi / 2
TYPICAL = {
    "m": 2.0, "x": 0.4, "y": -0.3, "z": 0.2, "a": 0.15, "b": 0.1, "c": -0.25,
    "A": 0.5, "B": 0.6, "C": 0.7, "D": 0.05, "E": -0.04, "F": 0.03,
}  # fmt: skip
"""Of each joint: mass, offset (x, y, z) from the joint before, mass centre (a, b, c), inertia."""
UNITS = "kg m m m m m m kg*m^2 kg*m^2 kg*m^2 kg*m^2 kg*m^2 kg*m^2"


@dataclass(frozen=True)
class Arm:
    """A scene, and how its joints turn.

    Attributes
    ----------
    scene : Scene
        Coordinates q1, ..., inputs T1, ...; parameters g and those of `TYPICAL` with the number of
        the joint.
    axes, fixed : tuple of str
        Of each joint: the axis that it turns about, and that of the fixed turn before it.
    turns : tuple of Expr
        Angles of the fixed turns.
    """

    scene: Scene
    axes: tuple[str, ...]
    fixed: tuple[str, ...]
    turns: tuple[Expr, ...]

    def joints(self, numbers: Mapping[str, float]) -> list[Link]:
        """The joints at values of the parameters, by name."""
        found = []
        for i, (axis, fixed, angle) in enumerate(
            zip(self.axes, self.fixed, self.turns, strict=True), start=1
        ):
            m, x, y, z, a, b, c, A, B, C, D, E, F = (
                numbers.get(f"{name}{i}", 0.0) for name in TYPICAL
            )
            found.append(
                Link(
                    i - 2, "xyz".index(axis), True, turn("xyz".index(fixed), float(angle)),
                    np.array([x, y, z]), m, np.array([a, b, c]),
                    np.array([[A, D, F], [D, B, E], [F, E, C]]),
                )
            )  # fmt: skip
        return found


def of_joint(i: int, zero: str) -> list[Expr]:
    """The parameters of joint i, in the order of `TYPICAL`, lengths and products of any sign."""
    return [
        S.Zero
        if name in zero
        else parameters(
            f"{name}{i}", given, str(round(value * (1 + i / 20), 6)), positive=name in "mABC"
        )[0]
        for (name, value), given in zip(TYPICAL.items(), UNITS.split(), strict=True)
    ]


def serial_arm(
    count: int,
    axes: str = "zxy",
    fixed: str = "xyz",
    turn: Expr | Sequence[Expr] = QUARTER,
    zero: str = "",
) -> Arm:
    """An arm of so many joints; axes are taken in turn, the first joint has no fixed turn.

    Parameters
    ----------
    axes, fixed : str
        Axes of the joints, and of the fixed turns before them.
    turn : Expr or sequence of Expr
        Angle of the fixed turns, or of each of them.
    zero : str
        Which of `TYPICAL` are zero and no parameters.
    """
    ways, ties = tuple(islice(cycle(axes), count)), tuple(islice(cycle(fixed), count))
    (g,) = parameters("g", units="m/s^2", typical="9.81")
    N, O = ReferenceFrame("N"), Point("O")
    q, motors = dynamicsymbols(f"q1:{count + 1}"), dynamicsymbols(f"T1:{count + 1}")
    outer, at, inner = N, O, None
    bodies, reactions, loads = [], [], [gravity(-g * N.z)]
    turns = (0, *([turn] * (count - 1) if isinstance(turn, Expr) else turn))
    for i, (way, tie) in enumerate(zip(ways, ties, strict=True), start=1):
        m, x, y, z, a, b, c, *moments = of_joint(i, zero)
        name = f"body{i}"
        at = at.locatenew(f"J{i}", x * outer.x + y * outer.y + z * outer.z)
        held = (
            outer
            if turns[i - 1] == 0
            else outer.orientnew(f"H{i}", "Axis", (turns[i - 1], getattr(outer, tie)))
        )
        along = getattr(held, way)
        frame = held.orientnew(f"B{i}", "Axis", (q[i - 1], along))
        centre = at.locatenew(f"C{i}", a * frame.x + b * frame.y + c * frame.z)
        bodies.append(RigidBody(name, centre, frame, m, inertia(frame, *moments)))
        for other in "xyz":
            direction = getattr(held, other)
            reactions.append(reaction(f"R{i}{other}", at=at, on=name, by=inner, along=direction))
            if other != way:
                reactions.append(reaction_couple(f"M{i}{other}", name, inner, direction))
        loads.append(torque(f"T{i}", motors[i - 1] * along, on=name, by=inner))
        outer, inner = frame, name
    scene = Scene(
        f"arm of {count}", N, O, coordinates=tuple(q), bodies=tuple(bodies), loads=tuple(loads),
        reactions=tuple(reactions), inputs=tuple(motors),
    )  # fmt: skip
    return Arm(scene, ways, ties, turns)
