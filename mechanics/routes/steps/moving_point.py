r"""Procedure (ii) step by step: a free body and a moment centre, then one principle.

sum tau_B = dH_B/dt + v_B x P        H_B = sum of (H_C + BC x p)
"""

import re
from collections.abc import Mapping, Sequence

from sympy import Add, Dummy, Expr, Mul, Symbol, sign

from mechanics.equations import Diagram, Line, Step, Term
from mechanics.program.builder import Node
from mechanics.program.vectors import Vector, cross, dot, scale, subtract, times
from mechanics.routes.moving_point import Balance, Candidates, Choice, candidates, choose
from mechanics.routes.moving_point_terms import load_terms, moment_centre
from mechanics.routes.steps.writer import (
    Numbers,
    Writer,
    arrival,
    collected_from,
    worked_loads,
    worked_out,
)

LARGEST_SCENE = 6
"""Equations up to which every term is written out; beyond, those of one free body are."""


def steps(writer: Writer) -> tuple[Step, ...]:
    """Choice, then momenta, rates and loads of each free body, then the equations of motion."""
    mechanism, numbers = writer.mechanism, Numbers("P")
    choice = choose(mechanism)
    found = candidates(mechanism, mechanism.filters)
    chosen, solved = _choice(writer, numbers, choice)
    every = len(choice.balances) <= LARGEST_SCENE
    made, ends = [], []
    for balance in choice.balances if every else choice.balances[-1:]:
        step, end = _principle(writer, numbers, found, balance)
        made.append(step)
        ends.append(end)
    if solved:
        text = "The rows above, with these reactions eliminated by algebra."
        return (chosen, *made, Step("Equations of motion", text, writer.goal))
    return (chosen, *made, arrival(writer, ends))


def _choice(writer: Writer, numbers: Numbers, choice: Choice) -> tuple[Step, bool]:
    said = "; ".join(_words(writer, balance) for balance in choice.balances)
    text = f"Chosen so that the reactions drop out: {said}."
    symbols = [reaction.symbol for reaction in writer.printer.scene.reactions]
    lines: list[Line] = []
    for step in choice.elimination.solved:
        nodes = (step.row.value, step.row.coefficients[step.reaction])
        value, pivot = writer.printer(nodes)
        others = {r: c for r, c in step.row.coefficients.items() if r != step.reaction}
        rest = (value - _share(writer, others, symbols)) / pivot
        lines.append(numbers(symbols[step.reaction], rest))
    if lines:
        loops = ", ".join(str(line.left) for line in lines)
        text += f" {loops} close a loop of bodies: they are let in, and eliminated by algebra."
    return Step("Free bodies and moment centres", text, tuple(lines)), bool(lines)


def _principle(
    writer: Writer, numbers: Numbers, found: Candidates, balance: Balance
) -> tuple[Step, tuple[str, Expr]]:
    """One principle with everything that enters it, and the row that it gives."""
    if balance.principle.linear:
        lines, terms, rate = _linear(writer, numbers, found, balance)
    else:
        lines, terms, rate = _angular(writer, numbers, found, balance)
    shown = worked_out(numbers, (*terms, *rate), _put_in(lines))
    where, place = _centre(writer, found, balance)
    inside = writer.mechanism.subtree(balance.principle.root)
    diagram = Diagram(tuple(inside), _free(writer, inside), where, place)
    words = _words(writer, balance)
    title = words[0].upper() + words[1:]
    text = "Only what crosses the boundary of the free body is drawn."
    if not balance.principle.linear:
        text += " Moments are components along the axis; reactions at the moment centre have none."
    step = Step(title, text, (*lines, *shown), (diagram,))
    return step, (shown[-1].number, Add(*(t.value for t in (*terms, *rate))))


def _put_in(lines: Sequence[Line]) -> str:
    """Which lines go into the last one, the principle: the last that gives each of its sides."""
    *before, principle = lines
    sides = f"{principle.left} = {principle.right}"
    last = {str(line.left): line.number for line in before if str(line.left) in sides}
    whole = [left for left in last if not any(left != one and left in one for one in last)]
    return f"{', '.join(f'({last[left]})' for left in whole)} into ({principle.number})"


def _linear(
    writer: Writer, numbers: Numbers, found: Candidates, balance: Balance
) -> tuple[list[Line], list[Term], list[Term]]:
    along, printer, mechanism = balance.principle.along, writer.printer, writer.mechanism
    momentum = rf"{writer.letter('momentum')}"
    parts = [
        Term(part)
        for index in mechanism.subtree(balance.principle.root)
        for part in printer.short(
            (mechanism.bodies[index].mass * dot(found.bodies[index].centre.velocity, along),)
        )
        if part != 0
    ]
    (rate,) = printer.short((dot(balance.momentum_rate, along),))
    lines = [
        numbers(momentum, tuple(parts), "momentum of the free body along that direction"),
        numbers(rf"\dot{{{momentum}}}", rate),
    ]
    terms = _loads(writer, found, balance)
    force = writer.letter("active")
    lines.append(numbers(rf"\sum {force}", _side(terms), "loads along that direction"))
    lines.append(numbers(rf"\sum {force}", rf"\dot{{{momentum}}}", "principle of linear momentum"))
    return lines, terms, [Term(-rate)]


def _angular(
    writer: Writer, numbers: Numbers, found: Candidates, balance: Balance
) -> tuple[list[Line], list[Term], list[Term]]:
    printer, mechanism, axis = writer.printer, writer.mechanism, balance.principle.axis
    letter, _ = _centre(writer, found, balance)
    centre = moment_centre(found, balance)
    spin, momentum = writer.letter("spin"), writer.letter("momentum")
    lines, parts = [], []
    for index in mechanism.subtree(balance.principle.root):
        body, motion, label = mechanism.bodies[index], found.bodies[index], writer.centre(index)
        arm = subtract(motion.centre.position, centre)
        push = scale(body.mass, motion.centre.velocity)
        name = rf"\vec{{r}}_{{{letter}{label}}}"
        if any(column := writer.vector(arm)):
            lines.append(numbers(name, column, f"from ${letter}$ to ${label}$"))
        lines.append(numbers(rf"\vec{{{momentum}}}_{{{label}}}", writer.vector(push)))
        if motion.turning is not None and motion.inertia is not None:
            own = times(motion.inertia, motion.turning.omega)
            (turning,) = printer.short((dot(axis, own),))
            lines.append(numbers(rf"{spin}_{{{label}}}", turning, f"about ${label}$"))
            parts.append(Term(turning))
        moment = _moment(writer, axis, (arm, push))
        if moment != 0:
            lines.append(numbers(rf"{name} \times \vec{{{momentum}}}_{{{label}}}", moment))
            parts.append(Term(moment))
    whole, rate, moving = printer.short(
        (
            dot(axis, balance.spin),
            dot(axis, balance.spin_rate),
            dot(axis, cross(balance.velocity, balance.momentum)),
        )
    )
    lines.append(numbers(f"{spin}_{{{letter}}}", tuple(parts), "the sum of these"))
    if len(parts) != 1 or parts[0].value != whole:
        lines.append(numbers(f"{spin}_{{{letter}}}", whole, collected_from(parts)))
    lines += _rates(writer, numbers, rf"\dot{{{spin}}}_{{{letter}}}", whole, rate)
    speed = writer.vector(balance.velocity)
    if any(speed):
        there = numbers(rf"\vec{{r}}_{{{letter}}}", writer.vector(centre), f"where ${letter}$ is")
        rate_of_place = f"rate of ({there.number})"
        lines += [there, numbers(rf"\vec{{v}}_{{{letter}}}", speed, rate_of_place)]
    cross_name = rf"\vec{{v}}_{{{letter}}} \times \vec{{{momentum}}}"
    by_hand = _moment(writer, axis, (balance.velocity, balance.momentum))
    formula = _cross_formula(writer, axis, (f"v_{{{letter}", momentum))
    if by_hand != moving:
        lines.append(numbers(cross_name, by_hand, between=formula))
        formula = ""
    lines.append(numbers(cross_name, moving, between=formula if moving != 0 else ""))
    terms = _loads(writer, found, balance)
    torque = rf"\sum \tau_{{{letter}}}"
    products = _products(writer, found, balance)
    lines += worked_loads(numbers, torque, products, terms, "moments of the loads")
    law = rf"\dot{{{spin}}}_{{{letter}}} + {cross_name}"
    lines.append(numbers(torque, law, "principle of angular momentum about a moving point"))
    along = balance.principle.along
    pitch = printer.short((dot(along, subtract(balance.momentum_rate, balance.force)),))
    return lines, terms, [Term(-part) for part in (rate, moving, *pitch) if part != 0]


def _rates(writer: Writer, numbers: Numbers, name: str, whole: Expr, rate: Expr) -> list[Line]:
    """The rate of a momentum by the chain rule, then collected."""
    table = writer.mechanism.rates
    pairs = dict(
        zip(writer.printer(tuple(table)), writer.printer.short(tuple(table.values())), strict=True)
    )
    # A sign does not change but where it jumps.
    signs = {value: Dummy() for value in whole.atoms(sign)}
    fixed, back = whole.subs(signs), {dummy: value for value, dummy in signs.items()}
    parts = [
        Term(Mul(slope.subs(back), change, evaluate=False))
        for symbol, change in pairs.items()
        if (slope := fixed.diff(symbol)) != 0 and change != 0
    ]
    if len(parts) < 2:
        return [numbers(name, rate)]
    lines = [numbers(name, tuple(parts), "the derivative by each variable times its rate")]
    if Add(*(part.value for part in parts)) != rate:
        lines.append(numbers(name, rate, "collected"))
    return lines


def _cross_formula(writer: Writer, axis: Vector, names: tuple[str, str]) -> str:
    """The component of a cross product along z; none for other axes."""
    one, other = names
    direction = [*writer.vector(axis)]
    if direction not in ([0, 0, 1], [0, 0, -1]):
        return ""
    x, y = ("x", "y") if direction[2] == 1 else ("y", "x")
    first, second = (rf"{one},{{{a}}}}} {other}_{{{b}}}" for a, b in ((x, y), (y, x)))
    return f"{first} - {second}"


def _moment(writer: Writer, axis: Vector, sides: tuple[Vector, Vector]) -> Expr:
    """axis . (r x p) as it is multiplied by hand: brackets of components."""
    arm, push = (writer.vector(side) for side in sides)
    direction = writer.vector(axis)
    total = []
    for i, along in enumerate(direction):
        j, k = (i + 1) % 3, (i + 2) % 3
        for factor, one, other in ((1, arm[j], push[k]), (-1, arm[k], push[j])):
            if along != 0 and one != 0 and other != 0:
                before = () if factor * along == 1 else (factor * along,)
                total.append(Mul(*before, one, other, evaluate=False))
    return Add(*total)


def _loads(writer: Writer, found: Candidates, balance: Balance) -> list[Term]:
    """What loads do, each by its name, and the reactions that are let in."""
    merged: dict[str, Node] = {}
    for name, _, node in load_terms(writer.mechanism, found, balance):
        merged[name] = merged[name] + node if name in merged else node
    terms = [*writer.of_loads(merged)]
    symbols = [reaction.symbol for reaction in writer.printer.scene.reactions]
    factors = writer.printer.short(tuple(balance.coefficients.values()))
    for r, factor in zip(balance.coefficients, factors, strict=True):
        if factor != 0:
            terms.append(Term(factor * symbols[r], str(symbols[r])))
    return terms


def _products(writer: Writer, found: Candidates, balance: Balance) -> dict[str, Expr]:
    """For each load, its moment about the moving point as brackets of components."""
    axis, along = balance.principle.axis, balance.principle.along
    centre = moment_centre(found, balance)
    moments: dict[str, Expr] = {}
    for index in writer.mechanism.subtree(balance.principle.root):
        for load in found.loads[index]:
            (rest,) = writer.printer.expanded((dot(axis, load.couple) + dot(along, load.force),))
            moment = _moment(writer, axis, (subtract(load.at, centre), load.force))
            moments[load.name] = moments.get(load.name, Add()) + moment + rest
    return moments


def _side(terms: list[Term]) -> tuple[Term, ...] | Expr:
    return tuple(terms) or Add()


def _share(writer: Writer, coefficients: Mapping[int, Node], symbols: list[Symbol]) -> Expr:
    factors = writer.printer(tuple(coefficients.values()))
    return Add(*(f * symbols[r] for r, f in zip(coefficients, factors, strict=True)))


def _centre(writer: Writer, found: Candidates, balance: Balance) -> tuple[str, tuple[Node, ...]]:
    """A letter for the moment centre, and where it is."""
    if balance.principle.linear:
        return "", ()
    name = writer.mechanism.points[found.subtrees[balance.principle.root].point].name
    beside = any(not entry.is_zero for entry in balance.principle.offset)
    name = name if re.fullmatch(r"[A-Za-z]\w{0,2}", name) else "B"
    return name + ("'" if beside else ""), moment_centre(found, balance)


def _free(writer: Writer, inside: tuple[int, ...] | range) -> str:
    bodies = writer.mechanism.bodies
    if len(tuple(inside)) == len(bodies) > 1:
        return "whole system"
    return " and ".join(bodies[index].name for index in inside)


def _words(writer: Writer, balance: Balance) -> str:
    frame = writer.mechanism.frames[0].name
    words = re.sub(rf"\b{re.escape(frame)}\.([xyz])\b", r"\1", balance.words)
    if len(writer.mechanism.bodies) == 1:
        words = words.replace("whole system", writer.mechanism.bodies[0].name)
    return words
