"""Initial values that satisfy the constraints: some are given, the rest is solved for.

    Phi(q) = 0   for the dependent coordinates, by Newton's method from several starts
    A u = b      for the dependent speeds, which is linear

Given values are kept. Of the others, the last ones in the order of the scene whose columns of the
Jacobian are independent become dependent; what is then left keeps its suggestion. Where several
configurations close the loop, the one nearest to the suggestion is taken, and named.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import root

from mechanics.errors import InputError, SingularError
from mechanics.simulate.manifold import Manifold

Array = NDArray[np.float64]

STARTS = 40
SEED = 20240229
# Residuals below this, relative to the size of the terms, count as zero.
CLOSED = 1e-9
INDEPENDENT = 1e-8
# Where constraints become dependent the configuration is a double root, known to half the digits.
DEGENERATE = 1e-6


@dataclass(frozen=True)
class Suggestion:
    """Values for one group, coordinates or speeds.

    Attributes
    ----------
    given : tuple of bool
        Whether the value was asked for, and has to be kept.
    kept : tuple of bool
        Those, parts of quaternions, and speeds of the scene's example: what stays where the others
        can satisfy the constraints. Empty: those alone.
    """

    names: tuple[str, ...]
    values: Array
    given: tuple[bool, ...]
    kept: tuple[bool, ...] = ()


def consistent_coordinates(
    manifold: Manifold, t: float, suggestion: Suggestion, periodic: Sequence[bool]
) -> tuple[Array, str]:
    """Coordinates on the manifold and the name of the branch.

    Parameters
    ----------
    periodic : sequence of bool
        For each coordinate whether a full turn of it changes nothing.

    Raises
    ------
    InputError
        When no configuration satisfies the constraints with the given values.
    """
    off, _ = manifold.position(t, suggestion.values)
    if not off.size:
        return suggestion.values, ""
    for given in _flags(suggestion):
        held = replace(suggestion, given=given)
        dependent = _dependent(_generic_jacobian(manifold, t, held), held, len(off))
        found = _Loops(manifold, t, held.values, dependent, np.array(periodic)).branches()
        if found:
            break
    names = suggestion.names
    if not found:
        kept = [i for i in range(len(names)) if i not in dependent]
        text = _values([names[i] for i in kept], suggestion.values[kept])
        raise InputError(
            f"no configuration satisfies {_listed(manifold.names[: len(off)])} with {text}:"
            f" change these values or the parameters, and give no more than {len(names) - len(off)}"
            " coordinates"
        )
    nearest = min(found, key=lambda q: float(np.linalg.norm(q - suggestion.values)))
    if not dependent:
        return nearest, ""
    solved = _values([names[i] for i in dependent], nearest[dependent])
    return nearest, f"branch: {solved} (of {len(found)} found)"


def consistent_speeds(manifold: Manifold, t: float, q: Array, suggestion: Suggestion) -> Array:
    """Speeds that satisfy the constraints at the configuration q.

    Raises
    ------
    InputError
        When the given speeds contradict the constraints.
    SingularError
        When the constraints depend on each other at q.
    """
    off, matrix = manifold.speed(t, q, suggestion.values)
    if not off.size:
        return suggestion.values
    if np.linalg.matrix_rank(matrix, rtol=DEGENERATE) < len(off):
        raise SingularError(
            f"the initial configuration is singular: there {_listed(manifold.names[-len(off) :])}"
            " depend on each other, and do not determine the motion: start beside it"
        )
    for held in _flags(suggestion):
        u = suggestion.values.copy()
        dependent = _dependent(matrix, replace(suggestion, given=held), len(off))
        if dependent:
            u[dependent] -= np.linalg.lstsq(matrix[:, dependent], off, rcond=None)[0]
        if _vanishes(*manifold.speed(t, q, u), u):
            return u
    given = [n for n, kept in zip(suggestion.names, suggestion.given, strict=True) if kept]
    raise InputError(
        f"the initial speeds {_listed(given) or '(none given)'} contradict the constraints,"
        f" which leave {len(u) - len(off)} free: give fewer speeds, or another configuration"
    )


def _flags(suggestion: Suggestion) -> dict[tuple[bool, ...], None]:
    """What is held, first with what is better kept, then without; in this order."""
    return dict.fromkeys((suggestion.kept or suggestion.given, suggestion.given))


def _dependent(jacobian: Array, suggestion: Suggestion, count: int) -> list[int]:
    """Up to `count` columns that were not given, the last ones that are independent."""
    chosen: list[int] = []
    size = np.max(np.abs(jacobian))
    for column in reversed(range(jacobian.shape[1])):
        if suggestion.given[column] or len(chosen) == count:
            continue
        values = np.linalg.svd(jacobian[:, [*chosen, column]], compute_uv=False)
        if values[-1] > INDEPENDENT * size:
            chosen.append(column)
    return sorted(chosen)


def _generic_jacobian(manifold: Manifold, t: float, suggestion: Suggestion) -> Array:
    """Phi_q beside the suggestion, which itself may be special: all angles zero, for example."""
    random = np.random.default_rng(SEED)
    values = suggestion.values
    aside = np.where(suggestion.given, 0.0, random.normal(scale=0.1, size=len(values)))
    return manifold.position(t, values + aside)[1]


@dataclass(frozen=True)
class _Loops:
    """The search for configurations: all coordinates but the dependent ones are held."""

    manifold: Manifold
    t: float
    q: Array
    dependent: list[int]
    periodic: NDArray[np.bool_]

    def branches(self) -> list[Array]:
        """Different configurations that close, found from the suggestion and random starts."""
        found: list[Array] = []
        for start in self._starts():
            q = self._solved(start)
            if q is None:
                continue
            if not any(np.allclose(self._reduced(q - other), 0.0, atol=1e-6) for other in found):
                found.append(self.q + self._reduced(q - self.q))
        return found

    def _starts(self) -> list[Array]:
        first = self.q[self.dependent]
        if not self.dependent:
            return [first]
        random = np.random.default_rng(SEED)
        size = (STARTS, len(first))
        anywhere = random.uniform(-np.pi, np.pi, size)
        around = first + np.maximum(np.abs(first), 1.0) * random.normal(size=size)
        return [first, *np.where(self.periodic[self.dependent], anywhere, around)]

    def _solved(self, start: Array) -> Array | None:
        def residual(x: Array) -> tuple[Array, Array]:
            off, jacobian = self.manifold.position(self.t, self._filled(x))
            return off, jacobian[:, self.dependent]

        x = start
        if self.dependent:
            x = root(residual, start, jac=True, method="lm", options={"xtol": 1e-15}).x
        q = self._filled(x)
        off, jacobian = self.manifold.position(self.t, q)
        return q if _vanishes(off, jacobian, q) else None

    def _filled(self, x: Array) -> Array:
        q = self.q.copy()
        q[self.dependent] = x
        return q

    def _reduced(self, difference: Array) -> Array:
        """A difference without the full turns of what is periodic."""
        turns = np.where(self.periodic, np.round(difference / (2 * np.pi)), 0.0)
        return difference - 2 * np.pi * turns


def _vanishes(off: Array, jacobian: Array, values: Array) -> bool:
    """Whether residuals are zero, judged by the size of the terms that make them up."""
    scale = np.abs(jacobian) @ np.maximum(np.abs(values), 1.0)
    return bool(np.all(np.abs(off) <= CLOSED * scale))


def _listed(names: Sequence[str]) -> str:
    return ", ".join(names)


def _values(names: Sequence[str], values: Array) -> str:
    return ", ".join(f"{name} = {value:.6g}" for name, value in zip(names, values, strict=True))
