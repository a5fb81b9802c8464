"""What a person passes for the values of one group of quantities, as an array."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechanics.errors import InputError

Array = NDArray[np.floating]


def given_array(group: str, names: Sequence[str], kind: type[np.floating], value: Any) -> Array:
    """An array (size,) or (batch, size) of a precision.

    Raises
    ------
    InputError
        If it is missing, holds no real numbers or has a wrong shape; it is named with both shapes.
    """
    size = len(names)
    if value is None:
        if size:
            raise InputError(f"{group} is missing: pass {size} values: {', '.join(names)}")
        value = np.zeros(0)
    try:
        array: Array = np.ascontiguousarray(value, dtype=kind)
    except (TypeError, ValueError) as error:
        raise InputError(f"{group}: these are no real numbers: {error}") from error
    if np.ndim(value) not in (1, 2) or array.shape[-1] != size:
        raise InputError(
            f"{group}: shape ({size},) or (batch, {size}) expected, {np.shape(value)} found:"
            f" the entries are {', '.join(names) or 'none'}"
        )
    return array
