"""What a walk to the extremes found. Nothing but data."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from mechanics.extremes.axes import Axis
from mechanics.extremes.cause import CAUSES, Cause
from mechanics.extremes.points import Walk

Array = NDArray[np.float64]

STABLE = 16.0
"""Backward error, in epsilon, up to which an equation holds to a few roundings."""

TOLERANCE = 1e-12
"""Relative error up to which double precision counts as accurate."""

PRECISIONS: dict[str, type[np.floating]] = {"double": np.float64, "single": np.float32}


def tolerance(precision: str) -> float:
    """As many roundings in every precision: 1e-12 in double, 5.4e-4 in single."""
    epsilon = float(np.finfo(PRECISIONS[precision]).eps)
    return TOLERANCE * epsilon / float(np.finfo(np.float64).eps)


@dataclass(frozen=True, eq=False)
class Figures:
    """Errors of one form in one precision at all N points of a walk.

    Attributes
    ----------
    form, precision : str
    forward : array (N,)
        Largest error of an acceleration or multiplier, in ulp.
    relative : array (N,)
        The same, relative to its value.
    backward : array (N,)
        Largest residual of a row against the sum of its terms, in epsilon.
    causes : array (N,) of int
        Index in `CAUSES`.
    normal : array (N,) of bool
        Whether M, f and every value of the form are zero or normal numbers.
    """

    form: str
    precision: str
    forward: Array
    relative: Array
    backward: Array
    causes: NDArray[np.int8]
    normal: NDArray[np.bool_]

    def cause(self, index: int) -> Cause:
        """Why the figures of a point are what they are."""
        return CAUSES[int(self.causes[index])]


@dataclass(frozen=True, eq=False)
class Visited:
    """A walk and what was found along it.

    Attributes
    ----------
    walk : Walk
    condition : array (N,)
        |K| |K^-1| in largest row sums, K the matrix of the equations in SI units; the mass matrix
        where there are no constraints.
    sensitivity : array (N,)
        max_i (|K^-1| (|K| |x| + |k|))_i / |x_i|: relative error of an acceleration for a relative
        error of the terms.
    figures : tuple of Figures
        One for each form and precision.
    """

    walk: Walk
    condition: Array
    sensitivity: Array
    figures: tuple[Figures, ...]

    def figure(self, form: str, precision: str) -> Figures:
        """The figures of a form in a precision."""
        return next(f for f in self.figures if (f.form, f.precision) == (form, precision))


@dataclass(frozen=True)
class End:
    """What ends a range.

    Attributes
    ----------
    cause : Cause
        ACCURATE where the walk ended first.
    where : str
        The expression that overflows or underflows first; empty for other causes.
    """

    cause: Cause
    where: str


@dataclass(frozen=True)
class Reach:
    """How far one quantity goes, the others as usual, before something breaks.

    Attributes
    ----------
    name, unit, form, precision : str
    usual : float
    low, high : float
        Ends of the range in which every point visited is accurate to `tolerance`.
    below, above : End
        What breaks beyond the ends.
    worst : float
        Largest backward error inside, in epsilon.
    """

    name: str
    unit: str
    form: str
    precision: str
    usual: float
    low: float
    high: float
    below: End
    above: End
    worst: float


@dataclass(frozen=True, eq=False)
class Extremes:
    """How the accelerations of one system hold at the extremes.

    Attributes
    ----------
    system, route : str
    default : str
        The form that `compile` takes for these equations.
    forms : tuple of str
        All forms that were measured.
    unknowns : tuple of str
        Names of u' and multipliers.
    axes : tuple of Axis
        Quantities in the order of the values of a point.
    usual : tuple of float
        The point from which every line and pair starts.
    visited : tuple of Visited
    reaches : tuple of Reach
    backend : str
    """

    system: str
    route: str
    default: str
    forms: tuple[str, ...]
    unknowns: tuple[str, ...]
    axes: tuple[Axis, ...]
    usual: tuple[float, ...]
    visited: tuple[Visited, ...]
    reaches: tuple[Reach, ...]
    backend: str

    @property
    def points(self) -> int:
        """Number of points visited."""
        return sum(len(v.walk) for v in self.visited)

    def worst(self, form: str, precision: str) -> float:
        """Largest backward error, in epsilon, where everything is zero or a normal number."""
        parts = [v.figure(form, precision) for v in self.visited]
        return max((float(f.backward[f.normal].max(initial=0.0)) for f in parts), default=0.0)
