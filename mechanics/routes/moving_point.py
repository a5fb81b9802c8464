"""Equations of procedure (ii), written out from `mechanics.routes.programs.moving_point`."""

from collections.abc import Mapping

from sympy import Add, Expr

from mechanics.equations import Equations, Line, Step
from mechanics.mechanism import Mechanism, lower
from mechanics.program import Builder
from mechanics.program.builder import Node
from mechanics.program.vectors import cross, dot
from mechanics.routes.programs import moving_point
from mechanics.routes.programs.rows import Rows
from mechanics.routes.textbook import Printer, textbook
from mechanics.scene import Scene

LARGEST_SCENE = 6
"""Number of equations up to which every term is written out; beyond, only the choice."""


def derive(scene: Scene) -> Equations:
    """Equations of motion from principles in which the reactions do not enter."""
    mechanism = lower(scene, Builder())
    return written(scene, mechanism, moving_point.derive(mechanism))


def written(scene: Scene, mechanism: Mechanism, rows: Rows) -> Equations:
    """The same from rows that were derived."""
    return textbook(scene, mechanism, rows, steps)


def steps(printer: Printer, mechanism: Mechanism) -> tuple[Step, ...]:
    """Choice, momenta, rates, loads."""
    choice = moving_point.choose(mechanism)
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
