"""What the laws of joints compare: vectors and turns in numbers, as their author gave them."""

from collections.abc import Iterator
from typing import Any

from flint import arb, arb_mat
from sympy import Expr
from sympy.physics.vector import Point, ReferenceFrame, Vector

from mechanics.checks.as_declared import Motion, dot
from mechanics.checks.virtual_power import Row

LETTERS = "xyz"
AXES = tuple(arb_mat(3, 1, [int(i == k) for i in range(3)]) for k in range(3))
NONE = arb_mat(3, 1)


def vector(motion: Motion, given: Vector) -> arb_mat:
    """3 x 1, inertial components."""
    return _now(motion.vector(given))


def unit(motion: Motion, given: Vector) -> arb_mat:
    """The same of length 1."""
    column = vector(motion, given)
    return column * (1 / dot(column, column).sqrt())


def place(motion: Motion, point: Point) -> arb_mat:
    """From the origin, 3 x 1."""
    return _now(motion.position(point))


def rotation(motion: Motion, frame: ReferenceFrame) -> arb_mat:
    """v_inertial = R v_frame, 3 x 3."""
    return _now(motion.rotation(frame))


def number(motion: Motion, given: Expr | float) -> arb:
    """A scalar, which may be a Python number."""
    return motion.number(given) if isinstance(given, Expr) else arb(given)


def turn(axis: arb_mat, angle: arb) -> arb_mat:
    """exp([axis]x angle)."""
    x, y, z = (axis[i, 0] * angle for i in range(3))
    zero = arb(0)
    turned: arb_mat = arb_mat([[zero, -z, y], [z, zero, -x], [-y, x, zero]]).exp()
    return turned


def same(words: str, left: arb_mat, right: arb_mat) -> Iterator[Row]:
    """Entry by entry."""
    for one, two in zip(left.entries(), right.entries(), strict=True):
        yield words, one, two


def _now(jet: Any) -> arb_mat:
    now: arb_mat = jet.parts[0]
    return now
