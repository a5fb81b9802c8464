"""Modes or poles about the rest position, where it is an equilibrium."""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechanics.equations import Equations
from mechanics.errors import MechanicsError, ValueMissingError
from mechanics.linear import Linear, damped, damped_modes, linearize, modes, numeric_modes
from mechanics.linear.values import with_numbers
from mechanics.report.result import Modes, Swing

Array = NDArray[Any]
LARGEST_EXACT = 3
"""Coordinates up to which modes are sought in the parameters: a larger pencil seldom factors."""


def small_motions(
    derived: Mapping[str, Equations],
) -> tuple[tuple[Modes, ...], tuple[str, ...]]:
    """Modes about q = 0 without inputs, or remarks that say why there are none."""
    equations = next((e for e in derived.values() if e.conjugate), next(iter(derived.values())))
    scene = equations.scene
    if scene.constraints and not equations.conjugate:
        return (), ("No small motions: equations with constraints have to be Lagrange's.",)
    try:
        rest = {q.name: 0 for q in scene.q}
        linear = linearize(equations, rest, {f.name: 0 for f in scene.input_symbols})
    except MechanicsError as error:
        return (), (f"No small motions about q = 0: {error}",)
    if len(linear.coordinates) > LARGEST_EXACT or scene.constraints:
        return _numeric(linear)
    try:
        return (_exact(linear),), ()
    except MechanicsError:
        # Damped, or the characteristic polynomial does not factor over the parameters.
        return _numeric(linear)


def _exact(linear: Linear) -> Modes:
    found = modes(linear)
    rows: list[tuple[str, Any, str]] = []
    for i, value in enumerate(found.eigenvalues):
        shape = ", ".join(str(entry) for entry in found.shapes[:, i])
        rows.append((rf"\omega_{{{i + 1}}}^2", value, f"shape ({shape})"))
    try:
        values = [float(with_numbers(linear.scene, value)) for value in found.eigenvalues]
        shapes = found.shapes.applyfunc(lambda entry: with_numbers(linear.scene, entry))
    except ValueMissingError:
        return Modes("Natural modes about q = 0", tuple(rows))
    swings = _swings(linear, np.array(values), np.array(shapes.tolist(), dtype=float))
    return Modes("Natural modes about q = 0", tuple(rows), swings)


def _swings(linear: Linear, values: Array, shapes: Array) -> tuple[Swing, ...]:
    """The modes with a frequency, numbered as in the list of all."""
    names = [q.name for q in linear.coordinates]
    return tuple(
        Swing(i, math.sqrt(value), dict(zip(names, map(float, shape), strict=True)))
        for i, (value, shape) in enumerate(zip(values, shapes.T, strict=True), 1)
        if np.isreal(value) and np.isrealobj(shape) and value > 0
    )


def _numeric(linear: Linear) -> tuple[tuple[Modes, ...], tuple[str, ...]]:
    try:
        if damped(linear):
            return (_damped(linear),), ()
        found = numeric_modes(linear)
    except MechanicsError as error:
        return (), (f"No modes: {error}",)
    rows = tuple(
        (
            rf"\omega_{{{i + 1}}}^2",
            None,
            f"{value:.6g}, shape ({', '.join(f'{entry:.4g}' for entry in found.shapes[:, i])})",
        )
        for i, value in enumerate(found.eigenvalues)
    )
    swings = _swings(linear, found.eigenvalues, found.shapes)
    return (Modes("Natural modes about q = 0, typical values", rows, swings),), ()


def _damped(linear: Linear) -> Modes:
    found = damped_modes(linear)
    rows = tuple((rf"s_{{{i + 1}}}", None, text) for i, text in enumerate(found.words))
    names = [q.name for q in linear.coordinates if q not in linear.cyclic]
    swings = tuple(
        Swing(i, float(s.imag), dict(zip(names, shape, strict=True)), float(s.real))
        for i, (s, shape) in enumerate(zip(found.poles, found.shapes.T, strict=True), 1)
        if s.imag > 0 and shape.any()
    )
    return Modes("Damped modes about q = 0, typical values", rows, swings)
