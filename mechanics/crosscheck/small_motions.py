"""Modes or poles about q = 0, where it is an equilibrium, and about declared equilibria."""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray
from sympy import Integer

from mechanics.checks.equilibria import exact
from mechanics.equations import Equations
from mechanics.errors import MechanicsError, ValueMissingError
from mechanics.linear import Linear, damped, damped_modes, linearize, modes, numeric_modes
from mechanics.linear.values import with_numbers
from mechanics.report.result import Modes, Swing

Array = NDArray[Any]
Found = tuple[tuple[Modes, ...], tuple[str, ...]]
LARGEST_EXACT = 3
"""Coordinates up to which modes are sought in the parameters: a larger pencil seldom factors."""


def small_motions(
    derived: Mapping[str, Equations],
) -> tuple[tuple[Modes, ...], tuple[str, ...]]:
    """Modes about q = 0 and declared equilibria without inputs, or remarks why there are none."""
    equations = next((e for e in derived.values() if e.conjugate), next(iter(derived.values())))
    scene = equations.scene
    if scene.constraints and not equations.conjugate:
        return (), ("No small motions: equations with constraints have to be Lagrange's.",)
    results = [_about(equations, declared) for declared in ({}, *scene.equilibria)]
    every = tuple(modes for own, _ in results for modes in own)
    # Where an equilibrium is declared nobody asks why q = 0 is none.
    remarks = tuple(words for _, own in results for words in own)
    return every, () if every and not results[0][0] else remarks


def _about(equations: Equations, declared: Mapping[str, Any]) -> Found:
    """Modes about an equilibrium, all else being 0."""
    scene = equations.scene
    where = ", ".join(f"{name} = {value}" for name, value in declared.items()) or "q = 0"
    place = {name: exact(value) for name, value in declared.items()}
    rest, still = (
        {symbol.name: place.get(symbol.name, Integer(0)) for symbol in symbols}
        for symbols in (scene.q, scene.input_symbols)
    )
    try:
        linear = linearize(equations, rest, still)
    except MechanicsError as error:
        cure = "" if scene.equilibria else "; declare equilibria= in the scene"
        return (), (f"No small motions about {where}: {error}{cure}",)
    if len(linear.coordinates) > LARGEST_EXACT or scene.constraints:
        return _numeric(linear, where)
    try:
        return (_exact(linear, where),), ()
    except MechanicsError:
        # Damped, or the characteristic polynomial does not factor over the parameters.
        return _numeric(linear, where)


def _place(linear: Linear) -> dict[str, float]:
    """Where the coordinates rest, at typical values."""
    values = {q.name: with_numbers(linear.scene, v) for q, v in linear.point.items()}
    return {q.name: float(values[q.name]) for q in linear.scene.q if values.get(q.name, 0) != 0}


def _exact(linear: Linear, where: str) -> Modes:
    found = modes(linear)
    rows: list[tuple[str, Any, str]] = []
    for i, value in enumerate(found.eigenvalues):
        shape = ", ".join(str(entry) for entry in found.shapes[:, i])
        rows.append((rf"\omega_{{{i + 1}}}^2", value, f"shape ({shape})"))
    try:
        values = [float(with_numbers(linear.scene, value)) for value in found.eigenvalues]
        shapes = found.shapes.applyfunc(lambda entry: with_numbers(linear.scene, entry))
    except ValueMissingError:
        return Modes(f"Natural modes about {where}", tuple(rows))
    swings = _swings(linear, np.array(values), np.array(shapes.tolist(), dtype=float))
    return Modes(f"Natural modes about {where}", tuple(rows), swings)


def _swings(linear: Linear, values: Array, shapes: Array) -> tuple[Swing, ...]:
    """The modes with a frequency, numbered as in the list of all."""
    names, place = [q.name for q in linear.coordinates], _place(linear)
    return tuple(
        Swing(i, math.sqrt(value), dict(zip(names, map(float, shape), strict=True)), 0.0, place)
        for i, (value, shape) in enumerate(zip(values, shapes.T, strict=True), 1)
        if np.isreal(value) and np.isrealobj(shape) and value > 0
    )


def _numeric(linear: Linear, where: str) -> Found:
    try:
        if damped(linear):
            return (_damped(linear, where),), ()
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
    return (Modes(f"Natural modes about {where}, typical values", rows, swings),), ()


def _damped(linear: Linear, where: str) -> Modes:
    found = damped_modes(linear)
    rows = tuple((rf"s_{{{i + 1}}}", None, text) for i, text in enumerate(found.words))
    names = [q.name for q in linear.coordinates if q not in linear.cyclic]
    place = _place(linear)
    swings = tuple(
        Swing(i, float(s.imag), dict(zip(names, shape, strict=True)), float(s.real), place)
        for i, (s, shape) in enumerate(zip(found.poles, found.shapes.T, strict=True), 1)
        if s.imag > 0 and shape.any()
    )
    return Modes(f"Damped modes about {where}, typical values", rows, swings)
