"""From rows to the common form.

row:  value(q, u, u') = sum_j c_j lambda_j     gives     M u' = f + B lambda
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from sympy import Expr, Matrix, S, Symbol, zeros

from mechanics.scene import Scene
from mechanics.symbolic import canonical, linear_equation


class ForceBalance(Protocol):
    """A row ``value = sum of coefficients times reactions``."""

    @property
    def value(self) -> Expr:
        """Rates minus loads."""
        ...

    @property
    def coefficients(self) -> dict[Symbol, Expr]:
        """What a unit of each reaction contributes."""
        ...


@dataclass(frozen=True)
class System:
    """M, f and B of ``M u' = f + B lambda``."""

    mass: Matrix
    forcing: Matrix
    reaction_matrix: Matrix


def tidied(scene: Scene, matrix: Matrix) -> Matrix:
    """Entries of SymPy's methods in the normal form where time is explicit.

    A frame that turns as Omega t leaves sin(Omega t)^2 + cos(Omega t)^2 all over them.
    """
    return matrix.applyfunc(canonical) if scene.explicit_time else matrix


def assemble(scene: Scene, rows: Sequence[ForceBalance], kept: Sequence[Symbol]) -> System:
    """Split rows into M, f and B; products that cancel are cancelled here, in the normal form."""
    mass, forcing, reactions = [], [], []
    for row in rows:
        coefficients, right = linear_equation(row.value, scene.ud)
        mass.append(coefficients)
        forcing.append(right)
        reactions.append([row.coefficients.get(symbol, S.Zero) for symbol in kept])
    return System(
        Matrix(mass),
        Matrix(forcing),
        Matrix(reactions) if kept else zeros(len(rows), 0),
    )
