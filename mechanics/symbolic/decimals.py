"""Enclosures at given values, and rounded decimals.

A printed decimal is right if |value - printed| <= half a unit of its last digit.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal, InvalidOperation
from fractions import Fraction

import sympy
from flint import arb

from mechanics.errors import ExpressionError
from mechanics.kernel import enclose as enclose_program
from mechanics.kernel.finding import exact
from mechanics.program import Program
from mechanics.symbolic.arithmetic import Arithmetic

Values = Mapping[sympy.Symbol, Fraction | int | arb]


@dataclass(frozen=True)
class Formulas:
    """Expressions as one program, to be enclosed at many states.

    Attributes
    ----------
    program : Program
    inputs : mapping of Symbol to str
        Names of the inputs.
    """

    program: Program
    inputs: Mapping[sympy.Symbol, str]

    def at(self, values: Values, bits: int = 128) -> tuple[arb, ...]:
        """Enclosures at a state; as `enclose`."""
        state = {name: values[s] for s, name in self.inputs.items() if s in values}
        missing = [name for name in self.program.inputs if name not in state]
        if missing:
            name, of_function, _ = missing[0].partition(": ")
            kind = "" if of_function else "symbol "
            raise ExpressionError(f"{kind}{name} has no value: add it to the values")
        return enclose_program(self.program, state, bits)["values"]


def formulas(expressions: Sequence[sympy.Expr]) -> Formulas:
    """Expressions in plain symbols as one program.

    Raises
    ------
    ExpressionError
        If an operation has no enclosure.
    """
    a = Arithmetic()
    program = a.builder.program({"values": [a.value(expression) for expression in expressions]})
    return Formulas(program, a.inputs)


def enclose(expr: sympy.Expr, values: Values, bits: int = 128) -> arb:
    """Return a ball that contains the value of an expression.

    Parameters
    ----------
    expr : sympy.Expr
        In plain symbols.
    values : mapping of Symbol to Fraction, int, SymPy rational or arb
        A value for every symbol.
    bits : int
        Working precision.

    Returns
    -------
    flint.arb
        Not finite where the expression is undefined.

    Raises
    ------
    ExpressionError
        If a symbol has no value, or an operation no enclosure.
    """
    return formulas([expr]).at(values, bits)[0]


def float_as_rational(number: sympy.Float) -> sympy.Rational:
    """Return the dyadic rational that a SymPy float stores: (-1)**sign * mantissa * 2**exponent."""
    sign, mantissa, exponent, _ = number._mpf_
    return sympy.Rational((-1) ** sign * int(mantissa)) * sympy.Integer(2) ** int(exponent)


def decimal_matches(value: arb, printed: str) -> bool:
    """Tell whether an enclosure lies within half a unit of the last digit of a printed decimal.

    Parameters
    ----------
    value : flint.arb
        As `enclose` gives it.
    printed : str
        Such as ``"0.7071"``, ``"-3"`` or ``"1.20e-3"``; trailing zeros count.

    Raises
    ------
    ValueError
        If `printed` is no decimal number.
    """
    low, high = roundings(printed)
    if not value.is_finite():
        return False
    middle, radius = exact(value.mid()), exact(value.rad())
    return low <= middle - radius and middle + radius <= high


def roundings(printed: str) -> tuple[Fraction, Fraction]:
    """Least and largest number that rounds to a printed decimal.

    Raises
    ------
    ValueError
        If `printed` is no decimal number.
    """
    try:
        number = Decimal(printed.replace("\N{MINUS SIGN}", "-"))
    except InvalidOperation as error:
        raise ValueError(f"{printed!r} is no decimal number: write it like 0.7071") from error
    exponent = number.as_tuple().exponent
    if not isinstance(exponent, int):
        raise ValueError(f"{printed!r} is no finite decimal number: write it like 0.7071")
    half = Fraction(10) ** exponent / 2
    return Fraction(number) - half, Fraction(number) + half
