"""Many states at once, by the batch kernel: arrays are read and written where they are.

    (batch, n) arrays, or transposed (n, batch) ones, of any strides

The batch kernel computes sines and cosines inline and fuses products into sums, so its results
differ from those of one state at a time by a few units in the last place.
"""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.graphs import MATRICES
from mechanics.compiled.machine.batch import BatchKernel
from mechanics.errors import InputError
from mechanics.program.routine import Routine

Array = NDArray[np.floating]

MANY = 512
"""States from which on a batch is given to the batch kernel: fewer are done before it is made."""
SHAREABLE = ("p", "inputs")
"""Inputs that are read once for all states where they are the same; others are repeated."""


def shared(given: Mapping[str, Array]) -> tuple[str, ...]:
    """Inputs that the states of a batch have in common."""
    return tuple(group for group in SHAREABLE if group in given and given[group].ndim == 1)


def run(
    kernel: BatchKernel, code: Routine, given: Mapping[str, Array], count: int,
    out: Mapping[str, Array], threads: int,
) -> tuple[list[Array], int]:  # fmt: skip
    """Every output as (batch, entries), and what the lanes have met.

    Parameters
    ----------
    kernel : BatchKernel
        Made for the inputs that `shared` names.
    given : mapping of str to array
        (size,) or (batch, size) by input.
    count : int
        Of states.
    out : mapping of str to array
        Where outputs may be written, (batch, entries), if that is possible; the others are made
        here, in the layout that the inputs have.
    """
    common = shared(given)
    arguments = {g: _readable(given[g]) for g, _ in code.inputs}
    for group, array in arguments.items():
        if group in common:
            arguments[group] = np.ascontiguousarray(array)
        else:
            arguments[group] = np.broadcast_to(array, (count, array.shape[-1]))
    moving = [a for g, a in arguments.items() if a.size and g not in common]
    lanes = all(a.strides[0] == a.itemsize for a in moving)
    targets = []
    for name, (rows, cols) in code.shapes:
        target = out.get(name)
        if target is None or not _writable(target, moving):
            kind = next(iter(arguments.values())).dtype
            shape = (rows * cols, count) if lanes else (count, rows * cols)
            target = np.empty(shape, kind)
            target = target.T if lanes else target
        targets.append(target)
    return targets, kernel(list(arguments.values()), targets, threads)


def _readable(array: Array) -> Array:
    """The array, or a copy where a pointer could not step from entry to entry."""
    steps = all(stride % array.itemsize == 0 for stride in array.strides)
    return array if steps and array.flags.aligned else array.copy()


def _writable(target: Array, inputs: Sequence[Array]) -> bool:
    """Whether results can be written there while the inputs are still read."""
    overlaps = any(np.may_share_memory(target, array) for array in inputs)
    return _readable(target) is target and not overlaps


def look_at(
    code: Routine,
    out: Mapping[str, Array],
    count: int | None,
    kind: type[np.floating],
    threads: int,
) -> None:
    """Compare arrays for results, and the number of threads, with what they have to be.

    Raises
    ------
    InputError
        If an array has another shape or type, cannot be written to, or there is no such output; for
        a number of threads that is none.
    """
    if not isinstance(threads, int) or threads < 1:
        raise InputError(f"threads: {threads!r} found: a whole number from 1 on is needed")
    shapes = {name: shape if name in MATRICES else shape[:1] for name, shape in code.shapes}
    for name, array in out.items():
        if name not in shapes:
            raise InputError(f"out: there is no output {name}: the outputs are {', '.join(shapes)}")
        shape = shapes[name] if count is None else (count, *shapes[name])
        found = np.shape(array), getattr(array, "dtype", type(array).__name__)
        if not isinstance(array, np.ndarray) or found != (shape, np.dtype(kind)):
            raise InputError(
                f"out: an array of shape {shape} and type {np.dtype(kind)} expected for {name},"
                f" {found[0]} {found[1]} found"
            )
        if not array.flags.writeable:
            raise InputError(f"out: the array for {name} cannot be written to: pass a copy")


def written(results: Mapping[str, Array], out: Mapping[str, Array]) -> dict[str, Array]:
    """The results, those that are asked for in arrays of the caller's in these."""
    for name, array in out.items():
        if not np.may_share_memory(array, results[name]):
            array[...] = results[name]
    return {name: out.get(name, array) for name, array in results.items()}
