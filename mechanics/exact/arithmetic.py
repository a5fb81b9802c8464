"""One experiment, several arithmetics: the operations that every arithmetic offers.

An *experiment* is a plain function ``experiment(a: Arithmetic)`` that returns a list of pairs
(left, right) of numbers that should be equal. It is written once and run over the normal form,
a finite field and balls.

Numbers understand ``+ - * /``, unary minus and integer ``**`` with each other and with ``int``,
``Fraction`` and SymPy rationals.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import sympy

from mechanics.exact import graph as graphs
from mechanics.exact import walk

Number = Any
"""A member of an arithmetic. Its class differs from arithmetic to arithmetic."""

Term = tuple[Fraction, Number]
"""One term of an angle or exponent: rational factor, number."""


class Arithmetic(ABC):
    """The operations that experiments and walkers use.

    A walker needs only what stands below, so SymPy expressions and CasADi graphs are read by the
    same code whatever the numbers are.
    """

    def __init__(self) -> None:
        self.memo: dict[object, Number] = {}

    def value(self, expr: sympy.Expr) -> Number:
        """Return the value of an expression in plain symbols; shared parts are evaluated once.

        Raises
        ------
        ExpressionError
            If the expression holds an operation that has no exact meaning here; it is named.
        """
        return walk.evaluate(self, sympy.sympify(expr), self.memo)

    def assign(self, symbol: sympy.Symbol, number: Number) -> None:
        """Let `symbol` stand for a number that the experiment has computed.

        In the field a computed angle is one whole: with th = x + y, sin(th) is not known to be
        sin(x) cos(y) + cos(x) sin(y). Substitute in the expression where that matters.

        Raises
        ------
        ValueError
            If the symbol has been used already: values that contain it would be wrong.
        """
        if symbol in self.memo:
            raise ValueError(
                f"symbol {symbol} has been used or assigned already: assign it before its first use"
            )
        self.memo[symbol] = self.rational(0) + number

    def graph(
        self,
        function: Any,
        arguments: Sequence[Sequence[Number]] | None = None,
        symbols: Sequence[Sequence[sympy.Expr]] | None = None,
    ) -> list[list[Number]]:
        """Evaluate a CasADi SX function.

        Parameters
        ----------
        function : casadi.Function
            Instruction by instruction; double constants are the dyadic rationals that they are.
        arguments : sequence of sequence of Number, optional
            For every input its entries, dense and column by column.
        symbols : sequence of sequence of sympy.Expr, optional
            Instead of `arguments`: the symbols (or expressions) that the entries stand for.

        Returns
        -------
        list of list of Number
            For every output its entries, dense and column by column.

        Raises
        ------
        ExpressionError
            If the graph holds an unknown operation (named), or the arguments have wrong shapes.
        """
        if arguments is None:
            arguments = [[self.value(entry) for entry in group] for group in symbols or ()]
        return graphs.evaluate(self, function, arguments)

    @abstractmethod
    def rational(self, number: int | Fraction) -> Number:
        """Return the number that an exact rational is."""

    @abstractmethod
    def symbol(self, symbol: sympy.Symbol) -> Number:
        """Return the value of a free symbol, drawn when it is first asked for."""

    @abstractmethod
    def constant(self, constant: sympy.Expr) -> Number:
        """Return a named transcendental constant such as pi."""

    @abstractmethod
    def circle(self, terms: Sequence[Term]) -> tuple[Number, Number]:
        """Return cosine and sine of the sum of factor * number over the terms."""

    @abstractmethod
    def exponential(self, terms: Sequence[Term]) -> Number:
        """Return exp of the sum of factor * number over the terms."""

    @abstractmethod
    def root_power(self, number: Number, exponent: Fraction) -> Number:
        """Return number ** exponent for a fractional exponent and a positive number."""

    @abstractmethod
    def absolute(self, number: Number) -> Number:
        """Return the absolute value."""

    @abstractmethod
    def sign(self, number: Number) -> Number:
        """Return -1, 0 or 1."""

    @abstractmethod
    def indicator(self, relation: str, difference: Number) -> Number:
        """Return 1 where ``difference < 0`` (``"<"``, ``"<="`` or ``"=="``) holds, else 0."""

    @abstractmethod
    def select(self, condition: Number, yes: Number, no: Number) -> Number:
        """Return `yes` where the indicator `condition` is 1, `no` where it is 0."""

    @abstractmethod
    def function(self, name: str, arguments: Sequence[Number]) -> Number:
        """Return the value of any other function; equal arguments give equal values."""

    @abstractmethod
    def solve(self, rows: Sequence[Sequence[Number]], rhs: Sequence[Number]) -> list[Number]:
        """Solve the square linear system ``rows @ x = rhs``.

        Raises
        ------
        SingularHere
            If the matrix is singular at this point; `decide` then tries others.
        """

    @abstractmethod
    def rank(self, rows: Sequence[Sequence[Number]]) -> int:
        """Return the rank of a matrix at this point."""

    @abstractmethod
    def is_zero(self, number: Number) -> bool:
        """Tell whether a number is zero at this point (normal form: everywhere)."""

    @abstractmethod
    def require_positive(self, number: Number) -> None:
        """Ask for another point unless `number` is positive here.

        Raises
        ------
        Inadmissible
            If it is not. In the field, squares play the positive numbers.
        """

    def sqrt(self, number: Number) -> Number:
        """Return the positive root; a point where the radicand is negative is redrawn."""
        return self.root_power(self.rational(0) + number, Fraction(1, 2))


def as_fraction(number: Any) -> Fraction:
    """Return an int, Fraction or SymPy rational as a Fraction.

    Raises
    ------
    TypeError
        For anything else, floats included: an exact number is needed.
    """
    if isinstance(number, int | Fraction):
        return Fraction(number)
    if isinstance(number, sympy.Rational):
        return Fraction(int(number.p), int(number.q))
    raise TypeError(
        f"exact number expected, {type(number).__name__} found: pass int, Fraction "
        "or a.value(expression)"
    )
