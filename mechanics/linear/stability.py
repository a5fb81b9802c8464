"""Stability from the signs of coefficients, exactly.

    p(s) = det(M s^2 + C s + K) = a_n s^n + ... + a_0,  a_n = 1; every pole has a negative real
           part if and only if all coefficients and every other Hurwitz determinant are positive
           (Lienard and Chipart)                                                             (1)
    even:  p(s) = P(S), S = s^2; motions stay bounded if all S are real, negative and distinct or
           semisimple: for C = 0, symmetric M > 0 and K the roots are real and semisimple, so they
           are all negative if and only if all coefficients of P have one sign;              (2)
           else they are real, negative and distinct if and only if P(s^2) + s P'(s^2) has all its
           roots on the left (Hermite and Biehler), by (1)                                   (3)
    steady motions: p(s) = s^k r(s), and r decides if 0 is semisimple in y' = A y: such deviations
           lead to neighbouring steady motions                                               (4)

A negative coefficient a_i / a_n means a pole with a positive real part: unstable. The borderline in
a gain is where a condition, linear in the gain, vanishes.
"""

from dataclasses import dataclass
from enum import Enum

from sympy import And, Expr, Gt, Lt, Matrix, S, Symbol, factor_list, fraction
from sympy.logic.boolalg import Boolean

from mechanics.errors import ExpressionError, InputError
from mechanics.linear.algebra import coefficients, independent_rows, is_zero, reduced, sign
from mechanics.linear.form import Linear
from mechanics.linear.transfer import characteristic_polynomial


class Stability(Enum):
    """What becomes of a small deviation."""

    ASYMPTOTIC = "every pole has a negative real part: deviations die out"
    BOUNDED = "all poles are on the imaginary axis and semisimple: deviations oscillate, bounded"
    NEIGHBOUR = "poles are 0, semisimple, or on the left: deviations end in a neighbouring motion"
    UNSTABLE = "a pole has a positive real part: a deviation grows exponentially"
    OPEN = "the signs depend on the parameters, or a pole lies on the borderline"

    @property
    def stable(self) -> bool | None:
        """True, False, or None where it is open."""
        return {Stability.UNSTABLE: False, Stability.OPEN: None}.get(self, True)


@dataclass(frozen=True)
class Region:
    """Where in a gain the system is stable: ``lower < gain < upper``, every bound counting.

    Attributes
    ----------
    gain : Symbol
    lower, upper : tuple of Expr
        Bounds; none on a side where it is stable all the way.
    """

    gain: Symbol
    lower: tuple[Expr, ...]
    upper: tuple[Expr, ...]

    @property
    def stable(self) -> Boolean:
        """The condition for stability."""
        above = [Gt(self.gain, bound) for bound in self.lower]
        return And(*above, *(Lt(self.gain, bound) for bound in self.upper))


def conditions(linear: Linear) -> tuple[Expr, ...]:
    """Expressions all of which are positive if and only if the operating point is stable."""
    return _conditions(linear, _monic(linear))


def _conditions(linear: Linear, ratios: list[Expr]) -> tuple[Expr, ...]:
    if not _even(ratios):
        return _lienard_chipart(ratios)
    squares = ratios[::2]
    if linear.undamped and (linear.conjugate or len(squares) == 1 or _symmetric(linear)):
        return tuple(squares)
    slopes = [(k + 1) * entry for k, entry in enumerate([*squares[1:], S.One])]
    mixed = [entry for pair in zip(squares, slopes, strict=True) for entry in pair]
    found = dict.fromkeys(_lienard_chipart(mixed))
    return tuple(entry for entry in found if not entry.is_Number or entry <= 0)


def stability(linear: Linear) -> Stability:
    """Stability of the operating point for all admissible parameters, if they settle it."""
    ratios = _monic(linear)
    if any(sign(ratio) == -1 for ratio in ratios):
        return Stability.UNSTABLE
    signs = [sign(condition) for condition in _conditions(linear, ratios)]
    if all(value == 1 for value in signs):
        if _even(ratios):
            return Stability.BOUNDED
        whole = 2 * len(linear.coordinates) - len(linear.cyclic)
        return Stability.ASYMPTOTIC if len(ratios) == whole else Stability.NEIGHBOUR
    # A negative discriminant makes S complex; Hurwitz determinants that are negative, poles too.
    return Stability.UNSTABLE if -1 in signs else Stability.OPEN


def stability_region(linear: Linear, gain: Symbol) -> Region:
    """Where in a gain the equilibrium is stable.

    Raises
    ------
    InputError
        If it is stable, or unstable, whatever the gain.
    ExpressionError
        If a condition has no linear factor in the gain, or its sign is open.
    """
    lower: list[Expr] = []
    upper: list[Expr] = []
    for condition in conditions(linear):
        bound, side = _bound(linear, condition, gain)
        if side:
            bounds = lower if side > 0 else upper
            if bound not in bounds:
                bounds.append(bound)
    if not lower and not upper:
        raise InputError(f"{linear.scene.name}: {gain} changes nothing about stability")
    return Region(gain, tuple(lower), tuple(upper))


def coefficient_ratios(linear: Linear) -> list[Expr]:
    """a_i / a_n, without the leading one."""
    s = Symbol("s")
    if linear.undamped:
        squares = coefficients((linear.mass * s + linear.stiffness).det(method="berkowitz"), s)
        found = [entry for pair in ((square, S.Zero) for square in squares) for entry in pair][:-1]
    else:
        found = coefficients(characteristic_polynomial(linear, s), s)
    return [reduced(entry / found[-1]) for entry in found[:-1]]


def _monic(linear: Linear) -> list[Expr]:
    """The same without zeros that do not matter, equation (4)."""
    ratios = coefficient_ratios(linear)[len(linear.cyclic) :]
    zeros = next((k for k, entry in enumerate(ratios) if not is_zero(entry)), len(ratios))
    if not linear.moves or not zeros:
        return ratios
    rank = len(independent_rows(linear.A))
    return ratios[zeros:] if rank == linear.A.rows - zeros else ratios


def _even(ratios: list[Expr]) -> bool:
    """Whether a monic polynomial is one in s^2."""
    return len(ratios) % 2 == 0 and all(is_zero(entry) for entry in ratios[1::2])


def _symmetric(linear: Linear) -> bool:
    matrices = (linear.mass, linear.stiffness)
    return all(is_zero(entry) for matrix in matrices for entry in matrix - matrix.T) and all(
        sign(linear.mass[:k, :k].det(method="berkowitz")) == 1
        for k in range(1, linear.mass.rows + 1)
    )


def _lienard_chipart(ratios: list[Expr]) -> tuple[Expr, ...]:
    """Coefficients of the monic polynomial, and Hurwitz determinants of every other order.

    Entry (i, j) of the Hurwitz matrix is a_(n - 2j + i), counted from 1. The determinant of order
    n is a_0 times the one of order n - 1, so that n - 1, n - 3, ... are the ones to take; that of
    order 1 is a coefficient again.
    """
    from_top = [S.One, *reversed(ratios)]
    degree = len(ratios)

    def entry(i: int, j: int) -> Expr:
        k = 2 * (j + 1) - (i + 1)
        return from_top[k] if 0 <= k <= degree else S.Zero

    table = Matrix(degree, degree, entry)
    orders = range(degree - 1, 1, -2)
    return (
        *ratios,
        *(reduced(table[:k, :k].det(method="berkowitz")) for k in orders),
    )


def _bound(linear: Linear, condition: Expr, gain: Symbol) -> tuple[Expr | None, int]:
    """Return (value, 1) if the condition holds above the value, -1 if below, 0 if always."""
    if not condition.has(gain):
        if sign(condition) != 1:
            raise InputError(
                f"{linear.scene.name}: stability needs {condition} > 0, which {gain} does not"
                " change: there is no borderline in it"
            )
        return None, 0
    above, below = fraction(condition)
    # The sign of a quotient is that of the product.
    rest, factors = factor_list(above * below)
    deciding = []
    for factor, power in factors:
        if factor.has(gain) and sign(factor) is None:
            deciding.append((factor, power))
        else:
            rest *= factor**power
    rest_sign = sign(rest)
    degrees = [(factor.as_poly(gain).degree(), power) for factor, power in deciding]
    if degrees != [(1, 1)] or rest_sign not in (1, -1):
        raise ExpressionError(
            f"{linear.scene.name}: the stability condition {condition} > 0 has no single linear"
            f" factor in {gain}: give values to other parameters"
        )
    linear_in_gain = deciding[0][0]
    constant, slope = coefficients(linear_in_gain, gain)
    slope_sign = sign(slope)
    if slope_sign is None:
        raise ExpressionError(
            f"{linear.scene.name}: the sign of {slope} decides on which side of the borderline"
            f" {gain} makes it stable: declare the parameters positive"
        )
    return reduced(-constant / slope), rest_sign * slope_sign
