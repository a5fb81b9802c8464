r"""Lagrange's method step by step.

d/dt (dL/dq') - dL/dq = Q + A^T lambda,      L = T - V
"""

from collections.abc import Sequence

from sympy import Add, Expr, Rational, S, Symbol

from mechanics.equations import Line, Step, Term
from mechanics.kinematics import differentiate
from mechanics.kinematics.motion import poses
from mechanics.program.builder import Node
from mechanics.program.derivatives import gradient
from mechanics.program.forward import tangent
from mechanics.routes.lagrange import (
    kinetic_energy,
    kinetic_parts,
    pressing_loads,
    virtual_power,
)
from mechanics.routes.loads import Wrench, other, potential
from mechanics.routes.rows import acceleration_forms, coefficients, substitute
from mechanics.routes.steps.writer import (
    FULL,
    Numbers,
    Writer,
    arrival,
    collected_from,
    pressed_step,
    shortest,
    worked_out,
)

DERIVATIVES = "Of ${}$: by a rate; that in time, along the motion; and by the coordinate."


def steps(writer: Writer) -> tuple[Step, ...]:
    """Energies, their derivatives, generalized forces, equations of motion."""
    mechanism, numbers = writer.mechanism, Numbers("L")
    energies = _energies(writer, numbers)
    if mechanism.u != mechanism.qd:
        return (energies, *_in_speeds(writer, numbers))
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
    pulls = _pulls(writer, [speed for _, _, speed in shown])
    held = [
        numbers(rf"{letter}^{{c}}_{{{name}}}", pull or S.Zero)
        for (name, _), pull in zip(names, pulls, strict=True)
        if mechanism.constraints
    ]
    rows: list[Line] = []
    ends: list[tuple[str, Expr]] = []
    for k, (name, dotted) in enumerate(names):
        own = [*terms[k], *(Term(-t.value, t.source) for t in (*loads[k], *pulls[k]))]
        own = [term for term in own if term.value != 0]
        _, total, by_place = _laws(lagrangian, name, dotted)
        lines = (*derivatives[3 * k + 1 : 3 * k + 3], forces[k], *held[k : k + 1])
        used = ", ".join(f"({line.number})" for line in lines)
        law = rf"{total} - {by_place} - {letter}_{{{name}}}"
        law += rf" - {letter}^{{c}}_{{{name}}}" if held else ""
        label = rf"{used} into ${law} = 0$"
        made = worked_out(numbers, own, label)
        rows += made
        ends.append((made[-1].number, Add(*(term.value for term in own))))
    pressed, ends = pressed_step(writer, numbers, ends)
    few = "" if len(shown) == len(pairs) else " Shown for the first coordinate; the others alike."
    return (
        energies,
        Step(
            "Derivatives",
            DERIVATIVES.format(lagrangian) + few,
            tuple(derivatives),
        ),
        Step(
            "Generalized forces",
            "Virtual work of the loads that have no potential, for each coordinate."
            if any(not _is_zero(line) for line in forces)
            else "Every load has a potential.",
            tuple(forces),
        ),
        *_held(held),
        Step("Lagrange's equations", "", tuple(rows)),
        *pressed,
        arrival(writer, ends),
    )


def _in_speeds(writer: Writer, numbers: Numbers) -> tuple[Step, ...]:
    """Declared speeds: (2) of `mechanics.routes.lagrange`, for the first, or all of few."""
    mechanism, printer, lagrangian = writer.mechanism, writer.printer, writer.letter("lagrangian")
    energy = kinetic_energy(mechanism) - potential(mechanism, poses(mechanism))
    speeds = mechanism.u if len(mechanism.u) <= FULL else mechanism.u[:1]
    shares = coefficients(mechanism.q_rates, speeds)
    derivatives: list[Line] = []
    seen: set[Symbol] = set()
    laws: dict[int, tuple[Node, str, tuple[str, str]]] = {}
    for j, (q, rate) in enumerate(zip(mechanism.q, mechanism.qd, strict=True)):
        if all(share.is_zero for share in shares[j]):
            continue
        names = [rf"<<{printer.symbol(node).name}>>" for node in (q, rate)]
        momentum, slope = gradient([energy], [1], (rate, q))
        (growth,) = tangent([momentum], mechanism.coordinate_rates)
        law = _laws(lagrangian, *names)
        values = printer.short((momentum, growth, slope))
        lines = [numbers(left, value) for left, value in zip(law, values, strict=True)]
        derivatives += lines
        seen = seen.union(*(value.free_symbols for value in values))
        laws[j] = growth - slope, f"{law[1]} - {law[2]}", (lines[1].number, lines[2].number)
    second = tangent(mechanism.q_rates, mechanism.rates)
    table = dict(zip(mechanism.qd, mechanism.q_rates, strict=True))
    table |= zip(mechanism.qdd, second, strict=True)
    rates = [
        numbers(printer.symbol(node), printer.short((value,))[0])
        for node, value in table.items()
        if printer.symbol(node) in seen and node not in mechanism.u
    ]
    letter = writer.letter("forces")
    loads, pulls = [_forces(writer, speed) for speed in speeds], _pulls(writer, speeds)
    titles = [f"<<{printer.symbol(speed).name}>>" for speed in speeds]
    forces = [
        numbers(rf"{letter}_{{{title}}}", tuple(own) or S.Zero)
        for title, own in zip(titles, loads, strict=True)
    ]
    held = [
        numbers(rf"{letter}^{{c}}_{{{title}}}", pull or S.Zero)
        for title, pull in zip(titles, pulls, strict=True)
        if mechanism.constraints
    ]
    rows: list[Line] = []
    ends: list[tuple[str, Expr]] = []
    for k, title in enumerate(titles):
        parts = {j: shares[j][k] for j in laws if not shares[j][k].is_zero}
        nodes = [share * laws[j][0] for j, share in parts.items()]
        put_in = printer.short(substitute(mechanism.builder, nodes, table))
        own = [Term(value) for value in put_in]
        own += [Term(-term.value, term.source) for term in (*loads[k], *pulls[k])]
        own = [term for term in own if term.value != 0]
        names = [number for j in parts for number in laws[j][2]]
        names += [line.number for line in (forces[k], *held[k : k + 1])]
        used = ", ".join(f"({name})" for name in names)
        used += f" with ({rates[0].number}) to ({rates[-1].number})" if rates else ""
        weights = printer.short(tuple(parts.values()))
        (first, *more) = parts
        into = f" into ${laws[first][1]} - {letter}_{{{title}}}"
        into += f" - {letter}^{{c}}_{{{title}}} = 0$" if held else " = 0$"
        made = worked_out(numbers, own, used + (into if not more and weights[0] == 1 else ""))
        rows += made
        ends.append((made[-1].number, Add(*(term.value for term in own))))
    pressed, ends = pressed_step(writer, numbers, ends)
    few = "" if len(speeds) == len(mechanism.u) else " Shown for the first speed; the others alike."
    return (
        Step("Derivatives", DERIVATIVES.format(lagrangian) + few, (*derivatives,)),
        Step("Rates", "What the declared speeds say of the coordinates.", tuple(rates)),
        Step(
            "Generalized forces",
            "Power of the loads that have no potential, by each speed."
            if any(not _is_zero(line) for line in forces)
            else "Every load has a potential.",
            tuple(forces),
        ),
        *_held(held),
        Step(
            "Lagrange's equations",
            "Each coordinate's equation, times how its rate depends on the speed; their sum is the"
            " equation of the speed.",
            tuple(rows),
        ),
        *pressed,
        arrival(writer, ends),
    )


def _laws(lagrangian: str, name: str, dotted: str) -> tuple[str, str, str]:
    """dL/dq', its rate, and dL/dq."""
    by_rate, by_place = (
        rf"\frac{{\partial {lagrangian}}}{{\partial {symbol}}}" for symbol in (dotted, name)
    )
    return by_rate, rf"\frac{{d}}{{dt}} {by_rate}", by_place


def _held(lines: list[Line]) -> tuple[Step, ...]:
    text = (
        "Each constraint, differentiated down to the accelerations, times its multiplier: how it"
        " depends on each of them."
    )
    return (Step("Forces of the constraints", text, tuple(lines)),) if lines else ()


def _pulls(writer: Writer, speeds: Sequence[Node]) -> list[tuple[Term, ...]]:
    """What each constraint does in the equation of each speed: lambda_i A_i."""
    mechanism = writer.mechanism
    accelerations = [mechanism.ud[mechanism.u.index(speed)] for speed in speeds]
    columns: list[list[Term]] = [[] for _ in speeds]
    for k, form in enumerate(acceleration_forms(mechanism), start=1):
        multiplier = writer.printer.symbols[f"lambda{k}"]
        factors = writer.printer.short(gradient([form], [1], accelerations))
        for column, factor in zip(columns, factors, strict=True):
            if factor != 0:
                column.append(Term(factor * multiplier))
    return [tuple(column) for column in columns]


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
                words = collected_from((Term(square),))
                squares.append(numbers(rf"v_{{{writer.centre(index)}}}^{{2}}", short, words))
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
    unknown = {
        f.reaction: mechanism.builder.input(mechanism.reactions[f.reaction].name)
        for f in mechanism.frictions
    }
    for wrench in (*other(mechanism, motions), *pressing_loads(mechanism, motions, unknown)):
        merged.setdefault(wrench.name, []).append(wrench)
    place = mechanism.u.index(speed)
    powers = {
        name: virtual_power(mechanism, motions, wrenches)[place]
        for name, wrenches in merged.items()
    }
    return [*writer.of_loads(powers)]
