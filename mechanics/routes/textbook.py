"""Rows of a program as a textbook writes them: the common form in SymPy.

row(q, u, u', lambda) = M u' - f - B lambda = 0
A u' - b = 0                                        constraints, differentiated down to u'
"""

from collections.abc import Sequence, Set
from dataclasses import replace
from functools import partial

from sympy import Add, Expr, Matrix, Mul, S, Symbol, sift

from mechanics.equations import Equations, Matrices, Rows
from mechanics.kinematics.printer import Printer
from mechanics.mechanism import Mechanism
from mechanics.program import Builder
from mechanics.program.builder import Node
from mechanics.program.sympy_reader import read
from mechanics.routes.rows import acceleration_forms, coefficients, remainder
from mechanics.scene import Scene
from mechanics.symbolic import canonical

Pair = tuple[Matrix, Matrix]
"""M and f, or A and b."""


def textbook(equations: Equations) -> Equations:
    """The same equations with the matrices and the eliminated reactions written in SymPy.

    Raises
    ------
    TooLarge
        Where a normal form is.
    """
    scene, mechanism, rows = equations.scene, equations.mechanism, equations.rows
    if mechanism is None or rows is None:
        return equations
    printer = Printer(scene, mechanism)
    return replace(
        equations,
        textbook=_matrices(printer, mechanism, rows),
        reactions=_reactions(printer, rows) if rows.reactions else (),
    )


def _matrices(printer: Printer, mechanism: Mechanism, rows: Rows) -> Matrices:
    """Products that cancel are cancelled here, in the normal form."""
    unknown = (*mechanism.ud, *rows.multipliers)
    n = len(mechanism.ud)
    left, right = _split(printer, mechanism, rows.values, unknown)
    matrix, column = left.applyfunc(canonical), right.applyfunc(canonical)
    if not rows.conjugate:
        held = {*printer.scene.parameters, *map(printer.symbol, rows.multipliers)}
        for i in range(matrix.rows):
            factor = _moving_factor([*matrix.row(i), column[i]], held)
            if factor != 1:
                for side in (left, right, matrix, column):
                    side[i, :] = (side.row(i) / factor).applyfunc(canonical)
    mass, forcing = _shortest(printer.scene, (left[:, :n], right), (matrix[:, :n], column))
    return Matrices(mass, forcing, -matrix[:, n:], *_constraints(printer, mechanism))


def _moving_factor(entries: Sequence[Expr], fixed: Set[Symbol]) -> Expr:
    """What multiplies every product of a row and moves: the row says nothing where it vanishes.

    A direction without divisors may have such a factor in each of its components.
    """
    products = [term.as_powers_dict() for e in entries for term in Add.make_args(e) if e != 0]
    if not products:
        return S.One
    common = {}
    for base in products[0]:
        powers = [product.get(base, S.Zero) for product in products]
        moves = not base.is_Symbol and base.free_symbols - fixed
        if moves and all(power.is_Integer and power > 0 for power in powers):
            common[base] = min(powers)
    return Mul(*(base**power for base, power in common.items()))


def _constraints(printer: Printer, mechanism: Mechanism) -> Pair:
    """A and b."""
    forms = acceleration_forms(mechanism)
    left, right = _split(printer, mechanism, forms, mechanism.ud)
    return left.applyfunc(canonical), right.applyfunc(canonical)


def _split(
    printer: Printer, mechanism: Mechanism, rows: Sequence[Node], unknown: Sequence[Node]
) -> Pair:
    """Rows that are linear in unknowns, as a matrix of these and a right side."""
    left = [entry for row in coefficients(rows, unknown) for entry in row]
    right = [-entry for entry in remainder(mechanism.builder, rows, unknown)]
    return Matrix(len(rows), len(unknown), printer(left)), Matrix(len(rows), 1, printer(right))


def _shortest(scene: Scene, derived: Pair, normal: Pair) -> Pair:
    """M and f as derived, multiplied out, or with factors before brackets: fewest operations."""
    masses = dict.fromkeys(body.mass for body in scene.bodies if isinstance(body.mass, Symbol))
    ways = [derived, normal]
    for factors in (frozenset(masses), frozenset(scene.parameters)):
        mass, forcing = (side.applyfunc(partial(_bracketed, factors)) for side in normal)
        ways += [(mass, forcing), (mass, derived[1])]
    # Of equally many, the one with the most before its brackets.
    return min(reversed(ways), key=_operations)


def _bracketed(factors: frozenset[Symbol], total: Expr) -> Expr:
    """A sum of products with equal powers of some symbols before brackets."""
    groups: dict[Expr, list[Expr]] = {}
    for term in Add.make_args(total):
        own, rest = sift(Mul.make_args(term), lambda f: f.as_base_exp()[0] in factors, binary=True)
        groups.setdefault(Mul(*own), []).append(Mul(*rest))
    return Add(*(Mul(front, Add(*inside)) for front, inside in groups.items()))


def _operations(matrices: Sequence[Matrix]) -> int:
    """Operations of matrices, equal ones counted once."""
    builder = Builder()
    entries = [entry for matrix in matrices for entry in matrix]
    return builder.program({"entries": read(builder, entries)}).count


def _reactions(printer: Printer, rows: Rows) -> tuple[tuple[Symbol, Expr], ...]:
    values = printer(tuple(rows.reactions.values()))
    return tuple(zip((printer.symbols[name] for name in rows.reactions), values, strict=True))
