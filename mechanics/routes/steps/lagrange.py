r"""Lagrange's method step by step.

d/dt (dL/dq') - dL/dq = Q,      L = T - V
"""

from __future__ import annotations

from sympy import Add, Expr, Rational, S

from mechanics.equations import Line, Step, Term
from mechanics.kinematics import differentiate
from mechanics.kinematics.motion import poses
from mechanics.program.builder import Node
from mechanics.program.derivatives import gradient
from mechanics.program.forward import tangent
from mechanics.routes.lagrange import kinetic_energy, kinetic_parts, virtual_power
from mechanics.routes.loads import Wrench, other, potential
from mechanics.routes.steps.writer import FULL, Numbers, Writer, arrival, shortest, worked_out


def steps(writer: Writer) -> tuple[Step, ...]:
    """Energies, their derivatives, generalized forces, equations of motion."""
    mechanism, numbers = writer.mechanism, Numbers("L")
    energies = _energies(writer, numbers)
    if mechanism.u != mechanism.qd or mechanism.constraints or mechanism.frictions:
        text = (
            "Differentiated, projected on the speeds, with a multiplier for each constraint."
            if mechanism.constraints or mechanism.u != mechanism.qd
            else "Differentiated; the reaction that presses enters with its friction."
        )
        return (energies, Step("Equations of motion", text, writer.goal))
    lagrangian = writer.letter("lagrangian")
    energy = kinetic_energy(mechanism) - potential(mechanism, poses(mechanism))
    pairs = list(zip(mechanism.q, mechanism.qd, mechanism.u, strict=True))
    shown = pairs if len(pairs) <= FULL else pairs[:1]
    names = [
        tuple(rf"<<{writer.printer.symbol(node).name}>>" for node in (q, rate))
        for q, rate, _ in shown
    ]
    derivatives, terms = [], []
    for (q, rate, _), (name, dotted) in zip(shown, names, strict=True):
        momentum, slope = gradient([energy], [1], (rate, q))
        (growth,) = tangent([momentum], mechanism.coordinate_rates)
        values = writer.printer.short((momentum, growth, slope))
        for law, value in zip(_laws(lagrangian, name, dotted), values, strict=True):
            derivatives.append(numbers(law, value))
        terms.append([Term(values[1]), Term(-values[2])])
    loads = [_forces(writer, speed) for _, _, speed in shown]
    letter = writer.letter("forces")
    forces = [
        numbers(rf"{letter}_{{{name}}}", tuple(own) or S.Zero)
        for (name, _), own in zip(names, loads, strict=True)
    ]
    rows: list[Line] = []
    ends: list[tuple[str, Expr]] = []
    for k, (name, dotted) in enumerate(names):
        own = [*terms[k], *(Term(-t.value, t.source) for t in loads[k])]
        own = [term for term in own if term.value != 0]
        _, total, by_place = _laws(lagrangian, name, dotted)
        used = ", ".join(f"({n.number})" for n in (*derivatives[3 * k + 1 : 3 * k + 3], forces[k]))
        label = rf"{used} into ${total} - {by_place} - {letter}_{{{name}}} = 0$"
        made = worked_out(numbers, own, label)
        rows += made
        ends.append((made[-1].number, Add(*(term.value for term in own))))
    few = "" if len(shown) == len(pairs) else " Shown for the first coordinate; the others alike."
    return (
        energies,
        Step(
            "Derivatives",
            rf"Of ${lagrangian}$, the rate along the motion." + few,
            tuple(derivatives),
        ),
        Step(
            "Generalized forces",
            "Virtual work of the loads that have no potential, for each coordinate."
            if any(not _is_zero(line) for line in forces)
            else "Every load has a potential.",
            tuple(forces),
        ),
        Step("Lagrange's equations", "", tuple(rows)),
        arrival(writer, ends),
    )


def _laws(lagrangian: str, name: str, dotted: str) -> tuple[str, str, str]:
    """dL/dq', its rate, and dL/dq."""
    by_rate, by_place = (
        rf"\frac{{\partial {lagrangian}}}{{\partial {symbol}}}" for symbol in (dotted, name)
    )
    return by_rate, rf"\frac{{d}}{{dt}} {by_rate}", by_place


def _is_zero(line: Line) -> bool:
    return not isinstance(line.right, tuple)


def _energies(writer: Writer, numbers: Numbers) -> Step:
    mechanism, printer, half = writer.mechanism, writer.printer, Rational(1, 2)
    kinetic = []
    squares = []
    for index, (mass, velocity, spin) in enumerate(kinetic_parts(mechanism)):
        (m, turning), moving = printer((mass, spin)), printer.expanded(velocity)
        square = Add(*(v**2 for v in moving))
        if square != 0:
            short = shortest(square)
            squares.append(numbers(rf"v_{{{writer.centre(index)}}}^{{2}}", square))
            if short != square:
                squares.append(numbers(rf"v_{{{writer.centre(index)}}}^{{2}}", short, "collected"))
            kinetic.append(Term(half * m * short))
        if turning != 0:
            kinetic.append(Term(half * shortest(turning)))
    (stored,) = printer.short((potential(mechanism, poses(mechanism)),))
    t, v = writer.letter("kinetic"), writer.letter("potential")
    lines = [*squares, numbers(t, tuple(kinetic) or S.Zero, "kinetic energy")]
    lines.append(numbers(v, stored, "potential energy"))
    lines.append(numbers(writer.letter("lagrangian"), f"{t} - {v}"))
    text = "In the coordinates and their rates; velocities are derivatives of positions."
    return Step("Energies", text, tuple(lines))


def _forces(writer: Writer, speed: Node) -> list[Term]:
    """Virtual work of each load that has no potential."""
    mechanism = writer.mechanism
    motions = differentiate.motions(mechanism)
    merged: dict[str, list[Wrench]] = {}
    for wrench in other(mechanism, motions):
        merged.setdefault(wrench.name, []).append(wrench)
    place = mechanism.u.index(speed)
    powers = {
        name: virtual_power(mechanism, motions, wrenches)[place]
        for name, wrenches in merged.items()
    }
    return [*writer.of_loads(powers)]
