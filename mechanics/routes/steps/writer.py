"""What the derivations of all routes share: names for what they introduce, numbers, the goal.

row_goal = sum_j c_j row_j,   c rational        how the rows of a route end in the common form
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import count
from typing import Any

from flint import nmod_mat
from sympy import (
    Add,
    Expr,
    Matrix,
    Rational,
    Symbol,
    collect,
    cos,
    expand,
    expand_trig,
    sin,
)

from mechanics.equations import Line, Side, Step, Term
from mechanics.kinematics.motion import Motions
from mechanics.kinematics.printer import Printer
from mechanics.mechanism import Mechanism
from mechanics.program.builder import Builder, Node
from mechanics.program.residues import Residues
from mechanics.program.sympy_reader import read
from mechanics.program.vectors import Vector
from mechanics.routes.multipliers import meanings
from mechanics.symbolic import operations, tidy

FULL = 3
"""Coordinates up to which every equation is shown in full; beyond, the first one is."""
MOST = 40
"""Products of an equation that is multiplied out in front of the reader."""
LARGEST = 1_000_000
"""Above and below in a factor of a row: what is no number at all has more digits."""
SHORT_NAME = re.compile(r"[A-Za-z]\w{0,2}'?")
"""A point whose name can stand as a subscript."""
CENTRES = "CGSABDEFHJKLMPQRTUVW"
"""Letters for mass centres whose points have names that are no letters."""
LETTERS = {
    "kinetic": (("T", "T"), ("E_k", "E_{k}")),
    "potential": (("V", "V"), ("U", "U"), ("E_p", "E_{p}")),
    "lagrangian": (("L", "L"), ("", r"\mathcal{L}")),
    "momentum": (("p", "p"), ("P", "P"), ("", r"\Pi")),
    "spin": (("H", "H"), ("", r"\mathcal{H}")),
    "active": (("F", "F"), ("K", "K"), ("", r"\Phi")),
    "forces": (("Q", "Q"), ("", r"\mathcal{Q}")),
}
"""What a textbook calls them, and what they are called where a scene has that name already."""


@dataclass(frozen=True)
class Writer:
    """A scene, how it is printed, and what its derivation has to arrive at.

    Attributes
    ----------
    goal : tuple of Line
        The equations in the common form, numbered, or in the route's own form.
    pressed : mapping of Symbol to Expr
        Reactions that friction depends on, by accelerations.
    """

    printer: Printer
    mechanism: Mechanism
    goal: tuple[Line, ...]
    pressed: Mapping[Symbol, Expr]

    def letter(self, quantity: str) -> str:
        """LaTeX of a quantity that the scene does not name, by a letter that it does not use."""
        taken = self.printer.symbols
        return next(latex for plain, latex in LETTERS[quantity] if plain not in taken)

    def centre(self, body: int) -> str:
        """Subscript for the mass centre of a body: the name of the point, else a free letter."""
        names = [self.mechanism.points[b.centre].name for b in self.mechanism.bodies]
        # A joint without a letter has the first one of its reactions.
        taken = {point.name for point in self.mechanism.points}
        taken |= {reaction.name[:1] for reaction in self.mechanism.reactions}
        free = (letter for letter in CENTRES if letter not in taken)
        for k, name in enumerate(names[: body + 1]):
            short = SHORT_NAME.fullmatch(name) and names.count(name) == 1
            label = name if short else next(free, str(k + 1))
        return label

    def axis(self, name: str) -> str:
        """An axis for people: that of the inertial frame is a letter, A.x is x of A."""
        frame, _, letter = name.partition(".")
        return letter if frame == self.mechanism.frames[0].name else f"{letter} of {frame}"

    def subscript(self, name: str) -> str:
        """The same as a subscript."""
        frame, _, letter = name.partition(".")
        return letter if frame == self.mechanism.frames[0].name else f"{letter}_{{{frame}}}"

    def of_loads(self, nodes: Mapping[str, Node]) -> tuple[Term, ...]:
        """What each load or reaction does, by its name: inputs before brackets."""
        inputs = self.printer.scene.input_symbols
        values = [collect(expand(v), inputs) for v in self.printer.expanded(tuple(nodes.values()))]
        return tuple(Term(v, name) for name, v in zip(nodes, values, strict=True) if v != 0)

    def vector(self, entries: Vector) -> Matrix:
        """Inertial components in the normal form, as a column."""
        return Matrix(self.printer.expanded(entries))


class Numbers:
    """The numbers of the equations of one route: F1, F2, ..."""

    def __init__(self, prefix: str) -> None:
        self._prefix, self._count = prefix, count(1)

    def __call__(self, left: Side, right: Side, label: str = "", between: str = "") -> Line:
        """A line with the next number."""
        return Line(left, right, label, f"{self._prefix}{next(self._count)}", between)


def kinematics(writer: Writer, numbers: Numbers, motions: Motions, accelerations: bool) -> Step:
    """Position, velocity and angular velocity of every body; accelerations where they are used."""
    mechanism, lines, names = writer.mechanism, [], []
    for index, body in enumerate(mechanism.bodies):
        point, label = motions.points[body.centre], writer.centre(index)
        vectors = [("r", point.position), ("v", point.velocity)]
        vectors += [("a", point.acceleration)] if accelerations else []
        if body.frame is not None:
            turning = motions.frames[body.frame]
            vectors.append((r"\omega", turning.omega))
            vectors += [(r"\alpha", turning.alpha)] if accelerations else []
        for letter, entries in vectors:
            column = writer.vector(entries)
            if any(column):
                lines.append(numbers(rf"\vec{{{letter}}}_{{{label}}}", column))
        names.append(f"${label}$ is the mass centre of {_the(body.name)}")
    whose = "Its position is" if len(names) == 1 else "Their positions are"
    way = (
        "differentiated twice along frames and points"
        if accelerations
        else "and differentiated for the velocity"
    )
    text = f"{'; '.join(names)}. {whose} read from the drawing, {way}."
    return Step("Kinematics", text, tuple(lines))


def shortest(expr: Expr) -> Expr:
    """An expression, or its normal form where that is shorter."""
    return min(expr, tidy(expr), key=operations)


def _the(name: str) -> str:
    return f"the {name}" if name.replace(" ", "").isalpha() else name


def multiplied_out(terms: Sequence[Term]) -> tuple[Term, ...]:
    """The products of some terms one by one, those that cancel marked; none where too many."""
    products = [
        Term(product, term.source)
        for term in terms
        for product in Add.make_args(expand(term.value))
        if product != 0
    ]
    if len(products) > MOST:
        return ()
    totals: dict[Expr, Expr] = {}
    for product in products:
        factor, rest = product.value.as_coeff_Mul()
        totals[rest] = totals.get(rest, 0) + factor
    return tuple(
        replace(product, cancels=totals[product.value.as_coeff_Mul()[1]] == 0)
        for product in products
    )


def squares_meet(terms: Sequence[Term]) -> tuple[Expr, ...]:
    """Angles whose squared sine and cosine stand with the same factor in what does not cancel."""
    left = {term.value.as_coeff_Mul()[1] for term in terms if not term.cancels}
    found = []
    for value in left:
        for factor in value.atoms(cos):
            if value.has(factor**2) and value * sin(factor.args[0]) ** 2 / factor**2 in left:
                found.append(factor.args[0])
    return tuple(dict.fromkeys(found))


def worked_out(
    numbers: Numbers, terms: Sequence[Term], label: str, full: bool = True
) -> tuple[Line, ...]:
    """A row with everything put in, and, in full, multiplied out: 0 on the right."""
    products = multiplied_out(terms) if full else ()
    before = {part for term in terms for part in Add.make_args(term.value)}
    words = ["what cancels is grey"] if any(product.cancels for product in products) else []
    words += _identities(products)
    if {product.value for product in products} == before:
        return (numbers(products, Rational(0), "; ".join((label, *words))),)
    lines = [numbers(tuple(terms), Rational(0), label)]
    if products:
        lines.append(numbers(products, Rational(0), "; ".join(("multiplied out", *words))))
    return tuple(lines)


def worked_loads(
    numbers: Numbers,
    left: str,
    products: Mapping[str, Expr],
    terms: Sequence[Term],
    label: str = "",
) -> list[Line]:
    """What loads do, each as the product that a person forms, then carried out."""
    formed = [replace(term, value=products.get(term.source, term.value)) for term in terms]
    lines = [numbers(left, tuple(formed) or Rational(0), label)]
    if formed != list(terms):
        words = ("multiplied out", *_identities(multiplied_out(formed)))
        lines.append(numbers(left, tuple(terms), "; ".join(words)))
    return lines


def collected_from(terms: Sequence[Term]) -> str:
    """What is said of a sum that is collected: with the identity that it takes."""
    return "; ".join(("collected", *_identities(multiplied_out(terms))))


def _identities(products: Sequence[Term]) -> list[str]:
    return [
        rf"$\sin^{{2}} <<{a}>> + \cos^{{2}} <<{a}>> = 1$"
        for a in squares_meet(products)
        if isinstance(a, Symbol)
    ]


def arrival(writer: Writer, rows: Sequence[tuple[str, Expr]]) -> Step:
    """The last step: rows that are zero, each with its number, and the common form."""
    held = len(writer.mechanism.constraints)
    goals = [residual(line) for line in writer.goal[: len(writer.goal) - held]]
    every = len(rows) == len(goals)
    values, said = _with_multipliers(writer, [row for _, row in rows])
    weights = combination(goals if every else goals[:1], values, writer)
    if weights is None:
        text = "Reactions maintain the constraints here, as multipliers do. " if said else ""
        names = ", ".join(f"({name})" for name, _ in rows)
        where = "where the constraints hold, and " if held else ""
        text += (
            f"Combined linearly, {where}with factors that depend on the state, {names}"
            f" {'give' if len(rows) > 1 else 'gives'} the same accelerations as these."
        )
    else:
        text = f"Reactions that maintain constraints are multipliers: {said}. " if said else ""
        sums = [
            f"({line.number}) is {_sum(row, [name for name, _ in rows])}"
            for line, row in zip(writer.goal, weights, strict=False)
        ]
        text += f"Sorted by accelerations, rates and loads, {'; '.join(sums)}."
        text += "" if every else " The others follow in the same way."
    if held:
        stop = "" if text.endswith(".") else " these."
        text += (
            f"{stop} The constraints, differentiated down to the accelerations, close the system."
        )
    return Step("Equations of motion", text, writer.goal)


def _with_multipliers(writer: Writer, rows: Sequence[Expr]) -> tuple[list[Expr], str]:
    """Rows with multipliers for the reactions that maintain constraints, and what is what."""
    table: dict[Symbol, Expr] = {}
    symbols, said = writer.printer.symbols, []
    for multiplier, (sign, reaction, _) in meanings(writer.mechanism).items():
        own = symbols.get(reaction)
        if own is not None and any(row.has(own) for row in rows):
            table[own] = sign * symbols[multiplier]
            said.append(f"$<<{reaction}>> = {'-' if sign < 0 else ''}<<{multiplier}>>$")
    return [row.xreplace(table) for row in rows], ", ".join(said)


def pressed_step(
    writer: Writer, numbers: Numbers, rows: Sequence[tuple[str, Expr]]
) -> tuple[tuple[Step, ...], list[tuple[str, Expr]]]:
    """Rows with the reactions put in that friction depends on, and the step that says which."""
    table = {s: v for s, v in writer.pressed.items() if any(row.has(s) for _, row in rows)}
    if not table:
        return (), list(rows)
    lines = [numbers(symbol, value) for symbol, value in table.items()]
    into = ", ".join(f"({line.number})" for line in lines)
    ends = []
    for name, row in rows:
        value = row.xreplace(table)
        if value == row:
            ends.append((name, row))
            continue
        lines += worked_out(numbers, (Term(value),), f"{into} into ({name})")
        ends.append((lines[-1].number, value))
    text = (
        "Friction depends on the reaction that presses. It follows from the momentum, along that"
        " reaction, of all that it carries."
    )
    return (Step("The reaction that presses", text, tuple(lines)),), ends


def _sum(weights: Sequence[Rational], names: Sequence[str]) -> str:
    parts: list[str] = []
    for weight, name in zip(weights, names, strict=True):
        if weight:
            sign = "\N{MINUS SIGN}" if weight < 0 else "+" if parts else ""
            size = "" if abs(weight) == 1 else f"{abs(weight)} "
            parts.append(f"{sign}{' ' if parts else ''}{size}({name})")
    return " ".join(parts)


def residual(line: Line) -> Expr:
    """Left minus right of a line whose sides are terms."""
    return Add(*_values(line.left)) - Add(*_values(line.right))


def _values(side: Side) -> list[Any]:
    return [term.value for term in side] if isinstance(side, tuple) else [side]


def combination(
    goals: Sequence[Expr], rows: Sequence[Expr], writer: Writer
) -> list[list[Rational]] | None:
    """Numbers c with goal_i = sum_j c_ij row_j, or None; proposed modulo a prime, then proved."""
    if not rows or (len(goals) > 1 and len(goals) != len(rows)):
        return None
    rows = rows[: len(goals)]
    unknown = [writer.printer.symbol(node) for node in writer.mechanism.ud[: len(goals)]]
    builder = Builder()
    slopes = [read(builder, [*Matrix(list(e)).jacobian(unknown)]) for e in (goals, rows)]
    filter_ = Residues(builder)
    goal, row = (
        nmod_mat(len(goals), len(unknown), filter_.values(e), filter_.prime) for e in slopes
    )
    if len(unknown) != len(rows) or row.rank() < len(rows):
        return None
    found = goal * row.inv()
    weights = [[_ratio(int(c), filter_.prime) for c in line] for line in found.tolist()]
    if any(max(abs(c.p), c.q) > LARGEST for line in weights for c in line):
        return None
    for end, factors in zip(goals, weights, strict=True):
        rest = end - Add(*(c * e for c, e in zip(factors, rows, strict=True)))
        if tidy(expand_trig(rest)) != 0:
            return None
    return weights


def _ratio(residue: int, prime: int) -> Rational:
    """The ratio of two numbers below sqrt(prime) that a residue is: Wang's reconstruction."""
    (above, below), (numerator, denominator) = (prime, 0), (residue, 1)
    while 2 * numerator**2 > prime:
        times = above // numerator
        (above, below), (numerator, denominator) = (
            (numerator, denominator),
            (above - times * numerator, below - times * denominator),
        )
    return Rational(numerator, denominator)
