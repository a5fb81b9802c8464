"""The linear part of the closed vocabulary: what a published row about small motions can be about.

    M x'' + C x' + K x = E w        D(s) X = E W        K a = omega^2 M a

All of it holds about an operating point that is proved to be an equilibrium, or a steady motion;
coordinates and inputs in a row stand for deviations from it. Coordinates, inputs, bodies and points
are named as in the scene. An *equation* has two sides and is checked as a whole: scaled or combined
rows and swapped sides are the same equation. Of any other quantity every side of the row is a form.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field

from sympy import Expr, Symbol, sympify

from mechanics.scene.published import Quantity

Named = tuple[tuple[str, Expr], ...]


@dataclass(frozen=True)
class OperatingPoint:
    """Values of all coordinates and inputs, by name; of a steady motion speeds, as `linearize`."""

    coordinates: Named
    inputs: Named = ()
    speeds: Named = ()


def operating_point(
    coordinates: Mapping[str, Expr | int],
    inputs: Mapping[str, Expr | int] | None = None,
    speeds: Mapping[str, Expr | int] | None = None,
) -> OperatingPoint:
    """An operating point: ``operating_point({"theta": 0}, {"f": 0})``."""

    def named(values: Mapping[str, Expr | int] | None) -> Named:
        return tuple((name, sympify(value)) for name, value in (values or {}).items())

    return OperatingPoint(named(coordinates), named(inputs), named(speeds))


@dataclass(frozen=True)
class ProportionalFeedback:
    """input = gain (reference - output): the controller of a control loop."""

    input: str
    output: str
    gain: Symbol
    reference: Symbol


@dataclass(frozen=True)
class Laplace:
    """The variable s and the image of every coordinate, input and reference, by name."""

    s: Symbol
    images: tuple[tuple[str, Symbol], ...]


@dataclass(frozen=True)
class LinearQuantity(Quantity):
    """Base of this part of the vocabulary.

    `where` names symbols of the source that stand for derived quantities, I_A' for an inertia.
    """

    point: OperatingPoint
    where: tuple[tuple[Symbol, Quantity], ...] = field(default=(), kw_only=True)


@dataclass(frozen=True)
class EquilibriumStability(LinearQuantity):
    """Whether the equilibrium is ``"stable"`` or ``"unstable"`` without control: the one side."""


@dataclass(frozen=True)
class LinearizedEquation(LinearQuantity):
    """Equation of small motions; several at once as n x 1 matrices."""


@dataclass(frozen=True)
class InertiaAbout(LinearQuantity):
    """Moment of inertia about the point where `about` is at rest, normal to the plane, in kg m^2.

    By the parallel-axis theorem, and as the coefficient of the coordinate's second rate in the
    linear equation of motion: a side has to be both.
    """

    body: str
    about: str
    coordinate: str


@dataclass(frozen=True)
class TransformedEquation(LinearQuantity):
    """Equation of small motions in the s-domain; with feedback, that of the closed loop."""

    laplace: Laplace
    feedback: ProportionalFeedback | None = None


@dataclass(frozen=True)
class TransferFunction(LinearQuantity):
    """Ratio of the images of a coordinate and an input, or a reference of the closed loop."""

    s: Symbol
    output: str
    given: str
    feedback: ProportionalFeedback | None = None


@dataclass(frozen=True)
class FeedbackLaw(LinearQuantity):
    """Equation of the controller, in time or, with images, in the s-domain."""

    feedback: ProportionalFeedback
    laplace: Laplace | None = None


@dataclass(frozen=True)
class PoleEquation(LinearQuantity):
    """Equation in s whose roots are the poles."""

    s: Symbol
    feedback: ProportionalFeedback | None = None


@dataclass(frozen=True)
class StabilityBoundary(LinearQuantity):
    """Value of the gain between stable and unstable."""

    feedback: ProportionalFeedback


@dataclass(frozen=True)
class StabilityRegion(LinearQuantity):
    """Gains for which the closed loop is stable, or is not: an inequality such as ``K > M*g/3``."""

    feedback: ProportionalFeedback
    stable: bool


@dataclass(frozen=True)
class TrialSolution(LinearQuantity):
    """Free vibration of amplitudes a, frequency omega and phase phi at time zero, n x 1 matrix."""

    amplitudes: tuple[Symbol, ...]
    omega: Symbol
    phase: Symbol
    time: Symbol


@dataclass(frozen=True)
class EigenvalueProblem(LinearQuantity):
    """Equation K a = omega^2 M a, n x 1 matrices, all terms on whatever side."""

    amplitudes: tuple[Symbol, ...]
    omega: Symbol


@dataclass(frozen=True)
class CharacteristicPolynomial(LinearQuantity):
    """det(K - omega^2 M), whose roots are the natural frequencies."""

    omega: Symbol


@dataclass(frozen=True)
class Eigenvalue(LinearQuantity):
    """omega^2 of a mode, counted from 1 for the lowest."""

    mode: int


@dataclass(frozen=True)
class BackSubstitution(LinearQuantity):
    """Equation (K - omega_r^2 M) a = 0 of the mode r, counted from 1 for the lowest."""

    amplitudes: tuple[Symbol, ...]
    mode: int


@dataclass(frozen=True)
class ModeShape(LinearQuantity):
    """Shape of a mode, n x 1, counted from 1 for the lowest.

    With ``scaled`` the largest element is one (the last of equals), else any multiple is right.
    """

    mode: int
    scaled: bool = True


@dataclass(frozen=True)
class ModalMatrix(LinearQuantity):
    """Shapes as columns, lowest frequency first, the largest element of each one."""


@dataclass(frozen=True)
class DimensionlessProblem(LinearQuantity):
    """Equation K' a = lambda M' a with matrices of integers, n x 1 matrices."""

    amplitudes: tuple[Symbol, ...]
    parameter: Symbol


@dataclass(frozen=True)
class SpeedMatrix(LinearQuantity):
    """``"M"``, ``"C1"``, ``"K0"`` or ``"K2"`` of M x'' + v C1 x' + (g K0 + v^2 K2) x = 0.

    Of a steady motion with the speed v, cyclic coordinates taken out by their momenta.
    """

    matrix: str
    speed: str
    gravity: str = "g"


@dataclass(frozen=True)
class DimensionlessParameter(LinearQuantity):
    """lambda as a group of parameters and omega."""

    omega: Symbol


@dataclass(frozen=True)
class DimensionlessMatrices(LinearQuantity):
    """K' and M': two sides, n x n matrices of integers that belong together."""


@dataclass(frozen=True)
class PrintedEigenvalues(LinearQuantity):
    """Diagonal matrix of the dimensionless eigenvalues, entries rounded, largest first or last."""

    largest_first: bool


@dataclass(frozen=True)
class PrintedShapes(LinearQuantity):
    """Shapes as columns of unit length, entries rounded, largest eigenvalue first or last.

    The sign of a column is free.
    """

    largest_first: bool
