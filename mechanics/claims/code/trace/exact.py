"""Numbers that code computes from exact ones, beside the doubles that they are: sqrt(3) stays that.

    numpy.sqrt(3)/2 -> 0.8660254037844386, sqrt(3)/2        numpy.cos(numpy.pi/6) -> the same

Anything but arithmetic finds a double in them, as it would without us.
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from fractions import Fraction
from math import isfinite
from typing import Any

import numpy as np
import sympy
from sympy import Expr

from mechanics.claims.code.constants import constant_of
from mechanics.errors import InputError

LONGEST = 200
"""Characters of a formula: a loop that refines a number makes it ever longer."""

LARGEST_EXPONENT = 64

Numbers = int | float | np.integer | np.floating | Fraction

DEGREE = sympy.pi / 180

ELEMENTARY: dict[str, Callable[[Expr], Expr]] = {
    "sin": sympy.sin, "cos": sympy.cos, "tan": sympy.tan, "arcsin": sympy.asin,
    "arccos": sympy.acos, "arctan": sympy.atan, "sinh": sympy.sinh, "cosh": sympy.cosh,
    "tanh": sympy.tanh, "arcsinh": sympy.asinh, "arccosh": sympy.acosh, "arctanh": sympy.atanh,
    "exp": sympy.exp, "log": sympy.log, "sqrt": sympy.sqrt,
    "cbrt": lambda x: sympy.sign(x) * sympy.Abs(x) ** sympy.Rational(1, 3),
    "fabs": sympy.Abs, "sign": sympy.sign,
    "conjugate": lambda x: x,
    "radians": lambda x: x * DEGREE, "deg2rad": lambda x: x * DEGREE,
}  # fmt: skip
"""Functions of one number, by NumPy's names."""

OF_DEGREES = ("radians", "deg2rad")
"""Those that only multiply."""

ARITHMETIC = (
    np.add, np.subtract, np.multiply, np.divide, np.power, np.negative, np.absolute, np.square,
)  # fmt: skip
"""What NumPy does with objects by their operators."""


class Exact(float):
    """A double and the number that it stands for.

    Attributes
    ----------
    expr : Expr
        Without symbols.
    notes : tuple of str
        What its numbers were read as.
    """

    expr: Expr
    notes: tuple[str, ...]

    def __new__(cls, value: float, expr: Expr, notes: tuple[str, ...] = ()) -> Exact:
        """A double with its formula."""
        number = super().__new__(cls, value)
        number.expr, number.notes = expr, notes
        return number

    def __add__(self, other: Any) -> Any:
        return _both(operator.add, self, other)

    def __radd__(self, other: Any) -> Any:
        return _both(operator.add, other, self)

    def __sub__(self, other: Any) -> Any:
        return _both(operator.sub, self, other)

    def __rsub__(self, other: Any) -> Any:
        return _both(operator.sub, other, self)

    def __mul__(self, other: Any) -> Any:
        return _both(operator.mul, self, other)

    def __rmul__(self, other: Any) -> Any:
        return _both(operator.mul, other, self)

    def __truediv__(self, other: Any) -> Any:
        return _both(operator.truediv, self, other)

    def __rtruediv__(self, other: Any) -> Any:
        return _both(operator.truediv, other, self)

    def __pow__(self, other: Any, modulus: None = None) -> Any:
        return _both(operator.pow, self, other)

    def __rpow__(self, other: Any, modulus: None = None) -> Any:
        return _both(operator.pow, other, self)

    def __neg__(self) -> Exact:
        return Exact(-float(self), -self.expr, self.notes)

    def __pos__(self) -> Exact:
        return self

    def __abs__(self) -> Exact:
        return Exact(abs(float(self)), sympy.Abs(self.expr), self.notes)

    def __getattr__(self, name: str) -> Callable[[], Any]:
        # NumPy's functions call the method of that name on every entry of an array of objects.
        if name not in ELEMENTARY:
            raise AttributeError(name)
        return lambda: exact(ELEMENTARY[name], getattr(np, name), self)

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        """Arithmetic entry by entry; anything else finds a double."""
        others = [entry for entry in inputs if not isinstance(entry, Exact)]
        if ufunc in ARITHMETIC or any(np.asarray(entry).dtype == object for entry in others):
            found: list[Any] = [_objects(entry) for entry in inputs]
        else:
            found = [float(entry) if isinstance(entry, Exact) else entry for entry in inputs]
        return getattr(ufunc, method)(*found, **options)


def _objects(entries: Any) -> np.ndarray:
    """An array of Python's numbers: NumPy's own would ask for this arithmetic again."""
    found = np.array(entries, dtype=object)
    for place in np.ndindex(found.shape):
        if isinstance(found[place], np.generic):
            found[place] = found[place].item()
    return found


def is_plain(value: Any) -> bool:
    """Whether a number is one of Python or NumPy, no truth value."""
    return isinstance(value, Numbers) and not isinstance(value, bool)


def exact(function: Callable[..., Expr], original: Callable[..., Any], *numbers: Any) -> Any:
    """A function of numbers as an `Exact`; the double alone where that has no formula."""
    plain = [float(number) if isinstance(number, Exact) else number for number in numbers]
    value = original(*plain)
    if not isfinite(value):
        return value
    formulas: list[Expr] = []
    notes: list[str] = []
    for number in numbers:
        formula, told = _formula(number)
        formulas.append(formula)
        notes += told
    try:
        found = function(*formulas)
    except (InputError, TypeError):
        return value
    if not found.is_real or len(str(found)) > LONGEST:
        return value
    return Exact(float(value), found, tuple(dict.fromkeys(notes)))


def _formula(number: Any) -> tuple[Expr, tuple[str, ...]]:
    if isinstance(number, Exact):
        return number.expr, number.notes
    if isinstance(number, int | np.integer):
        return sympy.Integer(int(number)), ()
    if isinstance(number, Fraction):
        return sympy.Rational(number.numerator, number.denominator), ()
    formula, note = constant_of(float(number))
    return formula, (note,) if note else ()


def _both(operation: Callable[[Any, Any], Any], left: Any, right: Any) -> Any:
    if not (is_plain(left) and is_plain(right)):
        return NotImplemented
    if operation is operator.pow and abs(right) > LARGEST_EXPONENT:
        return float(left) ** float(right)
    return exact(operation, lambda a, b: operation(float(a), float(b)), left, right)


PI, E, TAU = (
    Exact(float(number), number) for number in (sympy.pi, sympy.E, 2 * sympy.pi)
)  # fmt: skip
