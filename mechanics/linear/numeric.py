"""Numbers: state space, natural modes and poles by SciPy.

y' = A y + B w,    y = (x, x') without what is cyclic
"""

from dataclasses import dataclass

import numpy as np

from mechanics.errors import InputError
from mechanics.linear.first_order import Array
from mechanics.linear.form import Linear
from mechanics.linear.modes import Convention
from mechanics.linear.values import Numbers


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
    """A, s x s, and B, s x p, for the deviations y = (x, x') without coordinates that are cyclic.

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
    return linear.state_space(values)


def damped(linear: Linear, values: Numbers | None = None) -> bool:
    """Whether a speed enters the equations at these values: C is not zero there."""
    if linear.undamped:
        return False
    (damping,) = linear.numbers(values, "damping")
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

    mass, damping, stiffness = linear.numbers(values, "mass", "damping", "stiffness")
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
    """Eigenvalues of A in 1/s, shape (s,), by falling real part."""
    a, _ = state_space(linear, values)
    found: Array = np.linalg.eigvals(a)
    return found[np.lexsort((found.imag, -found.real))]
