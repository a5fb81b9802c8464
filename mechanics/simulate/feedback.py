"""State feedback: an input that depends on the state, and not on time alone.

w = law(t, q, u)        q' = N u + n,   M u' = f(q, u, w)
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechanics.errors import InputError, WrongKindError

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Feedback:
    """An input of a simulation as a function of the state.

    Parameters
    ----------
    law : callable
        Of (t, q, u): time in s, coordinates and speeds in the scene's order, shapes (n,) and (m,).
        It gives a number, or an array with one entry, and must not write into its arguments. It
        should be continuous: where it jumps, the integrator takes many short steps.

    Examples
    --------
    >>> from systems import rod_pendulum
    >>> model = compile(derive(rod_pendulum.scene()))
    >>> law = Feedback(lambda t, q, u: -30 * q[0] - 4 * u[0])
    >>> motion = simulate(model, 5.0, initial={"theta": 0.2}, inputs={"u": law})
    >>> bool(abs(motion.coordinates["theta"][-1]) < 1e-3)
    True
    """

    law: Callable[[float, Array, Array], Any]

    def __post_init__(self) -> None:
        if not callable(self.law):
            raise WrongKindError(
                f"Feedback: a function of t, q and u wanted, {type(self.law).__name__} found: pass"
                " lambda t, q, u: ..."
            )

    def __call__(self, t: float, q: Array, u: Array) -> float:
        """The value of the input.

        Raises
        ------
        InputError
            If the law gives no number.
        """
        found = self.law(t, q, u)
        number = np.asarray(found)
        # NumPy would take None for NaN, and texts for numbers.
        if number.dtype.kind in "biuf" and number.size == 1:
            return float(number.item())
        raise InputError(f"feedback: at t = {t:.6g} s the law gave {found!r}: one number is needed")
