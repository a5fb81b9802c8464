"""No infinity passes for an acceleration: what is no number is an error that says why.

Batches that may hold such states are evaluated with ``check=False``, or by `Model.evaluate`, which
gives what the machine gives.
"""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.c.status import WATCHED, watched
from mechanics.errors import InputError, MechanicsError, RangeError, SingularError
from mechanics.kinematics.euler_angles import singular_angles
from mechanics.program.routine import Routine
from mechanics.scene import Scene

Array = NDArray[np.floating]
SHOWN = 16
"""How many entries of a state an error names at most."""


def checked(
    scene: Scene,
    code: Routine,
    entries: Mapping[str, tuple[str, ...]],
    given: Mapping[str, Array],
    evaluate: Callable[[str], dict[str, Array]],
) -> dict[str, Array]:
    """Every output of a function, finite.

    Parameters
    ----------
    scene : Scene
        For the error.
    code : Routine
    entries : names of the entries of each input
    given : mapping of str to array
        (size,) or (batch, size) by input.
    evaluate : callable
        Takes the name of the function that also gives what is watched; its outputs there.

    Raises
    ------
    InputError
        If a value is infinite or no number.
    SingularError
        If something is divided by zero: the matrix of the equations is singular at a state.
    RangeError
        If a value is beyond the largest number.
    """
    found = evaluate(f"{code.name}{WATCHED}")
    good = np.all([np.isfinite(v).all(axis=-1) for v in found.values()], axis=0)
    inside = found.pop("watched")
    if not np.all(good):
        index = int(np.argmin(good)) if np.ndim(good) else 0
        divisors = np.atleast_2d(inside)[index][: len(watched(code).divisors)]
        state = {name: np.atleast_2d(v) for name, v in given.items()}
        values = {name: v[min(index, len(v) - 1)] for name, v in state.items()}
        raise _explained(scene, entries, values, divisors, index if np.ndim(good) else None)
    return found


def _explained(
    scene: Scene,
    entries: Mapping[str, tuple[str, ...]],
    values: Mapping[str, Array],
    divisors: Array,
    index: int | None,
) -> MechanicsError:
    named: list[tuple[str, Any]] = [
        (name, value)
        for group, numbers in values.items()
        for name, value in zip(entries[group], numbers.tolist(), strict=True)
    ]
    batch = "" if index is None else f"state {index} of the batch: "
    if bad := [f"{name} = {value}" for name, value in named if not np.isfinite(value)]:
        return InputError(f"{scene.name}: {batch}{', '.join(bad[:SHOWN])}: give finite numbers")
    more = ", ..." if len(named) > SHOWN else ""
    state = ", ".join(f"{name} = {value:.6g}" for name, value in named[:SHOWN]) + more
    if (divisors == 0).any():
        angles = singular_angles(scene, dict(named))
        if angles:
            return SingularError(f"{scene.name}: {batch}{angles}")
        return SingularError(
            f"{scene.name}: {batch}the equations are singular or nearly singular at"
            f" {state}: look for a body without mass, or pass check=False to get what is divided"
        )
    return RangeError(
        f"{scene.name}: {batch}a value is beyond the largest number at {state}: change the units,"
        " or pass check=False to get the infinities"
    )
