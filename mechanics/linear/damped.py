"""Damped modes in numbers: poles with their frequencies, damping ratios and shapes.

    (M s^2 + C s + K) a = 0,    s = -zeta omega +- i omega sqrt(1 - zeta^2)
    omega = |s|,    zeta = -Re s / |s|,    x(t) = Re(a e^(s t))

Shapes are complex: coordinates move with different phases unless damping is proportional.
"""

from dataclasses import dataclass
from math import degrees, pi

import numpy as np
from numpy.typing import NDArray

from mechanics.errors import wanted
from mechanics.linear.form import Linear
from mechanics.linear.numeric import largest, state_space
from mechanics.linear.sweep import AXIS
from mechanics.linear.values import Numbers


@dataclass(frozen=True, eq=False)
class DampedModes:
    """One entry a pair of conjugate poles, or a real pole; the lowest frequency first.

    Attributes
    ----------
    poles : array, shape (k,)
        s in 1/s, of a pair the one with Im s > 0.
    shapes : array, shape (n, k)
        a as columns, complex, of the n coordinates that have an effect; the largest element of each
        is one. All are 0 where a pole at 0 leads to a neighbouring steady motion.
    """

    poles: NDArray[np.complex128]
    shapes: NDArray[np.complex128]

    @property
    def frequencies(self) -> NDArray[np.float64]:
        """omega = |s|, in rad/s."""
        return np.abs(self.poles)

    @property
    def ratios(self) -> NDArray[np.float64]:
        """zeta = -Re s / |s|: one for a real pole, negative where motions grow, zero for s = 0."""
        sizes = np.abs(self.poles)
        return np.where(sizes > 0, 0.0 - self.poles.real, 0.0) / np.where(sizes > 0, sizes, 1.0)

    @property
    def words(self) -> tuple[str, ...]:
        """For each entry its frequency, damping and shape, for people."""
        rows = zip(self.poles, self.frequencies, self.ratios, self.shapes.T, strict=True)
        return tuple(
            f"{_motion(complex(s), float(omega), float(zeta))}, shape"
            f" ({', '.join(_element(complex(a)) for a in shape)})"
            if shape.any()
            else "s = 0, a neighbouring steady motion"
            for s, omega, zeta, shape in rows
        )


def damped_modes(linear: Linear, values: Numbers | None = None) -> DampedModes:
    """Poles of the state space with their shapes.

    Parameters
    ----------
    linear : Linear
    values : mapping, optional
        Parameter values by name or symbol; typical values stand for those that are missing.

    Raises
    ------
    ValueMissingError
        If a parameter has neither a value nor a typical one.
    WrongKindError
        If it is no `Linear`.
    InputError
        If derivatives of inputs drive the system.
    SingularError
        If M is singular at these values.

    Examples
    --------
    >>> from sympy import pi
    >>> from systems import rod_pendulum
    >>> hanging = linearize(derive(rod_pendulum.scene()), {"theta": pi}, {"u": 0})
    >>> print(damped_modes(hanging, {"g": 6, "l": 1}).poles.imag.round(9))
    [3.]
    """
    wanted(linear, Linear, "damped_modes", "pass linearize(derive(scene, route), at)")
    a, _ = state_space(linear, values)
    poles, vectors = np.linalg.eig(a)
    if linear.moves:
        poles = np.where(np.abs(poles) > AXIS * np.abs(poles).max(initial=0.0), poles, 0.0)
    upper = np.flatnonzero(poles.imag >= 0)
    order = upper[np.lexsort((poles[upper].real, np.abs(poles[upper])))]
    shapes = vectors[: len(linear.coordinates) - len(linear.cyclic), order].astype(complex)
    if linear.moves:
        shapes[:, poles[order] == 0] = 0.0
    scales = largest(np.where(shapes.any(axis=0), shapes, 1.0)) if len(shapes) else 1.0
    return DampedModes(poles[order].astype(complex), (shapes / scales).astype(complex))


def _motion(s: complex, omega: float, zeta: float) -> str:
    if s.imag == 0:
        return f"s = {s.real + 0.0:.6g} 1/s, no oscillation"
    # What the eigenvalues of a gyroscopic system leave of a real part is their rounding error.
    real, zeta = (s.real, zeta) if abs(zeta) > 1e-14 else (0.0, 0.0)
    return f"s = {real + 0.0:.6g} ± {s.imag:.6g}i 1/s, frequency {omega:.6g} rad/s" + (
        f" ({omega / (2 * pi):.4g} Hz), damping ratio {zeta:.4g}"
    )


def _element(a: complex) -> str:
    """A real element with its sign, another by its size and phase; -0 is 0."""
    if abs(a.imag) <= 1e-9 * abs(a):
        return f"{a.real + 0.0:.4g}"
    return f"{abs(a):.4g} at {degrees(np.angle(a)):.4g}°"
