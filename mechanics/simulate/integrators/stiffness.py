"""Whether explicit methods can afford a problem: the fastest motion sets the step.

    R(z) = 1 + z b (1 - z A)^-1 1        what a step makes of e^(lambda t),  z = h lambda

An explicit method is stable only while |R(z)| stays near |e^z|, so its steps are bound by the
fastest eigenvalue of df/dy even where that motion has no amplitude. Hairer and Wanner, Solving
Ordinary Differential Equations II, IV.2.
"""

import math

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solve_triangular

from mechanics.compiled.step import Tableau
from mechanics.simulate.integrators.problem import Problem
from mechanics.simulate.integrators.rate import Rate

Complex = NDArray[np.complex128]

# An error that a method amplifies so many times over the motion is no error any more.
AMPLIFIED = 1e6
# Evaluations of an explicit method for a radian of the fastest motion, at its limit of stability:
# DOP853 takes 12 for 6 radians.
RADIAN = 2.0


def rates_at_start(problem: Problem) -> Complex:
    """Eigenvalues of df/dy at the start, in 1/s; one that is infinite where they overflow."""
    slope = Rate(problem).jacobian(0.0, problem.start)
    if not np.all(np.isfinite(slope)):
        return np.array([complex(math.inf)])
    return np.linalg.eigvals(slope).astype(complex)


def too_stiff(problem: Problem) -> str:
    """Why an explicit method cannot afford the problem, or empty."""
    fastest = float(np.max(np.abs(rates_at_start(problem))))
    duration = float(problem.times[-1])
    needed = RADIAN * fastest * duration
    if needed <= problem.budget:
        return ""
    return (
        f"stiff: the fastest motion has {fastest:.3g} rad/s, so an explicit method takes at least"
        f" {needed:.2g} evaluations for {duration:g} s, and {problem.budget:.2g} are allowed"
    )


def unstable(tableau: Tableau, problem: Problem, step: float | None) -> str:
    """Why fixed steps of an explicit method are unstable at the start, or empty."""
    if step is None:
        return ""
    rates = rates_at_start(problem)
    if not np.all(np.isfinite(rates)):
        return "the derivatives of the equations overflow at the start"
    growth = np.array([_amplification(tableau, step * rate) for rate in rates])
    # Relative to the motion itself, which may grow.
    spurious = np.log(growth) - step * rates.real
    worst = int(np.argmax(spurious))
    if spurious[worst] * float(problem.times[-1]) / step < math.log(AMPLIFIED):
        return ""
    return (
        f"{tableau.name} is unstable with a step of {step:g} s: it makes errors of the fastest"
        f" motion ({abs(rates[worst]):.3g} rad/s) {math.exp(min(spurious[worst], 700)):.3g} times"
        " larger in each: take a shorter step or an implicit method"
    )


def _amplification(tableau: Tableau, z: complex) -> float:
    """|R(z)|."""
    stages = len(tableau.a)
    a = np.array([[*map(float, row), *[0.0] * (stages - len(row))] for row in tableau.a])
    b = np.array([float(entry) for entry in tableau.b])
    # Unit lower triangular: never singular, however long the step.
    inner = solve_triangular(-z * a, np.ones(stages), lower=True, unit_diagonal=True)
    return max(abs(complex(1 + z * b @ inner)), math.ulp(0.0))
