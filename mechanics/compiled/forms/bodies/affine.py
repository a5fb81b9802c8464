"""Values and vectors that are affine in unknowns: y = sum_j x_j z_j + c, coefficients being graphs.

Coefficients that are structurally zero are not kept, so that nothing is multiplied by them.
"""

from collections.abc import Hashable, Iterable, Mapping
from dataclasses import dataclass, field

import casadi as ca

Unknown = Hashable
"""What tells one unknown from another."""

NOTHING = ca.SX(0)
STILL: tuple[ca.SX, ...] = (NOTHING, NOTHING, NOTHING)
PLANES = ((1, 2), (2, 0), (0, 1))
"""For each axis the two that follow it."""


@dataclass(frozen=True)
class Affine:
    """``sum(coefficients[z] * z) + constant``."""

    coefficients: Mapping[Unknown, ca.SX] = field(default_factory=dict)
    constant: ca.SX = NOTHING

    def __add__(self, other: "Affine") -> "Affine":
        """The sum."""
        merged = dict(self.coefficients)
        for unknown, coefficient in other.coefficients.items():
            add(merged, unknown, coefficient)
        return Affine(merged, self.constant + other.constant)

    def times(self, factor: ca.SX) -> "Affine":
        """The product with a graph."""
        if factor.is_zero():
            return Affine()
        if factor.is_one():
            return self
        scaled = {unknown: factor * entry for unknown, entry in self.coefficients.items()}
        return Affine(scaled, factor * self.constant)

    def over(self, divisor: ca.SX) -> "Affine":
        """The quotient by a graph."""
        if divisor.is_one():
            return self
        parts = {unknown: entry / divisor for unknown, entry in self.coefficients.items()}
        return Affine(parts, self.constant / divisor)

    @property
    def known(self) -> bool:
        """Whether it holds no unknown."""
        return not self.coefficients

    @property
    def alias(self) -> bool:
        """Whether it is one of the unknowns as it is."""
        entries = list(self.coefficients.values())
        return len(entries) == 1 and entries[0].is_one() and self.constant.is_zero()


Vector = tuple[Affine, ...]
"""Three components."""

Graphs = tuple[ca.SX, ...]
"""Three components that are known."""

Rotation = tuple[Graphs, ...]
"""Three rows."""


def add(table: dict[Unknown, ca.SX], unknown: Unknown, value: ca.SX) -> None:
    """Add to an entry of a sparse row; what is structurally zero is left out."""
    total = table[unknown] + value if unknown in table else value
    if total.is_zero():
        table.pop(unknown, None)
    else:
        table[unknown] = total


def total(parts: Iterable[Affine]) -> Affine:
    """The sum of affine values."""
    result = Affine()
    for part in parts:
        result = result + part
    return result


def known(vector: Iterable[ca.SX]) -> Vector:
    """Components without unknowns."""
    return tuple(Affine({}, entry) for entry in vector)


def plus(*vectors: Vector) -> Vector:
    """The sum of vectors."""
    return tuple(total(entries) for entries in zip(*vectors, strict=True))


def turned(rotation: Rotation, vector: Vector) -> Vector:
    """Components after a rotation."""
    return tuple(
        total(entry.times(factor) for factor, entry in zip(row, vector, strict=True))
        for row in rotation
    )


def across(vector: Vector, arm: Graphs) -> Vector:
    """The cross product of an affine vector and a known one."""
    return tuple(vector[i].times(arm[j]) + vector[j].times(-arm[i]) for i, j in PLANES)


# ---------------------------------------------------------------- the same for known components


def cross(one: Graphs, two: Graphs) -> Graphs:
    """The cross product."""
    return tuple(one[i] * two[j] - one[j] * two[i] for i, j in PLANES)


def rotated(rotation: Rotation, vector: Graphs) -> Graphs:
    """Components after a rotation."""
    return tuple(dot(row, vector) for row in rotation)


def summed(one: Graphs, two: Graphs) -> Graphs:
    """The sum of two vectors."""
    return tuple(a + b for a, b in zip(one, two, strict=True))


def minus(vector: Graphs) -> Graphs:
    """The opposite vector."""
    return tuple(-entry for entry in vector)


def scaled(factor: ca.SX, vector: Graphs) -> Graphs:
    """A multiple of a vector."""
    return tuple(factor * entry for entry in vector)


def dot(one: Graphs, two: Graphs) -> ca.SX:
    """The scalar product."""
    x, y, z = (a * b for a, b in zip(one, two, strict=True))
    return x + y + z


def transposed(rotation: Rotation) -> Rotation:
    """The inverse rotation."""
    return tuple(zip(*rotation, strict=True))


def product(one: Rotation, two: Rotation) -> Rotation:
    """One rotation after another."""
    return transposed(tuple(rotated(one, column) for column in transposed(two)))
