"""Poles over a parameter or a speed, and where they cross the imaginary axis.

    y' = A(v) y,   det(s I - A(v)) = 0,   border:  max Re s(v) = 0

Poles of neighbouring values are paired so that the sum of the squares of their steps is least.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from mechanics.errors import InputError
from mechanics.linear.first_order import first_order
from mechanics.linear.form import Linear
from mechanics.linear.values import Numbers, evaluation

AXIS = 1e-7
"""Beside the largest pole, a real part that counts as zero: double poles at 0 err so much."""
NEAR = 1e-3
"""Of a step of the values: how far from a border one looks for the kind of it."""
BISECTIONS = 48


@dataclass(frozen=True, eq=False)
class Sweep:
    """Poles of the state space over one quantity.

    Attributes
    ----------
    linear : Linear
    over : str
        Name of the parameter or speed.
    values : array, shape (k,)
    poles : array, shape (k, s)
        In 1/s; a column is one pole as it moves.
    borders : tuple of float
        Values at which the largest real part leaves or reaches zero.
    """

    linear: Linear
    over: str
    values: NDArray[np.float64]
    poles: NDArray[np.complex128]
    borders: tuple[float, ...]

    @property
    def unstable(self) -> NDArray[np.bool_]:
        """Whether a pole has a positive real part, at each value; shape (k,)."""
        return np.array([grows(row) for row in self.poles])


def sweep(
    linear: Linear, over: str, values: Sequence[float], numbers: Numbers | None = None
) -> Sweep:
    """Poles over a parameter or a speed.

    Parameters
    ----------
    linear : Linear
    over : str
        A parameter, or a symbol of the steady motion.
    values : sequence of float
        Ascending.
    numbers : mapping, optional
        Values of other parameters; typical values stand for those that are missing.

    Raises
    ------
    InputError
        If the linear equations do not depend on it.
    ValueMissingError
        If another parameter has neither a value nor a typical one.
    """
    if over not in linear.program.inputs:
        known = ", ".join(linear.program.inputs) or "none"
        speed = linear.scene.u[0].name
        raise InputError(
            f"{linear.scene.name}: the linear equations do not depend on {over!r}, but on {known}:"
            f" give a speed of a steady motion by it, as in --speeds {speed}={over}, or another"
            " parameter"
        )
    poles = _poles(linear, over, numbers)
    rows = [poles(value) for value in values]
    for k in range(1, len(rows)):
        rows[k] = _paired(rows[k - 1], rows[k])
    flags = [grows(row) for row in rows]
    pairs = zip(values, values[1:], flags, flags[1:], strict=False)
    borders = [_border(poles, low, high, left) for low, high, left, right in pairs if left != right]
    return Sweep(linear, over, np.array(values, float), np.array(rows), tuple(borders))


def grows(poles: NDArray[np.complex128]) -> bool:
    """Whether one of them has a positive real part."""
    return bool(poles.real.max(initial=0.0) > AXIS * np.abs(poles).max(initial=0.0))


def _poles(
    linear: Linear, over: str, numbers: Numbers | None
) -> Callable[[float], NDArray[np.complex128]]:
    names = ("mass", "damping", "stiffness")
    at = evaluation(linear.scene, linear.program, linear.names, numbers, names, over)
    n = len(linear.coordinates)

    def poles(value: float) -> NDArray[np.complex128]:
        found = at({over: Fraction(value)})
        mass, damping, stiffness = (np.array(found[name]).reshape(n, n) for name in names)
        kept = n - len(linear.cyclic)
        a, _ = first_order(mass, damping, stiffness, np.zeros((n, 0)), kept, linear.scene.name)
        values = np.linalg.eigvals(a).astype(complex)
        return values[np.lexsort((values.imag, -values.real))]

    return poles


def _paired(
    before: NDArray[np.complex128], after: NDArray[np.complex128]
) -> NDArray[np.complex128]:
    """The poles in the order of those that they come from."""
    from scipy.optimize import linear_sum_assignment

    _, order = linear_sum_assignment(np.abs(before[:, None] - after[None, :]) ** 2)
    return after[order]


def _border(
    poles: Callable[[float], NDArray[np.complex128]], low: float, high: float, grows_low: bool
) -> float:
    """Where a pole crosses the axis, by bisection; poles that stay at 0 are left out.

    Where two poles meet on the axis, their real parts leave 0 as a square root, and what they are
    before is rounding errors; a pole that crosses the axis alone is found by its sign.
    """
    stable = np.abs(poles(high if grows_low else low))
    scale = AXIS * float(stable.max())
    zeros = int(np.sum(stable <= scale))

    def largest(value: float) -> float:
        found = poles(value)
        return float(found[np.argsort(np.abs(found))[zeros:]].real.max())

    border = _bisected(lambda value: (largest(value) > scale) is grows_low, low, high)
    near = NEAR * (high - low)
    ends = max(border - near, low), min(border + near, high)
    left, right = map(largest, ends)
    if min(left, right) < -scale and max(left, right) > scale:
        return _bisected(lambda value: (largest(value) > 0) is grows_low, *ends)
    return border


def _bisected(before: Callable[[float], bool], low: float, high: float) -> float:
    for _ in range(BISECTIONS):
        middle = (low + high) / 2
        low, high = (middle, high) if before(middle) else (low, middle)
    return (low + high) / 2
