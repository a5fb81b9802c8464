"""Stability from the signs of coefficients, exactly.

    p(s) = det(M s^2 + C s + K) = a_n s^n + ... + a_0,  a_n = 1; every pole has a negative real
           part if and only if all coefficients and every other Hurwitz determinant are positive
           (Lienard and Chipart)                                                             (1)
    even:  p(s) = P(S), S = s^2; motions stay bounded if all S are real, negative and distinct or
           semisimple: for C = 0, symmetric M > 0 and K the roots are real and semisimple, so they
           are all negative if and only if all coefficients of P have one sign;              (2)
           else they are real, negative and distinct if and only if P(s^2) + s P'(s^2) has all its
           roots on the left (Hermite and Biehler), by (1)                                   (3)
    M = M^T > 0, K = K^T > 0, C = D + G with D = D^T >= 0, G = -G^T: the energy x'^T M x' / 2 +
           x^T K x / 2 never grows, so motions stay bounded; they die out if D > 0, or if G = 0
           and no mode of M, K escapes the damping: D, D M^-1 K, D (M^-1 K)^2, ... have together
           the rank n (Kelvin, Tait and Chetaev; damping is pervasive)                       (4)
    steady motions: p(s) = s^k r(s), and r decides if 0 is semisimple in y' = A y: such deviations
           lead to neighbouring steady motions                                               (5)
    rest: the same with k coordinates that are ignorable and the whole null space of K; 0 that is
           not semisimple lets them drift at constant speed                                  (6)

A negative coefficient a_i / a_n means a pole with a positive real part: unstable. The borderline in
a gain is where a condition, linear in the gain, vanishes.
"""

from dataclasses import dataclass, replace
from enum import Enum
from itertools import combinations

from sympy import Add, And, Expr, Gt, Lt, Matrix, S, Symbol, expand, factor_list, fraction, prime
from sympy.logic.boolalg import Boolean

from mechanics.errors import ExpressionError, InputError, ValueMissingError
from mechanics.linear.algebra import coefficients, independent_rows, is_zero, reduced, sign
from mechanics.linear.form import Linear
from mechanics.linear.transfer import characteristic_polynomial
from mechanics.linear.values import with_numbers

# Products that a Hurwitz determinant may have before it is not written out.
TERMS = 10**9


class Stability(Enum):
    """What becomes of a small deviation."""

    ASYMPTOTIC = "every pole has a negative real part: deviations die out"
    BOUNDED = "all poles are on the imaginary axis and semisimple: deviations oscillate, bounded"
    NEIGHBOUR = "poles are 0, semisimple, or on the left: deviations end in a neighbouring motion"
    DRIFTING = "a pole at 0 is double, none is on the right: a deviation drifts at constant speed"
    UNSTABLE = "a pole has a positive real part: a deviation grows exponentially"
    OPEN = "the signs depend on the parameters, or a pole lies on the borderline"

    @property
    def stable(self) -> bool | None:
        """True, False, or None where it is open."""
        none = {Stability.UNSTABLE: False, Stability.DRIFTING: False, Stability.OPEN: None}
        return none.get(self, True)


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
    symmetric = _definite(linear.mass) and _symmetric(linear.stiffness)
    if linear.undamped and (linear.conjugate or len(squares) == 1 or symmetric):
        return tuple(squares)
    slopes = [(k + 1) * entry for k, entry in enumerate([*squares[1:], S.One])]
    mixed = [entry for pair in zip(squares, slopes, strict=True) for entry in pair]
    found = dict.fromkeys(_lienard_chipart(mixed))
    return tuple(entry for entry in found if not entry.is_Number or entry <= 0)


def stability(linear: Linear) -> Stability:
    """Stability of the operating point for all admissible parameters, if they settle it."""
    if (by_energy := _by_energy(linear)) is not None:
        return by_energy
    ratios, zeros = _monic(linear), 0
    if _only_ignorable(linear):
        zeros = next((k for k, entry in enumerate(ratios) if not is_zero(entry)), len(ratios))
        ratios = ratios[zeros:]
    if any(sign(ratio) == -1 for ratio in ratios):
        return Stability.UNSTABLE
    signs = [sign(condition) for condition in _conditions(linear, ratios)]
    if all(value == 1 for value in signs):
        if zeros > len(linear.ignorable):
            return Stability.DRIFTING
        if _even(ratios):
            return Stability.BOUNDED
        whole = 2 * len(linear.coordinates) - len(linear.cyclic)
        return Stability.ASYMPTOTIC if len(ratios) == whole else Stability.NEIGHBOUR
    # A negative discriminant makes S complex; Hurwitz determinants that are negative, poles too.
    return Stability.UNSTABLE if -1 in signs else Stability.OPEN


def verdict(linear: Linear) -> str:
    """Stability in words: for all admissible parameters, else at the typical values.

    Coordinates that are ignorable at rest are named: they are what a pole at 0 comes from.
    """
    where = ""
    try:
        answer = stability(linear)
    except ExpressionError:
        answer = Stability.OPEN
    if answer is Stability.OPEN and linear.program.inputs:
        try:
            answer = stability(_at_typical_values(linear))
        except (ExpressionError, ValueMissingError):
            return Stability.OPEN.value
        where = "at typical values, "
    names = ", ".join(map(str, linear.ignorable))
    words = {
        Stability.OPEN: "a pole lies on the borderline",
        Stability.NEIGHBOUR: f"a pole at 0: {names} may rest anywhere; other deviations die out",
        Stability.DRIFTING: f"a double pole at 0: {names} may drift at constant speed; no deviation"
        " grows exponentially",
    }
    own = words.get(answer) if linear.ignorable or answer is Stability.OPEN else None
    return where + (own or answer.value)


def _at_typical_values(linear: Linear) -> Linear:
    matrices = {
        name: getattr(linear, name).applyfunc(lambda entry: with_numbers(linear.scene, entry))
        for name in ("mass", "damping", "stiffness")
    }
    return replace(linear.with_matrices((), **matrices), ignorable=linear.ignorable)


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
    """The same without zeros that do not matter, equation (5)."""
    ratios = coefficient_ratios(linear)[len(linear.cyclic) :]
    zeros = next((k for k, entry in enumerate(ratios) if not is_zero(entry)), len(ratios))
    if not linear.moves or not zeros:
        return ratios
    rank = len(independent_rows(linear.A))
    return ratios[zeros:] if rank == linear.A.rows - zeros else ratios


def _only_ignorable(linear: Linear) -> bool:
    """Whether K pushes back against all but the coordinates that are ignorable at rest."""
    free = len(linear.ignorable)
    return bool(free) and len(independent_rows(linear.stiffness)) == linear.mass.rows - free


def _even(ratios: list[Expr]) -> bool:
    """Whether a monic polynomial is one in s^2."""
    return len(ratios) % 2 == 0 and all(is_zero(entry) for entry in ratios[1::2])


def _symmetric(matrix: Matrix) -> bool:
    return all(is_zero(entry) for entry in matrix - matrix.T)


def _by_energy(linear: Linear) -> Stability | None:
    """Stability by the energy, equation (4); None where that does not settle it."""
    mass, damping, stiffness = linear.mass, linear.damping, linear.stiffness
    if linear.cyclic or not _definite(mass) or not _definite(stiffness):
        return None
    dissipation, gyroscopic = (damping + damping.T) / 2, (damping - damping.T) / 2
    if all(is_zero(entry) for entry in dissipation):
        return Stability.BOUNDED
    if not _semidefinite(dissipation):
        return None
    if _definite(dissipation):
        return Stability.ASYMPTOTIC
    if not all(is_zero(entry) for entry in gyroscopic):
        return None
    return Stability.ASYMPTOTIC if _pervasive(mass, dissipation, stiffness) else None


def _definite(matrix: Matrix) -> bool:
    """Whether a matrix is symmetric and its leading minors are positive."""
    return _symmetric(matrix) and all(
        sign(matrix[:k, :k].det(method="berkowitz")) == 1 for k in range(1, matrix.rows + 1)
    )


def _semidefinite(matrix: Matrix) -> bool:
    """Whether no principal minor of a symmetric matrix is negative."""
    return all(
        sign(matrix.extract(rows, rows).det(method="berkowitz")) in (0, 1)
        for size in range(1, matrix.rows + 1)
        for rows in map(list, combinations(range(matrix.rows), size))
    )


def _pervasive(mass: Matrix, dissipation: Matrix, stiffness: Matrix) -> bool:
    """Whether n rows of D, D M^-1 K, ... have a determinant of one sign, whatever the numbers."""
    step = mass.adjugate(method="berkowitz") * stiffness  # M^-1 K but for a positive factor
    names = sorted((mass.row_join(dissipation).row_join(stiffness)).free_symbols, key=str)
    numbers = {name: prime(k) for k, name in enumerate(names, 1)}  # which rows: a proposal
    rows = dissipation
    power = dissipation
    for _ in range(1, mass.rows):
        power = (power * step).applyfunc(expand)
        rows = rows.col_join(power)
        chosen = independent_rows(rows.subs(numbers))
        if len(chosen) == mass.rows:
            return sign(rows[list(chosen), :].det(method="berkowitz")) in (-1, 1)
    return False


def _lienard_chipart(ratios: list[Expr]) -> tuple[Expr, ...]:
    """Coefficients of the monic polynomial, and Hurwitz determinants of every other order.

    Entry (i, j) of the Hurwitz matrix is a_(n - 2j + i), counted from 1. The determinant of order
    n is a_0 times the one of order n - 1, so that n - 1, n - 3, ... are the ones to take; that of
    order 1 is a coefficient again.

    Raises
    ------
    ExpressionError
        If they are too long to be written out.
    """
    from_top = [S.One, *reversed(ratios)]
    degree = len(ratios)
    length = max(len(Add.make_args(fraction(ratio)[0].expand())) for ratio in ratios)
    if length ** (degree - 1) > TERMS:
        symbols = set().union(*(ratio.free_symbols for ratio in ratios))
        raise ExpressionError(
            f"the conditions of stability for {degree} poles in {len(symbols)}"
            " parameters are too long to be written out: give values to parameters"
        )

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
