"""Code as expressions: the arithmetic whose numbers are SymPy expressions.

What walks CasADi graphs and C text over a field or over balls walks them over expressions, too.
"""

from collections.abc import Sequence
from fractions import Fraction

import sympy
from sympy import Expr, Piecewise, Rational

from mechanics.errors import ExpressionError
from mechanics.exact.arithmetic import Arithmetic, Number, Term
from mechanics.reading.code.constants import constant_from
from mechanics.reading.functions import magnitude

FUNCTIONS = {
    "log": sympy.log, "asin": sympy.asin, "acos": sympy.acos, "atan": sympy.atan,
    "atan2": sympy.atan2, "asinh": sympy.asinh, "acosh": sympy.acosh, "atanh": sympy.atanh,
    "erf": sympy.erf, "floor": sympy.floor, "ceil": sympy.ceiling,
}  # fmt: skip


class Written(Arithmetic):
    """Numbers are expressions; `notes` list constants that were computed beforehand."""

    def __init__(self) -> None:
        super().__init__()
        self.notes: list[str] = []

    def rational(self, number: int | Fraction) -> Number:
        """Return a constant as what it stands for."""
        value, note = constant_from(Fraction(number))
        if note and note not in self.notes:
            self.notes.append(note)
        return value

    def symbol(self, symbol: sympy.Symbol) -> Number:
        """Return the symbol."""
        return symbol

    def constant(self, constant: Expr) -> Number:
        """Return the constant."""
        return constant

    def _angle(self, terms: Sequence[Term]) -> Expr:
        return sympy.Add(*(Rational(f.numerator, f.denominator) * n for f, n in terms))

    def circle(self, terms: Sequence[Term]) -> tuple[Number, Number]:
        """Return cosine and sine of the sum."""
        angle = self._angle(terms)
        return sympy.cos(angle), sympy.sin(angle)

    def exponential(self, terms: Sequence[Term]) -> Number:
        """Return the exponential of the sum."""
        return sympy.exp(self._angle(terms))

    def root_power(self, number: Number, exponent: Fraction) -> Number:
        """Return a fractional power."""
        return number ** Rational(exponent.numerator, exponent.denominator)

    def absolute(self, number: Number) -> Number:
        """Return |x|."""
        return magnitude(number)

    def sign(self, number: Number) -> Number:
        """Return the sign."""
        return sympy.sign(number)

    def indicator(self, relation: str, difference: Number) -> Number:
        """Return 1 where the relation holds."""
        relations = {"<": sympy.StrictLessThan, "<=": sympy.LessThan, "==": sympy.Equality}
        return Piecewise((1, relations[relation](difference, 0)), (0, True))

    def select(self, condition: Number, yes: Number, no: Number) -> Number:
        """Return one of two expressions."""
        return condition * yes + (1 - condition) * no

    def function(self, name: str, arguments: Sequence[Number]) -> Number:
        """Return a function of the library."""
        if name == "power":
            return arguments[0] ** arguments[1]
        if name not in FUNCTIONS:
            raise ExpressionError(f"the function {name} is not known here")
        return FUNCTIONS[name](*arguments)

    def solve(self, rows: Sequence[Sequence[Number]], rhs: Sequence[Number]) -> list[Number]:
        """Solve a linear system by elimination without fractions of fractions."""
        return list(sympy.Matrix(rows).LUsolve(sympy.Matrix(rhs)))

    def rank(self, rows: Sequence[Sequence[Number]]) -> int:
        """Return the rank."""
        return int(sympy.Matrix(rows).rank())

    def is_zero(self, number: Number) -> bool:
        """Tell whether it is the number zero."""
        return bool(number == 0)

    def require_positive(self, number: Number) -> None:
        """Ask for nothing."""
