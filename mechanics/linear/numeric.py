"""Numbers: state space, natural modes and poles by SciPy.

y = (x, x'),   y' = A y + B w,   A = [[0, I], [-M^-1 K, -M^-1 C]],   B = [[0], [M^-1 E_0]]
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from sympy import Matrix

from mechanics.errors import InputError, SingularError
from mechanics.linear.form import Linear
from mechanics.linear.modes import Convention
from mechanics.linear.values import Numbers, with_numbers

Array = np.ndarray[Any, np.dtype[Any]]


@dataclass(frozen=True, eq=False)
class NumericModes:
    """Natural modes in numbers.

    Attributes
    ----------
    eigenvalues : array, shape (n,)
        omega^2, in rad^2/s^2; complex only where the equations are circulatory.
    shapes : array, shape (n, n)
        Shapes as columns.
    convention : Convention
    """

    eigenvalues: Array
    shapes: Array
    convention: Convention


def state_space(linear: Linear, values: Numbers | None = None) -> tuple[Array, Array]:
    """A, 2n x 2n, and B, 2n x p, for the deviations y = (x, x').

    Parameters
    ----------
    linear : Linear
    values : mapping, optional
        Parameter values by name or symbol; typical values stand for those that are missing.

    Raises
    ------
    ValueMissingError
        If a parameter has neither a value nor a typical one.
    InputError
        If derivatives of inputs drive the system.
    SingularError
        If M is singular at these values.
    """
    if len(linear.input_matrices) > 1:
        raise InputError(
            f"{linear.scene.name}: derivatives of the inputs drive the system, which y' = A y + B w"
            " cannot say: declare the highest derivative as the input"
        )
    mass, damping, stiffness, drive = _numbers(
        linear, values, linear.mass, linear.damping, linear.stiffness, linear.input_matrices[0]
    )
    n = mass.shape[0]
    if np.linalg.matrix_rank(mass) < n:
        raise SingularError(f"{linear.scene.name}: the mass matrix is singular at these values")
    solved = np.linalg.solve(mass, np.hstack([-stiffness, -damping, drive]))
    upper = np.hstack([np.zeros((n, n)), np.eye(n)])
    a = np.vstack([upper, solved[:, : 2 * n]])
    return a, np.vstack([np.zeros_like(drive), solved[:, 2 * n :]])


def damped(linear: Linear, values: Numbers | None = None) -> bool:
    """Whether a speed enters the equations at these values: C is not zero there."""
    if linear.undamped:
        return False
    _, damping, _ = _numbers(linear, values, linear.mass, linear.damping, linear.stiffness)
    return bool(damping.any())


def numeric_modes(
    linear: Linear,
    values: Numbers | None = None,
    convention: Convention = Convention.ENGINEERING,
) -> NumericModes:
    """Natural modes in numbers: `scipy.linalg.eigh` for symmetric equations, else `eig`.

    Raises
    ------
    InputError
        If the equations are damped at these values.
    """
    import scipy.linalg  # a tenth of the time that all else takes to import

    matrices = (linear.mass, linear.damping, linear.stiffness)
    mass, damping, stiffness = _numbers(linear, values, *matrices)
    if damping.any():
        raise InputError(f"{linear.scene.name}: the linear equations are damped: use damped_modes")
    if np.array_equal(mass, mass.T) and np.array_equal(stiffness, stiffness.T):
        found, shapes = scipy.linalg.eigh(stiffness, mass)
    else:
        found, shapes = scipy.linalg.eig(stiffness, mass)
        if np.all(np.abs(found.imag) <= np.finfo(float).eps * np.abs(found)):
            found, shapes = found.real, shapes.real
    order = np.argsort(found.real, kind="stable")
    if convention is Convention.MATLAB:
        order = order[::-1]
        shapes = shapes / np.linalg.norm(shapes, axis=0)
    else:
        shapes = shapes / largest(shapes)
    return NumericModes(found[order], shapes[:, order], convention)


def largest(shapes: Array) -> Array:
    """Largest element of each column; of equals, up to rounding, the last as in `modes`."""
    sizes = np.abs(shapes)
    equals = sizes >= sizes.max(axis=0) * (1 - 1e-9)
    last = len(shapes) - 1 - equals[::-1].argmax(axis=0)
    found: Array = shapes[last, np.arange(shapes.shape[1])]
    return found


def numeric_poles(linear: Linear, values: Numbers | None = None) -> Array:
    """Eigenvalues of A in 1/s, shape (2n,), by falling real part."""
    a, _ = state_space(linear, values)
    found: Array = np.linalg.eigvals(a)
    return found[np.lexsort((found.imag, -found.real))]


def _numbers(linear: Linear, values: Numbers | None, *matrices: Matrix) -> list[Array]:
    side_by_side = Matrix.hstack(*matrices)
    numbers = with_numbers(linear.scene, side_by_side, values).evalf(17)
    array = np.array(numbers.tolist(), dtype=float).reshape(side_by_side.shape)
    return np.split(array, np.cumsum([matrix.cols for matrix in matrices])[:-1], axis=1)
