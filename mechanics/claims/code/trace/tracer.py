"""Numbers that remember how they were made: a Python function called with them shows its formula.

    f(Traced(x)) -> Traced(formula in x)        if x > 0:  -> both ways, one after the other

A comparison that code decides upon asks the explorer, which goes through all decisions by calling
the function again.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable
from dis import opname
from fractions import Fraction
from functools import partial
from math import isnan
from numbers import Real
from typing import Any

import numpy as np
import sympy
from sympy import Expr

from mechanics.claims.code.constants import constant_of, exact_in_single
from mechanics.claims.code.trace.exact import DEGREE, ELEMENTARY, OF_DEGREES, Exact
from mechanics.claims.code.trace.explorer import Condition, Explorer
from mechanics.claims.code.trace.formulas import (
    Formula,
    added,
    called,
    divided,
    leaf,
    multiplied,
    negated,
    raised,
    subtracted,
)
from mechanics.claims.demands import (
    CONSTANT_NAN,
    NOTHING,
    Asked,
    Demand,
    asked,
    of_function,
    of_power,
)
from mechanics.claims.functions import modulo, quotient, remainder
from mechanics.errors import InputError

Operation = tuple[
    Callable[[Expr, Expr], Any],
    Callable[[Formula, Formula], Formula],
    Callable[[Expr, Expr], Iterable[Demand]],
]
"""What is done with two expressions, with two formulas, and what it asks for."""


class Traced:
    """A number with its formula."""

    __slots__ = ("asked", "explorer", "expr", "formula")
    __array_priority__ = 1000.0

    def __init__(
        self, expr: Expr, explorer: Explorer, formula: Formula = None, asked_for: Asked = NOTHING
    ) -> None:
        self.expr, self.explorer, self.formula = expr, explorer, formula
        self.asked = asked_for

    def new(self, expr: Expr, formula: Formula = None, asked_for: Asked | None = None) -> Traced:
        """Another number of the same call; `formula` as the code has it, where that is known.

        It asks for what this one does, where nothing else is said.
        """
        return Traced(expr, self.explorer, formula, self.asked if asked_for is None else asked_for)

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        """What NumPy does with arrays and a number: ``y *= m`` changes y, ``y*m`` makes another."""
        out = options.pop("out", None)
        if out is None and method == "__call__" and ufunc in TURNED and inputs[1] is self:
            return self._both(inputs[0], TURNED[ufunc], turned=True)
        entries = [_alone(one) if isinstance(one, Traced) else one for one in inputs]
        result = getattr(ufunc, method)(*entries, **options)
        if out is None:
            return result
        out[0][...] = result
        return out[0]

    def _both(self, other: Any, operation: Operation, turned: bool = False) -> Any:
        if isinstance(other, np.ndarray) and not turned:
            # NumPy goes through the entries and comes back here for each.
            return NotImplemented
        if isinstance(other, np.ndarray):
            found = np.empty(other.shape, dtype=object)
            for place, entry in np.ndenumerate(other):
                found[place] = self._both(entry, operation, turned)
            return found if other.shape else found.item()
        value = expression_of(other, self.explorer)
        if value is None:
            return NotImplemented
        formula = formula_of(other, value)
        of_expressions, of_formulas, demands = operation
        pair = (value, self.expr) if turned else (self.expr, value)
        formulas = (formula, self.formula) if turned else (self.formula, formula)
        own = asked(demands(*pair), self.asked, asked_of(other))
        return self.new(of_expressions(*pair), of_formulas(*formulas), own)

    def __add__(self, other: Any) -> Any:
        return self._both(other, ADD)

    def __radd__(self, other: Any) -> Any:
        return self._both(other, ADD, turned=True)

    def __sub__(self, other: Any) -> Any:
        return self._both(other, SUBTRACT)

    def __rsub__(self, other: Any) -> Any:
        return self._both(other, SUBTRACT, turned=True)

    def __mul__(self, other: Any) -> Any:
        return self._both(other, MULTIPLY)

    def __rmul__(self, other: Any) -> Any:
        return self._both(other, MULTIPLY, turned=True)

    def __truediv__(self, other: Any) -> Any:
        return self._both(other, DIVIDE)

    def __rtruediv__(self, other: Any) -> Any:
        return self._both(other, DIVIDE, turned=True)

    def __pow__(self, other: Any) -> Any:
        return self._both(other, POWER)

    def __rpow__(self, other: Any) -> Any:
        return self._both(other, POWER, turned=True)

    def __neg__(self) -> Traced:
        return self.new(-self.expr, negated(self.formula))

    def __pos__(self) -> Traced:
        return self

    def __abs__(self) -> Traced:
        return self.new(sympy.Abs(self.expr), called("abs", self.formula))

    def _compare(self, other: Any, relation: Any) -> Any:
        value = expression_of(other, self.explorer)
        if value is None:
            return NotImplemented
        own = asked((), self.asked, asked_of(other))
        return Condition(relation(self.expr - value, 0), self.explorer, own)

    def __lt__(self, other: Any) -> Any:
        return self._compare(other, sympy.StrictLessThan)

    def __le__(self, other: Any) -> Any:
        return self._compare(other, sympy.LessThan)

    def __gt__(self, other: Any) -> Any:
        return self._compare(other, sympy.StrictGreaterThan)

    def __ge__(self, other: Any) -> Any:
        return self._compare(other, sympy.GreaterThan)

    def __eq__(self, other: object) -> Any:
        return self._compare(other, sympy.Equality)

    def __ne__(self, other: object) -> Any:
        return self._compare(other, sympy.Unequality)

    __hash__ = None  # type: ignore[assignment]

    def is_of(self, kinds: Any) -> bool:
        """Whether a float is of one of some classes; what NumPy's float or an integer is hides."""
        every = kinds if isinstance(kinds, tuple) else getattr(kinds, "__args__", (kinds,))
        if any(issubclass(float, kind) for kind in every):
            return True
        if any(issubclass(base, kind) for base in NUMBERS for kind in every):
            self.explorer.hidden.append("it asks of which class a number is: leave that out")
        return False

    def __bool__(self) -> bool:
        return self.explorer.decide(sympy.Unequality(self.expr, 0), self.asked)

    def __float__(self) -> float:
        raise TypeError(
            "a traced number has no value: float(), int(), arrays of integers and the like hide a"
            " formula"
        )

    __int__ = __index__ = __round__ = __trunc__ = __floor__ = __ceil__ = __complex__ = __float__

    def __mod__(self, other: Any) -> Any:
        return self._both(other, MODULO)

    def __rmod__(self, other: Any) -> Any:
        return self._both(other, MODULO, turned=True)

    def _fmod(self, other: Any) -> Any:
        """The remainder with the sign of the number, as that of C."""
        return self._both(other, REMAINDER)

    def __floordiv__(self, _: Any) -> Any:
        raise TypeError("// of a traced number hides a formula: write it otherwise")

    __rfloordiv__ = __divmod__ = __rdivmod__ = __floordiv__

    def item(self) -> Traced:
        """Itself, as of an array with one entry."""
        return self

    def _hypot(self, other: Any) -> Any:
        """The length of (self, other)."""
        return np.sqrt(self * self + other * other)

    def _arctan2(self, other: Any) -> Traced:
        """The angle of (other, self)."""
        value = expression_of(other, self.explorer)
        formula = called("atan2", self.formula, formula_of(other, value))
        own = asked((), self.asked, asked_of(other))
        return self.new(sympy.atan2(self.expr, value), formula, own)

    @property
    def real(self) -> Traced:
        """Itself, as of a float."""
        return self

    @property
    def imag(self) -> float:
        """Zero, as of a float."""
        return 0.0

    def __copy__(self, _: object = None) -> Traced:
        return self

    __deepcopy__ = __copy__

    def __repr__(self, _: str = "") -> str:
        self.explorer.hidden.append("it makes text of a number: what it does with that is hidden")
        return "a traced number"

    __str__ = __format__ = __repr__

    def __getattr__(self, name: str) -> Callable[..., Any]:
        # NumPy's functions call the method of that name on every entry of an array of objects.
        frame = sys._getframe(1)
        direct = opname[frame.f_code.co_code[frame.f_lasti]] in ("LOAD_ATTR", "LOAD_METHOD")
        if not direct or of_libraries(str(frame.f_globals.get("__name__", ""))):
            if name in ELEMENTARY:
                return partial(self._elementary, name)
            if name in OF_TWO:
                return partial(getattr(Traced, f"_{name}"), self)
        elif name[:2] != "__" and (hasattr(float, name) or hasattr(np.float64, name)):
            self.explorer.hidden.append(f".{name} of a number hides a formula: write it otherwise")
        raise AttributeError(f"'float' object has no attribute '{name}'")

    def _elementary(self, name: str) -> Traced:
        if name in OF_DEGREES:
            return self.new(self.expr * DEGREE, multiplied(self.formula, leaf(DEGREE)))
        known = NAMES.get(name, name)
        own = asked(of_function(known, [self.expr]), self.asked)
        return self.new(ELEMENTARY[name](self.expr), called(known, self.formula), own)


def of_libraries(module: str) -> bool:
    """Whether a module may ask a traced number for what no float has."""
    return module.partition(".")[0] in LIBRARIES


Real.register(Traced)
Traced.__name__ = "float"  # in the words of errors, which code may look at
NUMBERS = (int, bool, np.float64, np.float32, np.int64, complex)
"""Classes of other numbers that may be passed."""
OF_TWO = ("fmod", "hypot", "arctan2")
LIBRARIES = ("mechanics", "numpy", "scipy")


def _power(a: Expr, b: Expr) -> Expr:
    if b.is_number and abs(b.n(5)) > 64:
        raise InputError(f"the exponent {b} is too large: 64 is the limit")
    return a**b


def _everywhere(_: Expr, __: Expr) -> tuple[Demand, ...]:
    return ()


ADD: Operation = (lambda a, b: a + b, added, _everywhere)
SUBTRACT: Operation = (lambda a, b: a - b, subtracted, _everywhere)
MULTIPLY: Operation = (lambda a, b: a * b, multiplied, _everywhere)
DIVIDE: Operation = (quotient, divided, lambda a, b: _divided(a, b))
POWER: Operation = (_power, raised, of_power)


def _divided(_: Expr, b: Expr) -> Iterable[Demand]:
    return of_power(b, sympy.S.NegativeOne)


MODULO: Operation = (modulo, lambda a, b: None, _divided)
REMAINDER: Operation = (remainder, lambda a, b: None, _divided)
TURNED = {
    np.add: ADD, np.subtract: SUBTRACT, np.multiply: MULTIPLY, np.true_divide: DIVIDE,
    np.power: POWER, np.remainder: MODULO,
}  # fmt: skip
"""What NumPy calls the operation of an array and a number behind it."""


def _alone(number: Traced) -> Any:
    """A number as an array without dimensions."""
    array = np.empty((), dtype=object)
    array[()] = number
    return array


def asked_of(value: Any) -> Asked:
    """What a number asks for, traced or not."""
    if isinstance(value, np.ndarray) and value.shape == ():
        return asked_of(value.item())
    if isinstance(value, float | np.floating) and isnan(value):
        return NAN
    return value.asked if isinstance(value, Traced) else NOTHING


def formula_of(value: Any, expression: Expr) -> Formula:
    """The formula of a number as the code has it, traced or not."""
    if isinstance(value, Traced):
        return value.formula
    if isinstance(value, np.ndarray) and value.shape == ():
        return formula_of(value.item(), expression)
    return leaf(expression)


def expression_of(value: Any, explorer: Explorer) -> Expr | None:
    """The formula of a number, traced or not; None for what is no number."""
    if isinstance(value, Traced):
        return value.expr
    if isinstance(value, np.ndarray) and value.shape == ():
        return expression_of(value.item(), explorer)
    if isinstance(value, bool | np.bool_):
        return sympy.Integer(int(value))
    if _overloaded(value):
        return None
    if isinstance(value, int | np.integer):
        return sympy.Integer(int(value))
    if isinstance(value, Fraction):
        return sympy.Rational(value.numerator, value.denominator)
    if isinstance(value, Exact):
        explorer.notes += [note for note in value.notes if note not in explorer.notes]
        return value.expr
    if isinstance(value, float | np.floating) and isnan(value):
        return sympy.S.Zero  # it asks for what no state has
    if isinstance(value, np.float32 | np.float16):
        exact_in_single(float(str(value)), value)
    if isinstance(value, float | np.floating):
        number, note = constant_of(float(value))
        if note and note not in explorer.notes:
            explorer.notes.append(note)
        return number
    if isinstance(value, Condition):
        return sympy.Integer(int(bool(value)))
    return None


def _overloaded(value: Any) -> bool:
    """Whether a number is of a class whose own operators come first."""
    kind = type(value)
    if kind in (float, int) or not isinstance(value, float | int) or isinstance(value, np.generic):
        return False
    plain: type = float if isinstance(value, float) else int
    return kind is not Exact and any(getattr(kind, n) is not getattr(plain, n) for n in OPERATORS)


OPERATORS = (
    "__radd__", "__rsub__", "__rmul__", "__rtruediv__", "__rpow__", "__rmod__", "__rfloordiv__",
    "__lt__", "__le__", "__gt__", "__ge__", "__eq__", "__ne__",
)  # fmt: skip
"""Of a class that is derived from `float`: they are called first, on either side."""
NAN = asked([Demand(CONSTANT_NAN)])

NAMES = {
    "arcsin": "asin", "arccos": "acos", "arctan": "atan", "arcsinh": "asinh", "arccosh": "acosh",
    "arctanh": "atanh", "fabs": "abs",
}  # fmt: skip
"""Functions that have other names in formulas."""
