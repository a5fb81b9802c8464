"""Test vectors: states, the values that a function has there, and how far off a good one may be.

    expected = nearest number to the enclosure with 512 bits
    tolerance = 4 * radius of the enclosure with 53 bits           rounded up to a power of two,
        or, where that says nothing, 4 times what `mechanics.export.roundings` counts

The values are not the model's own: the graph is walked in Arb balls. With the 53 bits of a double
(24 of a float), the radius of a ball is what the roundings of these operations can add up to, so it
tells how accurate plain arithmetic must be there, cancellation included; the factor leaves room for
a library whose sine is off by a unit of the last place, and for constants that had to be rounded.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, isfinite, log2

import numpy as np
from flint import arb

from mechanics.compiled import Model
from mechanics.compiled.quantities import Quantities, Quantity
from mechanics.compiled.sampling import sample
from mechanics.compiled.translation_validation.code import as_written
from mechanics.errors import SingularError
from mechanics.export.roundings import first_order
from mechanics.kernel import enclose
from mechanics.program import Program
from mechanics.program.routine import Routine

COUNT = 5
DRAWN = 60
DECADES = 1.0
SEED = 3
# Lengths of steps, in s.
STEP = 1e-3, 5e-2
BITS = 512, 4096
"""Binary digits of the enclosures; the second where the first are not narrow enough."""
ROOM = 4

Inputs = tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class Vector:
    """One state and what a function gives there.

    Attributes
    ----------
    inputs : tuple of tuple of float
        By input of the function.
    expected, tolerance : tuple of tuple of float
        By output, column by column.
    """

    inputs: Inputs
    expected: tuple[tuple[float, ...], ...]
    tolerance: tuple[tuple[float, ...], ...]


def vectors(
    model: Model, name: str, digits: int = 53, shared: Sequence[str] = ()
) -> tuple[Vector, ...]:
    """Test vectors of one function of a model; the same ones every time.

    Parameters
    ----------
    digits : int
        Binary digits of the numbers that the function computes with.
    shared : sequence of str
        Inputs that have the same values in all vectors.

    Raises
    ------
    SingularError
        If the function is finite, and not all cancellation, at none of the states.
    """
    written = model.casadi.routine(name)
    exact = as_written(written)
    found: list[Vector] = []
    groups = [group for group, _ in written.inputs]
    for inputs in _states(model.quantities, groups, shared):
        vector = _vector(written, exact, inputs, digits)
        if vector is not None:
            found.append(vector)
        if len(found) == COUNT:
            break
    if not found:
        raise SingularError(
            f"{name}: it is well defined at none of {DRAWN} ordinary states, or all digits of an"
            " output cancel there, so it cannot be tested: is the mass matrix singular? If not,"
            " leave it out: outputs=[...]"
        )
    return tuple(found)


def _states(quantities: Quantities, groups: Sequence[str], shared: Sequence[str]) -> list[Inputs]:
    """Ordinary states, rounded to single precision so that they are short to write."""
    known = sample(quantities, DRAWN, SEED, DECADES)
    columns = dict(zip(("q", "u", "inputs", "p"), known.groups, strict=True))
    random = np.random.default_rng(SEED)
    for group in ("ud", "multipliers"):
        entries: tuple[Quantity, ...] = getattr(quantities, group)
        columns[group] = random.uniform(-10, 10, (DRAWN, len(entries)))
    columns["h"] = random.uniform(*STEP, (DRAWN, 1))
    rounded = {group: array.astype(np.float32).astype(float) for group, array in columns.items()}
    return [
        tuple(tuple(rounded[g][0 if g in shared else i].tolist()) for g in groups)
        for i in range(DRAWN)
    ]


def _vector(written: Routine, exact: Program, inputs: Inputs, digits: int) -> Vector | None:
    """The test vector at a state; None where the function is singular or all cancellation."""
    radii = _radii(enclosed(written, exact, inputs, digits))
    for bits in BITS:
        fine = enclosed(written, exact, inputs, bits)
        if not _clear(radii, fine, digits):
            radii = first_order(written, inputs, digits)
        if _clear(radii, fine, digits) and _narrow(fine, radii):
            return Vector(
                inputs,
                tuple(tuple(_nearest(b) for b in output) for output in fine),
                tuple(tuple(_power_of_two(ROOM * r) for r in output) for output in radii),
            )
    return None


def _radii(balls: Sequence[Sequence[arb]]) -> list[list[float]]:
    return [[float(b.rad()) for b in output] for output in balls]


def _clear(radii: Sequence[Sequence[float]], fine: Sequence[Sequence[arb]], digits: int) -> bool:
    """Whether roundings leave half of the digits: where they do not, nothing would be tested."""
    for output, balls in zip(radii, fine, strict=True):
        size = max((abs(float(b.mid())) for b in balls), default=0.0)
        if not all(isfinite(r) and r <= 2.0 ** -(digits // 2) * size for r in output if r):
            return False
    return True


def _narrow(fine: Sequence[Sequence[arb]], radii: Sequence[Sequence[float]]) -> bool:
    """Whether enclosures are far narrower than what roundings may do."""
    pairs = zip(_radii(fine), radii, strict=True)
    return all(f <= 2.0**-20 * r for pair in pairs for f, r in zip(*pair, strict=True))


def enclosed(written: Routine, exact: Program, inputs: Inputs, bits: int) -> list[list[arb]]:
    """Every output as balls."""
    state = {
        f"{name}[{k}]": arb(value)
        for (name, _), values in zip(written.inputs, inputs, strict=True)
        for k, value in enumerate(values)
    }
    found = enclose(exact, state, bits)
    return [list(found[name]) for name, _ in written.shapes]


def _nearest(enclosure: arb) -> float:
    """The nearest double; zero for a ball around zero, whose midpoint means nothing."""
    return 0.0 if enclosure.contains(0) else float(enclosure.mid())


def _power_of_two(bound: float) -> float:
    return 2.0 ** ceil(log2(bound)) if bound > 0 else 0.0
