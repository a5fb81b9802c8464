"""How large each output becomes in a box: a state where it is large, and its value there.

    S_i  <=  max over the box of |y_i|

Coordinate ascent from drawn states; the value is enclosed, so that the true maximum is not smaller.
"""

from collections.abc import Mapping
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from mechanics.errors import InputError
from mechanics.kernel.balls import enclose
from mechanics.kernel.finding import exact
from mechanics.program import Program
from mechanics.program.interpret import interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.reduce.proof import Box

Array = NDArray[np.float64]
SEED, DRAWN, STEPS, TRIED = 2, 2048, 30, 8


def scales(program: Program, box: Box) -> tuple[Fraction, ...]:
    """S_i of each output, 0 where it is 0 at all states that were tried.

    Parameters
    ----------
    program : Program
        Without linear systems.
    box : mapping of str to (Fraction, Fraction)
        Of each input.

    Raises
    ------
    InputError
        If an output has no finite value anywhere.
    """
    names = [name for name in program.inputs if box[name][0] < box[name][1]]
    low, high = (np.array([float(box[name][k]) for name in names]) for k in (0, 1))
    draws = np.random.default_rng(SEED)
    start = draws.uniform(low, high, (DRAWN, len(names)))
    ends = np.where(draws.random(start.shape) < 0.5, low, high)
    start = np.where(draws.random(start.shape) < 0.5, start, ends)
    sizes = _sizes(program, box, names, start)
    for (name, k), row in zip(_entries(program), sizes, strict=True):
        if not (row >= 0).any():
            raise InputError(
                f"{name}[{k}] has no finite value at any state that was tried in the box:"
                " choose a smaller box, or one without singular states"
            )
    sizes = np.where(sizes >= 0, sizes, 0)
    return tuple(
        _ascended(program, box, names, start[np.argmax(sizes[i])], i)
        for i in range(len(sizes))
    )  # fmt: skip


def _sizes(program: Program, box: Box, names: list[str], states: Array) -> Array:
    """|y_i| at states; -1 where it is no number."""
    inputs = {name: np.full(len(states), float(box[name][0])) for name in program.inputs}
    inputs |= {name: states[:, k] for k, name in enumerate(names)}
    with np.errstate(all="ignore"):
        found = interpret(program, Arrays(), inputs)
        flat = [np.broadcast_to(v, len(states)) for entries in found.values() for v in entries]
        sizes = np.abs(np.stack(flat))
    return np.where(np.isfinite(sizes), sizes, -1)


def _entries(program: Program) -> list[tuple[str, int]]:
    return [(name, k) for name, nodes in program.outputs.items() for k in range(len(nodes))]


def _ascended(program: Program, box: Box, names: list[str], state: Array, i: int) -> Fraction:
    low, high = (np.array([float(box[name][k]) for name in names]) for k in (0, 1))
    draws = np.random.default_rng(SEED)
    best = float(_sizes(program, box, names, state[None])[i, 0])
    for _ in range(STEPS if names else 0):
        moves = np.repeat(state[None], TRIED * len(names), axis=0)
        for k in range(len(names)):
            near = state[k] + draws.normal(size=4) * (high[k] - low[k]) / 16
            values = [low[k], high[k], *draws.uniform(low[k], high[k], 2), *near]
            moves[TRIED * k : TRIED * (k + 1), k] = np.clip(values, low[k], high[k])
        sizes = _sizes(program, box, names, moves)[i]
        if sizes.max() > best:
            best, state = float(sizes.max()), moves[np.argmax(sizes)]
    return _enclosed(program, box, dict(zip(names, state, strict=True)), i)


def _enclosed(program: Program, box: Box, state: Mapping[str, float], i: int) -> Fraction:
    inside = {
        name: min(max(Fraction(float(state[name])), low), high) if name in state else low
        for name, (low, high) in box.items()
    }
    value = [entry for entries in enclose(program, inside).values() for entry in entries][i]
    return max(exact(abs(value).lower()), Fraction(0)) if value.is_finite() else Fraction(0)
