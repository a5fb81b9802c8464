"""Where frames and points are: paths through SymPy's trees, and positions in plain symbols.

    r = sum over the path of R_F c_F        (c_F: components of one step in the frame F)

Only positions and orientations are read from the user's objects, never velocities: a velocity that
can be set can contradict the position.
"""

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

from sympy import Expr, Matrix, zeros
from sympy.core.function import AppliedUndef
from sympy.physics.vector import Dyadic, Point, ReferenceFrame, Vector

from mechanics.errors import SceneError
from mechanics.scene.declared import decimals


def frame_path(root: ReferenceFrame, frame: ReferenceFrame) -> tuple[ReferenceFrame, ...]:
    """Frames from `root` to `frame`, both included, as the user oriented them.

    Raises
    ------
    SceneError
        When nothing orients the frame relative to the root.
    """
    path = _path(root, frame, lambda one: one._dlist[0])
    if not path:
        raise SceneError(
            f"frame {frame.name}: it is not oriented relative to {root.name}:"
            f" make it with {root.name}.orientnew or orient it"
        )
    return path


def point_path(root: Point, point: Point) -> tuple[Point, ...]:
    """Points from `root` to `point`, both included, as the user located them.

    Raises
    ------
    SceneError
        When nothing places the point relative to the root.
    """
    path = _path(root, point, lambda one: one._pos_dict)
    if not path:
        raise SceneError(
            f"point {point.name}: it is not placed relative to {root.name}:"
            f" make it with {root.name}.locatenew or set_pos"
        )
    return path


def _path(root: Any, end: Any, neighbours: Callable[[Any], Iterable[Any]]) -> tuple[Any, ...]:
    """The shortest way from `root` to `end`; empty where there is none.

    SymPy's own search keeps every way to every point: of a row of bars its time grows as n^3.
    """
    towards, waiting = {end: end}, deque([end])
    while waiting:
        here = waiting.popleft()
        if here is root:
            path = [root]
            while path[-1] is not end:
                path.append(towards[path[-1]])
            return tuple(path)
        for other in neighbours(here):
            if other not in towards:
                towards[other] = here
                waiting.append(other)
    return ()


def relative_rotation(parent: ReferenceFrame, child: ReferenceFrame) -> Matrix:
    """3 x 3 matrix R of one step: v_parent = R v_child."""
    return Matrix(parent.dcm(child)).applyfunc(decimals)


def step_vector(parent: Point, child: Point) -> Vector:
    """Vector of one step from parent to child, in the frames in which the user gave it."""
    return child._pos_dict[parent]


def components(vector: Vector) -> tuple[tuple[ReferenceFrame, Matrix], ...]:
    """(frame, 3 x 1 components) of a SymPy vector; empty for the zero vector."""
    return tuple((frame, Matrix(column).applyfunc(decimals)) for column, frame in vector.args)


def dyadic_matrix(dyadic: Dyadic, frame: ReferenceFrame) -> Matrix:
    """3 x 3 components of a dyadic in a frame.

    Where it is given in that frame its terms are added up; SymPy multiplies 27 vectors a term.
    """
    total = zeros(3, 3)
    for factor, first, second in dyadic.args:
        if any(owner != frame for vector in (first, second) for _, owner in vector.args):
            return Matrix(dyadic.to_matrix(frame))
        for left, _ in first.args:
            for right, _ in second.args:
                total += factor * left * right.T
    return total


@dataclass(frozen=True)
class Placed:
    """What places points and frames: the steps from the root, each told once.

    A chain of n bodies has n steps, but positions of n terms.
    """

    root: ReferenceFrame
    origin: Point
    _told: set[Point | ReferenceFrame] = field(default_factory=set)

    def point(self, point: Point) -> Iterator[Expr]:
        """Components of the steps to a point, and what orients their frames."""
        for parent, child in pairwise(point_path(self.origin, point)):
            if child not in self._told:
                self._told.add(child)
                yield from self.vector(step_vector(parent, child))

    def vector(self, vector: Vector) -> Iterator[Expr]:
        """Components of a vector, and what orients their frames."""
        for frame, column in components(vector):
            yield from column
            yield from self.frame(frame)

    def frame(self, frame: ReferenceFrame) -> Iterator[Expr]:
        """Entries of the rotations from the root to a frame."""
        for parent, child in pairwise(frame_path(self.root, frame)):
            if child not in self._told:
                self._told.add(child)
                yield from relative_rotation(parent, child)


@dataclass(frozen=True)
class Movers:
    """The functions of time in the way from the root to points and frames, step by step."""

    root: ReferenceFrame
    origin: Point
    _of_point: dict[Point, frozenset[Expr]] = field(default_factory=dict)
    _of_frame: dict[ReferenceFrame, frozenset[Expr]] = field(default_factory=dict)

    def point(self, point: Point) -> frozenset[Expr]:
        """Functions that the position of a point holds."""
        found: frozenset[Expr] = frozenset()
        for parent, child in pairwise(point_path(self.origin, point)):
            if child not in self._of_point:
                for frame, column in components(step_vector(parent, child)):
                    found |= column.atoms(AppliedUndef) | self.frame(frame)
                self._of_point[child] = found
            found = self._of_point[child]
        return found

    def frame(self, frame: ReferenceFrame) -> frozenset[Expr]:
        """Functions that the orientation of a frame holds."""
        found: frozenset[Expr] = frozenset()
        for parent, child in pairwise(frame_path(self.root, frame)):
            if child not in self._of_frame:
                turn = relative_rotation(parent, child)
                self._of_frame[child] = found | turn.atoms(AppliedUndef)
            found = self._of_frame[child]
        return found
