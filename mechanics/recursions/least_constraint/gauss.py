"""Gauss's function while it is written down and while it is minimised.

    G = 1/2 sum_k w_k (s_k . y + c_k)^2 + 1/2 y^T Q y - f . y,      y_i = sum_j X_ij y_j + c_i

Accelerations y of points and bodies are defined by those they are carried by and by u'. An unknown
that nothing is defined by any more is eliminated: what defines it is put into G, or G is made least
over it where it is free. Ideal reactions do no work on what the definitions admit, so they never
enter: for a tree this is the elimination of its reactions from leaf to root, and what is left of G
are articulated inertias.

Of two squares that hold the same unknown one is made free of it,

    w_1 (y + a)^2 + w_2 (x y + b)^2  =  D (y + r)^2 + w_1 w_2 / D (b - x a)^2,
    D = w_1 + w_2 x^2,    r = (w_1 a + w_2 x b) / D,

so weights are found without a subtraction, and a heavy body behind a light one takes no digits.
Where squares would become many they are added up in Q.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field

from mechanics.errors import SingularError
from mechanics.program.builder import Builder, Node
from mechanics.recursions.least_constraint.affine import Affine, Unknown, add

Row = dict[Unknown, Node]


@dataclass(frozen=True)
class Square:
    """``1/2 weight form^2``."""

    weight: Node
    form: Affine


@dataclass(frozen=True)
class Turn:
    """Two unknowns that are two others after a rotation.

    y_1 = c z_1 + s z_2,    y_2 = c z_2 - s z_1
    """

    pair: tuple[Unknown, Unknown]
    into: tuple[Unknown, Unknown]
    c: Node
    s: Node


@dataclass
class Gauss:
    """The function.

    Attributes
    ----------
    builder : Builder
    definitions : dict
        In the order in which they were made: what defines an unknown comes before it.
    turns : dict
        Definitions that are rotations.
    squares, quadratic, linear : list, dict, dict
        The squares, Q by rows, and f.
    squared : bool
        Whether squares are kept as long as they are few; else they are added up in Q at once.
    after : dict
        Values that are found after the elimination, of unknowns and of others that these need: by
        another way than that of their definitions.
    """

    builder: Builder
    squared: bool = True
    definitions: dict[Unknown, Affine] = field(default_factory=dict)
    turns: dict[Unknown, Turn] = field(default_factory=dict)
    squares: list[Square] = field(default_factory=list)
    quadratic: dict[Unknown, Row] = field(default_factory=dict)
    linear: Row = field(default_factory=dict)
    after: dict[Unknown, Affine] = field(default_factory=dict)

    def define(self, name: Unknown, value: Affine) -> Affine:
        """An unknown for a value that is more than one unknown or a number."""
        if value.known or value.alias:
            return value
        if name not in self.definitions:
            self.definitions[name] = value
        return Affine({name: self.builder.one}, self.builder.zero)

    def add_square(self, weight: Node, form: Affine) -> None:
        """Add ``1/2 weight form^2``."""
        if not weight.is_zero and not form.known:
            self.squares.append(Square(weight, form))
            if not self.squared:
                self.fold(self.squares)

    def add_product(self, weight: Node, one: Affine, two: Affine) -> None:
        """Add ``weight one two``."""
        if not weight.is_zero:
            for form, other in ((one, two), (two, one)):
                for i, x in form.coefficients.items():
                    self.add_force(i, -(x * weight * other.constant))
            for i, x in one.coefficients.items():
                for j, y in two.coefficients.items():
                    self.couple(i, j, (2 if i == j else 1) * (x * weight * y))

    def add_force(self, unknown: Unknown, force: Node) -> None:
        """Add to f."""
        if not force.is_zero:
            add(self.linear, unknown, force)

    def couple(self, i: Unknown, j: Unknown, value: Node) -> None:
        """Add to an entry of Q and its mirror image."""
        if not value.is_zero:
            add(self.quadratic.setdefault(i, {}), j, value)
            if i != j:
                add(self.quadratic.setdefault(j, {}), i, value)

    def row(self, unknown: Unknown) -> Row:
        """The entries of Q in the row of an unknown."""
        return self.quadratic.get(unknown, {})

    def holding(self, *unknowns: Unknown) -> list[Square]:
        """The squares that hold one of some unknowns."""
        return [s for s in self.squares if not s.form.coefficients.keys().isdisjoint(unknowns)]

    def holds(self, unknown: Unknown) -> bool:
        """Whether an unknown occurs other than in f."""
        return bool(self.row(unknown)) or bool(self.holding(unknown))

    def take(self, squares: Iterable[Square]) -> None:
        """Take squares out."""
        gone = set(map(id, squares))
        self.squares = [square for square in self.squares if id(square) not in gone]

    def fold(self, squares: list[Square]) -> None:
        """Add squares up in Q and f."""
        self.take(squares)
        for square in squares:
            entries = list(square.form.coefficients.items())
            for place, (i, x) in enumerate(entries):
                weighted = square.weight * x
                self.add_force(i, -(weighted * square.form.constant))
                for j, y in entries[place:]:
                    self.couple(i, j, weighted * y)

    def drop(self, unknown: Unknown) -> tuple[Row, Node, Node]:
        """Take an unknown out of Q and f: its row, the diagonal, its force."""
        row = self.quadratic.pop(unknown, {})
        diagonal = row.pop(unknown, self.builder.zero)
        for other in row:
            self.quadratic[other].pop(unknown)
        return row, diagonal, self.linear.pop(unknown, self.builder.zero)


def put(g: Gauss, unknown: Unknown, value: Affine) -> Affine:
    """Put ``y = sum_j x_j z_j + c`` into G."""
    held = g.holding(unknown)
    g.take(held)
    for square in held:
        rest = dict(square.form.coefficients)
        x = rest.pop(unknown)
        g.add_square(square.weight, Affine(rest, square.form.constant) + value.times(x))
    row, diagonal, force = g.drop(unknown)
    force = force - diagonal * value.constant
    entries = list(value.coefficients.items())
    for place, (i, x) in enumerate(entries):
        g.add_force(i, x * force)
        for k, coupling in row.items():
            g.couple(k, i, (2 if k == i else 1) * (coupling * x))
        weighted = x * diagonal
        for j, other in entries[place:]:
            g.couple(i, j, weighted * other)
    for k, coupling in row.items():
        g.add_force(k, -(coupling * value.constant))
    return value


def minimise(g: Gauss, unknown: Unknown) -> Affine:
    """Leave out a free unknown: ``dG/dy = 0``.

    Raises
    ------
    SingularError
        If nothing has mass that moves with it.
    """
    squares = g.holding(unknown)
    if few(g, unknown, squares):
        return _separated(g, unknown, squares)
    g.fold(squares)
    row, diagonal, force = g.drop(unknown)
    if diagonal.is_zero:
        raise SingularError(f"{unknown}: nothing that moves with it has mass")
    shares = {i: coupling / diagonal for i, coupling in row.items()}
    entries = list(row)
    for place, i in enumerate(entries):
        g.add_force(i, -(shares[i] * force))
        for j in entries[place:]:
            g.couple(i, j, -(shares[i] * row[j]))
    return Affine({i: -share for i, share in shares.items()}, force / diagonal)


def few(g: Gauss, unknown: Unknown, squares: list[Square]) -> bool:
    """Whether squares that hold an unknown are better kept: they hold one other at most."""
    others = {i for square in squares for i in square.form.coefficients} - {unknown}
    return bool(squares) and not g.row(unknown) and len(others) <= 1


def _separated(g: Gauss, unknown: Unknown, squares: list[Square]) -> Affine:
    """Make all squares but one free of an unknown, and that one least."""
    g.take(squares)
    # A square of the unknown alone, where there is one, leaves the others as they are.
    first, *others = sorted(squares, key=lambda square: len(square.form.coefficients))
    pivot, rest = _parted(first, unknown)
    weight = first.weight * pivot * pivot
    rest = rest.over(pivot)
    for square in others:
        x, form = _parted(square, unknown)
        weighted = square.weight * x
        total = weight + weighted * x
        g.add_square(square.weight * (weight / total), form + rest.times(-x))
        rest = rest.times(weight / total) + form.times(weighted / total)
        weight = total
    force = g.linear.pop(unknown, g.builder.zero)
    for i, entry in rest.coefficients.items():
        g.add_force(i, -(entry * force))
    return rest.times(-g.builder.one) + Affine({}, force / weight)


def _parted(square: Square, unknown: Unknown) -> tuple[Node, Affine]:
    rest = dict(square.form.coefficients)
    return rest.pop(unknown), Affine(rest, square.form.constant)


def gather(g: Gauss, unknown: Unknown) -> None:
    """One square for several of the same unknown alone."""
    alone = [s for s in g.squares if list(s.form.coefficients) == [unknown]]
    if len(alone) < 2:
        return
    g.take(alone)
    weight = moment = g.builder.zero
    for square in alone:
        weighted = square.weight * square.form.coefficients[unknown]
        weight = weight + weighted * square.form.coefficients[unknown]
        moment = moment + weighted * square.form.constant
    g.add_square(weight, Affine({unknown: g.builder.one}, moment / weight))


def turn(g: Gauss, by: Turn) -> None:
    """Put a rotation into G.

    h = s (Q_11 - Q_22) + 2 c Q_12,   Q' = [[Q_11 - s h, c h - Q_12], [., Q_22 + s h]]
    """
    one, two = by.pair
    g.fold(g.holding(one, two))
    first, upper, push = g.drop(one)
    mixed = first.pop(two, g.builder.zero)
    second, lower, pull = g.drop(two)
    c, s, (i, j) = by.c, by.s, by.into
    h = s * (upper - lower) + 2 * (c * mixed)
    g.couple(i, i, upper - s * h)
    g.couple(j, j, lower + s * h)
    g.couple(i, j, c * h - mixed)
    for k in dict.fromkeys((*first, *second)):
        a, b = first.get(k, g.builder.zero), second.get(k, g.builder.zero)
        g.couple(k, i, (2 if k == i else 1) * (c * a - s * b))
        g.couple(k, j, (2 if k == j else 1) * (s * a + c * b))
    g.add_force(i, c * push - s * pull)
    g.add_force(j, s * push + c * pull)
