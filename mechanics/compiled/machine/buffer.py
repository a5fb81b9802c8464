"""A function with memory of its own: write, run, read."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.floating]


@dataclass(frozen=True)
class Buffer:
    """One function at one state with the least overhead: write `inputs`, `run()`, read `outputs`.

    Attributes
    ----------
    inputs, outputs : mapping of str to array
        The arrays that `run` reads and writes; the same ones every time. Matrices are views.
    run : callable
    """

    inputs: Mapping[str, Array]
    outputs: Mapping[str, Array]
    run: Callable[[], None]
