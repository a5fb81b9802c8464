"""Procedure (i) step by step: free bodies, momentum principles, elimination of the reactions."""

from sympy import Add, Expr, Mul, Symbol

from mechanics.equations import Diagram, Line, Step, Term
from mechanics.kinematics import differentiate
from mechanics.kinematics.motion import Motions
from mechanics.mechanism import Mechanism
from mechanics.program.vectors import subtract
from mechanics.routes.free_body import FreeBodyRow, eliminated
from mechanics.routes.multipliers import solution
from mechanics.routes.steps.writer import (
    FULL,
    SHORT_NAME,
    Numbers,
    Writer,
    arrival,
    kinematics,
    worked_out,
)

Sides = tuple[tuple[Term, ...], Expr]


def steps(writer: Writer) -> tuple[Step, ...]:
    """Kinematics, momenta, free bodies, elimination, equations of motion."""
    printer, mechanism, numbers = writer.printer, writer.mechanism, Numbers("F")
    rows, elimination = eliminated(mechanism)
    motions = differentiate.motions(mechanism)
    first = kinematics(writer, numbers, motions, accelerations=False)
    momenta = tuple(
        numbers(_momentum(writer, row), *printer.short((row.momentum,))) for row in rows
    )
    symbols = [reaction.symbol for reaction in printer.scene.reactions]
    arms = _arms(writer, numbers, motions)
    sides = [_sides(writer, row, symbols) for row in rows]
    equations = [
        numbers(left, right, _label(writer, row), _momentum(writer, row, rate=True))
        for row, (left, right) in zip(rows, sides, strict=True)
    ]
    solved: dict[Symbol, tuple[Expr, str]] = {}
    lines: list[Line] = []
    for step in elimination.solved:
        symbol, value = symbols[step.reaction], solution(printer, step, symbols)
        source = equations[step.row.place]
        inserted = [solved[s][1] for s in solved if s in Add(*_values(source)).free_symbols]
        label = f"from ({source.number})" + _with(inserted)
        lines.append(numbers(symbol, value, label))
        solved[symbol] = value, lines[-1].number
    ends: list[tuple[str, Expr]] = []
    results: list[Line] = []
    for row in elimination.work:
        if row.place < 0:
            continue
        left, right = sides[row.place]
        put_in = [s for s in solved if any(t.value.has(s) for t in left)]
        names = ", ".join(f"({solved[s][1]})" for s in put_in)
        label = f"{names} into ({equations[row.place].number})" if names else ""
        terms = (*(_inserted(term, solved) for term in left), Term(-right))
        if not names:
            ends.append((equations[row.place].number, Add(*(t.value for t in terms))))
            continue
        full = not results or len(mechanism.u) <= FULL
        shown = worked_out(numbers, terms, label, full)
        results += shown
        ends.append((shown[-1].number, Add(*(term.value for term in terms))))
    loads = "Every load and every reaction is an arrow in the direction in which it is declared"
    diagrams = tuple(Diagram((index,), body.name) for index, body in enumerate(mechanism.bodies))
    return (
        first,
        Step(
            "Momenta",
            "Linear momentum of each body, and angular momentum about its mass centre.",
            momenta,
        ),
        Step(
            "Free bodies",
            f"{loads}; on two bodies that touch it is opposite. Loads and reactions stand on the"
            " left, the rate of momentum on the right; moments are about the mass centre.",
            (*arms, *equations),
            diagrams if len(diagrams) <= 2 * FULL else diagrams[:FULL],
        ),
        *_elimination(lines, results),
        arrival(writer, ends),
    )


def _elimination(lines: list[Line], results: list[Line]) -> tuple[Step, ...]:
    if not lines:
        return ()
    text = "Each reaction is solved from one equation and put into the others."
    return (Step("Elimination of the reactions", text, (*lines, *results)),)


def _sides(writer: Writer, row: FreeBodyRow, symbols: list[Symbol]) -> Sides:
    """Terms of loads and reactions, and the rate of momentum."""
    printer = writer.printer
    loads = printer.short([node for _, node in row.loads])
    rate, *factors = printer.short((row.rate, *row.coefficients.values()))
    left = [
        Term(value, name) for (name, _), value in zip(row.loads, loads, strict=True) if value != 0
    ]
    left += [
        Term(factor * symbols[r], str(symbols[r]))
        for r, factor in zip(row.coefficients, factors, strict=True)
    ]
    return tuple(left), rate


def _values(line: Line) -> list[Expr]:
    return [term.value for term in line.left] if isinstance(line.left, tuple) else []


def _inserted(term: Term, solved: dict[Symbol, tuple[Expr, str]]) -> Term:
    """A reaction by its value, in brackets, until none is left that was solved for."""
    value = term.value
    while held := [s for s in solved if value.has(s)]:
        factor = value.coeff(held[0])
        rest = value - factor * held[0]
        one = solved[held[0]][0]
        value = rest + (one if factor == 1 else Mul(*Mul.make_args(factor), one, evaluate=False))
        if rest != 0:
            value = value.expand()
    return Term(value, term.source)


def _with(numbers: list[str]) -> str:
    return f" with {', '.join(f'({n})' for n in numbers)}" if numbers else ""


def _arms(writer: Writer, numbers: Numbers, motions: Motions) -> tuple[Line, ...]:
    """From the mass centre of each body that turns to where forces act on it."""
    mechanism, found = writer.mechanism, []
    acting = [(r.at, {r.on, r.by}) for r in mechanism.reactions]
    acting += [(push.at, {push.on, push.by}) for push in mechanism.pushes]
    acting += [(line.first, {line.by}) for line in mechanism.lines]
    acting += [(line.second, {line.on}) for line in mechanism.lines]
    for index, body in enumerate(mechanism.bodies):
        points = dict.fromkeys(at for at, on in acting if at is not None and index in on)
        for point in points if body.frame is not None else ():
            centre, whole = motions.points[body.centre].position, mechanism.points[point].name
            name = _letter(mechanism, point)
            arm = writer.vector(subtract(motions.points[point].position, centre))
            if any(arm):
                label = rf"\vec{{r}}_{{{writer.centre(index)}{name}}}"
                words = f"from ${writer.centre(index)}$ to ${name}$"
                words += "" if name == whole else f", the {whole}"
                found.append(numbers(label, arm, words))
    return tuple(found)


def _letter(mechanism: Mechanism, point: int) -> str:
    """The name of a point, or, where that is words, the letter of the reactions there or a P."""
    names = [place.name for place in mechanism.points]
    if SHORT_NAME.fullmatch(names[point]):
        return names[point]
    letters = {r.name[0] for r in mechanism.reactions if r.at == point}
    return letters.pop() if len(letters) == 1 and not letters & {*names} else f"P_{{{point}}}"


def _momentum(writer: Writer, row: FreeBodyRow, rate: bool = False) -> str:
    letter = writer.letter("momentum" if row.kind == "linear" else "spin")
    letter = rf"\dot{{{letter}}}" if rate else letter
    return rf"{letter}_{{{writer.centre(row.body)},{writer.subscript(row.axis)}}}"


def _label(writer: Writer, row: FreeBodyRow) -> str:
    name = writer.mechanism.bodies[row.body].name
    way = "force along" if row.kind == "linear" else "moment about"
    return f"{name}, {way} {writer.axis(row.axis)}"
