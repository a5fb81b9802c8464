"""Rotations between frames that are fixed to each other, exactly: R^T R = 1 without rounding.

    R = 1 + 2 (w [v]x + [v]x [v]x) / (w^2 + v . v)      a quaternion (w, v) of rationals   (1)
    (w, v) = (1, t e),  t = tan(a/2)                    a turn by a about a unit vector e  (2)

A multiple of pi/12 keeps its sine and cosine; any other angle is replaced by one with a rational t
that differs by less than 1e-20, a quaternion that was rounded to doubles by its ratios.

Source: (1) Euler, Novi Commentarii 20, 1776; Rodrigues, J. Math. Pures Appl. 5, 1840.
"""

import math
from collections.abc import Sequence
from fractions import Fraction

from sympy import Expr, ImmutableMatrix, Integer, Matrix, Rational, cos, eye, pi, sin, tan

from mechanics.scene.rotations import Rotation
from mechanics.symbolic import canonical

DIGITS = 20
AXES = "xyz"


def about(axis: int, angle: Expr) -> Matrix:
    """The turn by an angle about a coordinate axis: v_parent = R v_child."""
    turns = angle / pi
    if not angle.is_number or (turns.is_Rational and (12 * turns).is_Integer):
        c, s = cos(angle), sin(angle)
    else:
        # What is left of the angle beside right angles keeps t small.
        quarters = Integer(round(float(2 * turns)))
        t = rounded(tan((angle - quarters * pi / 2) / 2))
        c, s = (1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)
        cq, sq = cos(quarters * pi / 2), sin(quarters * pi / 2)
        c, s = c * cq - s * sq, s * cq + c * sq
    j, k = (axis + 1) % 3, (axis + 2) % 3
    found = eye(3)
    found[j, j] = found[k, k] = c
    found[j, k], found[k, j] = -s, s
    return found


def roll_pitch_yaw(angles: Sequence[Expr]) -> ImmutableMatrix:
    """Turns about the fixed axes x, y and z, in this order: R = R_z R_y R_x."""
    roll, pitch, yaw = angles
    found = about(2, yaw) * about(1, pitch) * about(0, roll)
    return ImmutableMatrix(found.applyfunc(canonical))


def euler_rodrigues(quaternion: Sequence[Rational]) -> ImmutableMatrix:
    """Equation (1), of a rational quaternion of any length but zero."""
    return ImmutableMatrix(Rotation(tuple(quaternion), ()).matrix)


def towards(direction: Sequence[Rational]) -> tuple[ImmutableMatrix, int, int]:
    """A rotation, the number of a coordinate axis and a sign: R e_k sign is along the direction.

    One that lies along an axis is exact; others are met to 20 digits.
    """
    n = Matrix(direction)
    axis = max(range(3), key=lambda k: abs(n[k]))
    sign = 1 if n[axis] > 0 else -1
    if all(n[k] == 0 for k in range(3) if k != axis):
        return ImmutableMatrix(eye(3)), axis, sign
    unit = eye(3)[:, axis] * sign
    n = n / max(abs(entry) for entry in n)
    length = rounded((n.dot(n)) ** Rational(1, 2))
    turn = unit.cross(n)
    return euler_rodrigues([length + unit.dot(n), *turn]), axis, sign


def from_doubles(quaternion: Sequence[float]) -> tuple[ImmutableMatrix, str]:
    """The rotation of a quaternion in doubles, and in words the angle if it was recognised.

    One about a coordinate axis, by a multiple of pi/12 to 15 digits, is that.
    """
    turned = [k for k in range(3) if abs(quaternion[k + 1]) > 1e-15]
    if not turned:
        return ImmutableMatrix(eye(3)), ""
    largest = max(quaternion, key=abs)
    ratios = [Rational(Fraction(e / largest).limit_denominator(10**17)) for e in quaternion]
    if len(turned) == 1:
        (axis,) = turned
        value = 2 * math.atan2(quaternion[axis + 1], quaternion[0])
        count = round(value * 12 / math.pi)
        if count and abs(value - count * math.pi / 12) < 1e-14:
            angle = Rational(count, 12) * pi
            return ImmutableMatrix(about(axis, angle)), f"{angle} about {AXES[axis]}"
    ratios = [entry if abs(entry) > Rational(1, 10**15) else Integer(0) for entry in ratios]
    return euler_rodrigues(ratios), ""


def rounded(value: Expr) -> Rational:
    """A rational within 1e-20."""
    scale = Integer(10) ** DIGITS
    return Rational(int((value * scale).evalf(3 * DIGITS)), scale)
