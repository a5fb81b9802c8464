"""From rows to the common form; constraints differentiated down to u'.

    row:  value(q, u, u') = sum_j c_j lambda_j     gives     M u' = f + B lambda
    holonomic     phi(q) = 0       gives   (d phi / dt as a form in u), once more differentiated
    nonholonomic  phi(q, u) = 0    gives   A u' = b

This file holds algebra only: what is differentiated comes from the route that calls it.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

from sympy import Expr, Matrix, S, Symbol, zeros

from mechanics.errors import SceneError
from mechanics.exact import collect_linear
from mechanics.scene import Scene
from mechanics.scene.rates import rate


class ForceBalance(Protocol):
    """A row ``value = sum of coefficients times reactions``."""

    value: Expr
    coefficients: dict[Symbol, Expr]


@dataclass(frozen=True)
class System:
    """M, f and B of ``M u' = f + B lambda``."""

    mass: Matrix
    forcing: Matrix
    reaction_matrix: Matrix


def assemble(scene: Scene, rows: Sequence[ForceBalance], kept: Sequence[Symbol]) -> System:
    """Split rows into M, f and B; products that cancel are cancelled here, in the normal form."""
    mass, forcing, reactions = [], [], []
    for row in rows:
        coefficients, rest = collect_linear(row.value, scene.ud)
        mass.append(coefficients)
        forcing.append(-rest)
        reactions.append([row.coefficients.get(symbol, S.Zero) for symbol in kept])
    return System(
        Matrix(mass),
        Matrix(forcing),
        Matrix(reactions) if kept else zeros(len(rows), 0),
    )


def velocity_forms(scene: Scene, table: Mapping[Symbol, Expr]) -> list[Expr]:
    """Each constraint as an expression in q and u that vanishes, linear in u.

    Raises
    ------
    SceneError
        When a holonomic constraint holds speeds.
    """
    forms = []
    for constraint in scene.constraints:
        expression = scene.plain(constraint.expression, f"constraint {constraint.name}")
        if constraint.holonomic:
            if expression.free_symbols & {*scene.u, *scene.ud}:
                raise SceneError(
                    f"constraint {constraint.name}: a holonomic constraint holds no speeds:"
                    " declare it with nonholonomic(...)"
                )
            expression = rate(expression, table)
        forms.append(expression)
    return forms


def constraint_rows(scene: Scene, table: Mapping[Symbol, Expr]) -> tuple[Matrix, Matrix]:
    """A, c x n, and b, c x 1, with A u' = b."""
    forms = velocity_forms(scene, table)
    if not forms:
        return zeros(0, len(scene.u)), zeros(0, 1)
    matrix, bias = [], []
    for form in forms:
        coefficients, rest = collect_linear(rate(form, table), scene.ud)
        matrix.append(coefficients)
        bias.append(-rest)
    return Matrix(matrix), Matrix(bias)
