"""The steps of procedure (ii), for people: choice, momenta, rates, loads."""

from collections.abc import Sequence

from sympy import Add, zeros

from mechanics.equations import Line, Step
from mechanics.routes.balance import Balance
from mechanics.routes.elimination import Solved
from mechanics.symbolic import canonical

LARGEST_SCENE = 6
"""Number of equations up to which every term is written out; beyond, only the choice."""


def derivation_steps(balances: Sequence[Balance], solved: Sequence[Solved]) -> tuple[Step, ...]:
    """The derivation in the order in which it was carried out."""
    chosen = "; ".join(balance.principle.words for balance in balances)
    text = f"Chosen so that the reactions drop out: {chosen}."
    if solved:
        loops = ", ".join(str(step.reaction) for step in solved)
        text += f" {loops} close a loop of bodies: they are let in, and eliminated by algebra."
    lines = tuple(Line(step.reaction, step.value, f"from {step.body}") for step in solved)
    choice = Step("Free bodies and moment centres", text, lines)
    if len(balances) > LARGEST_SCENE:
        return (choice,)
    terms: list[Line] = []
    for balance in balances:
        words = balance.principle.words
        turning = balance.principle.axis != zeros(3, 1)
        name, rate = ("H_B", r"\dot H_B") if turning else ("P", r"\dot P")
        terms.append(Line(name, canonical(balance.momentum), words))
        terms.append(Line(rate, canonical(balance.momentum_rate)))
        if turning:
            terms.append(Line(r"v_B \times P", canonical(balance.moving_term)))
        load = r"\sum \tau_B" if turning else r"\sum F"
        held = Add(*(factor * symbol for symbol, factor in balance.coefficients.items()))
        terms.append(Line(load, canonical(balance.applied) + held))
    text = "Momentum, its rate, the term of the moving point, and the loads, for each choice."
    return (choice, Step("Momenta, rates and loads", text, tuple(terms)))
