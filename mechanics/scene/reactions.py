"""Reactions and constraints: what holds the bodies together."""

from dataclasses import dataclass

from sympy import Expr, Symbol
from sympy.physics.vector import Point, Vector

from mechanics.scene.declared import scalar


@dataclass(frozen=True)
class Reaction:
    """One unknown component of what one body exerts on another.

    Parameters
    ----------
    name : str
    on : str
        Body that feels `along` times the unknown.
    by : str or None
        Body that feels the opposite; None for the ground.
    along : Vector
        Unit direction.
    at : Point or None
        Where the force acts; None for a couple.
    parts : tuple of Reaction
        What the same unknown does elsewhere: the tension of a rope.
    """

    name: str
    on: str
    by: str | None
    along: Vector
    at: Point | None
    parts: tuple["Reaction", ...] = ()

    @property
    def actions(self) -> tuple["Reaction", ...]:
        """All that the unknown does."""
        return (self, *self.parts)

    @property
    def symbol(self) -> Symbol:
        """The unknown, in N or N m."""
        return Symbol(self.name, real=True)


def reaction(name: str, at: Point, on: str, by: str | None, along: Vector) -> Reaction:
    """An unknown force component at a point: see `Reaction`.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N, O = ReferenceFrame("N"), Point("O")
    >>> reaction("X", at=O, on="rod", by=None, along=N.x).name
    'X'
    """
    return Reaction(name, on, by, along, at)


def reaction_couple(name: str, on: str, by: str | None, along: Vector) -> Reaction:
    """An unknown couple component: see `Reaction`.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> N = ReferenceFrame("N")
    >>> reaction_couple("M", on="wheel", by="fork", along=N.x).by
    'fork'
    """
    return Reaction(name, on, by, along, None)


@dataclass(frozen=True)
class Constraint:
    """``expression = 0``, maintained by the named reactions.

    Parameters
    ----------
    name : str
    expression : Expr
        Of the coordinates (holonomic), or linear in their rates (nonholonomic).
    reactions : tuple of str
        Names of the declared reactions that maintain it; they stay as multipliers.
    holonomic : bool
    """

    name: str
    expression: Expr
    reactions: tuple[str, ...]
    holonomic: bool


def holonomic(name: str, expression: Expr, *reactions: str) -> Constraint:
    """A configuration constraint ``expression(q) = 0``: a closed loop, for example.

    Examples
    --------
    >>> from sympy.physics.mechanics import dynamicsymbols
    >>> x, y, (l,) = *dynamicsymbols("x y"), parameters("l", "m", "1")
    >>> holonomic("rod", x**2 + y**2 - l**2, "S").expression
    -l**2 + x(t)**2 + y(t)**2
    """
    return Constraint(name, scalar(expression, f"constraint {name}"), reactions, True)


def nonholonomic(name: str, expression: Expr, *reactions: str) -> Constraint:
    """A motion constraint ``expression(q, q') = 0``, linear in the rates: rolling, for example.

    Examples
    --------
    >>> from sympy import cos, sin
    >>> from sympy.physics.mechanics import dynamicsymbols
    >>> x, y, q = dynamicsymbols("x y q")
    >>> nonholonomic("skate", y.diff() * cos(q) - x.diff() * sin(q), "N").expression
    -sin(q(t))*Derivative(x(t), t) + cos(q(t))*Derivative(y(t), t)
    """
    return Constraint(name, scalar(expression, f"constraint {name}"), reactions, False)
