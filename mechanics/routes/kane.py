"""Kane's equations of a scene, written out from `mechanics.routes.programs.kane`."""

from mechanics.equations import Equations, Line, Step
from mechanics.mechanism import Mechanism, lower
from mechanics.program import Builder
from mechanics.program.derivatives import gradient
from mechanics.routes.programs import chain, kane
from mechanics.routes.programs.rows import Rows
from mechanics.routes.textbook import Printer, textbook
from mechanics.scene import Scene


def derive(scene: Scene) -> Equations:
    """Equations of motion by Kane's method; dependent speeds where there are constraints."""
    mechanism = lower(scene, Builder())
    return written(scene, mechanism, kane.derive(mechanism))


def written(scene: Scene, mechanism: Mechanism, rows: Rows) -> Equations:
    """The same from rows that were derived."""
    return textbook(scene, mechanism, kane.with_dependent_speeds(mechanism, rows), steps)


def steps(printer: Printer, mechanism: Mechanism) -> tuple[Step, ...]:
    """Partial velocities of the mass centres: what Kane's method projects on."""
    points = chain.motions(mechanism).points
    lines = []
    for body in mechanism.bodies:
        velocity = points[body.centre].velocity
        partials = [gradient([entry], [1], mechanism.u) for entry in velocity]
        for r, u in enumerate(mechanism.u):
            name = printer.symbol(u).name.replace("_", " ")
            for axis, partial in zip("xyz", partials, strict=True):
                (written,) = printer((partial[r],))
                if written != 0:
                    left = rf"\partial v_{{{body.name},{axis}}} / \partial \mathrm{{{name}}}"
                    lines.append(Line(left, written))
    text = "Partial velocities of the mass centres, inertial components."
    return (Step("Partial velocities", text, tuple(lines)),)
