"""What a person passes for the values of one group of quantities, as an array."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.fixed import Fixed, words
from mechanics.compiled.quantities import Quantities
from mechanics.errors import InputError
from mechanics.nearest import plural

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
            raise InputError(
                f"{group} is missing: pass {plural(size, 'value')}: {', '.join(names)}"
            )
        value = np.zeros(0)
    if isinstance(value, np.ndarray) and value.dtype.kind == "c":
        # NumPy would drop the imaginary parts.
        raise InputError(f"{group}: these are no real numbers: {value.dtype} found")
    try:
        array: Array = np.asarray(value, dtype=kind)
    except (TypeError, ValueError) as error:
        raise InputError(f"{group}: these are no real numbers: {error}") from error
    if np.ndim(value) not in (1, 2) or array.shape[-1] != size:
        raise InputError(
            f"{group}: shape ({size},) or (batch, {size}) expected, {np.shape(value)} found:"
            f" the entries are {', '.join(names) or 'none'}"
        )
    return array


def as_doubles(value: Any) -> Any:
    """A list, or an array of another real type, as an array of doubles; all else as it is."""
    if isinstance(value, np.ndarray):
        return value.astype(np.float64, copy=False) if value.dtype.kind in "fiu" else value
    if not isinstance(value, list | tuple):
        return value
    try:
        return np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError):
        # What it is instead is named by `given_array`, which meets it next.
        return value


def named_parameters(
    names: Sequence[str], given: Mapping[str, float], known: Quantities, fixed: Fixed
) -> Array:
    """Parameters in order, from those that are named; the rest have their typical values.

    Raises
    ------
    InputError
        If there is no such parameter, or it is fixed.
    ValueMissingError
        If one is not named and has no typical value.
    """
    if unknown := set(given) - set(names):
        held = f", and fixed: {words(fixed)}" if fixed else ""
        raise InputError(
            f"there is no parameter {', '.join(sorted(unknown))}: the parameters are"
            f" {', '.join(names)}{held}"
        )
    if set(given) == set(names):
        return np.array([given[name] for name in names], dtype=float)
    values = dict(zip(names, known.typical, strict=True)) | dict(given)
    return np.array([values[name] for name in names], dtype=float)
