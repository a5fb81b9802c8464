"""The constraints as a manifold of states, and the way back onto it.

    Phi(q, t) = 0                 holonomic
    A(q, t) u = b(q, t)           nonholonomic, and the rates of the holonomic ones

Positions go back by Newton's method with the shortest correction, dq = -Phi_q^+ Phi; speeds by the
shortest correction that satisfies the linear equations, du = -A^+ (A u - b).
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
NEWTON_STEPS = 8
# Residuals at which Newton's method stops, and that it has to reach.
ROUNDING, NEARLY = 1e-14, 1e-12


@dataclass(frozen=True)
class Manifold:
    """Constraints of a scene with numbers bound.

    Attributes
    ----------
    n : int
        Number of coordinates.
    names : tuple of str
        What each entry of `residual` is, the c_h positions first, then the c speeds.
    position : callable
        (t, q) to Phi, shape (c_h,), and Phi_q, shape (c_h, n).
    speed : callable
        (t, q, u) to A u - b, shape (c,), and A, shape (c, m).
    """

    n: int
    names: tuple[str, ...]
    position: Callable[[float, Array], tuple[Array, Array]]
    speed: Callable[[float, Array, Array], tuple[Array, Array]]

    def residual(self, t: float, state: Array) -> Array:
        """How far a state (q, u) is off, by constraint: magnitudes, in the constraints' units."""
        q, u = state[: self.n], state[self.n :]
        return np.abs(np.concatenate([self.position(t, q)[0], self.speed(t, q, u)[0]]))

    def project(self, t: float, state: Array) -> Array:
        """The state on the manifold beside the given one; NaN where there is none nearby."""
        if not self.names:
            return state
        q, u = state[: self.n], state[self.n :]
        q = self._positioned(t, q)
        off, matrix = self.speed(t, q, u)
        return np.concatenate([q, u - _shortest(matrix, off)])

    def _positioned(self, t: float, q: Array) -> Array:
        off, matrix = self.position(t, q)
        for _ in range(NEWTON_STEPS):
            if not off.size or _size(off, matrix, q) <= ROUNDING:
                return q
            q = q - _shortest(matrix, off)
            off, matrix = self.position(t, q)
        return q if _size(off, matrix, q) <= NEARLY else np.full_like(q, np.nan)


def _shortest(matrix: Array, off: Array) -> Array:
    """Shortest d with matrix d = off, shape (columns,)."""
    if not np.all(np.isfinite(matrix)) or not np.all(np.isfinite(off)):
        return np.full(matrix.shape[1], np.nan)
    return np.asarray(np.linalg.lstsq(matrix, off, rcond=None)[0], dtype=np.float64)


def _size(off: Array, matrix: Array, q: Array) -> float:
    """Largest residual, judged by the size of the terms; NaN where one is not finite."""
    scale = np.max(np.abs(matrix)) * max(1.0, float(np.max(np.abs(q))))
    return float(np.max(np.abs(off)) / scale)
