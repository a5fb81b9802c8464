"""Outputs: what somebody wants computed of a motion, beside what moves it.

    position       r_P                   J = dv_P/du
    orientation    R,  v_N = R v_F       J = d omega_F/du
    velocity       v_P,  or v_P . e      J = dv_P/du,  or e . dv_P/du

v and omega are those in the inertial frame, whatever the frame of the components is: J is the
geometric Jacobian. So J u is v where no input and no time moves the point, and J^T F the
generalized force, conjugate to u, of a force F at P.
"""

from dataclasses import dataclass

from sympy.physics.vector import Point, ReferenceFrame, Vector

from mechanics.errors import SceneError
from mechanics.scene.declared import kind_of

AXES = "xyz"
JACOBIAN = "_jacobian"
"""End of the name of the function that gives the Jacobian of an output."""

Entries = tuple[tuple[str, str], ...]
"""End of the name of each entry, row by row, and its unit."""


@dataclass(frozen=True)
class Position:
    """Of a point, from the origin, in m; see `position`."""

    point: Point
    in_: ReferenceFrame | None = None

    @property
    def entries(self) -> Entries:
        """What is computed, entry by entry."""
        return tuple((f"_{axis}", "m") for axis in AXES)


@dataclass(frozen=True)
class Orientation:
    """Of a frame, a matrix of rotation; see `orientation`."""

    frame: ReferenceFrame
    in_: ReferenceFrame | None = None

    @property
    def entries(self) -> Entries:
        """What is computed, entry by entry."""
        return tuple((f"_{row}{column}", "1") for row in AXES for column in AXES)


@dataclass(frozen=True)
class Velocity:
    """Of a point, or of the body at the point, in m/s; see `velocity`."""

    point: Point
    along: Vector | None = None
    on: str | None = None
    in_: ReferenceFrame | None = None

    @property
    def entries(self) -> Entries:
        """What is computed, entry by entry."""
        ends = tuple(f"_{axis}" for axis in AXES) if self.along is None else ("",)
        return tuple((end, "m/s") for end in ends)


Output = Position | Orientation | Velocity


def position(point: Point, *, in_: ReferenceFrame | None = None) -> Position:
    """Position of a point from the origin of the scene.

    Parameters
    ----------
    point : Point
    in_ : ReferenceFrame, optional
        In whose directions the components are; by default the inertial frame.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point
    >>> position(Point("P")).entries
    (('_x', 'm'), ('_y', 'm'), ('_z', 'm'))
    """
    _expect("position", "point", point, Point, 'origin.locatenew("P", L * frame.x)')
    _basis("position", in_)
    return Position(point, in_)


def orientation(frame: ReferenceFrame, *, in_: ReferenceFrame | None = None) -> Orientation:
    """Orientation of a frame: the matrix R with v = R v_frame.

    Parameters
    ----------
    frame : ReferenceFrame
    in_ : ReferenceFrame, optional
        Of the components v, and of the angular velocity; by default the inertial frame.

    Examples
    --------
    >>> from sympy.physics.mechanics import ReferenceFrame
    >>> orientation(ReferenceFrame("A")).entries[:3]
    (('_xx', '1'), ('_xy', '1'), ('_xz', '1'))
    """
    _expect("orientation", "frame", frame, ReferenceFrame, "body.frame")
    _basis("orientation", in_)
    return Orientation(frame, in_)


def velocity(
    point: Point, *, along: Vector | None = None, on: str | None = None,
    in_: ReferenceFrame | None = None,
) -> Velocity:  # fmt: skip
    """Velocity of a point in the inertial frame.

    Parameters
    ----------
    point : Point
    along : Vector, optional
        Unit vector: its component in this direction alone, a scalar.
    on : str, optional
        Body: the velocity of what is now at the point and moves with the body, such as the slip of
        a wheel at its contact. By default that of the point itself.
    in_ : ReferenceFrame, optional
        In whose directions the components are; by default the inertial frame.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O = ReferenceFrame("N"), Point("O")
    >>> velocity(O).entries
    (('_x', 'm/s'), ('_y', 'm/s'), ('_z', 'm/s'))
    >>> velocity(O, along=N.x).entries
    (('', 'm/s'),)
    """
    _expect("velocity", "point", point, Point, 'origin.locatenew("P", L * frame.x)')
    _basis("velocity", in_)
    if along is not None:
        _expect("velocity", "along", along, Vector, "frame.x")
        if in_ is not None:
            raise SceneError("velocity: along= gives one component, and in_= all: leave one out")
    if on is not None:
        _expect("velocity", "on", on, str, 'the name of a body, "wheel"')
    return Velocity(point, along, on, in_)


def _expect(what: str, title: str, value: object, kind: type, example: str) -> None:
    if not isinstance(value, kind):
        raise SceneError(f"{what}: {title} is {kind_of(value)}: give {example}")


def _basis(what: str, frame: object) -> None:
    if frame is not None:
        _expect(what, "in_", frame, ReferenceFrame, "a ReferenceFrame, as in in_=body.frame")
