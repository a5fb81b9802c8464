"""Programs on NumPy arrays with a bound of the error of every value: running error analysis.

    |value - true| <= error,   u = spacing of numbers at 1,   r = ulp of the table

    x + y, x - y   e_x + e_y + r u |v|
    x y            |x| e_y + |y| e_x + e_x e_y + r u |v|
    x / y          (e_x + |v| e_y) / (|y| - e_y) + r u |v|
    sqrt x         e_x / sqrt x + r u |v|
    f(x)           e_x sup |f'| over [x - e_x, x + e_x], see `_BOUNDS`, + r u |v|
    M x = b        max_i (|R| (|s| + e_s))_i / (1 - a),  s = b - M x,  a >= |I - R M|      (1)

While there are products only, the error is relative, one number for the whole array. The bounds
themselves are rounded, too, for which each is enlarged. Where nothing is known, it is infinite. A
comparison that the errors leave open has an error of 1.

Source: Higham, Accuracy and Stability of Numerical Algorithms, 2nd edition, section 3.3; (1):
Rump, Verification methods, Acta Numerica 19, 2010, section 10, with R an approximate inverse of M.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from mechanics.program.interpret import interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.program.operations import OPERATIONS, Operation
from mechanics.program.program import Program

LIBRARY = 4
"""NumPy's vectorised functions are this many times as far off as the C library's: 4 units."""

SLACK = 64
"""Units by which a bound is enlarged, for the roundings of the few operations it comes from."""
SECOND_ORDER = 2.0**-30
"""Products of relative errors, of which each is below 2^-32."""
MORE, LESS = 1 + 1e-12, 1 - 1e-12
"""Factors for a step of a bound before a difference that cancels."""


class Near(NamedTuple):
    """Values, and how far each may be from what it stands for: error + relative |value|.

    Attributes
    ----------
    value : array
    error : array or None
        None for none.
    relative : float
        Costs nothing while it is carried from product to product.
    """

    value: Any
    error: Any = None
    relative: Any = 0

    @property
    def exact(self) -> bool:
        """Whether it is what it stands for."""
        return self.error is None and not self.relative

    @property
    def absolute(self) -> Near:
        """The same with one bound."""
        if not self.relative:
            return self
        error = self.relative * np.abs(self.value)
        return Near(self.value, error if self.error is None else error + self.error)


def enclose(
    program: Program, inputs: Mapping[str, Any], precision: type = np.longdouble
) -> dict[str, tuple[Near, ...]]:
    """Values of the outputs with bounds of their errors.

    Parameters
    ----------
    program : Program
    inputs : mapping of str to array or Near
        Arrays are exact.
    precision : type
        ``numpy.float64`` or ``numpy.longdouble``.

    Returns
    -------
    dict of str to tuple of Near
        An infinite error where nothing is known.
    """
    columns = {
        name: given if isinstance(given, Near) else Near(np.asarray(given, dtype=precision))
        for name, given in inputs.items()
    }
    try:
        # The processor tells whether any operation has underflowed.
        with np.errstate(all="ignore", under="raise"):
            return interpret(program, RunningErrors(precision, normal=True), columns)
    except FloatingPointError:
        with np.errstate(all="ignore"):
            return interpret(program, RunningErrors(precision), columns)


@dataclass(frozen=True)
class RunningErrors:
    """The domain of arrays of one precision with running error bounds.

    Attributes
    ----------
    normal : bool
        Whether the caller sees to it that nothing underflows: errors are then relative as long as
        there are products only. Otherwise each rounding counts the smallest normal number, too.
    """

    precision: type = np.longdouble
    normal: bool = False

    @cached_property
    def unit(self) -> Any:
        """Spacing of the numbers at one."""
        return np.finfo(self.precision).eps

    @cached_property
    def operations(self) -> Mapping[str, Callable[..., Near]]:
        """NumPy's functions with their bounds."""
        values = Arrays(self.precision).operations
        return {
            row.name: self._function(row, values[row.name])
            for row in OPERATIONS
            if row.name in values and row.name in _BOUNDS
        }

    def _function(self, row: Operation, function: Callable[..., Any]) -> Callable[..., Near]:
        bound, combined, rounding = _BOUNDS[row.name], _RELATIVE.get(row.name), self._rounding(row)
        lost = self._lost(row)

        def apply(*operands: Near) -> Near:
            value = function(*[operand.value for operand in operands])
            if all([operand.exact for operand in operands]):
                return self._rounded(value, lost, rounding)
            if combined and all([operand.error is None for operand in operands]):
                before = combined(*[operand.relative for operand in operands])
                return self._rounded(value, None, (before + rounding) * (1 + SECOND_ORDER))
            error = bound(value, *[operand.absolute for operand in operands])
            return self._rounded(value, error if lost is None else error + lost, rounding)

        return apply

    def _lost(self, row: Operation) -> Any:
        """What a function of the library may lose without a word where its value is tiny."""
        if row.name == "erf":
            # SciPy has it in double precision only.
            return 2 * np.finfo(np.float64).tiny
        if row.ulp >= 1 and self.precision is not np.longdouble:
            # Vectorised functions need not tell when they underflow.
            return np.finfo(self.precision).tiny
        return None

    def _rounding(self, row: Operation) -> Any:
        """The error of the operation itself, relative to its value."""
        if row.name == "erf":
            return LIBRARY * row.ulp * np.finfo(np.float64).eps
        return (row.ulp if row.ulp < 1 else LIBRARY * row.ulp) * self.unit

    def _rounded(self, value: Any, error: Any, rounding: Any) -> Near:
        """A value with its bound; one that is no number is none."""
        if rounding and not self.normal:
            least = rounding * np.abs(value) + np.finfo(self.precision).tiny
            error, rounding = least if error is None else error + least, 0
        if error is not None:
            error = error * (1 + SLACK * self.unit)
            if not np.isfinite(error).all():
                error = np.where(np.isnan(error), np.inf, error)
        return Near(value, error, rounding)

    def constant(self, value: Fraction) -> Near:
        """The nearest number, and its distance."""
        number = Arrays(self.precision).constant(value)
        nearest = Fraction(*number.as_integer_ratio())
        distance = abs(nearest - value)
        if not nearest:
            return self._rounded(number, self.precision(float(distance)), 0)
        return Near(number, None, self.precision(float(distance / abs(nearest))))

    def pi(self) -> Near:
        """The nearest number to pi."""
        return self._rounded(Arrays(self.precision).pi(), None, self.unit)

    def solve(self, matrix: list[list[Any]], right: list[Any], symmetric: bool) -> Sequence[Near]:
        """Equation (1); the solution is improved twice by its residual."""
        size = len(right)
        values = [[entry.value for entry in row] for row in matrix]
        shape = np.broadcast_shapes(
            *(np.shape(entry) for row in values for entry in row),
            *(np.shape(entry.value) for entry in right),
        )
        stacked = [[np.broadcast_to(entry, shape) for entry in row] for row in values]
        inverse = _inverse(np.moveaxis(np.array(stacked, dtype=np.float64), (0, 1), (-2, -1)))
        rows = [
            [Near(inverse[..., i, j].astype(self.precision)) for j in range(size)]
            for i in range(size)
        ]
        x = [self.constant(Fraction(0)) for _ in right]
        for _ in range(3):
            residual = self._residual(matrix, x, right)
            step = [self._dot(row, [Near(s.value) for s in residual]) for row in rows]
            x = [Near(old.value + new.value) for old, new in zip(x, step, strict=True)]
        residual = self._residual(matrix, x, right)
        far = [self._dot([_size(r) for r in row], [_size(s) for s in residual]) for row in rows]
        columns = list(zip(*matrix, strict=True))
        one, zero = self.constant(Fraction(1)), self.constant(Fraction(0))
        rest = []
        for i, row in enumerate(rows):
            line = [
                self.operations["subtract"](one if i == j else zero, self._dot(row, column))
                for j, column in enumerate(columns)
            ]
            rest.append(sum(_upper(_size(entry)) for entry in line))
        distance = np.maximum.reduce(np.broadcast_arrays(*map(_upper, far)))
        contraction = np.maximum.reduce(np.broadcast_arrays(*rest)) * (1 + SLACK * size * self.unit)
        error = np.where(contraction < 1, distance / (1 - contraction), np.inf)
        return [self._rounded(np.broadcast_to(entry.value, shape), error, 0) for entry in x]

    def _dot(self, a: Sequence[Near], b: Sequence[Near]) -> Near:
        add, multiply = self.operations["add"], self.operations["multiply"]
        total = multiply(a[0], b[0])
        for x, y in zip(a[1:], b[1:], strict=True):
            total = add(total, multiply(x, y))
        return total

    def _residual(self, matrix: Any, x: Sequence[Near], right: Sequence[Near]) -> list[Near]:
        subtract = self.operations["subtract"]
        return [subtract(b, self._dot(row, x)) for row, b in zip(matrix, right, strict=True)]


def _inverse(matrix: Any) -> Any:
    """Approximate inverses; of a singular matrix one that proves nothing."""
    one = np.eye(matrix.shape[-1])
    usable = np.isfinite(matrix).all(axis=(-2, -1))[..., None, None]
    finite = np.where(usable, matrix, one)
    usable = usable & (np.linalg.slogdet(finite)[0] != 0)[..., None, None]
    return np.where(usable, np.linalg.inv(np.where(usable, finite, one)), np.nan)


def _size(near: Near) -> Near:
    return Near(np.abs(near.value), near.error, near.relative)


def _upper(near: Near) -> Any:
    return near.value + _e(near.absolute)


def _e(near: Near) -> Any:
    return 0 if near.error is None else near.error


def _sum(value: Any, x: Near, y: Near) -> Any:
    return _e(x) + _e(y)


def _product(value: Any, x: Near, y: Near) -> Any:
    if x.error is None:
        return np.abs(x.value) * y.error
    if y.error is None:
        return np.abs(y.value) * x.error
    return np.abs(x.value) * y.error + (np.abs(y.value) + y.error) * x.error


def _quotient(value: Any, x: Near, y: Near) -> Any:
    if y.error is None:
        return x.error / np.abs(y.value)
    room = np.abs(y.value) - y.error
    return np.where(room > 0, (_e(x) + np.abs(value) * y.error) / room, np.inf)


def _root(value: Any, x: Near) -> Any:
    return np.where(x.value > x.error, x.error / value, np.inf)


def _logarithm(value: Any, x: Near) -> Any:
    # log x - log(x - e) is the larger side.
    part = _e(x) / x.value * MORE
    return np.where((x.value > 0) & (part < 1), -np.log1p(-part), np.inf)


def _tangent(value: Any, x: Near) -> Any:
    # tan a - tan b = sin(a - b) / (cos a cos b), and cos b differs from cos a by e at most.
    cosine = 1 / np.sqrt(1 + value * value) * LESS
    return np.where(cosine > x.error, x.error / (cosine * (cosine - x.error)), np.inf)


def _arcsine(value: Any, x: Near) -> Any:
    end = (np.abs(x.value) + x.error) * MORE
    return np.where(end < 1, x.error / np.sqrt((1 - end) * (1 + end)), np.inf)


def _angle(value: Any, y: Near, x: Near) -> Any:
    # Of a point and another at a distance e: e / (r - e), unless the cut lies between them.
    e, r = np.hypot(_e(x), _e(y)) * MORE, np.hypot(x.value, y.value) * LESS
    cut = (x.value <= _e(x)) & (np.abs(y.value) <= _e(y)) & (_e(y) > 0)
    return np.where((r > e) & ~cut, e / (r - e), np.inf)


def _hyperbolic_arccosine(value: Any, x: Near) -> Any:
    least = (x.value - x.error) * LESS
    return np.where(least > 1, x.error / np.sqrt((least - 1) * (least + 1)), np.inf)


def _hyperbolic_arctangent(value: Any, x: Near) -> Any:
    end = (np.abs(x.value) + x.error) * MORE
    return np.where(end < 1, x.error / ((1 - end) * (1 + end)), np.inf)


def _power(value: Any, x: Near, y: Near) -> Any:
    # x^y = exp(y log x)
    change = _logarithm(value, x)
    log = np.abs(np.log(x.value)) * MORE + np.finfo(np.float64).tiny
    moved = np.abs(y.value) * change + (log + change) * _e(y)
    return np.where(x.value > 0, np.abs(value) * np.expm1(moved), np.inf)


def _jump(value: Any, x: Near) -> Any:
    return np.where(np.abs(x.value) > x.error, 0, 2)


def _floor(value: Any, x: Near) -> Any:
    part, room = x.value - value, x.error + 1e-12
    inside = (part >= room) & (1 - part > room)
    return np.where(inside, 0, np.ceil(x.error) + 1)


def _comparison(value: Any, x: Near, y: Near) -> Any:
    return np.where(np.abs(x.value - y.value) * LESS > _e(x) + _e(y), 0, 1)


def _truth(value: Any, *operands: Near) -> Any:
    return np.minimum(sum(_e(operand) for operand in operands), 1)


def _selected(value: Any, condition: Near, x: Near, y: Near) -> Any:
    side = np.where(condition.value != 0, _e(x), _e(y))
    if condition.error is None:
        return side
    other = np.where(condition.value != 0, y.value, x.value)
    either = np.abs(value - other) + np.maximum(_e(x), _e(y))
    return np.where(condition.error > 0, either, side)


_BOUNDS: dict[str, Callable[..., Any]] = {
    "add": _sum,
    "subtract": _sum,
    "multiply": _product,
    "divide": _quotient,
    "negate": lambda value, x: x.error,
    "abs": lambda value, x: x.error,
    "sqrt": _root,
    "power": _power,
    "exp": lambda value, x: np.abs(value) * np.expm1(x.error),
    "log": _logarithm,
    "sin": lambda value, x: np.minimum(x.error, 2),
    "cos": lambda value, x: np.minimum(x.error, 2),
    "tan": _tangent,
    "asin": _arcsine,
    "acos": _arcsine,
    "atan": lambda value, x: x.error,
    "atan2": _angle,
    "sinh": lambda value, x: x.error * np.cosh(np.abs(x.value) + x.error) * MORE,
    "cosh": lambda value, x: x.error * np.sinh(np.abs(x.value) + x.error) * MORE,
    "tanh": lambda value, x: np.minimum(x.error, 2),
    "asinh": lambda value, x: x.error,
    "acosh": _hyperbolic_arccosine,
    "atanh": _hyperbolic_arctangent,
    "erf": lambda value, x: np.minimum(x.error * 1.13, 2),  # 2 / sqrt(pi) = 1.128...
    "sign": _jump,
    "floor": _floor,
    "less": _comparison,
    "not_greater": _comparison,
    "equal": _comparison,
    "and": _truth,
    "or": _truth,
    "not": _truth,
    "select": _selected,
}
"""Error of a value whose operands are off by their errors, the operation itself exact.

Asked for where an operand has an error; derivatives are bounded over the whole interval.
"""

_RELATIVE: dict[str, Callable[..., Any]] = {
    "multiply": lambda x, y: x + y,
    "divide": lambda x, y: x + y,
    "negate": lambda x: x,
    "abs": lambda x: x,
    "sqrt": lambda x: x / 2,
    "select": lambda condition, x, y: max(x, y),
}
"""Relative error of a value from those of its operands, to first order, none of them absolute."""
