"""Bodies: a point mass, or a rigid body with its inertia about the mass centre."""

from dataclasses import dataclass

from sympy import Expr
from sympy.physics.vector import Dyadic, Point, ReferenceFrame, Vector

from mechanics.errors import SceneError
from mechanics.scene.declared import scalar
from mechanics.scene.geometry import dyadic_matrix


@dataclass(frozen=True)
class Particle:
    """A point mass: no rotational inertia, and no orientation that matters.

    Parameters
    ----------
    name : str
    centre : sympy Point
    mass : Expr
        In kg; may be zero where the mass matrix stays regular.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point
    >>> (m,) = parameters("m", units="kg")
    >>> Particle("bob", Point("P"), m).mass
    m
    """

    name: str
    centre: Point
    mass: Expr

    def __post_init__(self) -> None:
        object.__setattr__(self, "mass", _mass(self.name, self.mass))


NOTHING = Vector(0)


@dataclass(frozen=True)
class Outline:
    """What drawings show of a body: r = at + first cos(a) + second sin(a), an ellipse or a line.

    Parameters
    ----------
    first, second : Vector
        Semi-axes along the body's frame, of numbers in m or parameters of the scene. A line goes
        from at - first to at + first; its second one is ``Vector(0)``.
    at : Vector, optional
        From the mass centre.
    filled : bool
        A disc, and not a ring. Several in a plane are the ends of one body, drawn around them.
    """

    first: Vector
    second: Vector = NOTHING
    at: Vector = NOTHING
    filled: bool = False


@dataclass(frozen=True)
class RigidBody:
    """A rigid body.

    Parameters
    ----------
    name : str
    centre : sympy Point
        The mass centre.
    frame : sympy ReferenceFrame
        Fixed in the body.
    mass : Expr
    inertia : Expr or sympy Dyadic
        About the mass centre. A scalar is the moment of inertia about the normal of the plane
        that the scene keeps; in a scene that leaves its plane it is refused.
    outlines : tuple of Outline, optional
        How it is drawn, where its inertia and its joints do not tell; nothing else reads them.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame
    >>> m, L = parameters("m L", units="kg m")
    >>> RigidBody("rod", Point("C"), ReferenceFrame("A"), m, m * L**2 / 12).inertia
    L**2*m/12
    """

    name: str
    centre: Point
    frame: ReferenceFrame
    mass: Expr
    inertia: Expr | Dyadic
    outlines: tuple[Outline, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "mass", _mass(self.name, self.mass))
        if self.inertia is None:
            raise SceneError(
                f"body {self.name}: the inertia about the mass centre is missing:"
                " give a scalar (planar), a Dyadic, or declare a Particle"
            )
        if not isinstance(self.inertia, Dyadic):
            what = f"body {self.name}: the inertia"
            object.__setattr__(self, "inertia", scalar(self.inertia, what))
            if self.inertia.is_negative:
                raise SceneError(
                    f"body {self.name}: the inertia {self.inertia} is negative: a moment of"
                    " inertia is zero or more"
                )


Body = Particle | RigidBody


def _mass(name: str, mass: Expr) -> Expr:
    if mass is None:
        raise SceneError(f"body {name}: the mass is missing: give an expression, or 0 for none")
    value = scalar(mass, f"body {name}: the mass")
    if value.is_negative:
        raise SceneError(f"body {name}: the mass {value} is negative: a mass is zero or more")
    return value


def inertia_entries(body: RigidBody) -> list[Expr]:
    """The scalar inertia, or the entries of the dyadic in the body's frame."""
    if isinstance(body.inertia, Dyadic):
        return list(dyadic_matrix(body.inertia, body.frame))
    return [body.inertia]
