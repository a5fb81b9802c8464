"""How each route derives, step by step, for people: its programs in SymPy."""

from collections.abc import Mapping

from sympy import Add, Expr, Rational

from mechanics.equations import Line, Step
from mechanics.kinematics import chain, differentiate
from mechanics.kinematics.motion import Motions, poses
from mechanics.kinematics.printer import Printer
from mechanics.mechanism import Mechanism
from mechanics.program.builder import Node
from mechanics.program.derivatives import gradient
from mechanics.program.vectors import cross, dot
from mechanics.routes.free_body import FreeBodyRow, eliminated
from mechanics.routes.lagrange import kinetic_parts
from mechanics.routes.loads import potential
from mechanics.routes.moving_point import choose
from mechanics.routes.multipliers import solution
from mechanics.scene.loads import CONSERVATIVE
from mechanics.symbolic import canonical

LARGEST_SCENE = 6
"""Equations of `moving_point` up to which every term is written out; beyond, only the choice."""


def free_body(printer: Printer, mechanism: Mechanism) -> tuple[Step, ...]:
    """Kinematics, momenta, free bodies, elimination."""
    rows, elimination = eliminated(mechanism)
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
        rest = solution(printer, step, symbols)
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


def moving_point(printer: Printer, mechanism: Mechanism) -> tuple[Step, ...]:
    """Choice, momenta, rates, loads."""
    choice = choose(mechanism)
    symbols = [reaction.symbol for reaction in printer.scene.reactions]

    def share(coefficients: Mapping[int, Node], but: int | None = None) -> Expr:
        factors = printer(tuple(coefficients.values()))
        pairs = zip(coefficients, factors, strict=True)
        return Add(*(factor * symbols[r] for r, factor in pairs if r != but))

    text = f"Chosen so that the reactions drop out: {'; '.join(b.words for b in choice.balances)}."
    lines = []
    for step in choice.elimination.solved:
        value, pivot = printer((step.row.value, step.row.coefficients[step.reaction]))
        rest = (value - share(step.row.coefficients, step.reaction)) / pivot
        lines.append(Line(symbols[step.reaction], rest))
    if lines:
        loops = ", ".join(str(line.left) for line in lines)
        text += f" {loops} close a loop of bodies: they are let in, and eliminated by algebra."
    chosen = Step("Free bodies and moment centres", text, tuple(lines))
    if len(choice.balances) > LARGEST_SCENE:
        return (chosen,)
    terms: list[Line] = []
    for balance in choice.balances:
        axis, along = balance.principle.axis, balance.principle.along
        turning = not balance.principle.linear
        momentum, rate, moving, applied = printer.expanded(
            (
                dot(axis, balance.spin) + dot(along, balance.momentum),
                dot(axis, balance.spin_rate) + dot(along, balance.momentum_rate),
                dot(axis, cross(balance.velocity, balance.momentum)),
                dot(axis, balance.torque) + dot(along, balance.force),
            )
        )
        name, rate_name = ("H_B", r"\dot H_B") if turning else ("P", r"\dot P")
        terms += [Line(name, momentum, balance.words), Line(rate_name, rate)]
        if turning:
            terms.append(Line(r"v_B \times P", moving))
        load = r"\sum \tau_B" if turning else r"\sum F"
        terms.append(Line(load, applied + share(balance.coefficients)))
    text = "Momentum, its rate, the term of the moving point, and the loads, for each choice."
    return (chosen, Step("Momenta, rates and loads", text, tuple(terms)))


def kane(printer: Printer, mechanism: Mechanism) -> tuple[Step, ...]:
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


def lagrange(printer: Printer, mechanism: Mechanism) -> tuple[Step, ...]:
    """Kinetic and potential energy."""
    parts = kinetic_parts(mechanism)
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
