"""f(t, y) of a problem for integrators that are called from Python, and where no motion starts."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from mechanics.simulate.integrators.problem import OverBudget, Problem

Array = NDArray[np.float64]


class Rate:
    """f(t, y) of a problem for integrators that are called from Python; counts its calls.

    Parameters
    ----------
    kind : numpy.float64 or numpy.float32
        The precision of the compiled right-hand side.

    Raises
    ------
    OverBudget
        When called more often than the problem allows.
    """

    def __init__(self, problem: Problem, kind: type[np.floating] = np.float64) -> None:
        size = len(problem.start)
        self.evaluations = self.jacobians = 0
        self._problem, self._kind = problem, kind
        self._y, self._yd = np.zeros(size, kind), np.zeros(size, kind)
        self._w = np.asarray(problem.signals(0.0, problem.start), dtype=kind)
        self._p = np.asarray(problem.p, dtype=kind)
        kernel = problem.model.right_hand_side.rate.kernel(kind)
        self._run = kernel.bound([self._y, self._w, self._p], [self._yd])
        self._varying, self._signals = bool(problem.varying), problem.signals
        self._slope = np.zeros(size * size, kind)
        self._run_slope: Callable[[], None] | None = None

    def __call__(self, t: float, y: Array) -> Array:
        """y', shape (n + m,), in double precision whatever computed it."""
        if self.evaluations >= self._problem.budget:
            raise OverBudget(f"{self.evaluations} evaluations are used up at t = {t:.6g} s")
        self.evaluations += 1
        self._y[:] = y
        if self._varying:
            self._w[:] = self._signals(t, y)
        self._run()
        return self._yd.astype(float)

    def jacobian(self, t: float, y: Array) -> Array:
        """df/dy, shape (n + m, n + m)."""
        if self._run_slope is None:
            kernel = self._problem.model.right_hand_side.jacobian.kernel(self._kind)
            self._run_slope = kernel.bound([self._y, self._w, self._p], [self._slope])
        self.jacobians += 1
        self._y[:] = y
        if self._varying:
            self._w[:] = self._signals(t, y)
        self._run_slope()
        size = len(self._y)
        return self._slope.astype(float).reshape(size, size).T


def unsound(problem: Problem) -> str:
    """Why no motion starts there, or empty: a number or a rate that is not finite is named."""
    model = problem.model
    names = (*model.entries["q"], *model.entries["u"])
    given = [*zip(names, problem.start, strict=True)]
    given += [*zip(model.entries["p"], problem.p, strict=True)]
    given += [*zip(model.entries["inputs"], problem.signals(0.0, problem.start), strict=True)]
    for name, value in given:
        if not np.isfinite(value):
            return f"{name} is {value}: a finite number is needed"
    for name, value in zip(names, Rate(problem)(0.0, problem.start), strict=True):
        if not np.isfinite(value):
            return f"the rate of {name} is not finite at the start: the motion is singular there"
    return ""
