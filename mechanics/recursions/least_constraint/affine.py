"""Values and vectors that are affine in unknowns: y = sum_j x_j z_j + c, coefficients being nodes.

Coefficients that are zero are not kept, so that nothing is multiplied by them.
"""

from collections.abc import Hashable, Iterable, Mapping
from dataclasses import dataclass

from mechanics.program.builder import Node

Unknown = Hashable
"""What tells one unknown from another."""

PLANES = ((1, 2), (2, 0), (0, 1))
"""For each axis the two that follow it."""


def is_one(node: Node) -> bool:
    """Whether a node is the constant 1."""
    return node == node.builder.one


@dataclass(frozen=True)
class Affine:
    """``sum(coefficients[z] * z) + constant``."""

    coefficients: Mapping[Unknown, Node]
    constant: Node

    def __add__(self, other: "Affine") -> "Affine":
        """The sum."""
        merged = dict(self.coefficients)
        for unknown, coefficient in other.coefficients.items():
            add(merged, unknown, coefficient)
        return Affine(merged, self.constant + other.constant)

    def times(self, factor: Node) -> "Affine":
        """The product with a node."""
        if factor.is_zero:
            return Affine({}, factor)
        scaled = {unknown: factor * entry for unknown, entry in self.coefficients.items()}
        return Affine(scaled, factor * self.constant)

    def over(self, divisor: Node) -> "Affine":
        """The quotient by a node."""
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
        return len(entries) == 1 and is_one(entries[0]) and self.constant.is_zero


Affines = tuple[Affine, ...]
"""Three components."""


def add(table: dict[Unknown, Node], unknown: Unknown, value: Node) -> None:
    """Add to an entry of a sparse row; what is zero is left out."""
    total = table[unknown] + value if unknown in table else value
    if total.is_zero:
        table.pop(unknown, None)
    else:
        table[unknown] = total


def known(vector: Iterable[Node]) -> Affines:
    """Components without unknowns."""
    return tuple(Affine({}, entry) for entry in vector)


def plus(first: Affines, *others: Affines) -> Affines:
    """The sum of vectors."""
    for other in others:
        first = tuple(a + b for a, b in zip(first, other, strict=True))
    return first


def turned(rotation: Iterable[Iterable[Node]], vector: Affines) -> Affines:
    """Components after a rotation."""
    rows = []
    for row in rotation:
        x, y, z = (entry.times(factor) for factor, entry in zip(row, vector, strict=True))
        rows.append(x + y + z)
    return tuple(rows)


def across(vector: Affines, arm: Iterable[Node]) -> Affines:
    """The cross product of an affine vector and a known one."""
    c = tuple(arm)
    return tuple(vector[i].times(c[j]) + vector[j].times(-c[i]) for i, j in PLANES)
