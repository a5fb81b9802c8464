"""A system: how to make its scene, and the equations that its source publishes."""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from sympy import Expr, Symbol

from mechanics.nearest import plural
from mechanics.scene.published import Published
from mechanics.scene.scene import Scene


@dataclass(frozen=True)
class Path:
    """Values worth a visit that no single quantity leads to: a gain beside its critical value.

    Attributes
    ----------
    label : str
        What is special there, in a phrase.
    along : Symbol
        Counts the points of the path.
    values : tuple of Fraction
        What it takes in turn.
    sets : tuple of (str, Expr)
        Coordinate, speed, input or parameter, and its value in terms of `along` and the parameters.
    """

    label: str
    along: Symbol
    values: tuple[Fraction, ...]
    sets: tuple[tuple[str, Expr], ...]


@dataclass(frozen=True, repr=False)
class System:
    """A scene with the equations published for it.

    Attributes
    ----------
    name : str
        As the command line knows it.
    scene : callable
        Makes a new scene; SymPy's frames and points are mutable.
    published : tuple of Published
        Rows of the source, typed by hand; may be empty.
    paths : tuple of Path
        Where `mechanics extremes` goes besides lines and pairs of quantities.
    model : callable or None
        Makes the model of another program that the scene is taken from, or the scene itself: whose
        own equations are compared. None where `scene` declares it.

    Examples
    --------
    >>> from systems import rod_pendulum
    >>> System("mine", rod_pendulum.scene)
    <system mine: 0 published rows>
    """

    name: str
    scene: Callable[[], Scene]
    published: tuple[Published, ...] = ()
    paths: tuple[Path, ...] = ()
    model: Callable[[], Any] | None = None

    def __repr__(self) -> str:
        return f"<system {self.name}: {plural(len(self.published), 'published row')}>"
