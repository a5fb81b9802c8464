"""Second-order equations as first-order ones, in numbers.

y = (x, x'),   y' = A y + B w,   A = [[0, I], [-M^-1 K, -M^-1 C]],   B = [[0], [M^-1 E_0]]
"""

from typing import Any

import numpy as np

from mechanics.errors import SingularError

Array = np.ndarray[Any, np.dtype[Any]]


def first_order(
    mass: Array, damping: Array, stiffness: Array, drive: Array, kept: int, name: str
) -> tuple[Array, Array]:
    """A and B.

    Parameters
    ----------
    mass, damping, stiffness : array, shape (n, n)
    drive : array, shape (n, p)
    kept : int
        The first so many coordinates are states; those after them have no effect.
    name : str
        Of the system, for the error.

    Raises
    ------
    SingularError
        If M is singular.
    """
    n = len(mass)
    if np.linalg.matrix_rank(mass) < n:
        raise SingularError(f"{name}: the mass matrix is singular at these values")
    solved = np.linalg.solve(mass, np.hstack([-stiffness[:, :kept], -damping, drive]))
    upper = np.hstack([np.zeros((kept, kept)), np.eye(n)[:kept]])
    a = np.vstack([upper, solved[:, : kept + n]])
    return a, np.vstack([np.zeros((kept, drive.shape[1])), solved[:, kept + n :]])
