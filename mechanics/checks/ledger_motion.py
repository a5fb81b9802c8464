"""Rows that hold along the motion: equations of motion, and reactions as functions of the state.

    lhs(q, u, u') = rhs(q, u, u')    at    (u', lambda) = [[M, -B], [A, 0]]^-1 (f, b)

The accelerations of one route are put into the two typed sides. A row without u', or one that is
not linear in u', is no equation of motion: other motions satisfy a product of equations, too. A set
of them is complete when their gradients d(lhs - rhs)/du' have as many independent rows as there are
degrees of freedom.
"""

from collections.abc import Sequence
from functools import partial

from sympy import (
    Abs,
    Expr,
    Matrix,
    Max,
    Min,
    Mod,
    Mul,
    Piecewise,
    S,
    Symbol,
    ceiling,
    floor,
    fraction,
    sign,
    together,
)

from mechanics.checks.ledger_compare import decide_in, equal
from mechanics.checks.solution import put_solution
from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.kernel import Finding, Verdict, undecided
from mechanics.kinematics.momenta import momenta_written_out
from mechanics.kinematics.printer import symbols
from mechanics.mechanism import name_of
from mechanics.program.derivatives import gradient as gradient_of
from mechanics.program.residues import Residues
from mechanics.program.sympy_printer import expressions
from mechanics.routes.rows import acceleration_forms, coefficients
from mechanics.scene import Scene
from mechanics.scene.actions import frictions
from mechanics.scene.published import Published
from mechanics.scene.quantities import EquationOfMotion
from mechanics.scene.rates import TIME, rate_table
from mechanics.scene.symbols import symbols_of
from mechanics.symbolic import Arithmetic, Number, decide, slope

Pairs = list[tuple[Number, Number]]

STATIC = "it holds no acceleration, so it is no equation of motion"
CURVED = (
    "it is not linear in the accelerations: a product or power of equations, which other motions"
    " satisfy too"
)

KINKED = (
    "{} holds accelerations, so other motions may satisfy it, too: write an equation that is linear"
    " in them, without it"
)
KINKS = {
    Abs: "abs", sign: "sign", Max: "max", Min: "min", floor: "floor", ceiling: "ceil",
    Mod: "mod", Piecewise: "a case",
}  # fmt: skip
"""Functions whose derivatives say nothing of linearity, in words."""


def without_magnitude(sides: Sequence[Expr]) -> Sequence[Expr]:
    """The sides of an equation of the same solutions: |e| = 0 is e = 0."""
    if S.Zero not in sides:
        return sides
    return [
        Mul(*(f.args[0] if isinstance(f, Abs) else f for f in Mul.make_args(side)))
        for side in sides
    ]


def _kinked(scene: Scene, sides: Sequence[Expr]) -> str:
    """A function that holds accelerations and has kinks or steps, in words; empty for none."""
    held = (f for side in sides for f in side.atoms(*KINKS) if f.free_symbols & set(scene.ud))
    return ", ".join(sorted({KINKS[type(f)] for f in held}))


def check_equation(
    subject: str, sides: Sequence[Expr], equations: Equations, where: Sequence[Expr] = ()
) -> Finding:
    """Whether a typed equation of motion holds, and says something, along the motion."""
    scene = equations.scene
    if strange := _strange(scene, sides) or _untold(equations, sides):
        return undecided(subject, strange)

    def experiment(a: Arithmetic) -> Pairs:
        put_motion(a, equations)
        first, *others = sides
        return [(a.value(first), a.value(side)) for side in others]

    kinematics = equations.kinematics
    found = decide_in(kinematics, subject, experiment, symbols_of(sides), where=where)
    if found.verdict is Verdict.REFUTED:
        return found
    sides = without_magnitude(sides)
    if kinked := _kinked(scene, sides):
        return undecided(subject, KINKED.format(kinked))
    if equations.textbook is None:
        doubt = _of_no_motion(scene, sides)
        return undecided(subject, doubt) if doubt else found
    rates = gradient(scene, sides)
    # What holds a reaction says what that is, without accelerations too.
    said = [*rates, *((sides[0] - sides[1]).diff(r.symbol) for r in scene.reactions)]
    static = equal(kinematics, subject, said, [S.Zero] * len(said), where)
    if static.verdict is not Verdict.REFUTED:
        return undecided(subject, STATIC)
    if found.shown and _bent(scene, rates):
        # A ratio of accelerations is as good as its numerator.
        above, _ = fraction(together(sides[0] - sides[1]))
        curved = [above.diff(one, other) for one in scene.ud for other in scene.ud]
        if not equal(kinematics, subject, curved, [S.Zero] * len(curved), where).shown:
            return undecided(subject, CURVED)
    return found


def _of_no_motion(scene: Scene, sides: Sequence[Expr]) -> str:
    """Why long sides are no equation of motion; by derivatives of their program.

    A derivative that is not zero at a point of a field is not zero. A ratio is not looked into.
    """
    a = Arithmetic()
    residual = a.value(sides[0]) - a.value(sides[1])
    unknowns = [a.value(symbol) for symbol in (*scene.ud, *(r.symbol for r in scene.reactions))]
    slopes, filter_ = gradient_of([residual], [1], unknowns), Residues(a.builder)
    if all(map(filter_.is_zero, slopes)):
        return STATIC
    rates = slopes[: len(scene.ud)]
    curved = gradient_of(rates, [a.builder.input(f"weight {i}") for i in range(len(rates))],
                         unknowns[: len(rates)])  # fmt: skip
    return "" if all(map(filter_.is_zero, curved)) else CURVED


def _strange(scene: Scene, sides: Sequence[Expr]) -> str:
    """Names the symbols that the scene does not have, which no statement about it can hold."""
    known = {*scene.q, *scene.qd, *scene.u, *scene.ud, *rate_table(scene), *scene.parameters, TIME}
    known |= {reaction.symbol for reaction in scene.reactions}
    for symbol, value in scene.definitions.items():
        known |= {symbol, *value.free_symbols}
    names = sorted(str(symbol) for symbol in symbols_of(sides) - known)
    if not names:
        return ""
    return (
        f"{', '.join(names)}: the scene has no such symbol: write the scene's own, of the same"
        " assumptions, or declare it"
    )


def _untold(equations: Equations, sides: Sequence[Expr]) -> str:
    """Names the reactions in an equation that the route does not give values to."""
    held = {reaction.name for reaction in equations.scene.reactions}
    held &= {symbol.name for symbol in symbols_of(sides)}
    names = sorted(name for name in held if not gives(equations, name))
    if not names:
        return ""
    return f"route {equations.route} does not give {', '.join(names)}: take those of free_body"


def _bent(scene: Scene, rates: Sequence[Expr]) -> bool:
    """Whether an equation is not linear in the accelerations: its gradient depends on them."""
    return any(rate.free_symbols & set(scene.ud) for rate in rates)


def check_reaction(
    subject: str, name: str, sides: Sequence[Expr], equations: Equations,
    where: Sequence[Expr] = (),
) -> Finding:  # fmt: skip
    """Whether every typed side is the reaction, along the motion.

    Raises
    ------
    InputError
        When the scene has no such reaction, or the equations do not give it.
    """
    symbol = Symbol(name, real=True)
    declared = [reaction.name for reaction in equations.scene.reactions]
    if name not in declared:
        known = f"they are {', '.join(declared)}" if declared else "it declares none"
        raise InputError(f"{subject}: {equations.scene.name} has no reaction {name!r}: {known}")
    if not gives(equations, name):
        raise InputError(
            f"{subject}: the equations of route {equations.route} do not give reaction {name}:"
            " pass those of free_body"
        )

    if strange := _strange(equations.scene, sides):
        return undecided(subject, strange)

    def experiment(a: Arithmetic) -> Pairs:
        put_motion(a, equations)
        return [(a.value(side), a.value(symbol)) for side in sides]

    return decide_in(equations.kinematics, subject, experiment, symbols_of(sides), where=where)


def gives(equations: Equations, name: str) -> bool:
    """Whether equations tell a reaction: as a multiplier, or as one that was eliminated."""
    if equations.textbook is None:
        rows = equations.program[1]
        return name in rows.reactions or name in map(name_of, rows.multipliers)
    symbol = Symbol(name, real=True)
    if symbol in equations.multipliers:
        return True
    return symbol in dict(equations.reactions)


def put_motion(a: Arithmetic, equations: Equations) -> None:
    """Let u', the multipliers and the reactions stand for their values along the motion.

    A reaction that friction depends on presses there, and its bodies slide: other states are no
    motion of the scene, which does not say what friction is at rest.
    """
    put_solution(a, equations)
    for load in frictions(equations.scene):
        a.require_positive(a.value(equations.scene.plain(load.sliding) ** 2))
        if gives(equations, load.normal):
            a.require_positive(a.value(Symbol(load.normal, real=True)))


def gradient(scene: Scene, sides: Sequence[Expr]) -> list[Expr]:
    """d(left - right)/du', where signs keep their values."""
    residual = sides[0] - sides[1]
    return [slope(residual, symbol) for symbol in scene.ud]


def closing(equations: Equations) -> Matrix:
    """A of A u' = b."""
    if equations.textbook is not None:
        return equations.constraint_matrix
    mechanism, _ = equations.program
    matrix = coefficients(acceleration_forms(mechanism), mechanism.ud)
    program = mechanism.builder.program({"A": [entry for row in matrix for entry in row]})
    found = expressions(program, symbols(equations.scene))["A"]
    return Matrix(len(matrix), len(mechanism.ud), found)


def check_complete(scene: Scene, rows: Sequence[Published], equations: Equations) -> Finding:
    """Whether the typed equations of motion determine all accelerations.

    The constraints of the scene, differentiated down to u', count as rows too, so that the typed
    ones have to be as many as the degrees of freedom.

    Raises
    ------
    InputError
        When there is no equation of motion among the rows.
    """
    typed = [row for row in rows if isinstance(row.quantity, EquationOfMotion)]
    if not typed:
        raise InputError(f"{scene.name}: there is no equation of motion among the published rows")
    written = partial(momenta_written_out, equations.kinematics)
    sides = [
        [scene.plain(written(side), row.tag) for side in without_magnitude(row.sides)]
        for row in typed
    ]
    left = Matrix([gradient(scene, pair) for pair in sides])
    left = left.col_join(closing(equations))

    def experiment(a: Arithmetic) -> Pairs:
        if _bent(scene, left):
            put_motion(a, equations)
        rank = a.rank([[a.value(entry) for entry in left.row(i)] for i in range(left.rows)])
        return [(a.rational(rank), a.rational(len(scene.ud)))]

    return decide(f"{scene.name}: the published equations of motion are complete", experiment)
