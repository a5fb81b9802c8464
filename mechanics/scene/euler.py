"""Euler angles: three turns, each about an axis of the frame that the turn before has made.

R = R_i(a) R_j(b) R_k(c)            singular where sin b = 0 (k = i), else where cos b = 0
"""

from dataclasses import dataclass

from sympy import Expr
from sympy.physics.vector import ReferenceFrame

from mechanics.errors import SceneError
from mechanics.scene.symbols import name_of

AXES = "xyz"


@dataclass(frozen=True)
class Euler:
    """Three turns in a row; see `euler`.

    Attributes
    ----------
    order : str
        Axes, such as ``"zxz"``; neighbours differ.
    angles : tuple of three dynamic symbols
        In rad.
    """

    order: str
    angles: tuple[Expr, ...]

    def orient(self, name: str, parent: ReferenceFrame) -> ReferenceFrame:
        """A new frame, turned in its parent three times."""
        frame = parent
        for k, (axis, angle) in enumerate(zip(self.order, self.angles, strict=True), start=1):
            own = name if k == 3 else f"{name}_{k}"
            frame = frame.orientnew(own, "Axis", (angle, getattr(frame, axis)))
        return frame


def euler(order: str, *angles: Expr) -> Euler:
    """A rotation by Euler angles, for `ball` and `free`.

    Parameters
    ----------
    order : str
        Axes, each of the frame that the turn before has made: ``"zxz"`` are Euler's own angles,
        ``"zyx"`` yaw, pitch and roll.
    angles : three dynamic symbols
        In rad. The first and the third turn are about one line where the second is 0 (orders such
        as zxz) or a quarter turn (such as xyz): choose the order so that motions stay away, or
        take a `quaternion`.

    Raises
    ------
    SceneError
        When these are not three axes with three angles, or neighbours are the same axis.

    Examples
    --------
    >>> from sympy.physics.vector import ReferenceFrame, dynamicsymbols
    >>> euler("ZXZ", *dynamicsymbols("a b c")).orient("B", ReferenceFrame("N"))
    B
    """
    axes = order.lower() if isinstance(order, str) else ""
    if len(axes) != 3 or len(angles) != 3 or not {*axes} <= {*AXES}:
        raise SceneError(
            f"euler: {order!r} with {len(angles)} angles: give three axes and three angles,"
            ' as in euler("zxz", phi, theta, psi)'
        )
    if axes[0] == axes[1] or axes[1] == axes[2]:
        raise SceneError(f"euler: {order!r} turns twice about the same axis: let neighbours differ")
    for angle in angles:
        name_of(angle)
    return Euler(axes, angles)
