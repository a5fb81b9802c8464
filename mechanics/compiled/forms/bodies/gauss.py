"""Gauss's principle, minimised from the leaves of a tree of definitions to its root.

    G = 1/2 y^T Q y - f^T y  ->  least,      y_i = sum_j X_ij y_j + c_i

Accelerations y of points and bodies are defined by those they are carried by and by u'. An unknown
that nothing is defined by any more is eliminated, in one of three ways:

    put         y = X z + c goes into G
    minimise    y = (f_y - sum_j Q_yj z_j) / Q_yy, where y is free
    swap        a free z that only y = x z + ... holds, x > 0, is defined by y, which is free then

Ideal reactions do no work on what the definitions admit, so they never enter: for a tree this is
the elimination of its reactions from leaf to root, and Q are articulated inertias.
"""

from collections.abc import Callable
from dataclasses import dataclass, field

import casadi as ca

from mechanics.compiled.forms.bodies.affine import NOTHING, Affine, Unknown, add
from mechanics.errors import SingularError

Positive = Callable[[ca.SX], bool]


@dataclass
class Gauss:
    """The function that is minimised, while it is written down and while it is worked on.

    Attributes
    ----------
    definitions : dict
        In the order in which they were made: what defines an unknown comes before it.
    """

    definitions: dict[Unknown, Affine] = field(default_factory=dict)
    turns: dict[Unknown, "Turn"] = field(default_factory=dict)
    quadratic: dict[Unknown, dict[Unknown, ca.SX]] = field(default_factory=dict)
    linear: dict[Unknown, ca.SX] = field(default_factory=dict)

    def define(self, name: Unknown, value: Affine) -> Affine:
        """An unknown for a value that is more than one unknown or a number."""
        if value.known or value.alias:
            return value
        if name not in self.definitions:
            self.definitions[name] = value
        return Affine({name: ca.SX(1)})

    def add_square(self, one: Affine, two: Affine, weight: ca.SX) -> None:
        """Add weight times one times two to G (half of it where they are the same)."""
        if weight.is_zero():
            return
        for i, x in one.coefficients.items():
            self.add_force(i, -(x * weight * two.constant))
            for j, y in two.coefficients.items():
                self._couple(i, j, x * weight * y)

    def add_force(self, unknown: Unknown, force: ca.SX) -> None:
        """Add to f."""
        if not force.is_zero():
            add(self.linear, unknown, force)

    def _couple(self, i: Unknown, j: Unknown, value: ca.SX) -> None:
        if not value.is_zero():
            add(self.quadratic.setdefault(i, {}), j, value)

    def row(self, unknown: Unknown) -> dict[Unknown, ca.SX]:
        """The entries of Q in the row of an unknown."""
        return self.quadratic.get(unknown, {})

    def couple(self, i: Unknown, j: Unknown, value: ca.SX) -> None:
        """Add to an entry of Q and its mirror image."""
        self._couple(i, j, value)
        if i != j:
            self._couple(j, i, value)

    def drop(self, unknown: Unknown) -> tuple[dict[Unknown, ca.SX], ca.SX, ca.SX]:
        """Take an unknown out: its row without the diagonal, the diagonal, its force."""
        row = self.quadratic.pop(unknown, {})
        diagonal = row.pop(unknown, NOTHING)
        for other in row:
            self.quadratic[other].pop(unknown)
        return row, diagonal, self.linear.pop(unknown, NOTHING)


def put(g: Gauss, unknown: Unknown, value: Affine) -> Affine:
    """Put ``y = sum_j x_j z_j + c`` into G."""
    row, diagonal, force = g.drop(unknown)
    given = value.constant
    force = force - diagonal * given
    entries = list(value.coefficients.items())
    for place, (i, x) in enumerate(entries):
        g.add_force(i, x * force)
        for k, coupling in row.items():
            g.couple(k, i, (2 if k == i else 1) * (coupling * x))
        weighted = x * diagonal
        for j, other in entries[place:]:
            g.couple(i, j, weighted * other)
    for k, coupling in row.items():
        g.add_force(k, -(coupling * given))
    return value


def minimise(g: Gauss, unknown: Unknown) -> Affine:
    """Leave out a free unknown: ``dG/dy = 0``.

    Raises
    ------
    SingularError
        If nothing has mass that moves with it.
    """
    row, diagonal, force = g.drop(unknown)
    if diagonal.is_zero():
        raise SingularError(f"{unknown}: nothing that moves with it has mass")
    shares = {i: coupling / diagonal for i, coupling in row.items()}
    entries = list(row)
    for place, i in enumerate(entries):
        g.add_force(i, -(shares[i] * force))
        for j in entries[place:]:
            g.couple(i, j, -(shares[i] * row[j]))
    return Affine({i: -share for i, share in shares.items()}, force / diagonal)


@dataclass(frozen=True)
class Turn:
    """Two unknowns that are two others after a rotation.

    y_1 = c z_1 + s z_2,    y_2 = c z_2 - s z_1
    """

    pair: tuple[Unknown, Unknown]
    into: tuple[Unknown, Unknown]
    c: ca.SX
    s: ca.SX


def turn(g: Gauss, by: Turn) -> None:
    """Put a rotation into G.

    h = s (Q_11 - Q_22) + 2 c Q_12,   Q' = [[Q_11 - s h, c h - Q_12], [., Q_22 + s h]]
    """
    one, two = by.pair
    first, upper, push = g.drop(one)
    mixed = first.pop(two, NOTHING)
    second, lower, pull = g.drop(two)
    c, s, (i, j) = by.c, by.s, by.into
    h = s * (upper - lower) + 2 * (c * mixed)
    g.couple(i, i, upper - s * h)
    g.couple(j, j, lower + s * h)
    g.couple(i, j, c * h - mixed)
    for k in dict.fromkeys((*first, *second)):
        a, b = first.get(k, NOTHING), second.get(k, NOTHING)
        g.couple(k, i, c * a - s * b)
        g.couple(k, j, s * a + c * b)
    g.add_force(i, c * push - s * pull)
    g.add_force(j, s * push + c * pull)
