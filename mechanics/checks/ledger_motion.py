"""Rows that hold along the motion: equations of motion, and reactions as functions of the state.

    lhs(q, u, u') = rhs(q, u, u')    at    (u', lambda) = [[M, -B], [A, 0]]^-1 (f, b)

The accelerations of one route are put into the two typed sides. A row that does not hold u' at all
is no equation of motion, and a set of them is complete when d(lhs - rhs)/du' has as many
independent rows as there are degrees of freedom.
"""

from collections.abc import Sequence

from sympy import Expr, Matrix, S, Symbol

from mechanics.checks.agreement import solve
from mechanics.checks.ledger_compare import decide_in, equal, symbols_of
from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.exact import Arithmetic, Finding, Number, Verdict, decide
from mechanics.scene import Scene
from mechanics.scene.published import Published
from mechanics.scene.quantities import EquationOfMotion

Pairs = list[tuple[Number, Number]]


def check_equation(subject: str, sides: Sequence[Expr], equations: Equations) -> Finding:
    """Whether a typed equation of motion holds, and says something, along the motion."""
    scene = equations.scene
    rates = gradient(scene, sides)
    static = equal(scene, subject, rates, [S.Zero] * len(rates))
    if static.verdict is not Verdict.REFUTED:
        return Finding(
            subject, Verdict.UNDECIDED, "it holds no acceleration, so it is no equation of motion"
        )

    def experiment(a: Arithmetic) -> Pairs:
        put_motion(a, equations)
        first, *others = sides
        return [(a.value(first), a.value(side)) for side in others]

    return decide_in(scene, subject, experiment, symbols_of(sides))


def check_reaction(subject: str, name: str, sides: Sequence[Expr], equations: Equations) -> Finding:
    """Whether every typed side is the reaction, along the motion.

    Raises
    ------
    InputError
        When the equations do not give the reaction.
    """
    symbol = Symbol(name, real=True)
    if symbol not in {*equations.multipliers, *dict(equations.reactions)}:
        raise InputError(
            f"{subject}: the equations of route {equations.route} do not give reaction {name}:"
            " pass those of free_body"
        )

    def experiment(a: Arithmetic) -> Pairs:
        put_motion(a, equations)
        return [(a.value(side), a.value(symbol)) for side in sides]

    return decide_in(equations.scene, subject, experiment, symbols_of(sides))


def put_motion(a: Arithmetic, equations: Equations) -> None:
    """Let u', the multipliers and the reactions stand for their values along the motion."""
    for symbol, number in zip(equations.unknowns, solve(a, equations), strict=True):
        a.assign(symbol, number)
    for symbol, expression in equations.reactions:
        a.assign(symbol, a.value(expression))


def gradient(scene: Scene, sides: Sequence[Expr]) -> list[Expr]:
    """d(left - right)/du'."""
    residual = sides[0] - sides[1]
    return [residual.diff(symbol) for symbol in scene.ud]


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
    left = Matrix([gradient(scene, [scene.plain(s, row.tag) for s in row.sides]) for row in typed])
    left = left.col_join(equations.constraint_matrix)

    def experiment(a: Arithmetic) -> Pairs:
        rank = a.rank([[a.value(entry) for entry in left.row(i)] for i in range(left.rows)])
        return [(a.rational(rank), a.rational(len(scene.ud)))]

    return decide(f"{scene.name}: the published equations of motion are complete", experiment)
