"""Equations of procedure (i), written out from `mechanics.routes.programs.free_body`."""

from sympy import Add

from mechanics.equations import Equations, Line, Step
from mechanics.mechanism import Mechanism, lower
from mechanics.program import Builder
from mechanics.routes.programs import differentiate, free_body
from mechanics.routes.programs.free_body import FreeBodyRow
from mechanics.routes.programs.motion import Motions
from mechanics.routes.programs.rows import Rows
from mechanics.routes.textbook import Printer, textbook
from mechanics.scene import Scene


def derive(scene: Scene) -> Equations:
    """Equations of motion by isolating every body; each eliminated reaction in u' and lambda."""
    mechanism = lower(scene, Builder())
    return written(scene, mechanism, free_body.derive(mechanism))


def written(scene: Scene, mechanism: Mechanism, rows: Rows) -> Equations:
    """The same from rows that were derived."""
    return textbook(scene, mechanism, rows, steps)


def steps(printer: Printer, mechanism: Mechanism) -> tuple[Step, ...]:
    """Kinematics, momenta, free bodies, elimination."""
    rows, elimination = free_body.eliminated(mechanism)
    names = [body.name for body in mechanism.bodies]
    symbols = [reaction.symbol for reaction in printer.scene.reactions]
    equations = []
    for row in rows:
        applied, rate, *factors = printer.short((row.applied, row.rate, *row.coefficients.values()))
        held = (f * symbols[r] for f, r in zip(factors, row.coefficients, strict=True))
        label = f"{names[row.body]}, {row.kind} along {row.axis}"
        equations.append(Line(Add(applied, *held), rate, label))
    solved = []
    for step in elimination.solved:
        value, *factors = printer.short((step.row.value, *step.row.coefficients.values()))
        others = dict(zip(step.row.coefficients, factors, strict=True))
        pivot = others.pop(step.reaction)
        rest = Add(value, *(-f * symbols[r] for r, f in others.items())) / pivot
        solved.append(Line(symbols[step.reaction], rest, f"from {names[step.row.body]}"))
    return (
        Step(
            "Kinematics",
            "Positions of the mass centres, differentiated once for the velocities.",
            kinematic_lines(printer, mechanism, differentiate.motions(mechanism)),
        ),
        Step(
            "Momenta",
            "Linear momentum of each body, and angular momentum about its mass centre.",
            tuple(
                Line(_momentum_name(row, names), *printer.short((row.momentum,))) for row in rows
            ),
        ),
        Step(
            "Free-body equations",
            "Each body isolated: loads and reactions on the left, rate of momentum on the right.",
            tuple(equations),
        ),
        Step(
            "Elimination",
            "From the leaves of the tree of bodies to its root, each reaction is solved from one"
            " row and put into the others.",
            tuple(solved),
        ),
    )


def kinematic_lines(printer: Printer, mechanism: Mechanism, motions: Motions) -> tuple[Line, ...]:
    """Position and velocity components that are not zero, and the angular velocity."""
    found = []
    for body in mechanism.bodies:
        centre, label = motions.points[body.centre], rf"\mathrm{{{body.name}}}"
        vectors = [("r", centre.position), ("v", centre.velocity)]
        if body.frame is not None:
            vectors.append((r"\omega", motions.frames[body.frame].omega))
        for title, vector in vectors:
            found += [
                Line(rf"{title}_{{{label},{axis}}}", entry)
                for axis, entry in zip("xyz", printer.expanded(vector), strict=True)
                if entry != 0
            ]
    return tuple(found)


def _momentum_name(row: FreeBodyRow, names: list[str]) -> str:
    symbol = "p" if row.kind == "linear" else "H"
    return rf"{symbol}_{{\mathrm{{{names[row.body]}}},{row.axis.split('.')[-1]}}}"
