"""What becomes of small errors along a motion: the variational equations.

    Phi' = (df/dy) Phi,   Phi(0) = 1        an error e at the start has grown to Phi(t) e

Where errors grow exponentially the motion is chaotic, and doubles, which round at every operation,
tell it only for a while. The exponent: Benettin et al., Meccanica 15 (1980).
"""

import math
from dataclasses import dataclass

import casadi as ca
import numpy as np
from numpy.typing import NDArray
from scipy.integrate import LSODA

from mechanics.compiled.machine.evaluator import evaluator
from mechanics.program.casadi_reader import read_routine
from mechanics.simulate.integrators.problem import Problem

Array = NDArray[np.float64]

ROUNDING = 2.0**-53
# An error of this share of the motion is no error any more but another motion.
LOST = 1e-2
# Twenty-fold growth over half of the motion is exponential: regular motions grow with a low power
# of time, which doubles, or quadruples.
EXPONENTIAL = 20.0
TOLERANCE = 1e-9
BUDGET = 300_000


@dataclass(frozen=True, eq=False)
class Growth:
    """Growth of small errors, in the scales of the motion.

    Attributes
    ----------
    times : array, shape (N,)
    factor : array, shape (N,)
        Largest growth of an error of the start, the 2-norm of Phi; NaN where it is not known.
    """

    times: Array
    factor: Array

    @property
    def known(self) -> int:
        """Number of times at which the factor is known."""
        return int(np.sum(np.isfinite(self.factor)))

    @property
    def exponent(self) -> float:
        """Rate of growth in 1/s over the second half of what is known.

        An estimate of the largest Lyapunov exponent when that is many of its inverses long.
        """
        last = self.known - 1
        middle = int(np.searchsorted(self.times, self.times[last] / 2))
        if last <= middle:
            return 0.0
        ratio = float(self.factor[last] / self.factor[middle])
        return math.log(ratio) / float(self.times[last] - self.times[middle])

    @property
    def chaotic(self) -> bool:
        """Whether the growth looks exponential."""
        return self.exponent * float(self.times[self.known - 1]) / 2 > math.log(EXPONENTIAL)

    @property
    def meaningful_until(self) -> float:
        """Time in s when a rounding at the start has grown to 1 % of the motion, or infinity."""
        lost = self.factor * ROUNDING > LOST
        return float(self.times[int(np.argmax(lost))]) if lost.any() else math.inf

    @property
    def words(self) -> str:
        """What a reader has to know, in a sentence."""
        last = self.known - 1
        text = f"small errors grow {self.factor[last]:.3g} times in {self.times[last]:g} s"
        if self.chaotic:
            text += f", exponentially (Lyapunov time {1 / self.exponent:.2g} s)"
        if math.isfinite(self.meaningful_until):
            text += f"; doubles can be compared until {self.meaningful_until:g} s"
        return text


def growth(problem: Problem, scale: Array) -> Growth:
    """Growth of small errors at the times of a problem.

    Parameters
    ----------
    scale : array, shape (n + m,)
        Size of each entry, in which errors are measured.
    """
    size, times = len(problem.start), problem.times
    rate = _Variational(problem)
    start = np.concatenate([problem.start, np.diag(scale).ravel()])
    factor = np.full(len(times), np.nan)
    factor[0], done = 1.0, 1
    solver = LSODA(rate, 0.0, start, float(times[-1]), rtol=TOLERANCE, atol=TOLERANCE)
    while solver.status == "running" and rate.calls < BUDGET:
        solver.step()
        state = solver.dense_output()
        while done < len(times) and times[done] <= solver.t:
            columns = state(times[done])[size:].reshape(size, size)
            if not np.all(np.isfinite(columns)):
                return Growth(times, factor)
            factor[done] = np.linalg.norm(columns / scale, 2)
            done += 1
    return Growth(times, factor)


class _Variational:
    """(f, J V) of the problem, compiled; V by columns, as rows of the array that comes after y."""

    def __init__(self, problem: Problem) -> None:
        model = problem.model
        rate = model.right_hand_side.rate.function
        y, w, p = rate.sx_in()
        columns = ca.SX.sym("v", y.numel(), y.numel())
        value = rate(y, w, p)
        state = ca.vertcat(y, ca.vec(columns))
        slopes = ca.vertcat(value, ca.vec(ca.jtimes(value, y, columns)))
        function = ca.Function(
            "variational", [state, w, p], ca.cse([ca.densify(slopes)]), ["y", "inputs", "p"], ["yd"]
        )
        names = model.right_hand_side.entries
        grown = tuple(f"v{i + 1}" for i in range(y.numel() ** 2))
        entries = {**names, "y": (*names["y"], *grown)}
        kernel = evaluator(
            function, read_routine(function), entries, np.float64, model.compiler, model.flags
        )
        self.calls = 0
        self._signals, self._w = problem.signals, problem.signals(0.0)
        self._state, self._slopes = np.zeros(state.numel()), np.zeros(state.numel())
        self._run = kernel.bound([self._state, self._w, problem.p], [self._slopes])

    def __call__(self, t: float, state: Array) -> Array:
        self.calls += 1
        self._state[:] = state
        self._w[:] = self._signals(t)
        self._run()
        return self._slopes.copy()
