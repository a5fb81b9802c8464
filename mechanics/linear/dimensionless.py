"""Dimensionless form of the eigenvalue problem, found from K and M.

K = kappa K',  M = mu M',  K' and M' of integers
K' a = lambda M' a,  lambda = mu omega^2 / kappa
"""

from dataclasses import dataclass
from math import gcd, lcm

from sympy import Expr, Integer, Matrix, S, Symbol

from mechanics.errors import ExpressionError
from mechanics.linear.algebra import reduced
from mechanics.linear.form import Linear


@dataclass(frozen=True, eq=False)
class Dimensionless:
    """K' a = lambda M' a.

    Attributes
    ----------
    stiffness, mass : Matrix
        K' and M', integers without a common divisor each.
    group : Expr
        lambda / omega^2 = mu / kappa.
    """

    stiffness: Matrix
    mass: Matrix
    group: Expr

    def parameter(self, omega: Symbol) -> Expr:
        """lambda in terms of the frequency."""
        return self.group * omega**2


def dimensionless(linear: Linear) -> Dimensionless:
    """Split parameters from numbers in the eigenvalue problem.

    Raises
    ------
    ExpressionError
        If the entries of K or of M are not rational multiples of one group of parameters.
    """
    kappa, stiffness = _split(linear, "stiffness", linear.stiffness)
    mu, mass = _split(linear, "mass", linear.mass)
    return Dimensionless(stiffness, mass, reduced(mu / kappa))


def _split(linear: Linear, kind: str, matrix: Matrix) -> tuple[Expr, Matrix]:
    """Return the group and the primitive integer matrix, positive where it is first not zero."""
    parts = [reduced(entry).factor().as_coeff_Mul(rational=True) for entry in matrix]
    groups = {group for number, group in parts if number != 0}
    if len(groups) != 1:
        raise ExpressionError(
            f"{linear.scene.name}: the {kind} matrix {matrix.tolist()} is no number matrix times"
            " one group of parameters, so there is no single dimensionless parameter"
        )
    numbers = [number if group is not S.One or number else S.Zero for number, group in parts]
    below = lcm(*(int(number.q) for number in numbers))
    above = gcd(*(int(number.p) * below // int(number.q) for number in numbers))
    group = groups.pop()
    integers = [Integer(int(number.p) * below // int(number.q) // above) for number in numbers]
    return group * Integer(above) / below, Matrix(matrix.rows, matrix.cols, integers)
