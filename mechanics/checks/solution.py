"""Equations in SymPy, or as a program, solved in any arithmetic.

[[M, -B], [A, 0]] (u', lambda) = (f, b)
"""

from mechanics.equations import Equations
from mechanics.kinematics.printer import symbols
from mechanics.mechanism import name_of
from mechanics.program.interpret import include
from mechanics.routes.rows import acceleration_forms, coefficients, remainder
from mechanics.scene import Scene
from mechanics.symbolic import Arithmetic, Number

LARGEST_PROOF = 5
"""Number of speeds up to which the normal form is tried: beyond, it outgrows its limit anyway."""


def proof_pays(scene: Scene) -> bool:
    """Whether to try for a proof, or be content with a certificate."""
    return len(scene.u) <= LARGEST_PROOF


def put_solution(a: Arithmetic, equations: Equations) -> None:
    """Let u', the multipliers and the reactions stand for their values along the motion."""
    if equations.textbook is None:
        _put_program(a, equations)
        return
    for symbol, number in zip(equations.unknowns, solve(a, equations), strict=True):
        a.assign(symbol, number)
    for symbol, expression in equations.reactions:
        a.assign(symbol, a.value(expression))


def _put_program(a: Arithmetic, equations: Equations) -> None:
    """The same where the rows are a program."""
    mechanism, route = equations.program
    build, named = mechanism.builder, symbols(equations.scene)
    unknowns = (*mechanism.ud, *route.multipliers)
    rows = [*route.values, *acceleration_forms(mechanism)]
    matrix = coefficients(rows, unknowns)
    right = [-entry for entry in remainder(build, rows, unknowns)]
    program = build.program({"matrix": [e for row in matrix for e in row], "right": right})
    given = {name: a.value(named[name]) for name in program.inputs}
    found, n = include(a.builder, program, given), len(rows)
    flat = found["matrix"]
    solved = a.solve([list(flat[n * i : n * (i + 1)]) for i in range(n)], list(found["right"]))
    values = {name_of(node): value for node, value in zip(unknowns, solved, strict=True)}
    for name, value in values.items():
        a.assign(named[name], value)
    if not route.reactions:
        return
    told = build.program({name: [node] for name, node in route.reactions.items()})
    given = {n: values[n] if n in values else a.value(named[n]) for n in told.inputs}
    for name, (value,) in include(a.builder, told, given).items():
        a.assign(named[name], value)


def solve(a: Arithmetic, equations: Equations) -> list[Number]:
    """Values of (u', lambda) in an arithmetic."""
    left, right = equations.system
    rows = [[a.value(entry) for entry in left[i, :]] for i in range(left.rows)]
    return a.solve(rows, [a.value(entry) for entry in right])
