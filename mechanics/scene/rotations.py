"""Rotations without a chart: a unit quaternion as coordinates, the angular velocity as speeds.

    R = 1 + 2 (e0 [e]x + [e]x [e]x) / n,      e = (e1, e2, e3),  n = e0^2 + e . e           (1)
    e0' = -e . w / 2,      e' = (e0 w + e x w) / 2                                          (2)
    w = 2 (e0 e' - e0' e - e x e') / n                                                      (3)

w is the angular velocity relative to the parent, in components of the frame itself. By (2) n does
not change, so that n = 1 is a condition on the initial state, which no reaction maintains. (1) is
a rotation for every n > 0: what is derived from it holds off the unit sphere, too.

Source: P. E. Nikravesh, Computer-Aided Analysis of Mechanical Systems, 1988, chapter 6.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Expr, Matrix, Rational, eye
from sympy.physics.vector import ReferenceFrame, dynamicsymbols

from mechanics.errors import SceneError
from mechanics.scene.symbols import name_of

HALF = Rational(1, 2)


@dataclass(frozen=True)
class Rotation:
    """A rotation by a unit quaternion; see `quaternion`.

    Attributes
    ----------
    coordinates : tuple of four dynamic symbols
        The scalar part first.
    speeds : tuple of three dynamic symbols
        Angular velocity relative to the parent, components in the frame itself, in rad/s.
    """

    coordinates: tuple[Expr, ...]
    speeds: tuple[Expr, ...]

    @property
    def name(self) -> str:
        """Its coordinates, for people."""
        return " ".join(map(name_of, self.coordinates))

    @property
    def square(self) -> Expr:
        """n, the square of the norm: 1 along every motion."""
        e0, e1, e2, e3 = self.coordinates
        return e0**2 + e1**2 + e2**2 + e3**2

    @property
    def matrix(self) -> Matrix:
        """Equation (1): 3 x 3, v_parent = R v_frame."""
        scalar, vector = self.coordinates[0], Matrix(self.coordinates[1:])
        factor, skew = 2 / self.square, _skew(vector)
        return eye(3) + (scalar * skew + skew * skew).applyfunc(lambda entry: factor * entry)

    @property
    def rates(self) -> tuple[Expr, ...]:
        """Equation (2), in the order of the coordinates."""
        scalar, vector = self.coordinates[0], Matrix(self.coordinates[1:])
        w = Matrix(self.speeds)
        return (-HALF * vector.dot(w), *(HALF * (scalar * w + vector.cross(w))))

    @property
    def definitions(self) -> tuple[tuple[Expr, Expr], ...]:
        """Each speed with equation (3)."""
        e0, vector = self.coordinates[0], Matrix(self.coordinates[1:])
        t = dynamicsymbols._t
        turned = e0 * vector.diff(t) - e0.diff(t) * vector - vector.cross(vector.diff(t))
        return tuple((u, 2 * w / self.square) for u, w in zip(self.speeds, turned, strict=True))

    def orient(self, name: str, parent: ReferenceFrame) -> ReferenceFrame:
        """A new frame, turned in its parent by equation (1).

        Returns
        -------
        ReferenceFrame
            Its angular velocity in the parent is that of the speeds.
        """
        frame = ReferenceFrame(name)
        # `orient_explicit` would differentiate and simplify, for what stands in the next lines.
        frame._dcm(parent, self.matrix)
        wx, wy, wz = self.speeds
        frame.set_ang_vel(parent, wx * frame.x + wy * frame.y + wz * frame.z)
        return frame


def quaternion(coordinates: str | Sequence[Expr], speeds: str | Sequence[Expr]) -> Rotation:
    """A rotation without a chart, for a body that turns freely or hangs in a ball joint.

    Parameters
    ----------
    coordinates : str or four dynamic symbols
        Of the quaternion, the scalar part first: ``"e0 e1 e2 e3"``.
    speeds : str or three dynamic symbols
        Of the angular velocity, in components of the frame that it turns: ``"wx wy wz"``.

    Raises
    ------
    SceneError
        When there are not four coordinates and three speeds.

    Examples
    --------
    >>> from sympy.physics.vector import ReferenceFrame
    >>> rotation = quaternion("e0 e1 e2 e3", "wx wy wz")
    >>> B = rotation.orient("B", ReferenceFrame("N"))
    >>> B.ang_vel_in(B)
    0
    """
    found = []
    for kind, count, names in (("coordinates", 4, coordinates), ("speeds", 3, speeds)):
        symbols = dynamicsymbols(names) if isinstance(names, str) else names
        symbols = tuple(symbols) if isinstance(symbols, Sequence) else (symbols,)
        if len(symbols) != count:
            raise SceneError(
                f"quaternion: {len(symbols)} {kind}, {names!r}: give {count}, as in"
                ' quaternion("e0 e1 e2 e3", "wx wy wz")'
            )
        for symbol in symbols:
            name_of(symbol)
        found.append(symbols)
    return Rotation(*found)


def rotation_between(
    rotations: Sequence[Rotation], parent: ReferenceFrame, frame: ReferenceFrame
) -> Rotation | None:
    """The rotation that turns a frame in its parent; None where none of them does."""
    step = parent.dcm(frame)
    return next((rotation for rotation in rotations if rotation.matrix == step), None)


def _skew(v: Matrix) -> Matrix:
    return Matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
