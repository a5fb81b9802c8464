"""Natural modes of undamped linear equations, symbolic where the characteristic polynomial factors.

K a = omega^2 M a,    det(K - omega^2 M) = 0,    x = a sin(omega t + phi)
"""

from dataclasses import dataclass
from enum import Enum
from functools import cmp_to_key

from sympy import Expr, Matrix, Symbol, factor_list, sqrt

from mechanics.errors import ExpressionError, InputError, wanted
from mechanics.linear.algebra import coefficients, null_space, numerator, reduced, sign
from mechanics.linear.form import Linear
from mechanics.linear.values import with_numbers
from mechanics.scene import Scene
from mechanics.symbolic import enclose

EIGENVALUE = Symbol("Lambda")


class Convention(Enum):
    """Order of the modes and scaling of their shapes; the value says it in words."""

    ENGINEERING = "lowest frequency first, largest element of a shape one (the last of equals)"
    MATLAB = "highest frequency first, sum of the squares of the elements one"


@dataclass(frozen=True, eq=False)
class Modes:
    """Natural modes of n coordinates.

    Attributes
    ----------
    eigenvalues : tuple of Expr
        omega^2, in rad^2/s^2.
    shapes : Matrix
        The modal matrix, n x n: shapes as columns.
    convention : Convention
    """

    eigenvalues: tuple[Expr, ...]
    shapes: Matrix
    convention: Convention


def characteristic(linear: Linear, eigenvalue: Symbol = EIGENVALUE) -> Expr:
    """det(K - Lambda M), expanded."""
    _require_undamped(linear)
    pencil = linear.stiffness - eigenvalue * linear.mass
    return pencil.det(method="berkowitz").expand()


def characteristic_factors(
    linear: Linear, eigenvalue: Symbol = EIGENVALUE
) -> tuple[tuple[Expr, int], ...]:
    """Factors in Lambda of the characteristic polynomial over the rationals in the parameters."""
    _, factors = factor_list(numerator(characteristic(linear, eigenvalue)))
    return tuple((f, power) for f, power in factors if f.has(eigenvalue))


def modes(linear: Linear, convention: Convention = Convention.ENGINEERING) -> Modes:
    """Natural modes, exactly.

    Eigenvalues whose order depends on the parameters are put in their order at the typical values.
    Shapes of a repeated eigenvalue are orthogonal with respect to M.

    Raises
    ------
    InputError
        If the equations are damped.
    ValueMissingError
        If an order needs a typical value that is missing.
    ExpressionError
        If the characteristic polynomial has a factor that is not linear: use `numeric_modes`.

    Examples
    --------
    >>> from sympy import pi
    >>> from systems import rod_pendulum
    >>> hanging = linearize(derive(rod_pendulum.scene()), {"theta": pi}, {"u": 0})
    >>> modes(hanging).eigenvalues
    (3*g/(2*l),)
    """
    wanted(linear, Linear, "modes", "pass linearize(derive(scene, route), at)")
    found: list[tuple[Expr, Matrix]] = []
    for factor, _ in characteristic_factors(linear):
        roots = coefficients(factor, EIGENVALUE)
        if len(roots) != 2:
            raise ExpressionError(
                f"{linear.scene.name}: the roots of a factor of degree {len(roots) - 1} of the"
                " characteristic polynomial have no formula in the parameters: give values and use"
                " numeric_modes"
            )
        value = reduced(-roots[0] / roots[1])
        for shape in _shapes(linear, value):
            found.append((value, shape))

    def before(one: tuple[Expr, Matrix], two: tuple[Expr, Matrix]) -> int:
        return _compare(linear.scene, one[0], two[0])

    found.sort(key=cmp_to_key(before))
    if convention is Convention.MATLAB:
        found.reverse()
    columns = [_scaled(linear.scene, shape, convention) for _, shape in found]
    return Modes(tuple(value for value, _ in found), Matrix.hstack(*columns), convention)


def _require_undamped(linear: Linear) -> None:
    if not linear.undamped:
        raise InputError(
            f"{linear.scene.name}: the linear equations are damped and have no natural modes"
            " K a = omega^2 M a: use damped_modes or poles"
        )


def _shapes(linear: Linear, value: Expr) -> list[Matrix]:
    """Basis of the null space of K - value M, M-orthogonal."""
    basis, _ = null_space((linear.stiffness - value * linear.mass).applyfunc(reduced))
    shapes: list[Matrix] = []
    for j in range(basis.cols):
        shape = basis.col(j)
        for other in shapes:
            weight = (other.T * linear.mass * shape)[0] / (other.T * linear.mass * other)[0]
            shape = (shape - weight * other).applyfunc(reduced)
        shapes.append(shape)
    return shapes


def _scaled(scene: Scene, shape: Matrix, convention: Convention) -> Matrix:
    if convention is Convention.MATLAB:
        length = sqrt(reduced(sum(entry**2 for entry in shape)))
        return shape / length
    largest = shape[0]
    for entry in shape[1:]:
        if _compare(scene, entry**2, largest**2) >= 0:
            largest = entry
    return (shape / largest).applyfunc(reduced)


def _compare(scene: Scene, one: Expr, two: Expr) -> int:
    """Sign of one - two; at the typical values where the parameters do not settle it."""
    settled = sign(one - two)
    if settled is not None:
        return settled
    ball = enclose(with_numbers(scene, reduced(one - two)), {})
    return 1 if ball > 0 else -1 if ball < 0 else 0
