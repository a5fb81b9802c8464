"""Frames and points of one of SymPy's models made anew, so that the scene owns what it holds.

What the model places by velocities alone is placed here, too; its symbols are real numbers.
"""

from collections.abc import Set
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

from sympy import Derivative, Expr, Matrix, Symbol, sympify
from sympy.physics.vector import Dyadic, Point, ReferenceFrame, Vector, dynamicsymbols, outer

from mechanics.importers.sympy_model import written
from mechanics.importers.sympy_motion import Moved, linked
from mechanics.scene.geometry import (
    components,
    frame_path,
    point_path,
    relative_rotation,
    step_vector,
)


@dataclass
class Copy:
    """Copies, by what they stand for.

    Parameters
    ----------
    root : ReferenceFrame
        Inertial, of the model.
    positive : set of Expr
        Symbols that are masses or moments of inertia.
    """

    root: ReferenceFrame
    moved: Moved
    positive: Set[Expr]
    frames: dict[ReferenceFrame, ReferenceFrame] = field(default_factory=dict)
    points: dict[Point, Point] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.frames[self.root] = ReferenceFrame(self.root.name)
        self.origin = Point("O")
        for anchor, offset in self.moved.anchors.items():
            if offset == 0:
                self.points[anchor] = self.origin
                self.origin.name = anchor.name
            else:
                self.points[anchor] = self.origin.locatenew(anchor.name, self.vector(offset))

    def all_points(self) -> None:
        """Copy every point that the model places with a body: forces may act there."""
        for anchor in self.moved.anchors:
            for point in linked(anchor):
                self.point(point)

    @property
    def frame(self) -> ReferenceFrame:
        """The inertial frame."""
        return self.frames[self.root]

    def scalar(self, expression: Expr) -> Expr:
        """An expression in the symbols of the scene."""
        constants = sympify(expression).free_symbols - {dynamicsymbols._t}
        found = sympify(expression).xreplace({s: self.symbol(s) for s in constants})
        found = written(found)
        return found.doit() if found.has(Derivative) else found

    def symbol(self, symbol: Symbol) -> Symbol:
        """A real symbol of that name; one that has assumptions stays as it is."""
        if symbol.is_extended_real:
            return symbol
        sign = "positive" if symbol in self.positive else "real"
        return Symbol(symbol.name, **{sign: True})

    def turned(self, frame: ReferenceFrame) -> ReferenceFrame:
        """The copy of a frame."""
        if frame in self.frames:
            return self.frames[frame]
        if frame in self.moved.turned:
            parent, axis, angle = self.moved.turned[frame]
            own = self.turned(parent).orientnew(
                frame.name, "Axis", (self.scalar(angle), self.vector(axis))
            )
            return self.frames.setdefault(frame, own)
        for parent, child in pairwise(frame_path(self.root, frame)):
            if child not in self.frames:
                own = ReferenceFrame(child.name)
                # `orient_dcm` would differentiate and simplify, for what nobody asks.
                own._dcm(self.frames[parent], self.matrix(relative_rotation(parent, child)))
                self.frames[child] = own
        return self.frames[frame]

    def matrix(self, matrix: Matrix) -> Matrix:
        """A matrix in the symbols of the scene."""
        return matrix.applyfunc(self.scalar)

    def point(self, point: Point) -> Point | None:
        """The copy of a point; None for one that no body is placed with."""
        if point in self.points:
            return self.points[point]
        known = linked(point)
        anchor = next((a for a in self.moved.anchors if a in known), None)
        if anchor is None:
            return None
        for parent, child in pairwise(point_path(anchor, point)):
            if child not in self.points:
                step = self.vector(step_vector(parent, child))
                self.points[child] = self.points[parent].locatenew(child.name, step)
        return self.points[point]

    def vector(self, vector: Vector) -> Vector:
        """The copy of a vector, in the frames in which it was given."""
        return Vector([(self.matrix(column), self.turned(f)) for f, column in components(vector)])

    def inertia(self, body: Any) -> Dyadic:
        """Of a rigid body about its mass centre.

        What is given in the frame that carries an axis about which the body spins is the same in
        its own.
        """
        total = Dyadic(0)
        for size, one, two in body.central_inertia.args:
            total += self.scalar(size) * outer(self.vector(one), self.vector(two))
        return total
