"""Lagrange's equations of a scene, written out from `mechanics.routes.programs.lagrange`."""

from sympy import Add, Rational

from mechanics.equations import Equations, Line, Step
from mechanics.mechanism import Mechanism, lower
from mechanics.program import Builder
from mechanics.routes.programs import lagrange
from mechanics.routes.programs.loads import potential
from mechanics.routes.programs.motion import poses
from mechanics.routes.programs.rows import Rows
from mechanics.routes.textbook import Printer, textbook
from mechanics.scene import Scene
from mechanics.scene.loads import CONSERVATIVE
from mechanics.symbolic import canonical


def derive(scene: Scene) -> Equations:
    """Equations of motion by Lagrange's method, with multipliers for every constraint."""
    mechanism = lower(scene, Builder())
    return written(scene, mechanism, lagrange.derive(mechanism))


def written(scene: Scene, mechanism: Mechanism, rows: Rows) -> Equations:
    """The same from rows that were derived."""
    return textbook(scene, mechanism, rows, steps)


def steps(printer: Printer, mechanism: Mechanism) -> tuple[Step, ...]:
    """Kinetic and potential energy."""
    parts = lagrange.kinetic_parts(mechanism)
    half, kinetic = Rational(1, 2), []
    for mass, velocity, spin in parts:
        (m, turning), moving = printer((mass, spin)), printer(velocity)
        kinetic += [half * m * Add(*(canonical(v) ** 2 for v in moving)), half * canonical(turning)]
    (stored,) = printer((potential(mechanism, poses(mechanism)),))
    loads = printer.scene.loads
    power = tuple(load.name for load in loads if not isinstance(load, CONSERVATIVE))
    extra = f" Generalized forces: {', '.join(power)}." if power else ""
    text = "Kinetic and potential energy in the coordinates and their rates." + extra
    return (Step("Energies", text, (Line("T", Add(*kinetic)), Line("V", stored))),)
