"""The steps of procedure (i), for people: kinematics, momenta, free bodies, elimination, result."""

from collections.abc import Mapping, Sequence

from sympy import Add

from mechanics.equations import FreeBodyRow, Line, Step
from mechanics.kinematics.motion import BodyMotion
from mechanics.routes.elimination import Elimination


def derivation_steps(
    motions: Mapping[str, BodyMotion],
    rows: Sequence[FreeBodyRow],
    result: Elimination,
) -> tuple[Step, ...]:
    """The derivation in the order in which it was carried out."""
    return (
        Step(
            "Kinematics",
            "Positions of the mass centres, differentiated once for the velocities.",
            tuple(
                line for name, motion in motions.items() for line in kinematic_lines(name, motion)
            ),
        ),
        Step(
            "Momenta",
            "Linear momentum of each body, and angular momentum about its mass centre.",
            tuple(Line(_momentum_name(row), row.momentum) for row in rows),
        ),
        Step(
            "Free-body equations",
            "Each body isolated: loads and reactions on the left, rate of momentum on the right.",
            tuple(
                Line(
                    Add(row.applied, *(factor * symbol for symbol, factor in row.coefficients)),
                    row.rate,
                    f"{row.body}, {row.kind} along {row.axis}",
                )
                for row in rows
            ),
        ),
        Step(
            "Elimination",
            "From the leaves of the tree of bodies to its root, each reaction is solved from one"
            " row and put into the others.",
            tuple(
                Line(solved.reaction, solved.value, f"from {solved.body}")
                for solved in result.order
            ),
        ),
    )


def kinematic_lines(name: str, motion: BodyMotion) -> list[Line]:
    """Position and velocity components that are not zero, and the angular velocity."""
    label = rf"\mathrm{{{name}}}"
    found = []
    for title, vector in (
        ("r", motion.centre.position),
        ("v", motion.centre.velocity),
        (r"\omega", motion.angular_velocity),
    ):
        found += [
            Line(rf"{title}_{{{label},{axis}}}", vector[i])
            for i, axis in enumerate("xyz")
            if vector[i] != 0
        ]
    return found


def _momentum_name(row: FreeBodyRow) -> str:
    symbol = "p" if row.kind == "linear" else "H"
    return rf"{symbol}_{{\mathrm{{{row.body}}},{row.axis.split('.')[-1]}}}"
